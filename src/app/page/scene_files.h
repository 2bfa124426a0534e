// Everything that a scene reads, as a page carries it: packed into a text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/plan/files.h"

namespace snell::app {

// Packs the files of a scene into a text that a page carries.

struct PackedFile {
    std::string name;  // relative, with '/'
    std::string bytes;
    bool decoded = false;  // `bytes` are content::decoded_file() of the file of this name, which stands before it
};

// The limits of a page's archive. The page itself holds to the same ones.
inline constexpr std::size_t most_page_files = 10'000;
inline constexpr std::uint64_t most_page_bytes = std::uint64_t{512} << 20;  // of all files together

// One line of JSON with the names and sizes, then the bytes of all files. Of plain BMP images it has `rows`, and of
// each byte of their pixels what its neighbours do not foretell.
std::string archive(std::span<const PackedFile> files);

// The same bytes give the same text: no time and no name is in it.
std::string gzipped(std::string_view bytes);

// Everything that a scene reads, as a page carries it.

struct SceneFiles {
    std::string scene;  // the name of the scene among the files
    std::vector<PackedFile> files;
    std::string error;  // "", or why the scene cannot be in a page
};

// Reads the scene and all files that it names, whatever its rungs and values are. Images of formats that pages do not
// decode are there twice: as they are, and decoded.
SceneFiles scene_files(const std::string& scene, const Access& access);

}  // namespace snell::app
