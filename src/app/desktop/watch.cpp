#include "src/app/desktop/watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace snell {

namespace {

// The sum does not depend on the order, which folders do not guarantee.
std::uint64_t hash_of_names(const std::string& folder) {
    std::uint64_t sum = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        sum += std::hash<std::string>()(entry->path().filename().string()) * 2 + 1;
    return sum;
}

}  // namespace

Watch::Stamp Watch::look(Entry& entry) {
    struct stat status {};
    if (stat(entry.path.c_str(), &status) != 0) return {};
    const Stamp stamp{status.st_mtim.tv_sec, status.st_mtim.tv_nsec, static_cast<std::uint64_t>(status.st_size),
                      static_cast<std::uint64_t>(status.st_ino), true};
    if (!S_ISDIR(status.st_mode)) return stamp;
    if (stamp == entry.folder) return entry.last;
    entry.folder = stamp;
    return {0, 0, hash_of_names(entry.path), stamp.inode, true};
}

void Watch::set_paths(std::vector<std::string> paths) {
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    std::vector<Entry> entries;
    for (std::string& path : paths) {
        const auto old =
            std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.path == path; });
        if (old != entries_.end()) {
            entries.push_back(*old);
        } else {
            Entry entry{.path = std::move(path), .known = {}, .last = {}, .folder = {}};
            entry.known = entry.last = look(entry);
            entries.push_back(std::move(entry));
        }
    }
    entries_ = std::move(entries);
}

bool Watch::changed() {
    bool differs = false, rests = true;
    for (Entry& entry : entries_) {
        const Stamp now = look(entry);
        if (now != entry.known) {
            differs = true;
            rests &= now == entry.last;
        }
        entry.last = now;
    }
    if (!differs || !rests) return false;
    for (Entry& entry : entries_) entry.known = entry.last;
    return true;
}

}  // namespace snell
