// Runs work on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "src/content/workers.h"

namespace snell::content {

// Calls `work(first, last)` for blocks that cover 0..count, on as many threads as there are cores. `work` must not
// throw.
template <class Work>
void parallel_blocks(std::size_t count, const Work& work) {
    const std::size_t threads = std::min(cores(), count);
    // Each thread gets several blocks, so that a slow block does not delay the rest.
    const std::size_t block = std::max<std::size_t>(count / std::max<std::size_t>(threads * 8, 1), 1);
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t first = next.fetch_add(block); first < count; first = next.fetch_add(block)) {
            work(first, std::min(first + block, count));
        }
    };
    work_beside(threads > 0 ? threads - 1 : 0, run, [&](std::size_t) { run(); });
}

}  // namespace snell::content
