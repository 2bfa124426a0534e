// `snell new`: new folders with a scene to start from.
#pragma once

#include "src/app/commands/subcommands.h"

namespace snell::app {

Run add_new(CLI::App& command);

}  // namespace snell::app
