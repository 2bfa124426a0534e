// Draws whose meshes are outside of the frustum are not handed to the driver.
#include <cmath>

#include "src/runtime/impl.h"

namespace snell {

namespace {

// Frames may be shifted by as much without another answer.
constexpr double most_shift = 1;

}  // namespace

// Returns null if all items must be drawn. What it returns changes with the view, the size and the depth range only.
const std::vector<bool>* Runtime::Impl::out_of_view(Index pass, const Frame& frame, const PassView& view) {
    if (!savings || std::abs(view.shift[0]) > most_shift || std::abs(view.shift[1]) > most_shift) return nullptr;
    runtime::OutOfView& known = passes[pass].out_of_view[view.face];
    runtime::OutOfView::Sight sight{frame.view.scene, frame.view.eye, frame.view.objects, frame.view.projection,
                                    view.width,       view.height,    view.depth};
    if (known.sight != sight) {
        PassView still = view;
        still.shift = {};
        known.items.clear();
        for (const auto& item : passes[pass].items) known.items.push_back(item && out_of_view(*item, frame, still));
        known.sight = std::move(sight);
    }
    return &known.items;
}

bool Runtime::Impl::out_of_view(const runtime::ReadyDraw& ready, const Frame& frame, PassView& view) const {
    const runtime::GpuMesh& mesh = *meshes[ready.mesh];
    const RasterState& raster = plan.scene.rasters[plan.scene.draws[ready.draw].raster];
    const bool points = mesh.topology == Topology::points;
    if (!ready.program->in_place || mesh.has_w || (points && raster.point_size_mode)) return false;
    // The driver may or may not clip lines and points by their middle. One more pixel is for its rounding.
    const double pixels = (points ? raster.point_size : raster.line_width) / 2 + most_shift + 1;
    const runtime::DrawContext& c = context(ready.draw, frame, view);
    return snell::out_of_view({c.view * c.model, mesh.min, mesh.max}, c.projection,
                              {2 * pixels / view.width, 2 * pixels / view.height});
}

}  // namespace snell
