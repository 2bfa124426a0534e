// What is known of a stage's values without a driver: which a driver may find constant by the text, and which are sure
// while uniforms are settled.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl::folding {

struct Fold {
    // By the text alone.
    enum class Kind : unsigned char { live, constant };
    Kind kind = Kind::live;
    bool zero = false;                                        // a constant of which a component may be 0
    double value = std::numeric_limits<double>::quiet_NaN();  // of a scalar constant, where known
    bool cancels = false;  // made of what a driver drops with its inverse, as in exp2(log2(x)), where x may be negative

    // In every run of the stage, while the settled uniforms have their values.
    enum class Sure : unsigned char { nothing, number, anything };  // never given; always the same; not known
    Sure sure = Sure::anything;
    Base base = Base::unknown;
    double number = 0;
    bool exact = true;                                      // not rounded
    double most = std::numeric_limits<double>::infinity();  // no component is larger: surely neither infinite nor NaN
    std::uint64_t from = 0;                                 // the uniforms that it is known by, as bits
};

// Of a uniform that may be settled.
Fold free_number(Base base);
// Of a value that is not settled, but no component of which is larger.
Fold bounded(double most, std::uint64_t from);
// As GLSL writes the number, to the last bit of a float; empty if no text gives it on every driver.
std::string number_text(Base base, double value);
// Of a settled number or truth value.
Fold settled_number(Base base, double value, std::uint64_t from);

struct Decided {
    std::vector<bool> stay;         // by Unit::marks
    std::vector<std::string> text;  // what is there instead of an operand; empty: Mark::function is called
    std::uint64_t from = 0;         // the uniforms that decided
    bool possible = false;          // values of uniforms could
};

// The settled uniforms of which the sign of a zero may be seen, as 1 / -0 is another infinity than 1 / 0.
std::uint64_t signs(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                    std::map<std::string_view, Fold>& passed);

// Which marks of the unit stay. `signs`: of all units; what they leave out by a weight of 0 keeps no sign. `free`:
// uniforms that may be settled, whether they are or not. `passed`: what is known of the stage's inputs; of its outputs
// when this returns.
Decided decide(const Unit& unit, const std::map<std::string_view, Fold>& settled,
               const std::map<std::string_view, Fold>& free, std::uint64_t signs,
               std::map<std::string_view, Fold>& passed);

}  // namespace snell::glsl::folding
