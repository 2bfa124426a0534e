// From the file names of a scene to paths, with what there is to say about them. For src/plan alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "src/plan/files.h"

namespace snell {

// Extensions that a name without one may mean.
const std::vector<std::string_view>& stage_extensions(Stage stage);
const std::vector<std::string_view>& mesh_extensions(const Shape& shape);
const std::vector<std::string_view>& image_extensions();

// The path, or empty with file-not-found; file-inexact when the name on disk is another. Neither is said twice
// of one place in the text.
std::string locate(const FileName& file, const std::vector<std::string_view>& extensions, const Files& files,
                   Diagnostics& diagnostics);

void report_unreadable(const FileName& file, std::string_view reason, Diagnostics& diagnostics);

// The files of a texture, as located: one picture, or the six faces of a cube map.
struct TextureFile {
    std::string name;  // for messages
    std::string path;  // empty: not there, and said so
    Span span;
};
std::vector<TextureFile> locate_texture(const Texture& texture, const Files& files, Diagnostics& diagnostics);

}  // namespace snell
