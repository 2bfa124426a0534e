// Files of the program's own about a path, in a folder of its own.
#pragma once

#include <string>
#include <string_view>

namespace snell {

// The file in the folder that belongs to the path, such as "/home/ann/.cache/x/00c0ffee00c0ffee.png": the same in every
// version of the program. `extension` is without the dot.
std::string named_by(const std::string& folder, std::string_view path, std::string_view extension);

}  // namespace snell
