// Matrices that hard scenes must not break.
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <limits>

#include "parser/scene.h"

namespace snell {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

template <class Matrix>
bool all_finite(const Matrix& m) {
    for (int c = 0; c < Matrix::length(); ++c)
        for (int r = 0; r < Matrix::col_type::length(); ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

// Largest entry of MᵀM - I; NaN stays NaN.
template <class Matrix>
double rigidity(const Matrix& view) {
    const glm::dmat3 r(view), d = glm::transpose(r) * r - glm::dmat3(1);
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(d[c][k]) <= worst) && !std::isnan(worst)) worst = std::abs(d[c][k]);
    return worst;
}

inline Camera looking(Vec3 eye, Vec3 center, Vec3 up) {
    Camera camera;
    camera.look_at = {eye, center, up};
    return camera;
}

}  // namespace snell
