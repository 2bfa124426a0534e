// Random damage to texts. The same numbers from the generator give the same damage on every machine.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace snell::torture {

using Random = std::mt19937;

// 0 … count - 1; 0 where there is nothing to choose from. The standard's distributions differ between libraries.
std::size_t below(Random& random, std::size_t count);

template <class T>
const T& choose(Random& random, const std::vector<T>& from) {
    return from.at(below(random, from.size()));
}

enum class Language { scene, shader };

// What damage is made with.
struct Dictionary {
    std::vector<std::string> scene_words, shader_words;  // each once, with their punctuation
    std::vector<std::string> scenes, shaders;            // whole texts, to be spliced
};

// Takes up the words and the text.
void learn(Dictionary& dictionary, Language language, const std::string& text);

// Names, numbers and single other characters of a text, without blanks.
std::vector<std::string> words_of(const std::string& text);

// Damages the text once, and says how. Texts don't grow beyond about a megabyte.
std::string damage(std::string& text, Language language, const Dictionary& dictionary, Random& random);

}  // namespace snell::torture
