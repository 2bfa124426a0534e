// Errors and warnings of the OpenGL driver. The tests fail on any of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace snell::gl {

using MessageReport = std::function<void(const char* message)>;
// From now on reports the driver's messages: errors, undefined behaviour, and all messages of high severity. A debug
// context reports the most. `report` must outlive the context. Has no effect if the context has no debug output.
void watch_messages(const MessageReport& report);

// Returns the names of the errors that glGetError reports, and clears them.
std::vector<std::string> take_errors();

}  // namespace snell::gl
