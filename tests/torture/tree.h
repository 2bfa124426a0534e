// The scenes and shaders of this repository as something to be damaged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/torture/mutate.h"

namespace snell::torture {

// Paths are relative to the folder that the tree was copied to.
struct Subject {
    std::string scene;
    std::vector<std::string> texts;  // the scene first, then all that it names: scenes, shaders, meshes
    std::vector<std::string> bytes;  // pictures and shapes that it names
};

struct Tree {
    std::vector<std::vector<Subject>> kinds;  // scenes/, tests/cases, tests/odd with tests/bad, tests/glsl
    Dictionary dictionary;
};

// Copies scenes/ and the tests' scenes and shaders from the repository into `folder`. Programs of tests/glsl get a
// scene around them.
void copy_tree(const std::string& root, const std::string& folder);
Tree read_tree(const std::string& folder);

struct Change {
    std::string file, text;  // the whole text
};

struct Mutant {
    std::string scene;
    std::vector<Change> changes;
    std::vector<std::string> options;  // of snell render
    double timeout = 20;               // that they ask for
    std::string output = "o.png";
    std::string how;  // what was done
};

// Mutant number `number` of a series.
Mutant make_mutant(const Tree& tree, const std::string& folder, std::uint32_t seed, std::uint32_t number);

void write_file(const std::string& path, const std::string& text);

}  // namespace snell::torture
