// Commands of OpenGL and its helpers that the language lacks, and what does their work in a scene.
#pragma once

#include <string>
#include <string_view>

namespace snell {

// What to write for a statement of OpenGL ("glEnable GL_BLEND", "ShadeModel GL_FLAT"), or why there is nothing to
// write; empty for other words.
std::string help_for_opengl(std::string_view word, std::string_view argument);

}  // namespace snell
