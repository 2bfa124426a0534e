#include "src/app/open/in_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/document/view_text.h"
#include "src/gl/target.h"
#include "src/plan/show.h"

namespace snell::app {

namespace {

constexpr int longest_side = 128;  // pixels, of the pictures that are tried

// Returns the first view that shows something, as the value of --view; "" if none does.
std::string view_that_shows(Runtime& runtime, const Frame& frame, const Runtime::Drawn& drawn, int width, int height) {
    const double scale = std::min(1., static_cast<double>(longest_side) / std::max(width, height));
    const int w = std::max(1, static_cast<int>(width * scale)), h = std::max(1, static_cast<int>(height * scale));
    const gl::Target target = gl::make_target(w, h, 1);
    if (!target.framebuffer) return {};
    for (const View& view : views_to_try(drawn.boxes, drawn.camera, frame.view)) {
        bool reached = false;
        Frame tried{
            .time = frame.time, .view = view, .controls = frame.controls, .standing = true, .reached = &reached};
        runtime.draw(tried, {.framebuffer = target.framebuffer.get(), .width = w, .height = h});
        if (reached) return view_text(view);
    }
    return {};
}

}  // namespace

Diagnostics nothing_in_view(Document& document, const Frame& frame, int width, int height) {
    Diagnostics result;
    Runtime& runtime = *document.runtime;
    const Runtime::Drawn drawn = runtime.drawn(frame);
    if (drawn.first == none) {
        if (document.diagnostics.has_errors()) return result;  // the errors say why
        const bool elsewhere = !runtime.scene().draws.empty();
        result.warning("nothing-drawn", elsewhere ? "nothing is drawn to the window" : "the scene draws nothing",
                       elsewhere ? "'RenderToTexture' without arguments returns to the window"
                                 : "a command such as 'Sphere 1' draws with the Program before it");
        return result;
    }
    const std::string view = view_that_shows(runtime, frame, drawn, width, height);
    const bool at_origin = !drawn.camera.look_at;
    std::string help = "what is drawn lies outside of the picture or is discarded, culled or hidden";
    if (!view.empty()) help = fmt::format("'--view {}' shows it", view);
    if (!view.empty() && at_origin)
        help +=
            "; the scene has no LookAt, so the eye is at the origin and looks to -Z: 'LookAt' or 'Translate' places it";
    result.warning("nothing-in-view", runtime.scene().draws[drawn.first].span,
                   "nothing is in view: no fragment of any draw reached the picture", help);
    return result;
}

}  // namespace snell::app
