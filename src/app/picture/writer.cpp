#include "src/app/picture/writer.h"

#include <algorithm>

#include "src/app/picture/sha256.h"
#include "src/app/picture/sheet.h"
#include "src/content/whole_file.h"
#include "src/runtime/resources/stopwatch.h"

namespace snell::app {

namespace {

constexpr std::size_t most_waiting = 8, most_threads = 4;

Written write(const std::string& path, std::optional<content::Image> picture, bool light,
              const Writer::Wanted& wanted) {
    const runtime::Stopwatch watch;
    Written written;
    if (picture) written.error = content::write_image(path, *picture);
    if (written.error.empty() && (wanted.hash || (wanted.tile && !picture))) {
        const std::string bytes = content::whole_file(path);
        written.bytes = bytes.size();
        if (wanted.hash) written.sha256 = sha256(bytes);
        if (!picture) picture = content::decode_image(path, bytes).image;
    }
    if (wanted.tile && picture) written.tile = thumbnail(*picture, light);
    written.milliseconds = watch.milliseconds();
    return written;
}

}  // namespace

Writer::~Writer() { finish(); }

void Writer::add(std::string path, std::optional<content::Image> picture, const std::string& wrong, bool light) {
    const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
    std::unique_lock lock(mutex_);
    if (!wrong.empty()) {
        written_.push_back({.error = wrong});
        return;
    }
    change_.wait(lock, [&] { return queue_.size() < most_waiting; });
    queue_.push_back({written_.size(), std::move(path), std::move(picture), light});
    written_.emplace_back();
    if (threads_.size() < std::min(threads, written_.size())) threads_.emplace_back([this] { work(); });
    change_.notify_all();
}

void Writer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        change_.wait(lock, [&] { return done_ || !queue_.empty(); });
        if (queue_.empty()) return;
        Job job = std::move(queue_.front());
        queue_.pop_front();
        change_.notify_all();
        lock.unlock();
        Written written = write(job.path, std::move(job.picture), job.light, wanted_);
        lock.lock();
        written_[job.place] = std::move(written);
    }
}

const std::vector<Written>& Writer::finish() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    change_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    return written_;
}

}  // namespace snell::app
