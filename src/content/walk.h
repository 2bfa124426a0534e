// Folders and everything below them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <system_error>

namespace snell::content {

// What happens next: the walk continues, does not enter the folder that was visited, or ends.
enum class Walk { on, past, end };
// `status` is that of the entry itself, also of a link. `depth` is the number of folders above it, below the first.
using Visit = std::function<Walk(const std::filesystem::path& path, std::filesystem::file_status status, int depth)>;

// Visits everything below a folder, in no particular order, without following links. A folder that cannot be read, or
// vanishes meanwhile, hides only itself; the error is returned if it is the first one.
std::error_code walk(const std::filesystem::path& folder, const Visit& visit);

}  // namespace snell::content
