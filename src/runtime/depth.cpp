// Fits the near and far planes to the scene, so that surfaces that nearly touch do not fight over pixels.
#include <utility>
#include "src/plan/lens.h"

#include "src/runtime/impl.h"

namespace snell {

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
    const glm::dmat4 eye = frame.view.eye.matrix() * view_matrix(scene.cameras[camera]);
    const Lens lens = lens_of(scene.cameras[camera], frame.view.projection, eye);
    if (!lens.camera.perspective) return std::nullopt;
    if (frame.view.axes && axes)  // through the same camera
        boxes.push_back({lens.shift * runtime::about_origin(frame.view.scene, eye) * eye, axes->min, axes->max});
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
    const Lens lens = lens_of(camera, frame.view.projection, frame.view.eye.matrix() * view_matrix(camera));
    const glm::dmat4 p = projection_matrix(lens.camera, aspect, fitted_depth(frame));
    return (p[3][2] - ndc * p[3][3]) / (p[2][2] - ndc * p[2][3]);
}

}  // namespace snell
