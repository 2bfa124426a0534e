// Which operands a driver may find constant because settled uniforms are.
#pragma once

#include <array>
#include <cstdint>
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
    std::uint64_t from = 0;                                   // uniforms that take part, as bits
    double gain = 0;                                          // the largest number that multiplies it
};

// Uniforms, as bits of Fold::from, that must not become constants: the result of `fract` and the like would not be
// nearly the same (a hash multiplies by 43758), or an index that is out of bounds another element.
std::uint64_t touchy(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                     std::map<std::string_view, Fold>& passed);

// By Unit::marks, whether the mark stays: for divisors that the text alone makes 0, and where settled uniforms count.
// `passed`: what is known of the stage's inputs; of its outputs when this returns.
std::vector<bool> marks_that_stay(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                                  std::map<std::string_view, Fold>& passed);

}  // namespace snell::glsl::run
