// Checks that a picture's file was written to its end.
#pragma once

#include <string>
#include <string_view>

#include "src/content/image/image.h"

namespace snell::content {

// Returns true if the file is of the format that the extension of `path` stands for, and is complete. A PNG must have
// all its chunks with their checksums; EXR, HDR, JPEG, TGA and BMP are decoded, and must have their end marks (JPEG,
// TGA) or their size (BMP). Returns false for all other formats, such as TIFF: a cut can't be ruled out.
bool is_whole(const std::string& path, std::string_view bytes, const ImageLimits& limits);

}  // namespace snell::content
