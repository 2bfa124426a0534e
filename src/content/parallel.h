// Work on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace snell::content {

// Calls `work(first, last)` for blocks that cover 0..count, on as many threads as there are cores. `work` must
// not throw.
template <class Work>
void parallel_blocks(std::size_t count, const Work& work) {
    const std::size_t threads = std::min<std::size_t>(std::max(std::thread::hardware_concurrency(), 1u), count);
    // Several blocks for each thread, so that a slow one does not hold up the rest.
    const std::size_t block = std::max<std::size_t>(count / std::max<std::size_t>(threads * 8, 1), 1);
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t first = next.fetch_add(block); first < count; first = next.fetch_add(block)) {
            work(first, std::min(first + block, count));
        }
    };
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(run);
    run();
}

}  // namespace snell::content
