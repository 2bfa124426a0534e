// The threads that work is spread over. This is the only place that starts any outside of src/app: a platform without
// threads replaces workers.cpp (src/platform/web).
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>

namespace snell::content {

// The number of threads that can work at the same time, the caller's included: at least 1.
std::size_t cores();

// Calls `beside` on `count` threads, or on fewer if the system refuses more, and meanwhile `here` on the caller's
// thread, with the number that were started. Returns when all of them have returned. None may throw.
void work_beside(std::size_t count, const std::function<void()>& beside,
                 const std::function<void(std::size_t started)>& here);

// Runs work on all cores.

// Calls `work(first, last)` for blocks that cover 0..count, on as many threads as there are cores. `work` must not
// throw.
template <class Work>
void parallel_blocks(std::size_t count, const Work& work) {
    const std::size_t threads = std::min(cores(), count);
    // Each thread gets several blocks, so that a slow block does not delay the rest.
    const std::size_t block = std::max<std::size_t>(count / std::max<std::size_t>(threads * 8, 1), 1);
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t first = next.fetch_add(block); first < count; first = next.fetch_add(block))
            work(first, std::min(first + block, count));
    };
    work_beside(threads > 0 ? threads - 1 : 0, run, [&](std::size_t) { run(); });
}

}  // namespace snell::content
