#include "src/app/watch.h"

#include <sys/stat.h>

#include <algorithm>

namespace snell {

Watch::Stamp Watch::look(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return {};
    return {status.st_mtim.tv_sec, status.st_mtim.tv_nsec, static_cast<std::uint64_t>(status.st_size),
            static_cast<std::uint64_t>(status.st_ino), true};
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
            const Stamp now = look(path);
            entries.push_back({std::move(path), now, now});
        }
    }
    entries_ = std::move(entries);
}

bool Watch::changed() {
    bool differs = false, rests = true;
    for (Entry& entry : entries_) {
        const Stamp now = look(entry.path);
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
