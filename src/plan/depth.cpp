#include <algorithm>
#include <cmath>

#include "src/plan/plan.h"

namespace snell {

std::optional<DepthRange> fit_depth(std::span<const DepthBox> boxes) {
    const DepthRange usual;
    double nearest = HUGE_VAL, farthest = 0;
    for (const DepthBox& box : boxes)
        for (unsigned corner = 0; corner < 8; ++corner) {
            glm::dvec4 p(1);
            for (int axis = 0; axis < 3; ++axis) {
                const auto i = static_cast<std::size_t>(axis);
                p[axis] = static_cast<double>(corner >> i & 1 ? box.max[i] : box.min[i]);
            }
            const double depth = -(box.eye_from_model * p).z;
            if (!std::isfinite(depth)) return std::nullopt;
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    // The range is widened by 1 % on both sides to absorb rounding.
    const DepthRange fitted{std::max(usual.near, nearest * .99), std::min(usual.far, farthest * 1.01)};
    if (!(fitted.far > fitted.near)) return std::nullopt;
    return fitted;
}

}  // namespace snell
