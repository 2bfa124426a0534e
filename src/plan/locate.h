// Resolves the file names of a scene to paths and reports what is wrong with them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "src/plan/files.h"

namespace snell {

// The extensions that are tried for a name without one.
const std::vector<std::string_view>& stage_extensions(Stage stage);
const std::vector<std::string_view>& scene_extensions();  // of included ones
const std::vector<std::string_view>& mesh_extensions(const Shape& shape);
const std::vector<std::string_view>& image_extensions();

// Without regard to case: true for "light.VERT" and "vert".
bool has_extension(std::string_view path, std::string_view extension);
// True for a file with an extension of a shader, of whatever stage.
bool is_shader_name(std::string_view path);

// A path as a scene writes it: relative to the file `from` that contains the name, or to the scene.
std::string written_name(const std::string& path, std::string_view from, const Files& files);

// Returns the path. Returns an empty string and reports file-not-found if there is none; reports file-inexact if the
// name on disk differs. Each is reported once per place in the text.
std::string locate(const FileName& file, const std::vector<std::string_view>& extensions, const Files& files,
                   Diagnostics& diagnostics);

// Reports file-unreadable, once per place in the text.
void report_unreadable(const FileName& file, std::string_view reason, Diagnostics& diagnostics);

// A file of a texture: its one image, or one of the six faces of a cube map.
struct TextureFile {
    std::string name;  // for messages
    std::string path;  // empty if the file was not found, which has been reported
    Span span;
    int noise = 0;  // texels a side of glman's noise, which is made where its file is not there
};
// Locates the files of a texture that is not computed; reports missing ones.
std::vector<TextureFile> locate_texture(const Texture& texture, const Files& files, Diagnostics& diagnostics);

// Which file was probably meant by a name that leads nowhere.

// True if an existing file may be what an argument of these `extensions` takes. An extension that says nothing about
// the kind of file must be the one that was asked for.
bool same_kind(std::string_view file, std::string_view asked, const std::vector<std::string_view>& extensions);

// The file whose name is nearest to `asked`, if so few letters differ that it was probably meant; otherwise empty.
// Extensions count little: same_kind() has decided about them.
std::string_view nearest_file(std::string_view asked, const std::vector<std::string_view>& files);

// What messages say of a statement.

// The statement's text in one line, cut if it is long.
std::string statement_text(const Span& span, const Sources& sources);
// The statement's place, such as "scene.glib:12".
std::string statement_place(const Span& span, const Sources& sources);

}  // namespace snell
