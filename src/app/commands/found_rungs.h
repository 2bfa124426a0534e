// The part of `snell accuracy` that lists and writes found rungs, without measuring: --list-found, --apply.
#pragma once

#include "src/app/commands/advice.h"
#include "src/app/open/complain.h"

namespace CLI {
class App;
}

namespace snell::app {

void add_found_rungs(CLI::App& command, AccuracyOptions& options);

// True if the options ask for a list or for texts, and for no measurement.
bool only_texts(const AccuracyOptions& options);

// Does so. `command` has the options as they were given.
Exit write_found_rungs(const AccuracyOptions& options, const CLI::App& command);

}  // namespace snell::app
