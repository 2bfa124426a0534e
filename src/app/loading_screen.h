// A window while its scene loads: a bar from half a second after that began.
#pragma once

#include <functional>

#include "src/app/progress.h"
#include "src/platform/window.h"
#include "src/ui/gui.h"

namespace snell {

class LoadingScreen {
public:
    // `behind` draws what the bar lies over into the cleared window of that many pixels.
    using Behind = std::function<void(PixelSize pixels)>;
    LoadingScreen(Window& window, ui::Gui& gui, ui::Painter& painter, Behind behind);

    // What RuntimeOptions::progress takes. A window that was not shown yet is shown in `size`.
    Watcher watcher(PixelSize size);

private:
    void show(const LoadProgress& progress);

    Window& window_;
    ui::Gui& gui_;
    ui::Painter& painter_;
    Behind behind_;
    Patience patience_;
    bool visible_ = false;
};

}  // namespace snell
