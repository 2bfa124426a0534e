#include "src/app/desktop/watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "src/content/files.h"

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

std::filesystem::file_time_type written(const std::string& path) {
    std::error_code error;
    return std::filesystem::last_write_time(path, error);
}

// Editors keep the mark of UTF-8 to themselves.
bool says(const std::string& path, std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    const std::string bytes = content::whole_file(path);
    return bytes == text || (bytes.starts_with(mark) && std::string_view(bytes).substr(mark.size()) == text);
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

bool Watch::changed(bool at_once) {
    bool differs = false, rests = true;
    for (Entry& entry : entries_) {
        const Stamp now = look(entry);
        if (now != entry.known) {
            differs = true;
            rests &= now == entry.last;
        }
        entry.last = now;
    }
    if (!differs || !(rests || at_once)) return false;
    for (Entry& entry : entries_) entry.known = entry.last;
    return true;
}

GivenTexts::GivenTexts(const Access& access) {
    if (!access.instead) return;
    for (const auto& [path, text] : *access.instead) given_.emplace(path, written(path));
}

void GivenTexts::remove_saved(Access& access) const {
    if (!access.instead) return;
    std::map<std::string, std::string> left;
    for (const auto& [path, text] : *access.instead)
        if (const auto given = given_.find(path); given != given_.end() && given->second == written(path))
            if (!says(path, text)) left.emplace(path, text);
    access.instead = nullptr;
    access = access.with(std::move(left));
}

}  // namespace snell
