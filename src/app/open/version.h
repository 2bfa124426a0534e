// The version of the program, which CMakeLists.txt sets.
#pragma once

namespace snell {

const char* version();  // such as "1.2.0"

}  // namespace snell
