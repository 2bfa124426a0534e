// The only way snell reads files that a scene names: relative to a folder, forgiving about case, counted.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/limits.h"

namespace snell {

struct FileCounters {
    std::uint64_t opened = 0, bytes = 0;
};

// What a name led to.
struct Resolved {
    std::string path;      // on disk; empty: nothing there
    bool inexact = false;  // found under another case, in another place or with an extension: warn
    std::string nearest;   // when nothing is there: the most similar name, as a scene would write it
    bool outside = false;  // something is there, and outside of what may be read
};

// What a scene may read, and how much.
struct Access {
    Limits limits;
    // Nothing outside of this folder is read, by whatever name or through whatever link. Nothing: no such bound.
    std::optional<std::string> confine;
};

// Thread-safe. Nothing is ever created or written.
class Files {
public:
    // Names are relative to `folder` ("" is the working directory).
    explicit Files(std::string folder, Access access = {});

    const std::string& folder() const { return folder_; }
    const Access& access() const { return access_; }
    const Limits& limits() const { return access_.limits; }
    // Tries, in this order: the name itself; its components without regard to case (ASCII); the name with each
    // of `extensions` ({"vert", "vs", "glsl"}), exactly and then without regard to case; its last component in
    // the folder itself. '\' is '/', quotes around the name are dropped. Only regular files count, links to them
    // included. What was not there is not looked for again.
    Resolved resolve(std::string_view name, const std::vector<std::string_view>& extensions = {}) const;
    // The same from the folder of a file that was read (`from` is its path on disk), then from the own folder:
    // what an included scene or shader names.
    Resolved resolve_beside(std::string_view from, std::string_view name,
                            const std::vector<std::string_view>& extensions = {}) const;
    // nullopt: can't be read (`error` says why). Regular files only: a pipe or a device is refused before
    // it is opened, so that reading never waits.
    std::optional<std::string> read(const std::string& path, std::string& error);
    // The same for what several name, such as included shaders: each file is read once. Null: can't be read.
    std::shared_ptr<const std::string> read_once(const std::string& path, std::string& error);
    // The file is in use although what was read of it earlier serves again: to be watched like one that was read.
    void keep(const std::string& path);
    FileCounters counters() const;
    // Every path that was read or kept, once each in the order of first reading, for watching.
    std::vector<std::string> read_paths() const;

private:
    Resolved look_for(std::string_view written, const std::vector<std::string_view>& extensions) const;

    std::string folder_;
    Access access_;
    std::string root_;  // the real path of the folder that reading is confined to; empty: it is not
    mutable std::mutex mutex_;
    FileCounters counters_;
    std::map<std::string, std::shared_ptr<const std::string>> texts_;  // by path, of read_once()
    mutable std::map<std::string, Resolved> missing_;                  // by what was asked for
    std::vector<std::string> read_paths_;
};

}  // namespace snell
