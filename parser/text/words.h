// Words: compared without regard to case (ASCII), and split.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace snell {

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

}  // namespace snell
