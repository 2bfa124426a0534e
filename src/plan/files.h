// The only way in which snell reads the files that a scene names. Names are relative to a folder, their case is
// forgiven, and every file read is counted.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/limits.h"

namespace snell {

struct FileCounters {
    std::uint64_t opened = 0, bytes = 0;
};

// The result of looking up a file name.
struct Resolved {
    std::string path;  // path on disk; empty if the file is not found
    // Found in another case, in another folder or with an added extension; the caller should warn.
    bool inexact = false;
    std::string nearest;            // if nothing is found: the most similar name, written as in a scene
    std::string_view refused = {};  // if something of that name exists: why it is not read
};

// Which files a scene may read, and how large they may be.
struct Access {
    Limits limits;
    // Only files within this folder are read, by whatever name or link they are reached. Nullopt: all files may be
    // read.
    std::optional<std::string> confine;
    // By path, or by path without links and "..": what is read instead of the file, which is found by the former if it
    // does not exist. For texts that were changed and are not written yet, or that once were there.
    std::shared_ptr<const std::map<std::string, std::string>> instead = nullptr;
    // Folders whose files are read too, although they are not within `confine`. A file that is found nowhere else is
    // found there by its name, in folders of any depth.
    std::vector<std::string> allow = {};

    // The same with further texts, which go before those that are there.
    Access with(std::map<std::string, std::string> texts) const;
};

// Finds and reads files. Thread-safe; it never creates or writes a file.
class Files {
public:
    // Names are relative to `folder`; "" is the working directory.
    explicit Files(std::string folder, Access access = {});

    const std::string& folder() const { return folder_; }
    const Access& access() const { return access_; }
    const Limits& limits() const { return access_.limits; }
    // Looks for a regular file, or a link to one, in this order: the name itself; the name without regard to (ASCII)
    // case; the name with each of `extensions`, such as {"vert", "vs", "glsl"}, first exactly and then without regard
    // to case; its last component in the folder itself; its last component in Access::allow. '\' counts as '/', and
    // quotes around the name are dropped. A name that was not found is remembered, and its search is not repeated.
    Resolved resolve(std::string_view name, const std::vector<std::string_view>& extensions = {}) const;
    // The same without a search for what may have been meant: for files that scenes may do without, which most do.
    Resolved find(std::string_view name) const;
    // Resolves a name that an included scene or shader contains: relative to the folder of that file, whose path on
    // disk is `from`, and otherwise to this object's folder. A name that leads elsewhere is not taken for `from`
    // itself. All three give one file that is spelled in several ways, such as a.frag and sub/../a.frag, by the way
    // that came first, so that it is one file for all that compare paths.
    Resolved resolve_beside(std::string_view from, std::string_view name,
                            const std::vector<std::string_view>& extensions = {}) const;
    // Returns the file's bytes. Returns nullopt and sets `error` if it cannot be read. A pipe or a device is refused
    // before it is opened, so that reading never blocks.
    std::optional<std::string> read(const std::string& path, std::string& error);
    // Returns the text of a file that several others may name, such as an included shader; each file is read once.
    // Returns null and sets `error` if it cannot be read.
    std::shared_ptr<const std::string> read_once(const std::string& path, std::string& error);
    // Lists a file as in use whose contents were reused from earlier, so that it is watched like the files that were
    // read.
    void keep(const std::string& path);
    FileCounters counters() const;
    // Returns every path that was read or kept, once each in the order of first use, so that the files can be watched.
    std::vector<std::string> read_paths() const;

private:
    const std::string* instead_of(const std::string& path) const;  // null: the file itself
    Resolved as_spelled_first(Resolved found) const;
    Resolved in_folder(std::string_view written, const std::vector<std::string_view>& extensions) const;
    Resolved look_for(std::string_view written, const std::vector<std::string_view>& extensions) const;
    // What look_for() finds but for Resolved::nearest.
    Resolved look_up(std::string_view written, const std::vector<std::string_view>& extensions) const;
    Resolved handed_out(std::string_view written, const std::vector<std::string_view>& extensions) const;

    std::string folder_;
    Access access_;
    std::vector<std::string> roots_;  // real paths of the folders to which reading is confined; empty if it is not
    mutable std::mutex mutex_;
    FileCounters counters_;
    std::map<std::string, std::shared_ptr<const std::string>> texts_;  // by path, for read_once()
    mutable std::map<std::string, Resolved> missing_;                  // by the name that was looked up
    mutable std::map<std::string, std::string> spelled_;               // what came first, by path without ".."
    // Paths below the folders of Access::allow, by file names in lower case; nullopt: not read yet.
    mutable std::optional<std::multimap<std::string, std::string>> handed_out_;
    std::vector<std::string> read_paths_;
};

}  // namespace snell
