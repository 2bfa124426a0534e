// The exit status of every command.
#pragma once

namespace snell::app {

enum Exit { exit_fine = 0, exit_input = 1, exit_usage = 2, exit_graphics = 3, exit_timeout = 4, exit_lost = 5 };

}  // namespace snell::app
