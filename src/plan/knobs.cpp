#include "src/plan/knobs.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell {

namespace {

int scaled(int count, double factor) {
    return std::clamp(static_cast<int>(std::lround(count * factor)), 3, std::max(count, 2000));
}

// If the shape approximates a round one, multiplies its number of parts by `factor`; returns whether it does.
bool scale(Shape& shape, double factor) {
    bool any = false;
    const auto each = [&](auto& value, bool round) {
        any = any || round;
        if constexpr (std::is_same_v<decltype(value), int&>)
            if (round) value = scaled(value, factor);
    };
    std::visit([&](auto& kind) { for_each_field(kind, each); }, shape);
    return any;
}

}  // namespace

Plan with_knobs(Plan plan, const PlanKnobs& knobs) {
    if (knobs.tessellation != 1) {
        for (MeshRequest& mesh : plan.meshes) scale(mesh.shape, knobs.tessellation);
        for (Draw& draw : plan.scene.draws) scale(draw.shape, knobs.tessellation);
    }
    for (Texture& texture : plan.scene.textures) {
        if (knobs.filter && !texture.files.empty()) texture.filter = *knobs.filter;
        if (texture.target != TextureTarget::cube || texture.computed != Computed::no) continue;
        if (knobs.cube_size > 0) texture.size[0] = knobs.cube_size;
        if (knobs.cube_bits > 0) texture.bits = knobs.cube_bits;
    }
    return plan;
}

bool has_round_shapes(const Scene& scene) {
    return ranges::any_of(scene.draws, [](const Draw& draw) {
        Shape shape = draw.shape;
        return scale(shape, 1);
    });
}

bool has_textures(const Scene& scene) {
    return ranges::any_of(scene.textures, [](const Texture& texture) { return !texture.files.empty(); });
}

bool has_cube_maps(const Scene& scene) {
    return ranges::any_of(scene.textures, [](const Texture& texture) { return texture.target == TextureTarget::cube; });
}

}  // namespace snell
