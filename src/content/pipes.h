// Bytes through file descriptors.
#pragma once

#include <string>
#include <string_view>

namespace snell::content {

// Returns "" or the error, such as that of a pipe whose reader is gone.
std::string write_all(int descriptor, std::string_view bytes);

// Returns what comes until the end, or until an error.
std::string read_all(int descriptor);

}  // namespace snell::content
