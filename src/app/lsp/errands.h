// What editors ask snell to do with a scene, by its subcommands, which read it as it was saved.
#pragma once

#include <string>

#include "src/server/services.h"

namespace snell::app {

// Opens a scene in a window of its own, which outlives the editor. Returns "" or the error.
std::string open_window(const std::string& scene);

server::Outcome run_errand(const server::Errand& errand, const Access& access);

}  // namespace snell::app
