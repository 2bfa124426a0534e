// Which operands a driver may find constant because settled uniforms are.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl::run {

struct Fold {
    enum class Kind : unsigned char {
        live,      // it differs between vertices or pixels, or is not known to be constant
        constant,  // by the text alone
        settled,   // if the uniforms are constants
    };
    Kind kind = Kind::live;
    bool zero = false;                                        // a constant of which a component may be 0
    double value = std::numeric_limits<double>::quiet_NaN();  // of a scalar constant, where known
};

// By Unit::marks, whether the mark stays. `passed`: what is known of the stage's inputs; of its outputs when this
// returns.
std::vector<bool> marks_that_stay(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                                  std::map<std::string_view, Fold>& passed);

}  // namespace snell::glsl::run
