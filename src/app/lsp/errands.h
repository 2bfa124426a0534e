// What editors ask snell to do with a scene, by its subcommands.
#pragma once

#include <string>

#include "src/server/services.h"

namespace snell::app {

// Opens a scene, as it was saved, in a window of its own, which outlives the editor. Returns "" or the error.
std::string open_window(const std::string& scene);

// Takes the texts that are open, of `access`, instead of their files.
server::Outcome run_errand(const server::Errand& errand, const Access& access);

}  // namespace snell::app
