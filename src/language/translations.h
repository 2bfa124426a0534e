// The programs of a project, translated as for a driver, without one.
#pragma once

#include <vector>

#include "src/language/project.h"

namespace snell::language {

// In the order of the programs, for an OpenGL that has everything.
std::vector<glsl::Options> options_of(const Plan& plan, const glsl::IncludeReader& include);
glsl::Translation translate_program(Project& project, Index program, const glsl::Options& options);
// Reports values of Program lines that do not fit the uniforms that the shaders declare.
void report_values(Project& project);

}  // namespace snell::language
