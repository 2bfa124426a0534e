// Near and far planes as tight as the scene allows, so that surfaces that nearly touch do not fight over pixels.
#include <utility>

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
    for (Index pass = 0; pass < passes.size(); ++pass) {
        if (scene.passes[pass].kind != Pass::Kind::window) continue;
        for (const auto& item : passes[pass].items) {
            if (!item) continue;
            const Draw& draw = scene.draws[item->draw];
            const runtime::GpuMesh& mesh = *meshes[item->mesh];
            if (camera == none) camera = draw.camera;
            if (!item->program->plain_depth || mesh.has_w || draw.camera != camera) return std::nullopt;
            const runtime::DrawContext& c = context(draw, frame, view);
            boxes.push_back({c.scene * c.view * c.model, mesh.min, mesh.max});
        }
    }
    if (boxes.empty() || !scene.cameras[camera].perspective) return std::nullopt;
    if (frame.view.axes && axes) {
        const glm::dmat4 eye = frame.view.eye.matrix() * view_matrix(axes_camera());
        boxes.push_back({runtime::about_origin(frame.view.scene, eye) * eye, axes->min, axes->max});
    }
    return fit_depth(boxes);
}

}  // namespace snell
