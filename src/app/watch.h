// Notices that files were saved.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace snell {

// Looks at the files themselves, not at the system's notifications: these are silent on network folders, and an
// editor that saves by renaming makes them lose the file. One look at fifty files costs less than 0.1 ms.
// Of a folder only the names in it count: a file that a scene lacks may appear there.
class Watch {
public:
    // The files and folders whose present state is known; further ones are compared from now on.
    void set_paths(std::vector<std::string> paths);
    // Looks. True once a change has come to rest: two looks in a row saw the same new state, so that a file
    // still being written is not read by half.
    bool changed();

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
        Stamp folder;  // when its names were last read
    };
    static Stamp look(Entry& entry);

    std::vector<Entry> entries_;
};

}  // namespace snell
