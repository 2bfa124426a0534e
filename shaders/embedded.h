// The files of shaders/, embedded when snell is built.
#pragma once

#include <string_view>

namespace snell {

// By path below shaders/ ("builtin/color.vert"); empty when there is no such file.
std::string_view embedded_shader(std::string_view path);

}  // namespace snell
