// What kinds of statements editors show.
#pragma once

#include "parser/commands/commands.h"

namespace snell::language {

inline bool begins_pass(const Command& command) { return command.name.starts_with("RenderTo"); }

inline bool binds_texture(const Command& command) {
    return command.name.starts_with("Texture") || command.name == "CubeMap" || command.name == "Irradiance" ||
           command.name == "Prefilter";
}

inline bool draws(const Command& command) {
    return command.group == "Geometry" && command.name != "NumPatchVertices" &&
           (!command.name.starts_with("gl") || command.name == "glBegin");
}

}  // namespace snell::language
