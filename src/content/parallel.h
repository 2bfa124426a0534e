// Runs work on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace snell::content {

// Starts `count` threads, or fewer if the system refuses more.
template <class Run>
std::vector<std::jthread> start_threads(std::size_t count, const Run& run) {
    std::vector<std::jthread> threads;
    threads.reserve(count);
    try {
        while (threads.size() < count) threads.emplace_back(run);
    } catch (const std::system_error&) {
    }
    return threads;
}

// Calls `work(first, last)` for blocks that cover 0..count, on as many threads as there are cores. `work` must not
// throw.
template <class Work>
void parallel_blocks(std::size_t count, const Work& work) {
    const std::size_t threads = std::min<std::size_t>(std::max(std::thread::hardware_concurrency(), 1u), count);
    // Each thread gets several blocks, so that a slow block does not delay the rest.
    const std::size_t block = std::max<std::size_t>(count / std::max<std::size_t>(threads * 8, 1), 1);
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t first = next.fetch_add(block); first < count; first = next.fetch_add(block)) {
            work(first, std::min(first + block, count));
        }
    };
    const std::vector<std::jthread> helpers = start_threads(threads > 0 ? threads - 1 : 0, run);
    run();
}

}  // namespace snell::content
