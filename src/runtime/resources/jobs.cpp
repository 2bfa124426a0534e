#include "src/runtime/resources/jobs.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "parser/text/ranges.h"
#include "src/content/workers.h"

namespace snell::runtime {

namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);

// Records which jobs are done, and wakes the thread that waits for them.
class Board {
public:
    explicit Board(const std::vector<Job>& jobs) : jobs_(jobs), done_(jobs.size(), false) {}

    // Does jobs until none is left. Any number of threads may call it.
    void work() {
        for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
            jobs_[i].work();
            const std::scoped_lock lock(mutex_);
            done_[i] = true;
            ++count_;
            change_.notify_one();
        }
    }

    void watch(const Watcher& watcher) {
        std::size_t told = 0;
        std::unique_lock lock(mutex_);
        while (true) {
            const auto first = ranges::find(done_, false);
            const std::string_view name =
                first == done_.end() ? ""
                                     : std::string_view(jobs_[static_cast<std::size_t>(first - done_.begin())].name);
            lock.unlock();
            watcher({LoadProgress::Stage::files, name, told, jobs_.size()});
            lock.lock();
            if (told == jobs_.size()) return;
            change_.wait_for(lock, between_looks, [&] { return count_ > told; });
            if (count_ > told) ++told;
        }
    }

private:
    const std::vector<Job>& jobs_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    std::condition_variable change_;
    std::vector<bool> done_;
    std::size_t count_ = 0;
};

void work_alone(const std::vector<Job>& jobs, const Watcher& watcher) {
    for (std::size_t done = 0; done < jobs.size(); ++done) {
        watcher({LoadProgress::Stage::files, jobs[done].name, done, jobs.size()});
        jobs[done].work();
    }
    watcher({LoadProgress::Stage::files, "", jobs.size(), jobs.size()});
}

}  // namespace

void say_once(const Diagnostics& said, Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : said.items())
        if (ranges::none_of(diagnostics.items(),
                            [&](const Diagnostic& other) { return other.is_at(diagnostic.code, diagnostic.span); }))
            diagnostics.add(diagnostic);
}

void run(const std::vector<Job>& jobs, const Watcher& watcher) {
    if (jobs.empty()) {
        if (watcher) watcher({LoadProgress::Stage::files, "", 0, 0});
        return;
    }
    Board board(jobs);
    const std::size_t count = std::min(content::cores(), jobs.size());
    // The thread that reports progress does no jobs, unless no other thread could be started.
    content::work_beside(
        watcher ? count : count - 1, [&] { board.work(); },
        [&](std::size_t started) {
            if (!watcher)
                board.work();
            else if (started > 0)
                board.watch(watcher);
            else
                work_alone(jobs, watcher);
        });
}

}  // namespace snell::runtime
