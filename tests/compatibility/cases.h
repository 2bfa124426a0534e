// Programs to be drawn twice: untouched and translated.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "src/glsl/glsl.h"

namespace snell::oracle {

using Files = std::map<Stage, std::filesystem::path>;

struct Case {
    std::string name;
    Files files;
    Files modern;  // the equivalent for a core profile; empty: there is none
};

// The programs of tests/glsl: NAME.vert, NAME.frag …; plain.vert and plain.frag fill what NAME lacks.
std::vector<Case> cases_of_folder(const std::filesystem::path& folder);
// The programs that a scene makes; those with missing files are left out.
std::vector<Case> cases_of_scene(const std::filesystem::path& scene);
// Every stem.frag of a folder, with stem.vert or else the folder's only vertex shader.
std::vector<Case> pairs_of_folder(const std::filesystem::path& folder);

using Texts = std::map<Stage, std::string>;
Texts texts(const Files& files);

// What the shaders themselves say about how they are to be drawn.
struct Needs {
    unsigned primitive = 0;  // GL_TRIANGLES …
    int patch_vertices = 3;
    int targets = 1;
    bool two_sided = false;
    std::string geometry_input, geometry_output;
};
Needs needs(const Texts& texts);

struct Translated {
    bool ok = false;
    Texts texts;
    glsl::Translation translation;
    std::string messages;  // rendered diagnostics
    Diagnostics diagnostics;
};
Translated translated(const Case& which, const glsl::Target& target);

// Where failing programs' translations are kept to be looked at: a folder of this user's.
std::filesystem::path kept_texts();
// The file's name without its extension.
std::filesystem::path write_texts(const std::string& name, const Texts& texts,
                                  const std::filesystem::path& folder = kept_texts());

}  // namespace snell::oracle
