// Sets every uniform of a program to a value that depends on its name alone, or on what the system says.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "src/glsl/glsl.h"

namespace snell::oracle {

glm::dmat4 model_view();
glm::dmat4 projection();
glm::dmat4 texture_matrix();

// Units: 0, 1, 4 … 7 pictures of every kind, 2 and 3 noise, 8 a depth texture.
inline constexpr int shadow_unit = 8;
inline constexpr int units = 9;

// Of the program in use. Those named in `own` are left as they are.
void set_uniforms(unsigned program, const std::vector<glsl::UniformDefault>& own);

}  // namespace snell::oracle
