// How names of types stand in sentences.
#pragma once

#include <string_view>

namespace snell {

// "a" or "an", as is said before the name of a type or another word that letters spell: an int, a uint.
constexpr std::string_view article(std::string_view word) {
    return !word.empty() && std::string_view("aei").find(word[0]) != std::string_view::npos ? "an" : "a";
}

}  // namespace snell
