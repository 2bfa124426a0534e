#include "src/plan/knobs.h"

#include <algorithm>
#include <cmath>

namespace snell {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>  // clang 14 cannot deduce it
Overloaded(Functions...)->Overloaded<Functions...>;

int scaled(int count, double factor) {
    return std::clamp(static_cast<int>(std::lround(count * factor)), 3, std::max(count, 2000));
}

// If the shape approximates a round one, multiplies its number of parts by `factor`; returns whether it does.
bool scale(Shape& shape, double factor) {
    const auto two = [factor](int& a, int& b) {
        a = scaled(a, factor);
        b = scaled(b, factor);
        return true;
    };
    return std::visit(
        Overloaded{[&](Sphere& s) { return two(s.slices, s.stacks); }, [&](Torus& s) { return two(s.sides, s.rings); },
                   [&](Cone& s) {
                       s.slices = scaled(s.slices, factor);
                       return true;
                   },
                   [&](Cylinder& s) {
                       s.slices = scaled(s.slices, factor);
                       return true;
                   },
                   [&](Disk& s) {
                       s.slices = scaled(s.slices, factor);
                       return true;
                   },
                   [&](Xarrow& s) {
                       s.n = scaled(s.n, factor);
                       return true;
                   },
                   [](auto&) { return false; }},
        shape);
}

}  // namespace

bool Knobs::same_plan(const Knobs& other) const {
    return tessellation == other.tessellation && filter == other.filter && cube_size == other.cube_size &&
           cube_bits == other.cube_bits;
}

Plan with_knobs(Plan plan, const Knobs& knobs) {
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
    return std::ranges::any_of(scene.draws, [](const Draw& draw) {
        Shape shape = draw.shape;
        return scale(shape, 1);
    });
}

bool has_textures(const Scene& scene) {
    return std::ranges::any_of(scene.textures, [](const Texture& texture) { return !texture.files.empty(); });
}

bool has_cube_maps(const Scene& scene) {
    return std::ranges::any_of(scene.textures,
                               [](const Texture& texture) { return texture.target == TextureTarget::cube; });
}

}  // namespace snell
