// Characters of a text that should be UTF-8 and may be anything.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace snell::utf8 {

struct Char {
    char32_t code = 0;
    std::uint32_t length = 1;  // bytes
    bool valid = true;         // false: one byte that is no UTF-8; `code` is that byte
};

// The character at `at`, which must be inside the text. Overlong forms and surrogates are invalid.
Char decode(std::string_view text, std::size_t at);

void append(std::string& out, char32_t code);

// Columns that a terminal gives the character: 0, 1 or 2.
int width(char32_t code);

// True for what must not reach a terminal or can't be seen there: controls, bidirectional marks, blanks of no width.
bool hidden(char32_t code);

// The text with hidden characters as \xNN or \u{NNNN}, and bytes that are no UTF-8 read as Latin-1.
std::string printable(std::string_view text);

// How a diagnostic names a character: "U+00A0".
std::string code_point(char32_t code);

}  // namespace snell::utf8
