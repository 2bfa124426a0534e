// Files that scenes name, files that belong to snell itself, and folders with everything below them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <system_error>

#include "parser/text/limits.h"

namespace snell::content {

// Folders and everything below them.

// What happens next: the walk continues, does not enter the folder that was visited, or ends.
enum class Walk { on, past, end };
// `status` is that of the entry itself, also of a link. `depth` is the number of folders above it, below the first.
using Visit = std::function<Walk(const std::filesystem::path& path, std::filesystem::file_status status, int depth)>;

// Visits everything below a folder, in no particular order, without following links. A folder that cannot be read, or
// vanishes meanwhile, hides only itself; the error is returned if it is the first one.
std::error_code walk(const std::filesystem::path& folder, const Visit& visit);

// Reads files that belong to snell itself, and not to a scene.

// Returns the file's current bytes; empty if it cannot be read.
std::string whole_file(const std::string& path);

// Files that scenes name. A platform whose files are in memory replaces regular_file.cpp (src/platform/web).

// Returns the bytes of a regular file. Otherwise, and if there are more than `limit`, returns nullopt and sets `error`:
// "it is a folder", "Permission denied". A pipe or a device is refused before it is opened, so that reading never
// blocks. `allowed`, if any, is asked about the path, without links, of the very file that will be read; where it
// returns false, it sets the error itself.
std::optional<std::string> read_regular_file(const std::string& path, std::uint64_t limit,
                                             const std::function<bool(const std::string& real_path)>& allowed,
                                             std::string& error);

// The error of a file that has more bytes.
inline std::string larger_than(std::uint64_t limit) {
    return "it is larger than " + std::to_string(limit) + " bytes (" + limit_help(limit, &Limits::file_bytes) + ")";
}

}  // namespace snell::content
