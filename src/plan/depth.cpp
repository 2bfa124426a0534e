#include <algorithm>
#include <cmath>

#include "src/plan/plan.h"

namespace snell {

std::array<glm::dvec3, 8> DepthBox::corners() const {
    std::array<glm::dvec3, 8> result;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto at = [&](unsigned i) { return static_cast<double>((corner >> i & 1) != 0 ? max[i] : min[i]); };
        result[corner] = glm::dvec3(eye_from_model * glm::dvec4(at(0), at(1), at(2), 1));
    }
    return result;
}

std::optional<DepthRange> fit_depth(std::span<const DepthBox> boxes) {
    const DepthRange usual;
    double nearest = HUGE_VAL, farthest = 0;
    for (const DepthBox& box : boxes)
        for (const glm::dvec3& corner : box.corners()) {
            if (!std::isfinite(corner.z)) return std::nullopt;
            nearest = std::min(nearest, -corner.z);
            farthest = std::max(farthest, -corner.z);
        }
    // The range is widened by 1 % on both sides to absorb rounding.
    const DepthRange fitted{std::max(usual.near, nearest * .99), std::min(usual.far, farthest * 1.01)};
    if (!(fitted.far > fitted.near)) return std::nullopt;
    return fitted;
}

bool out_of_view(const DepthBox& box, const glm::dmat4& clip_from_eye, const glm::dvec2& margin) {
    // Of the sum of absolute values: about 80 times the rounding error of a float.
    constexpr double rounding = 1e-5;
    const glm::dvec3 low(box.min[0], box.min[1], box.min[2]), high(box.max[0], box.max[1], box.max[2]);
    const glm::dvec3 middle = (low + high) / 2., half = (high - low) / 2.;
    const glm::dmat4& eye = box.eye_from_model;
    const glm::dvec4 at = eye * glm::dvec4(middle, 1);
    glm::dvec4 size = glm::abs(eye[3]);
    for (int axis = 0; axis < 3; ++axis) size += glm::abs(eye[axis]) * (std::abs(middle[axis]) + half[axis]);
    const glm::dmat4 rows = glm::transpose(clip_from_eye);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec4 w = rows[3] * (axis < 2 ? 1 + margin[axis] : 1.);
        const double error = rounding * glm::dot(glm::abs(w) + glm::abs(rows[axis]), size);
        for (const double side : {-1., 1.}) {
            const glm::dvec4 inwards = w + side * rows[axis];
            double most = glm::dot(inwards, at);
            for (int k = 0; k < 3; ++k) most += std::abs(glm::dot(inwards, eye[k])) * half[k];
            if (most < -error) return true;  // all corners are beyond one plane, and so is everything between them
        }
    }
    return false;
}

}  // namespace snell
