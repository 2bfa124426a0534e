// What is known of a value without running the shader. Everything unknown is the default.
#pragma once

#include <limits>
#include <string_view>

#include "src/glsl/read/token.h"

namespace snell::lint {

enum class Length : std::uint8_t { unknown, unit, other };
enum class Why : std::uint8_t { none, interpolated, position, sum };  // of Length::other
enum class Space : std::uint8_t { unknown, any, object, world, eye };
enum class Varies : std::uint8_t { unknown, no, yes };  // between the fragments of one draw

// Bounds of every component. A bound is `real` where values near it do occur; else it is only not exceeded.
struct Range {
    double lo = -std::numeric_limits<double>::infinity(), hi = std::numeric_limits<double>::infinity();
    bool real_lo = false, real_hi = false;
    bool operator==(const Range&) const = default;
};

inline Range exactly(double v) { return {v, v, true, true}; }
inline Range between(double lo, double hi) { return {lo, hi, true, true}; }
Range sum(const Range& a, const Range& b);
Range negative(const Range& a);
Range product(const Range& a, const Range& b, bool square);
Range larger(const Range& a, const Range& b);
Range smaller(const Range& a, const Range& b);
Range either(const Range& a, const Range& b);

// sign * dot(first, second), of vectors by identity.
struct Cosine {
    int first = 0, second = 0, sign = 0;
    bool operator==(const Cosine&) const = default;
};

// refract() with eta = base + shift, base by identity.
struct Bend {
    int base = 0;
    double shift = 0;
    int first = -1, last = -1;  // tokens of the eta that refract() was given
    bool operator==(const Bend& o) const { return base == o.base && shift == o.shift; }
};

// The difference of two things that no constant is among, perhaps times or over what keeps one sign.
struct Difference {
    int first = -1, last = -1;  // tokens
    bool turned = false;        // its negative
    bool operator==(const Difference&) const = default;
};

struct Value {
    glsl::Type type;
    int id = 0;             // equal for copies of one value
    int opposite = 0;       // the id that this is the negative of
    std::string_view name;  // of the varying or attribute that it came from

    // vectors
    Length length = Length::unknown;
    Why why = Why::none;
    Space space = Space::unknown;
    bool point = false;      // a position, or the direction to it from the origin of its space
    bool plain = false;      // not multiplied by anything that was computed
    bool refracted = false;  // made from a result of refract()
    bool from_eye = false;   // a result of reflect() or refract() of a position in eye coordinates
    int mirrored = 0;        // the direction that reflect() was given, by id
    int mirrored_opposite = 0;

    // matrices
    Space from = Space::unknown, to = Space::unknown;

    // numbers
    Range range;
    Difference difference;
    int uniform = -1;         // it is that uniform itself: Unit::globals
    Cosine cosine, one_plus;  // it is such a cosine; 1 plus such a cosine
    Bend eta, bend;           // it is such an eta; a direction or a colour got with such an eta

    Varies varies = Varies::unknown;
};

// What is known when it may be either.
Value either(const Value& a, const Value& b);
Varies together(Varies a, Varies b);
// A direction or a position, as far as is known; a colour is not.
bool spatial(const Value& v);

}  // namespace snell::lint
