// Which scene a shader belongs to.
#pragma once

#include <string>

namespace snell::language {

// A scene that names the shader, or a text that includes it: in the shader's folder, the ones above, and the ones
// below, all as they are on disk. Returns "" if there is none among the first hundred. Scenes whose text names the
// shader are preferred.
std::string find_scene(const std::string& shader_path);

}  // namespace snell::language
