// What the driver complains of. Tests fail on any of it.
#pragma once

#include <string>
#include <vector>

namespace snell::gl {

// Messages of severity "error" and undefined behaviour, gathered from now on (a debug context tells most).
// `log` must outlive the context. No effect where the context has no debug output.
void collect_messages(std::vector<std::string>& log);

// The names of the errors that glGetError holds, and clears them.
std::vector<std::string> take_errors();

}  // namespace snell::gl
