#include "src/app/window/loading_screen.h"

#include <utility>

#include "src/gl/present.h"
#include "src/ui/loading.h"

namespace snell {

LoadingScreen::LoadingScreen(Window& window, ui::Gui& gui, ui::Painter& painter, Behind behind)
    : window_(window), gui_(gui), painter_(painter), behind_(std::move(behind)) {}

Watcher LoadingScreen::watcher(PixelSize size) {
    return [this, size](const LoadProgress& progress) {
        if (!patience_.due(progress) || Patience::ends(progress)) return;
        if (!std::exchange(visible_, true)) window_.show(size);
        show(progress);
    };
}

// Events wait for the frame after loading: there is nothing yet that they could change.
void LoadingScreen::show(const LoadProgress& progress) {
    window_.wait(0);
    const PixelSize size = window_.size(), pixels = window_.framebuffer();
    if (pixels.width <= 0 || pixels.height <= 0) return;
    const float density = size.width > 0 ? static_cast<float>(pixels.width) / static_cast<float>(size.width) : 1.0F;
    ui::Screen screen = gui_.screen();
    screen.width = static_cast<float>(size.width);
    screen.height = static_cast<float>(size.height);
    screen.density = density;
    screen.scale = window_.content_scale() / density;
    if (gui_.input(screen, 0, {})) painter_.upload_fonts();
    gui_.begin();
    ui::loading(words(progress), share(progress));
    gui_.end();
    const ImVec4 around = ui::palette().surround;
    gl::clear_window(pixels.width, pixels.height, around.x, around.y, around.z);
    behind_(pixels);
    painter_.paint();
    window_.present();
}

}  // namespace snell
