#include "src/app/window/window.h"

#include <fmt/format.h>

#include <utility>

#include "src/app/desktop/folder.h"
#include "src/app/desktop/given_texts.h"
#include "src/app/open/complain.h"
#include "src/app/window/app.h"
#include "src/content/regular_file.h"

namespace snell {

namespace {

void begin_with(Carried& carried, WindowOptions& options) {
    if (carried.scene.empty()) {  // nothing was drawn before
        carried.scene = options.scene;
        carried.recovery.files = {options.scene};
        return;
    }
    if (carried.scene != options.scene) {
        options.quality.clear();  // the options were for the first scene
        options.ladders.clear();
    }
    options.scene = carried.scene;
    options.size = carried.size;
}

}  // namespace

int run_window(const WindowOptions& options) {
    Restart restart(options.after);
    WindowOptions now = options;
    now.scene = only_scene(now.scene);
    std::optional<Carried> carried = restart.carried();
    if (carried) begin_with(*carried, now);
    std::string unreadable;
    if (!carried && !now.scene.empty() && !is_folder(now.scene) &&
        !content::read_regular_file(now.scene, now.access.limits.file_bytes, {}, unreadable))
        return complain(app::exit_input, fmt::format("cannot read '{}': {}", options.scene, unreadable));
    // What is saved while one context is shown holds for the next, too.
    const GivenTexts given(now.access);
    Past past(kept_folder(settings_file()));
    while (true) {
        std::string error;
        std::unique_ptr<Window> window = Window::make({.title = title_of(now.scene)}, error);
        if (!window && now.scene.empty())
            return complain(app::exit_usage, "no scene given, and no window to choose one in: " + error);
        if (!window)
            return complain(app::exit_graphics, "no window: " + error, "'snell render' draws without a display");
        given.remove_saved(now.access);
        App app(now, std::move(window), restart, carried ? &*carried : nullptr, past);
        app.run(carried && carried->recovery.edited);
        if (!app.lost()) return app.readable() ? app::exit_fine : app::exit_input;
        const bool again = carried.has_value();
        carried = app.carried();
        fmt::print(stderr, "snell: {}", render(carried->recovery.problem, {}));
        // The window ends if the context was lost twice without a good picture in between.
        if (again && !carried->recovery.kept) return app::exit_lost;
        begin_with(*carried, now);
    }
}

}  // namespace snell
