// The program: reads the command line, and runs what it asks for. Tests call it in copies of their process.
#pragma once

namespace snell::app {

// Returns the exit status.
int run(int argc, const char* const* argv);

}  // namespace snell::app
