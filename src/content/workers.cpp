#include "src/content/workers.h"

#include <system_error>
#include <thread>
#include <vector>

namespace snell::content {

std::size_t cores() { return std::max(std::thread::hardware_concurrency(), 1U); }

void work_beside(std::size_t count, const std::function<void()>& beside,
                 const std::function<void(std::size_t started)>& here) {
    std::vector<std::jthread> threads;
    threads.reserve(count);
    try {
        while (threads.size() < count) threads.emplace_back(std::cref(beside));
    } catch (const std::system_error&) {  // fewer do as well
    }
    here(threads.size());
}

}  // namespace snell::content
