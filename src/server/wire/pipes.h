// Bytes through file descriptors.
#pragma once

#include <string_view>

namespace snell::server {

// Returns false if the reader is gone.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace snell::server
