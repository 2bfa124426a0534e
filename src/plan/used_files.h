// Lists the files that a scene may read, so that nothing is written over them.
#pragma once

#include <string>
#include <vector>

#include "src/plan/plan.h"

namespace snell {

// Returns the paths of everything that `files` has read, and of all meshes, textures, noise and included shaders that
// the plan names, whatever its rungs are. Includes in comments and in branches that are never compiled count, too.
std::vector<std::string> used_files(const Plan& plan, const Sources& sources, const Files& files);

}  // namespace snell
