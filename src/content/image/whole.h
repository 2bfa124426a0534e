// Whether a picture's file was written to its end.
#pragma once

#include <string>
#include <string_view>

#include "src/content/image/image.h"

namespace snell::content {

// A PNG by its last chunk and all checksums. Other formats by decoding them, and those whose decoders do without the
// end, by their end marks (JPEG, TGA) or their size (BMP), too. `path` gives the expected format.
bool is_whole(const std::string& path, std::string_view bytes, const ImageLimits& limits);

}  // namespace snell::content
