// Reads the files that scenes name. A platform whose files are in memory replaces regular_file.cpp (src/platform/web).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "parser/text/limits.h"

namespace snell::content {

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
