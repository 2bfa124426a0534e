// Files that belong to snell itself, and folders with everything below them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

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

}  // namespace snell::content
