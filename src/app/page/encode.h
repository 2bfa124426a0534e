// Pictures as bytes that browsers decode.
#pragma once

#include <string>

#include "src/content/image/image.h"

namespace snell::app {

struct EncodedPicture {
    std::string bytes;
    const char* extension = "png";  // "png" or "webp"
};

// Encodes as WebP, which takes a fifth of a PNG, or as PNG without OpenImageIO.
EncodedPicture encoded(const content::Image& picture);

}  // namespace snell::app
