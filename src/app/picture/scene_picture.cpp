#include "src/app/picture/scene_picture.h"

#include "src/app/picture/picture.h"
#include "src/document/document.h"
#include "src/gl/target.h"

namespace snell::app {

std::optional<content::Image> scene_picture(const std::string& scene, const ScenePicture& wanted, const gl::Caps& caps,
                                            std::string& messages) {
    Diagnostics wrong;
    const auto choose = [&](const Scene& read, Rungs& rungs) {
        for (const std::string& rung : wanted.ladders) choose_rung(rungs, read, rung, wrong);
    };
    const auto document =
        open_document(scene, caps, choose, nullptr, {}, access_to(scene, wanted.access, wanted.grade));
    messages += render(document->diagnostics, document->sources);
    if (!document->runtime) return std::nullopt;
    Controls controls = document->controls;
    for (const std::string& set : wanted.sets) set_control(controls, document->scene(), set, wrong);
    messages += render(wrong, document->sources);
    if (document->diagnostics.has_errors() || wrong.has_errors()) return std::nullopt;
    const auto [width, height] =
        wanted.size.value_or(std::pair(document->scene().window_size[0], document->scene().window_size[1]));
    Runtime& runtime = *document->runtime;
    const gl::Target target = gl::make_target(width, height, wanted.samples, runtime.display_pixels());
    if (!target.framebuffer) {
        messages += "snell: error: this OpenGL gives no picture of this size\n";
        return std::nullopt;
    }
    const View view;
    return draw_picture(runtime, {wanted.time, view, controls}, target, {.width = width, .height = height}, {});
}

}  // namespace snell::app
