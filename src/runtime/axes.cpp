// White axes of length 1.5 with their letters, about three pixels wide, turning with the scene.
#include "src/plan/lens.h"
#include "src/runtime/impl.h"

namespace snell {

namespace {

using Point = std::array<float, 3>;

content::Mesh axes_mesh() {
    content::Mesh mesh;
    mesh.topology = Topology::lines;
    const auto line = [&mesh](Point a, Point b) {
        for (const Point& p : {a, b}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(p);
        }
    };
    constexpr float length = 1.5F, gap = 1.6F, half = .05F, high = .1F;
    line({0, 0, 0}, {length, 0, 0});
    line({0, 0, 0}, {0, length, 0});
    line({0, 0, 0}, {0, 0, length});
    line({gap - half, -high, 0}, {gap + half, high, 0});  // X
    line({gap - half, high, 0}, {gap + half, -high, 0});
    line({-half, gap + 2 * high, 0}, {0, gap + high, 0});  // Y
    line({half, gap + 2 * high, 0}, {0, gap + high, 0});
    line({0, gap + high, 0}, {0, gap, 0});
    line({-half, high, gap}, {half, high, gap});  // Z
    line({half, high, gap}, {-half, -high, gap});
    line({-half, -high, gap}, {half, -high, gap});
    mesh.compute_bounds();
    return mesh;
}

}  // namespace

void Runtime::Impl::ready_axes() {
    if (!axes) axes = runtime::upload(axes_mesh());
}

void Runtime::Impl::draw_axes(const Frame& frame, const Surface& surface) {
    runtime::aim(surface);
    const Camera camera = window_camera(plan.scene);
    runtime::DrawContext context;
    context.view = eye_from_world(camera, frame.view);
    const Lens lens = lens_of(camera, frame.view.projection, context.view);
    context.scene = lens.shift * about_origin(frame.view.scene, camera, context.view);
    context.width = surface.width;
    context.height = surface.height;
    const double aspect = static_cast<double>(surface.width) / surface.height;
    context.projection = projection_matrix(lens.camera, aspect, fitted_depth(frame)) * context.scene;
    state.forget();
    RasterState raster;
    raster.line_width = context.line_width = 3;
    const runtime::Variant variant{false, caps.max_line_width < 3};
    auto& slot = programs[{none, variant}];
    if (!slot) slot = runtime::link_builtin(variant, caps, store.get(), counters);
    runtime::LinkedProgram& builtin = *slot;
    state.raster(raster, true);
    state.program(builtin.program.get());
    counters.uniform_uploads += static_cast<std::uint64_t>(runtime::set_system(builtin, context));
    state.vertex_array(axes->array.get());
    state.color({1, 1, 1, 1});
    glDrawElements(GL_LINES, static_cast<GLsizei>(axes->count), GL_UNSIGNED_INT, nullptr);
    ++counters.draws;
}

}  // namespace snell
