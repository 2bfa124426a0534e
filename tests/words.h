// Rows of a test as one text.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace snell {

// The parts of the text between the separators.
inline std::vector<std::string> words(const std::string& text, char between = ' ') {
    std::vector<std::string> out;
    std::istringstream from(text);
    for (std::string word; std::getline(from, word, between);) out.push_back(word);
    return out;
}

}  // namespace snell
