#include "src/app/picture/outputs.h"

#include <algorithm>
#include <filesystem>
#include <unordered_map>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/app/picture/sheet.h"
#include "src/content/files.h"
#include "src/content/html_page.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "src/runtime/resources/counters.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// Gives each file one name, following links as replace_file() does. Folders are cached, as many pictures share them.
class Places {
public:
    std::string of(const std::string& file) {
        std::error_code error;
        const fs::path path = content::without_links(file);
        const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
        const auto [found, is_new] = folders_.try_emplace(folder);
        if (is_new) found->second = fs::weakly_canonical(fs::absolute(folder, error), error);
        return (found->second / path.filename()).lexically_normal().string();
    }

private:
    std::unordered_map<std::string, fs::path> folders_;
};

constexpr std::size_t most_waiting = 8, most_threads = 4;

Written write(const std::string& path, std::optional<content::Image> picture, bool light,
              const Writer::Wanted& wanted) {
    const runtime::Stopwatch watch;
    Written written;
    if (picture) written.error = content::write_image(path, *picture);
    if (written.error.empty() && (wanted.hash || (wanted.tile && !picture))) {
        const std::string bytes = content::whole_file(path);
        written.bytes = bytes.size();
        if (wanted.hash) written.sha256 = content::sha256(bytes);
        if (!picture) picture = content::decode_image(path, bytes).image;
    }
    if (wanted.tile && picture) written.tile = thumbnail(*picture, light);
    written.milliseconds = watch.milliseconds();
    return written;
}

}  // namespace

bool replace_a_file(std::span<const std::string> outputs) {
    return ranges::any_of(outputs, [](const std::string& file) {
        std::error_code error;
        return !file.empty() && !content::is_stream(file) && fs::is_regular_file(file, error);
    });
}

std::vector<std::string> read_by(std::span<const std::string> scenes, std::span<const std::string> outputs,
                                 const Access& access, bool grade) {
    std::vector<std::string> read(scenes.begin(), scenes.end());
    if (!replace_a_file(outputs)) return read;
    for (const std::string& scene : scenes)
        for (std::string& file : files_read_by(scene, access_to(scene, access, grade))) read.push_back(std::move(file));
    return read;
}

bool distinct_outputs(std::span<const std::string> outputs, std::span<const std::string> read) {
    Places places;
    std::unordered_map<std::string, const std::string*> taken;
    for (const std::string& file : read) taken.emplace(places.of(file), nullptr);
    bool distinct = true;
    for (const std::string& file : outputs) {
        if (file.empty() || content::is_stream(file)) continue;
        const auto [other, is_new] = taken.emplace(places.of(file), &file);
        if (is_new) continue;
        distinct = false;
        const std::string what = !other->second           ? "is read, and would be overwritten"
                                 : *other->second == file ? "would be two outputs"
                                                          : fmt::format("and '{}' would be one file", *other->second);
        complain(fmt::format("'{}' {}", file, what), "give each output a name of its own");
    }
    return distinct;
}

Exit check_outputs(std::span<const std::string> outputs, std::span<const std::string> read) {
    if (!distinct_outputs(outputs, read)) return exit_usage;
    Exit status = exit_fine;
    for (const std::string& file : outputs) {
        const std::string wrong = file.empty() ? "" : content::check_place(file);
        if (!wrong.empty() && !cannot_write(file, wrong)) status = exit_input;
    }
    return status;
}

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
