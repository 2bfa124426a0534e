// Decoders of image formats, used by decode_image, and what a file holds by its first bytes and by its name.
#pragma once

#include <string>
#include <string_view>

#include "src/content/image/image.h"

namespace snell::content {

// Recognises a format by its first bytes: "bmp", "png", "jpeg" …; empty if they are unknown (TGA and raw .tex have no
// signature). Files that are not images but often have an image's name are recognised as "html", "git-lfs" …
std::string_view sniff(std::string_view first_bytes);

// Returns the extension in lower case without the dot, such as "png".
std::string extension_of(std::string_view path);

// Returns the format that an extension stands for, by the names of sniff(); empty if it is unknown.
std::string_view format_of_extension(std::string_view extension);

// Decode formats that snell reads without OpenImageIO. `bytes` is the whole file.
ImageResult decode_bmp(std::string_view bytes, const ImageLimits& limits);
ImageResult decode_tex(std::string_view bytes, const ImageLimits& limits);
ImageResult decode_png(std::string_view bytes, const ImageLimits& limits);
// Decodes a format that OpenImageIO reads. `format` is a name from sniff(), or empty to try all formats. OpenImageIO
// gets the bytes as a file in memory, because the file on disk may have changed since they were read.
ImageResult decode_other(std::string_view bytes, std::string_view format, const ImageLimits& limits);

// Read the headers; nullopt if the bytes are not a valid header of the format.
std::optional<ImageHeader> bmp_header(std::string_view first_bytes);
std::optional<ImageHeader> png_header(std::string_view first_bytes);
// A raw texture has no signature: the header is valid only if its sizes match the size of the whole file.
std::optional<ImageHeader> tex_header(std::string_view first_bytes, std::size_t file_size);

// Makes the result of a failed decoding: no image, and one error.
ImageResult image_failed(std::string code, std::string message, std::string help = {});

// Returns an issue if an image of this size exceeds the limits; called before memory is allocated.
std::optional<ImageIssue> check_size(std::string_view format, std::int64_t width, std::int64_t height,
                                     std::int64_t depth, std::size_t pixel_bytes, const ImageLimits& limits);

// Converts floats (tightly packed, as `shape` describes) to f16. Non-finite values become the mean of their neighbours,
// values beyond ±65504 are clamped; both are reported.
ImageResult half_image(Image shape, std::vector<float> values);

// Rotates and mirrors the image by EXIF's orientation (2..8); other numbers change nothing.
Image oriented(const Image& image, int orientation);

// Read little-endian numbers. The caller must have checked that `bytes` is long enough.
inline std::uint32_t read_u16(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]) | static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + 1]))
                                                       << 8;
}
inline std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
    return read_u16(bytes, at) | read_u16(bytes, at + 2) << 16;
}
inline std::int32_t read_i32(std::string_view bytes, std::size_t at) {
    return static_cast<std::int32_t>(read_u32(bytes, at));
}
// Reads a big-endian number in the same way.
inline std::uint32_t read_big_u32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

}  // namespace snell::content
