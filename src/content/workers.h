// The threads that work is spread over. This is the only place that starts any outside of src/app: a platform without
// threads replaces workers.cpp (src/platform/web).
#pragma once

#include <cstddef>
#include <functional>

namespace snell::content {

// The number of threads that can work at the same time, the caller's included: at least 1.
std::size_t cores();

// Calls `beside` on `count` threads, or on fewer if the system refuses more, and meanwhile `here` on the caller's
// thread, with the number that were started. Returns when all of them have returned. None may throw.
void work_beside(std::size_t count, const std::function<void()>& beside,
                 const std::function<void(std::size_t started)>& here);

}  // namespace snell::content
