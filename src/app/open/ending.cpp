#include "src/app/open/ending.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "parser/text/words.h"
#include "src/app/open/complain.h"
#include "src/content/replace.h"
#include "src/gl/driver.h"

namespace snell::app {

Deadline::Deadline(double seconds, Late late, std::function<void()> last)
    : seconds_(seconds), late_(std::move(late)), last_(std::move(last)) {
    if (seconds > 0) thread_ = std::thread([this] { watch(); });
}

Deadline::~Deadline() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    change_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void Deadline::begin(std::string what, double used) {
    if (seconds_ <= 0) return;
    bool idle = false;
    {
        const std::lock_guard lock(mutex_);
        idle = idle_;
        what_ = std::move(what);
        const std::chrono::duration<double> left(std::max(seconds_ - used, seconds_ / 4));
        end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(left);
    }
    // A thread that is not idle wakes at an earlier end, and finds the new one then; what has less time ends before.
    if (idle || used > 0) change_.notify_all();
}

void Deadline::now(std::string what) {
    const std::lock_guard lock(mutex_);
    what_ = std::move(what);
}

void Deadline::rest() {
    const std::lock_guard lock(mutex_);
    end_ = Clock::time_point::max();
}

void Deadline::watch() {
    std::unique_lock lock(mutex_);
    while (!done_) {
        if (end_ == Clock::time_point::max()) {
            idle_ = true;
            change_.wait(lock);
            idle_ = false;
            continue;
        }
        const auto end = end_;
        if (change_.wait_until(lock, end) != std::cv_status::timeout || done_ || Clock::now() < end_) continue;
        if (late_) {
            late_(what_);
            end_ = Clock::time_point::max();
        } else {
            // Without memory, drivers may wait for a thread that has got no stack.
            if (short_of_memory()) {
                if (last_) last_();
                out_of_memory();
            }
            const std::string text = fmt::format(
                "snell: error: {} takes longer than {} seconds [timeout]\n   help: a loop in a shader may not end; "
                "--timeout SECONDS allows more\n",
                utf8::printable(what_), seconds_);
            [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
            if (last_) last_();
            content::abandon_replacements();
            // exit() would wait for other threads, which may never return.
            _exit(exit_timeout);
        }
    }
}

namespace {

// Calls nothing that takes memory or locks.
void ended_by_driver(int signal) {
    if (short_of_memory()) out_of_memory();
    std::signal(signal, SIG_DFL);
    raise(signal);
}

std::atomic<bool> interrupted = false;

void on_interrupt(int) {
    interrupted = true;
    std::signal(SIGINT, SIG_DFL);
}

}  // namespace

bool short_of_memory(std::size_t bytes) {
    if (!std::isfinite(address_space())) return false;
    void* probe = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED) return true;
    munmap(probe, bytes);
    return false;
}

double address_space() {
    rlimit limit{};
    const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return limited ? static_cast<double>(limit.rlim_cur) : std::numeric_limits<double>::infinity();
}

void out_of_memory() {
    constexpr std::string_view less =
        "snell: error: out of memory [out-of-memory]\n   help: the scene asks for more than there is; --limit and "
        "--size ask for less\n";
    constexpr std::string_view more =
        "snell: error: out of memory [out-of-memory]\n   help: the limit of address space ('ulimit -v') is too low: an "
        "OpenGL driver alone may take 700000 kB\n";
    const std::string_view text = address_space() < 1U << 30U ? more : less;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    _exit(exit_input);
}

int status_of(const std::function<int()>& work) {
    try {
        return work();
    } catch (const std::exception& error) {
        if (short_of_memory()) out_of_memory();  // a thread that gets no stack, for example
        return complain(exit_input, error.what());
    }
}

void watch_memory() {
    std::set_new_handler(out_of_memory);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS}) {
        struct sigaction now {};
        // Sanitizers have their own.
        if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(signal, ended_by_driver);
    }
}

Interrupt::Interrupt() {
    interrupted = false;
    before_ = std::signal(SIGINT, on_interrupt);
}

Interrupt::~Interrupt() { std::signal(SIGINT, before_); }

bool Interrupt::came() { return interrupted; }

void Interrupt::end() {
    std::fflush(nullptr);
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
    std::abort();
}

bool LossWatch::lost() {
    std::error_code error;
    if (!file_.empty() && std::filesystem::remove(file_, error)) return true;
    if (left_ == 0) return gl::lost();
    if (left_ == 1) return true;
    --left_;
    return false;
}

}  // namespace snell::app
