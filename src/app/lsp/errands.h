// What editors ask snell to do with a scene, by its subcommands.
#pragma once

#include <string>

#include "src/server/services.h"

namespace snell::app {

// Both take the texts that are open, of `access`, instead of their files.
server::Window open_window(const std::string& scene, const Access& access);
server::Outcome run_errand(const server::Errand& errand, const Access& access);

}  // namespace snell::app
