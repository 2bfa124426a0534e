// The files that a scene may read, found without compiling.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/plan/plan.h"

namespace snell {

struct ShaderText {
    std::string path;
    std::string_view text;
};

// Returns the stages of the program first, then each included file once. Includes in comments and in branches that are
// never compiled count, too; a file that cannot be read has an empty text. The texts live as long as `sources` and
// `reader`.
std::vector<ShaderText> shader_texts(const PlannedProgram& program, const Sources& sources, Files& reader);

// For callers that must not write over any of them: returns the paths of everything that `files` has read, and of all
// meshes, textures, noise and included shaders that the plan names, whatever its rungs are. Includes in comments and in
// branches that are never compiled count, too.
std::vector<std::string> used_files(const Plan& plan, const Sources& sources, const Files& files);

}  // namespace snell
