// `snell new`: new folders with a scene to start from, of the kinds of src/app/open/templates.h.
#pragma once

#include "src/app/commands/subcommands.h"
#include "src/app/open/templates.h"

namespace snell::app {

Run add_new(CLI::App& command);

}  // namespace snell::app
