// What the driver complains of. Tests fail on any of it.
#pragma once

#include <string>
#include <vector>

namespace snell::gl {

// Messages of errors, undefined behaviour, and all of high severity, gathered from now on (a debug context tells most).
// `log` must outlive the context. No effect where the context has no debug output.
void collect_messages(std::vector<std::string>& log);

// Prints them on standard error instead, for debug builds.
void print_messages();

// The names of the errors that glGetError holds, and clears them.
std::vector<std::string> take_errors();

}  // namespace snell::gl
