// Unpacks an archive from a stranger into a folder of its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace snell::app {

struct UnpackLimits {
    std::uint64_t bytes = std::uint64_t{256} << 20;  // of all files together, unpacked
    std::size_t files = 5'000;
    std::size_t depth = 32;  // of folders
};

struct Unpacked {
    std::string error;               // "", or why reading ended; what was unpacked before it stays
    std::vector<std::string> notes;  // what was left out: links, names that lead out of the folder
};

bool is_archive(const std::string& path);  // by the name's ending

// Writes files below `folder`, which must exist, and nothing else anywhere: names with "..", absolute names, links and
// devices are left out. Bytes of names that are not UTF-8 are read as Latin-1. Files of macOS (__MACOSX, ._*) are left
// out silently.
Unpacked unpack(const std::string& archive, const std::string& folder, const UnpackLimits& limits = {});

}  // namespace snell::app
