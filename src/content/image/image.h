// Images on the CPU. No GL; OpenImageIO is used only through module.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/limits.h"

namespace snell::content {

enum class PixelType : std::uint8_t { u8, f16, f32 };

// Tightly packed pixels. Row 0 is the *top* row of the image (for volumes, slice 0 is first). Raw .tex files are in
// texture order instead, with row 0 at t = 0, and have `bottom_first` set.
struct Image {
    int width = 0, height = 1, depth = 1;
    int channels = 4;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
    PixelType type = PixelType::u8;
    bool bottom_first = false;
    bool light = false;  // the file's format holds light, in floats
    bool srgb = false;   // colours, not alpha, stand for light and are encoded by the sRGB curve
    std::vector<std::byte> pixels;

    std::size_t pixel_bytes() const;
    std::size_t row_bytes() const { return pixel_bytes() * static_cast<std::size_t>(width); }
    std::size_t bytes() const {
        return row_bytes() * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
    }
};

struct ImageLimits {
    int side = static_cast<int>(Limits{}.texture_side);
    std::uint64_t bytes = Limits{}.texture_bytes;
};

struct ImageIssue {
    bool error = false;
    std::string code;     // "image-unreadable", "image-truncated", "image-too-large", "image-non-finite" …
    std::string message;  // names the format and what is wrong
    std::string help;     // what the user can do
};

struct ImageResult {
    std::optional<Image> image;  // nullopt if an issue is an error
    std::vector<ImageIssue> issues;
    std::vector<std::size_t> replaced;  // indices of the channels, as for value_at(), that were not finite
};

// Decodes an image file, whose format is recognised by its content, otherwise by its extension. `bytes` is the whole
// file; `path` is used only for its extension, and nothing is opened. Non-finite values are replaced and reported.
// Float and 16-bit images become f16, 8-bit ones u8.
ImageResult decode_image(const std::string& path, std::string_view bytes, const ImageLimits& limits = {});

// The properties that the first bytes of an image file state.
struct ImageHeader {
    std::string format;  // "bmp", "tex", "png", "jpeg", "hdr", "exr", …
    int width = 0, height = 0, depth = 1;
};
// Reads the header without decoding pixels. Returns nullopt if the format is unknown without OpenImageIO.
std::optional<ImageHeader> read_header(std::string_view first_bytes, std::size_t file_size);

// The placeholder for an image that cannot be read: magenta and black checks.
Image checkerboard(int size = 64);

Image flipped(Image image);          // reverses the order of the rows
Image to_bytes(const Image& image);  // converts to u8, clamped to 0..1 and rounded; NaN becomes 0
Image to_half(const Image& image);   // converts to f16; what was encoded is light then
Image to_rgba(Image image);          // converts to 4 channels: grey is copied to red, green and blue, alpha is 1
// The sRGB curve (IEC 61966-2-1) and its inverse, odd functions: negative numbers keep their sign.
double light_of_srgb(double encoded);
double srgb_of_light(double light);
// Returns one channel as a number; u8 is scaled to 0..1, and what is encoded is decoded. `index` counts channels from
// the start of the pixels.
float value_at(const Image& image, std::size_t index);
float half_to_float(std::uint16_t half);
std::uint16_t float_to_half(float value);  // rounds to nearest even; overflow becomes infinity

// Writes a file in the format of its extension: .png through libpng, everything else through the OpenImageIO module.
// The file appears whole or not at all (a temporary file next to it is renamed). Returns an empty string, or what went
// wrong. Streams, such as /dev/stdout, get PNG. Both row orders are accepted; the file has the top row first. f32
// images are written unchanged to float formats, and clamped and rounded for 8-bit ones.
std::string write_image(const std::string& path, const Image& image);
// Returns the bytes of a PNG file, as write_image writes it; empty if the image has no pixels.
std::string encode_png(const Image& image);
// True if write_image needs no module for this path's extension, which holds only for PNG.
bool writes_without_module(std::string_view path);

// A file that holds an image as it is in memory. A page in a browser gets images in this form that another thread, or
// the native program, has decoded: the bytes "SNELLIMG"; width, height, depth, channels and type as little-endian
// 32-bit numbers; the pixels.

std::vector<std::byte> decoded_file(const Image& image);
bool is_decoded_file(std::string_view bytes);
ImageResult read_decoded_file(std::string_view bytes, const ImageLimits& limits);

// Pictures for people: made smaller, and the colours of numbers.

// RGB in bytes, not larger than that: the mean of `value(x, y, channel)` over the pixels that become one. NaN is black.
template <class Value>
Image reduced(int width, int height, int most_width, int most_height, const Value& value) {
    const double factor =
        std::min({static_cast<double>(most_width) / width, static_cast<double>(most_height) / height, 1.});
    const auto size = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * factor))); };
    const auto from = [](int i, int all, int of) { return static_cast<int>(std::int64_t{i} * of / all); };
    Image image{.width = size(width), .height = size(height), .channels = 3};
    image.pixels.reserve(image.bytes());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0, count = 0;
                for (int j = from(y, image.height, height); j < from(y + 1, image.height, height); ++j)
                    for (int i = from(x, image.width, width); i < from(x + 1, image.width, width); ++i, ++count)
                        sum += static_cast<double>(value(i, j, c));
                image.pixels.push_back(
                    static_cast<std::byte>(std::lround(sum > 0 ? std::min(sum / count, 1.) * 255 : 0)));
            }
    return image;
}

// The colour of errors for a fraction 0..1, from black over violet and orange to nearly white. A darker colour always
// means less, in print and for every eye; NaN is as wrong as can be.
inline std::array<float, 3> heat(double fraction) {
    constexpr std::array<std::array<float, 3>, 5> colors{
        {{0, 0, .02F}, {.32F, .07F, .48F}, {.72F, .21F, .47F}, {.99F, .55F, .38F}, {.99F, .99F, .75F}}};
    const double at = std::isnan(fraction) ? 4 : std::clamp(fraction, 0., 1.) * 4;
    const auto index = std::min(static_cast<std::size_t>(at), colors.size() - 2);
    const float part = static_cast<float>(at - static_cast<double>(index));
    std::array<float, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = colors[index][c] * (1 - part) + colors[index + 1][c] * part;
    return color;
}

}  // namespace snell::content
