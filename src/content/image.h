// Pictures on the CPU. No GL here; OpenImageIO only behind module.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/limits.h"

namespace snell::content {

enum class PixelType : std::uint8_t { u8, f16, f32 };

// Tightly packed; row 0 is the *top* row of the picture (for volumes: slice 0 first). Raw .tex files are in
// texture order instead (row 0 = t 0): `bottom_first` says so.
struct Image {
    int width = 0, height = 1, depth = 1;
    int channels = 4;  // 1 grey, 2 grey+alpha, 3, 4
    PixelType type = PixelType::u8;
    bool bottom_first = false;
    std::vector<std::byte> pixels;

    std::size_t pixel_bytes() const;
    std::size_t row_bytes() const { return pixel_bytes() * static_cast<std::size_t>(width); }
    std::size_t bytes() const {
        return row_bytes() * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
    }
};

struct ImageLimits {
    int side = static_cast<int>(Limits{}.texture_side);
    std::size_t bytes = Limits{}.texture_bytes;
};

struct ImageIssue {
    bool error = false;
    std::string code;     // "image-unreadable", "image-truncated", "image-too-large", "image-non-finite" …
    std::string message;  // names the format found and what is wrong
    std::string help;     // what would do
};

struct ImageResult {
    std::optional<Image> image;  // none when an issue is an error
    std::vector<ImageIssue> issues;
};

// By content first, by extension second. `bytes` is the whole file; of `path` only the extension
// matters, and nothing is opened. Non-finite values are mended and reported;
// float and 16-bit images come as f16, 8-bit ones as u8.
ImageResult decode_image(const std::string& path, std::string_view bytes, const ImageLimits& limits = {});

// Only what the first bytes say; no pixel is decoded. nullopt: not known without OpenImageIO.
struct ImageHeader {
    std::string format;  // "bmp", "tex", "png", "jpeg", "hdr", "exr", …
    int width = 0, height = 0, depth = 1;
};
std::optional<ImageHeader> read_header(std::string_view first_bytes, std::size_t file_size);

// The picture that stands for one that can't be read: magenta and black checks.
Image checkerboard(int size = 64);

Image flipped(const Image& image);   // rows in the opposite order
Image to_bytes(const Image& image);  // u8, clamped to 0..1 and rounded; what is not a number becomes 0
Image to_half(const Image& image);   // f16
Image to_rgba(const Image& image);   // 4 channels; grey is spread, alpha 1
// One channel as a number: u8 is 0..1. `index` counts channels from the start of the pixels.
float value_at(const Image& image, std::size_t index);
float half_to_float(std::uint16_t half);
std::uint16_t float_to_half(float value);  // round to nearest even; overflow to infinity

// Writes by extension: .png through libpng, everything else through the OpenImageIO module. The file appears
// whole or not at all (temporary file beside it, then rename). Empty string: done; else what went wrong.
// `rows` are top first, RGBA. f32 pictures go to float formats unchanged and are clamped and rounded for
// 8-bit ones.
std::string write_image(const std::string& path, const Image& image);
// The file's bytes; empty when there are no pixels. As write_image does for .png.
std::string encode_png(const Image& image);
// The extensions that write_image takes need the module except this one.
bool writes_without_module(std::string_view path);

}  // namespace snell::content
