// Which operands a driver may find constant because settled uniforms are.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl::run {

enum class Fold : unsigned char {
    live,      // it differs between vertices or pixels, or is not known to be constant
    constant,  // by the text alone
    settled,   // if the uniforms are constants
};

// By Unit::marks, whether the mark stays. `settled`: names of uniforms. `passed`: what is known of the stage's inputs;
// of its outputs when this returns.
std::vector<bool> marks_that_stay(const Unit& unit, const std::set<std::string_view>& settled,
                                  std::map<std::string_view, Fold>& passed);

}  // namespace snell::glsl::run
