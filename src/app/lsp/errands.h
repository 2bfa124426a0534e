// What editors ask snell to do with a scene, by its subcommands.
#pragma once

#include <string>
#include <string_view>

#include "src/server/services.h"

namespace snell::app {

// Both take the texts that are open, of `access`, instead of their files.
server::Window open_window(const std::string& scene, const Access& access);
server::Outcome run_errand(const server::Errand& errand, const Access& access);

// Why a window failed that ended by itself after so many seconds, by the last error that it printed; "" if it did not
// fail: it shows the errors of the scene itself.
std::string failure_of_window(int status, double seconds, std::string_view printed);

}  // namespace snell::app
