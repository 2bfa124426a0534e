// Writes images to files.
#include <algorithm>
#include <cmath>

#include "src/content/image/formats.h"
#include "src/content/image/png_write.h"
#include "src/content/image/rows.h"

namespace snell::content {

Image to_bytes(const Image& image) {
    if (image.type == PixelType::u8) return image;
    Image result = image;
    result.type = PixelType::u8;
    result.srgb = false;
    result.pixels.resize(result.bytes());
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        const float value = value_at(image, i);
        const float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;
        result.pixels[i] = static_cast<std::byte>(std::lround(clamped * 255.0f));
    }
    return result;
}

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
    RowWriter file(path, image);
    if (image.bottom_first)
        file.add(flipped(image).pixels);
    else
        file.add(image.pixels);
    return file.finish();
}

}  // namespace snell::content
