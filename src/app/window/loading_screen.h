// Shows a progress bar in the window if loading takes longer than half a second.
#pragma once

#include <functional>

#include "src/app/open/progress.h"
#include "src/platform/window.h"
#include "src/ui/kit/gui.h"

namespace snell {

class LoadingScreen {
public:
    // Draws the background of the bar into the cleared window, of the given size in pixels.
    using Behind = std::function<void(PixelSize pixels)>;
    LoadingScreen(Window& window, ui::Gui& gui, ui::Painter& painter, Behind behind);

    // Returns a function for RuntimeOptions::progress. A window that is still hidden is shown in `size`.
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
