// Errors and warnings of the OpenGL driver. The tests fail on any of them.
#pragma once

#include <string>
#include <vector>

namespace snell::gl {

// From now on appends the driver's messages to `log`: errors, undefined behaviour, and all messages of high severity. A
// debug context reports the most. `log` must outlive the context. Has no effect if the context has no debug output.
void collect_messages(std::vector<std::string>& log);

// Prints the same messages to standard error instead; used in debug builds.
void print_messages();

// Returns the names of the errors that glGetError reports, and clears them.
std::vector<std::string> take_errors();

}  // namespace snell::gl
