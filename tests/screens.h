// Where tests leave pictures for people to look at.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace snell {

// Empty where nobody asked for them; `./dev guide` does.
inline std::string screens_folder() {
    const char* folder = std::getenv("SNELL_SCREENS");
    if (folder == nullptr || *folder == '\0') return {};
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace snell
