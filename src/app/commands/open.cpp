// `snell SCENE`: the window.
#include <fmt/format.h>

#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/exit_status.h"
#include "src/app/window/window.h"

namespace snell::app {

Run add_window(CLI::App& command) {
    auto window = std::make_shared<WindowOptions>();
    command.add_option("SCENE", window->scene,
                       "the scene to open in a window, or a folder: its only scene, or a list to choose from");
    add_size(command, window->size, "size of the window, WIDTHxHEIGHT");
    add_repeated(command, "--ladder", window->ladders, "ladder=rung to begin with; may be repeated");
    add_quality(command, window->quality);
    // For tests of the window, not for users.
    command.add_option("--state", window->state_file)->group("");
    command.add_option("--exit-after", window->exit_after)->group("");
    command.add_option("--lose-file", window->lose_file)->group("");
    command.add_option("--after", window->after)->group("");  // passed by a window that restarts itself
    add_specialise(command, window->specialise);
    add_timeout(command, window->timeout, "a frame; then the scene waits for another edit");
    add_access(command, window->access);
    return [window, &command] {
        if (!size_fits(window->size, window->access.limits)) return exit_usage;
        const Exit ended = static_cast<Exit>(run_window(*window));
        if (ended == exit_usage) fmt::print(stderr, "\n{}\n", command.help());
        return ended;
    };
}

}  // namespace snell::app
