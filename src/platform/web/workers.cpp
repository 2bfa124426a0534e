// A page has one thread: the caller does all.
#include "src/content/workers.h"

namespace snell::content {

std::size_t cores() { return 1; }

void work_beside(std::size_t, const std::function<void()>&, const std::function<void(std::size_t started)>& here) {
    here(0);
}

}  // namespace snell::content
