// Words and characters: compared without regard to case (ASCII), split, tidied, put into sentences, and read from what
// should be UTF-8 but may be any bytes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

// Words: compared without regard to case (ASCII), and split.

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

constexpr bool same_word(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (lower(a[i]) != lower(b[i])) return false;
    return true;
}

constexpr bool contains(std::string_view text, std::string_view part) {
    const auto same = [](char a, char b) { return lower(a) == lower(b); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end() || part.empty();
}

// The parts between separators; of an empty text there are none.
inline std::vector<std::string_view> split(std::string_view text, char separator = ' ') {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        words.push_back(text.substr(0, text.find(separator)));
        text.remove_prefix(words.back().size() < text.size() ? words.back().size() + 1 : text.size());
    }
    return words;
}

// Removes the quotes of `text`, which must begin with one: '"', or a curved quote, which has three bytes. `closed`
// tells that there is a closing quote.
constexpr std::string_view without_quotes(std::string_view text, bool closed) {
    const std::size_t opening = text.starts_with('"') ? 1 : 3;
    text.remove_prefix(opening < text.size() ? opening : text.size());
    if (!closed) return text;
    const std::size_t closing = text.ends_with('"') ? 1 : 3;
    text.remove_suffix(closing < text.size() ? closing : text.size());
    return text;
}

// Text without what does not count in it: blanks around it, capitals (ASCII).

constexpr std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n") {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

inline std::string lowered(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = lower(c);
    return result;
}

inline std::string raised(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

// Words in sentences.

// "a" or "an", as is said before the name of a type or another word that letters spell: an int, a uint.
constexpr std::string_view article(std::string_view word) {
    return !word.empty() && std::string_view("aei").find(word[0]) != std::string_view::npos ? "an" : "a";
}

// Formats as "1 error", "2 errors" or "2 passes".
inline std::string counted(std::size_t count, std::string_view noun) {
    const char* const ending = count == 1 ? "" : noun.ends_with('s') ? "es" : "s";
    return std::to_string(count).append(" ").append(noun).append(ending);
}

}  // namespace snell

namespace snell::utf8 {

// Characters of text that should be UTF-8 but may be any bytes.

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
