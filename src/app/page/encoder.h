// Pictures as bytes that browsers decode.
#pragma once

#include <string>

#include "src/content/image/image.h"

namespace snell::app {

struct EncodedPicture {
    std::string bytes;
    const char* extension = "png";  // "png" or "webp"
    std::string error;              // "", or why there are no bytes
};

// Encodes as PNG, or as WebP, which takes a fifth, but shows sharp edges less exactly.
EncodedPicture encoded(const content::Image& picture, bool lossless);

}  // namespace snell::app
