#include "src/plan/view.h"

#include <cmath>

namespace snell {
namespace {

struct SinCos {
    double sin, cos;
};

// Takes degrees and reduces them before the conversion to radians, so that 1e9 degrees lose no accuracy and multiples
// of 90 are exact.
SinCos sin_cos(double degrees) {
    if (!std::isfinite(degrees)) return {0, 1};
    const double reduced = std::remainder(degrees, 360.);
    const double quarter = std::nearbyint(reduced / 90.);
    const double rest = (reduced - 90. * quarter) * (3.14159265358979323846 / 180.);
    const double s = std::sin(rest), c = std::cos(rest);
    switch ((static_cast<int>(quarter) + 4) % 4) {
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        case 3:
            return {-c, s};
        default:
            return {s, c};
    }
}

double finite_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

}  // namespace

glm::dmat4 Transformation::matrix() const {
    const auto [sx, cx] = sin_cos(rotate_x);
    const auto [sy, cy] = sin_cos(rotate_y);
    const auto [sz, cz] = sin_cos(rotate_z);
    const double s = finite_or(scale, 1);
    // The rotation is Ry · Rx: the turn about the screen's Y acts on the result of the turn about X.
    const glm::dvec4 right(s * cy, 0, s * -sy, 0), up(s * sy * sx, s * cx, s * cy * sx, 0);
    return {cz * right + sz * up, cz * up - sz * right, glm::dvec4(s * sy * cx, s * -sx, s * cy * cx, 0),
            glm::dvec4(finite_or(x, 0), finite_or(y, 0), finite_or(z, 0), 1)};
}

}  // namespace snell
