// Writes images to files.
#include "src/content/image/formats.h"
#include "src/content/image/png_write.h"
#include "src/content/image/rows.h"
#include "src/content/replace.h"

namespace snell::content {

std::string encode_png(const Image& image) {
    if (image.width <= 0 || image.height <= 0 || image.pixels.size() != image.bytes()) return {};
    std::string bytes;
    PngEncoder png([&bytes](std::string_view more) {
        bytes += more;
        return true;
    });
    const Image top_first = to_bytes(image.bottom_first ? flipped(image) : image);
    const bool good =
        png.begin(top_first) && png.rows(top_first.pixels.data(), static_cast<std::size_t>(image.height)) && png.end();
    return good ? bytes : "";
}

bool writes_without_module(std::string_view path) { return extension_of(path) == "png"; }

std::string write_image(const std::string& path, const Image& image) {
    if (image.pixels.size() != image.bytes()) return "the picture is empty";
    if (image.depth > 1) return "cannot write a 3D texture as an image";
    // What cannot be renamed is written at once, and has no extension that would tell its format.
    if (is_stream(path) && extension_of(path).empty()) return replace_file(path, encode_png(image));
    RowWriter file(path, image);
    if (image.bottom_first)
        file.add(flipped(image).pixels);
    else
        file.add(image.pixels);
    return file.finish();
}

}  // namespace snell::content
