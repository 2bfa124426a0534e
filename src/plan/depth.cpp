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

}  // namespace snell
