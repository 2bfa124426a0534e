// Notices that files were saved; texts that an editor gives in place of files hold until then.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "src/plan/files.h"

namespace snell {

// Polls the files instead of using the system's notifications. Notifications do not work on network folders, and an
// editor that saves by renaming makes them lose the file. Polling fifty files takes less than 0.1 ms. For a folder only
// the names in it count, because a missing file of a scene may appear there.
class Watch {
public:
    // Sets the files and folders to watch. The known state of those that were watched before stays; new ones are
    // compared with their current state.
    void set_paths(std::vector<std::string> paths);
    // Polls once. Returns true when two polls in a row saw the same new state, so that a file is not read while it is
    // still being written; `at_once`: also for one that was never seen before.
    bool changed(bool at_once = false);

private:
    struct Stamp {
        std::int64_t seconds = 0, nanoseconds = 0;
        std::uint64_t size = 0, inode = 0;
        bool exists = false;
        bool operator==(const Stamp&) const = default;
    };
    struct Entry {
        std::string path;
        Stamp known, last;
        Stamp folder;  // modification time when its names were last read
    };
    static Stamp look(Entry& entry);

    std::vector<Entry> entries_;
};

// Texts that an editor gives in place of files, because they were not saved yet. Each holds until its file is saved.
class GivenTexts {
public:
    explicit GivenTexts(const Access& access);

    // Removes the texts of `access` whose files were saved, and those that say what their files say.
    void remove_saved(Access& access) const;

private:
    std::map<std::string, std::filesystem::file_time_type> given_;  // by path, when its file was written last
};

}  // namespace snell
