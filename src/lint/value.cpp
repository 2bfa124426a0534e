#include "src/lint/value.h"

#include <algorithm>
#include <cmath>

namespace snell::lint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// inf - inf and 0 * inf are no bounds.
double bound(double v, double otherwise) { return std::isnan(v) ? otherwise : v; }

template <class T>
void keep_equal(T& a, const T& b) {
    if (!(a == b)) a = T{};
}

}  // namespace

Range sum(const Range& a, const Range& b) {
    return {bound(a.lo + b.lo, -infinity), bound(a.hi + b.hi, infinity), a.real_lo && b.real_lo,
            a.real_hi && b.real_hi};
}

Range negative(const Range& a) { return {-a.hi, -a.lo, a.real_hi, a.real_lo}; }

Range product(const Range& a, const Range& b, bool square) {
    if (square) {
        const double end = std::max(std::abs(a.lo), std::abs(a.hi));
        return {a.lo > 0 ? a.lo * a.lo : a.hi < 0 ? a.hi * a.hi : 0, end * end, false, false};
    }
    const double ends[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    if (std::any_of(std::begin(ends), std::end(ends), [](double v) { return std::isnan(v); })) {
        if (a.lo >= 0 && b.lo >= 0) return {0, infinity, false, false};
        return {};
    }
    const bool real = a.real_lo && a.real_hi && b.real_lo && b.real_hi;
    return {*std::min_element(std::begin(ends), std::end(ends)), *std::max_element(std::begin(ends), std::end(ends)),
            real, real};
}

Range larger(const Range& a, const Range& b) {
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi), a.lo > b.lo ? a.real_lo : b.real_lo,
            a.hi > b.hi ? a.real_hi : b.real_hi};
}

Range smaller(const Range& a, const Range& b) { return negative(larger(negative(a), negative(b))); }

Range either(const Range& a, const Range& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.real_lo && b.real_lo, a.real_hi && b.real_hi};
}

Varies together(Varies a, Varies b) {
    if (a == Varies::yes || b == Varies::yes) return Varies::yes;
    return a == Varies::no && b == Varies::no ? Varies::no : Varies::unknown;
}

Value either(const Value& a, const Value& b) {
    Value v = a;
    keep_equal(v.id, b.id);
    keep_equal(v.opposite, b.opposite);
    keep_equal(v.name, b.name);
    keep_equal(v.length, b.length);
    keep_equal(v.why, b.why);
    if (v.space == Space::any) v.space = b.space;
    if (b.space != Space::any) keep_equal(v.space, b.space);
    keep_equal(v.point, b.point);
    keep_equal(v.plain, b.plain);
    v.refracted = a.refracted || b.refracted;
    v.from_eye = a.from_eye && b.from_eye;
    keep_equal(v.mirrored, b.mirrored);
    keep_equal(v.mirrored_opposite, b.mirrored_opposite);
    keep_equal(v.from, b.from);
    keep_equal(v.to, b.to);
    v.range = either(a.range, b.range);
    keep_equal(v.difference, b.difference);
    if (a.uniform != b.uniform) v.uniform = -1;
    keep_equal(v.cosine, b.cosine);
    keep_equal(v.one_plus, b.one_plus);
    keep_equal(v.eta, b.eta);
    keep_equal(v.bend, b.bend);
    v.varies = a.varies == b.varies ? a.varies : Varies::unknown;
    return v;
}

bool spatial(const Value& v) {
    return v.length != Length::unknown || v.space == Space::object || v.space == Space::world || v.space == Space::eye;
}

}  // namespace snell::lint
