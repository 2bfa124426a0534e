// The decoders behind decode_image, one for each format that snell reads by itself. Inside src/content only.
#pragma once

#include <string>
#include <string_view>

#include "src/content/image.h"

namespace snell::content {

// "bmp", "png", "jpeg" …, from the first bytes; empty when they tell nothing (TGA and raw .tex have no
// signature). Kinds of file that are no pictures but are met under picture names come as "html", "git-lfs" …
std::string_view sniff(std::string_view first_bytes);

// Lower case, without the dot: "png".
std::string extension_of(std::string_view path);

// The format that an extension stands for, by sniff's names; empty: not known here.
std::string_view format_of_extension(std::string_view extension);

ImageResult decode_bmp(std::string_view bytes, const ImageLimits& limits);
ImageResult decode_tex(std::string_view bytes, const ImageLimits& limits);
ImageResult decode_png(std::string_view bytes, const ImageLimits& limits);
// Whatever OpenImageIO reads. `format` is sniff's word, empty to let it try them all.
// The bytes are given to it as a file in memory: what stands under the picture's name may have changed meanwhile.
ImageResult decode_other(std::string_view bytes, std::string_view format, const ImageLimits& limits);

std::optional<ImageHeader> bmp_header(std::string_view first_bytes);
std::optional<ImageHeader> png_header(std::string_view first_bytes);
// The whole file's size decides whether the first numbers are sizes of a raw texture.
std::optional<ImageHeader> tex_header(std::string_view first_bytes, std::size_t file_size);

ImageResult image_failed(std::string code, std::string message, std::string help = {});

// What speaks against a picture of this size, asked before memory is taken for it.
std::optional<ImageIssue> check_size(std::string_view format, std::int64_t width, std::int64_t height,
                                     std::int64_t depth, std::size_t pixel_bytes, const ImageLimits& limits);

// Floats (tightly packed, as `shape` says) → f16: non-finite values become the mean of their neighbours, values
// beyond ±65504 are clamped; both are reported.
ImageResult half_image(Image shape, std::vector<float> values);

// Little-endian numbers; the caller has checked that they are there.
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

}  // namespace snell::content
