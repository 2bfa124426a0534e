// Characters of text that should be UTF-8 but may be any bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace snell::utf8 {

struct Char {
    char32_t code = 0;
    std::uint32_t length = 1;  // in bytes
    bool valid = true;         // if false, `code` is one byte that is not valid UTF-8
};

// Decodes the character at offset `at`, which must be inside of the text. Overlong forms and surrogates are invalid.
Char decode(std::string_view text, std::size_t at);

// Appends a character as UTF-8.
void append(std::string& out, char32_t code);

// The number of terminal columns of a character: 0, 1 or 2.
int width(char32_t code);

// True for characters that must not reach a terminal or are invisible there: controls, bidirectional marks, zero-width
// blanks.
bool hidden(char32_t code);

// Returns the text with hidden characters escaped as \xNN or \u{NNNN}; bytes that are not UTF-8 are read as Latin-1.
std::string printable(std::string_view text);

// Formats a character for a diagnostic, such as "U+00A0".
std::string code_point(char32_t code);

}  // namespace snell::utf8
