#include "src/app/picture/scene_picture.h"

#include <cmath>

#include "src/app/picture/picture.h"
#include "src/document/document.h"
#include "src/gl/target.h"
#include "src/runtime/inspect.h"

namespace snell::app {

content::ImageResult scene_picture(const std::string& scene, const ScenePicture& wanted, const gl::Caps& caps,
                                   std::string& messages) {
    Diagnostics wrong;
    const auto choose = [&](const Scene& read, Rungs& rungs) {
        for (const std::string& rung : wanted.ladders) choose_rung(rungs, read, rung, wrong);
    };
    const auto document =
        open_document(scene, caps, choose, nullptr, {}, access_to(scene, wanted.access, wanted.grade));
    messages += render(document->diagnostics, document->sources);
    if (!document->runtime) return {};
    Controls controls = document->controls;
    for (const std::string& set : wanted.sets) set_control(controls, document->scene(), set, wrong);
    messages += render(wrong, document->sources);
    if (document->diagnostics.has_errors() || wrong.has_errors()) return {};
    const auto [width, height] =
        wanted.size.value_or(std::pair(document->scene().window_size[0], document->scene().window_size[1]));
    Runtime& runtime = *document->runtime;
    const gl::Target target = gl::make_target(width, height, wanted.samples, runtime.display_pixels());
    if (!target.framebuffer) {
        messages += "snell: error: this OpenGL gives no picture of this size\n";
        return {};
    }
    const View view;
    Frame frame{wanted.time, view, controls};
    content::ImageResult result;
    result.image = draw_picture(runtime, frame, target, {.width = width, .height = height}, {});
    frame.standing = true;
    FloatPicture floats;
    std::vector<float> rgba;
    if (floats.resize(width, height)) floats.draw(runtime, frame, rgba);
    const auto channels = static_cast<std::size_t>(result.image->channels);
    for (std::size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 < 3 && std::isnan(rgba[i])) result.replaced.push_back(i / 4 * channels + i % 4);
    return result;
}

}  // namespace snell::app
