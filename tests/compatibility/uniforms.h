// Sets every uniform of a program to a value that depends on its name alone, or on what the system says.
#pragma once

#include <glm/glm.hpp>

#include "src/glsl/glsl.h"

namespace snell::oracle {

glm::dmat4 model();
glm::dmat4 view();
glm::dmat4 model_view();
glm::dmat4 projection();
glm::dmat4 texture_matrix();

// Units: 0 to 7 have a picture of every kind, 2 and 3 stand for noise, 8 is a depth texture.
inline constexpr int shadow_unit = 8;
inline constexpr int units = 9;

// Of the program in use, which may be the translation or what was translated. Initialised uniforms are left
// alone, or set to the values that the translation gives where the context knows no initialisers.
void set_uniforms(unsigned program, const glsl::Translation& translation, bool set_defaults);

}  // namespace snell::oracle
