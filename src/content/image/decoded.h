// A file that holds an image as it is in memory. A page in a browser gets images in this form that another thread, or
// the native program, has decoded: the bytes "SNELLIMG"; width, height, depth, channels and type as little-endian
// 32-bit numbers; the pixels.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "src/content/image/image.h"

namespace snell::content {

std::vector<std::byte> decoded_file(const Image& image);
bool is_decoded_file(std::string_view bytes);
ImageResult read_decoded_file(std::string_view bytes, const ImageLimits& limits);

}  // namespace snell::content
