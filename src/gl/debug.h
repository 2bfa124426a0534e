// Errors and warnings of the OpenGL driver. The tests fail on any of them.
// Times on the GPU's own clock, by timestamp queries.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

using MessageReport = std::function<void(const char* message)>;
// From now on reports the driver's messages: errors, undefined behaviour, and all messages of high severity. A debug
// context reports the most. `report` must outlive the context. Has no effect if the context has no debug output.
void watch_messages(const MessageReport& report);

// Returns the names of the errors that glGetError reports, and clears them.
std::vector<std::string> take_errors();

class Marks {
public:
    // True if the context has timestamp queries. Software renderers have them, but their times are wrong.
    bool available();
    // Records the time at which the GPU has finished all commands issued so far. Does not wait.
    void mark();
    std::size_t count() const { return used_; }
    // Returns the milliseconds between consecutive marks, one value fewer than there are marks, and clears the marks.
    // Waits for the GPU.
    std::span<const double> take();

private:
    enum class Known { not_yet, yes, no };
    Known known_ = Known::not_yet;
    std::vector<Query> queries_;
    std::size_t used_ = 0;
    std::vector<double> times_;
};

}  // namespace snell::gl
