// Where meshes lie in the view: near and far planes that fit the scene, so that surfaces that nearly touch do not fight
// over pixels, and draws that are outside of the frustum, which are not handed to the driver.
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/view.h"
#include "src/runtime/impl.h"

namespace snell {

using runtime::ReadyPass;

namespace {

// Frames may be shifted by as much without another answer of out_of_view().
constexpr double most_shift = 1;

}  // namespace

std::optional<DepthRange> Runtime::Impl::fitted_depth(const Frame& frame) const {
    View view = frame.view;
    view.texture = {};  // moves nothing
    view.mouse_x = view.mouse_y = 0;
    if (!fitted || fitted->view != view) fitted = {std::move(view), fit(frame)};
    return fitted->planes;
}

std::optional<DepthRange> Runtime::Impl::fit(const Frame& frame) const {
    const Scene& scene = plan.scene;
    PassView view;  // of whatever size
    std::vector<DepthBox> boxes;
    Index camera = none;
    for (const runtime::ReadyDraw* item : window_draws()) {
        const Draw& draw = scene.draws[item->draw];
        const runtime::GpuMesh& mesh = *meshes[item->mesh];
        if (camera == none) camera = draw.camera;
        if (!item->program->plain_depth || mesh.has_w || draw.camera != camera) return std::nullopt;
        const runtime::DrawContext& c = context(item->draw, frame, view);
        boxes.push_back({c.scene * c.view * c.model, mesh.min, mesh.max});
    }
    if (boxes.empty()) return std::nullopt;
    const glm::dmat4 eye = eye_from_world(scene.cameras[camera], frame.view);
    const Lens lens = lens_of(scene.cameras[camera], frame.view.projection, eye);
    if (!lens.camera.perspective) return std::nullopt;
    if (frame.view.axes && axes)  // through the same camera
        boxes.push_back(
            {lens.shift * about_origin(frame.view.scene, scene.cameras[camera], eye) * eye, axes->min, axes->max});
    return fit_depth(boxes);
}

std::vector<const runtime::ReadyDraw*> Runtime::Impl::window_draws() const {
    std::vector<const runtime::ReadyDraw*> draws;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const auto& item : passes[pass].items)
            if (item && plan.scene.passes[pass].kind == Pass::Kind::window) draws.push_back(&*item);
    return draws;
}

Runtime::Drawn Runtime::Impl::drawn(const Frame& frame) const {
    const Scene& scene = plan.scene;
    const std::vector<const runtime::ReadyDraw*> draws = window_draws();
    Drawn result;
    if (draws.empty()) return result;
    const Index camera = scene.draws[draws.back()->draw].camera;
    result.first = draws.front()->draw;
    result.camera = scene.cameras[camera];
    PassView view;
    for (const runtime::ReadyDraw* item : draws) {
        if (scene.draws[item->draw].camera != camera) continue;
        const runtime::DrawContext& c = context(item->draw, frame, view);
        const runtime::GpuMesh& mesh = *meshes[item->mesh];
        result.boxes.push_back({c.scene * c.view * c.model, mesh.min, mesh.max});
    }
    return result;
}

// This inverts the projection: the result is the distance that it maps to this depth.
double Runtime::Impl::distance(Index draw, double depth, const Frame& frame, const Surface& surface) const {
    const double aspect = static_cast<double>(surface.width) / surface.height, ndc = 2 * depth - 1;
    const Camera& camera = plan.scene.cameras[plan.scene.draws[draw].camera];
    const Lens lens = lens_of(camera, frame.view.projection, eye_from_world(camera, frame.view));
    const glm::dmat4 p = projection_matrix(lens.camera, aspect, fitted_depth(frame));
    return (p[3][2] - ndc * p[3][3]) / (p[2][2] - ndc * p[2][3]);
}

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
    if (!ready.program->in_place || mesh.has_w || !mesh.bounded || (points && raster.point_size_mode)) return false;
    // The driver may or may not clip lines and points by their middle. One more pixel is for its rounding.
    const double pixels = (points ? raster.point_size : raster.line_width) / 2 + most_shift + 1;
    const runtime::DrawContext& c = context(ready.draw, frame, view);
    return snell::out_of_view({c.view * c.model, mesh.min, mesh.max}, c.projection,
                              {2 * pixels / view.width, 2 * pixels / view.height});
}

std::vector<runtime::Reader> Runtime::Impl::readers_of(Index pass) const {
    std::vector<runtime::Reader> readers;
    for (const Index rendered : passes[pass].textures)
        for (Index other = 0; other < passes.size(); ++other) {
            if (!passes[other].live) continue;
            // Textures that two passes draw to hold what both left there.
            if (other != pass && ranges::count(passes[other].textures, rendered) > 0) readers.push_back({pass, 0});
            const auto& items = passes[other].items;
            for (std::size_t item = 0; item < items.size(); ++item)
                if (items[item] && reads(*items[item], rendered)) readers.push_back({other, item});
        }
    return readers;
}

void Runtime::Impl::find_needed(const Frame& frame, const PassView& window) {
    for (Index pass = static_cast<Index>(passes.size()); pass-- > 0;) {
        ReadyPass& ready = passes[pass];
        if (!savings || !ready.live || plan.scene.passes[pass].kind == Pass::Kind::window) continue;
        if (!ready.readers) ready.readers = readers_of(pass);
        ready.needed = ranges::any_of(*ready.readers, [&](const runtime::Reader& reader) {
            if (reader.pass <= pass) return true;  // it reads what the frame before has left
            if (plan.scene.passes[reader.pass].kind != Pass::Kind::window) return passes[reader.pass].needed;
            const std::vector<bool>* out = out_of_view(reader.pass, frame, window);
            return !out || !(*out)[reader.item];
        });
    }
}

bool Runtime::Impl::due(Index pass, bool standing) {
    ReadyPass& ready = passes[pass];
    if (standing) return ready.needed && ready.stale;
    if (!ready.needed) ready.stale = true;
    return ready.needed;
}

}  // namespace snell
