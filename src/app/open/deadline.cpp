#include "src/app/open/deadline.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "parser/text/utf8.h"
#include "src/app/open/exit_status.h"

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

void Deadline::begin(std::string what) {
    if (seconds_ <= 0) return;
    bool idle = false;
    {
        const std::lock_guard lock(mutex_);
        idle = idle_;
        what_ = std::move(what);
        end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds_));
    }
    // A thread that is not idle wakes at an earlier end, and finds the new one then.
    if (idle) change_.notify_all();
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
            const std::string text = fmt::format(
                "snell: error: {} takes longer than {} seconds [timeout]\n   help: a loop in a shader may not end; "
                "--timeout SECONDS allows more\n",
                utf8::printable(what_), seconds_);
            [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
            if (last_) last_();
            // exit() would wait for other threads, which may never return.
            _exit(exit_timeout);
        }
    }
}

}  // namespace snell::app
