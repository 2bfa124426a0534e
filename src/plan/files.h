// The only way snell reads files that a scene names: relative to a folder, forgiving about case, counted.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

struct FileCounters {
    std::uint64_t opened = 0, bytes = 0;
};

// What a name led to.
struct Resolved {
    std::string path;      // on disk; empty: nothing there
    bool inexact = false;  // found under another case or with an extension added: warn
    std::string nearest;   // when nothing is there: the most similar name in that folder
};

class Files {
public:
    // Names are relative to `folder` ("" is the working directory).
    explicit Files(std::string folder) : folder_(std::move(folder)) {}

    const std::string& folder() const { return folder_; }
    // `extensions` are tried when the bare name is not there: {"vert", "vs", "glsl"}.
    Resolved resolve(std::string_view name, const std::vector<std::string_view>& extensions = {}) const;
    // nullopt: can't be read (`error` says why). Regular files only.
    std::optional<std::string> read(const std::string& path, std::string& error);
    FileCounters counters() const;
    // Every path that was read, for watching.
    std::vector<std::string> read_paths() const;

private:
    std::string folder_;
    mutable std::mutex mutex_;
    FileCounters counters_;
    std::vector<std::string> read_paths_;
};

}  // namespace snell
