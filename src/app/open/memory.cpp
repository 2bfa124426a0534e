#include "src/app/open/memory.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <string_view>

#include "src/app/open/exit_status.h"

namespace snell::app {

namespace {

// Calls nothing that takes memory or locks.
void ended_by_driver(int signal) {
    if (short_of_memory()) out_of_memory();
    std::signal(signal, SIG_DFL);
    raise(signal);
}

}  // namespace

bool short_of_memory(std::size_t bytes) {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
    void* probe = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED) return true;
    munmap(probe, bytes);
    return false;
}

void out_of_memory() {
    constexpr std::string_view less =
        "snell: error: out of memory [out-of-memory]\n   help: the scene asks for more than there is; --limit and "
        "--size ask for less\n";
    constexpr std::string_view more =
        "snell: error: out of memory [out-of-memory]\n   help: the limit of address space ('ulimit -v') is too low: an "
        "OpenGL driver alone may take 700000 kB\n";
    rlimit limit{};
    const std::string_view text = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < 1U << 30U ? more : less;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    _exit(exit_input);
}

void watch_memory() {
    std::set_new_handler(out_of_memory);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS}) {
        struct sigaction now {};
        // Sanitizers have their own.
        if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(signal, ended_by_driver);
    }
}

}  // namespace snell::app
