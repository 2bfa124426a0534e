// Reads files that belong to snell itself, and not to a scene.
#pragma once

#include <string>

namespace snell::content {

// Returns the file's current bytes; empty if it cannot be read.
std::string whole_file(const std::string& path);

}  // namespace snell::content
