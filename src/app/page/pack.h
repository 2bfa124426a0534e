// Packs the files of a scene into a text that a page carries.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

struct PackedFile {
    std::string name;  // relative, with '/'
    std::string bytes;
    bool decoded = false;  // `bytes` are content::decoded_file() of the file of this name, which stands before it
};

// The limits of a page's archive. The page itself holds to the same ones.
inline constexpr std::size_t most_page_files = 10'000;
inline constexpr std::uint64_t most_page_bytes = std::uint64_t{512} << 20;  // of all files together

// One line of JSON with the names and sizes, then the bytes of all files.
std::string archive(std::span<const PackedFile> files);

// The same bytes give the same text: no time and no name is in it.
std::string gzipped(std::string_view bytes);

}  // namespace snell::app
