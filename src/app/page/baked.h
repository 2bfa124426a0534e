// Pictures of a scene over one or two of its sliders, for pages of scenes that browsers cannot draw.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "src/app/open/ending.h"
#include "src/app/page/scene_files.h"
#include "src/content/image/image.h"
#include "src/document/document.h"

namespace snell::app {

struct Baking {
    std::vector<std::string> sliders;  // one or two, named as for --set
    int steps = 0;                     // of each slider that holds fractions; 0: default_steps()
    int width = 0, height = 0, samples = 1;
    double time = 0;
    bool lossless = false;  // PNG, otherwise WebP, which takes a fifth
};

int default_steps(std::size_t sliders);
inline constexpr std::size_t most_baked = 1024;                         // pictures
inline constexpr std::size_t most_baked_bytes = std::size_t{64} << 20;  // of all pictures

struct Baked {
    std::vector<PackedFile> pictures;
    nlohmann::ordered_json json;  // for web/page/baked.ts
    std::string error;            // "", or why there are no pictures
};

// Draws every combination, each picture as `snell render --set` does. The context of `caps` must be current.
Baked baked(Document& document, const View& view, const Baking& baking, const gl::Caps& caps, const Limits& limits,
            Deadline& deadline);

// Pictures as bytes that browsers decode.

struct EncodedPicture {
    std::string bytes;
    const char* extension = "png";  // "png" or "webp"
    std::string error;              // "", or why there are no bytes
};

// Encodes as PNG, or as WebP, which takes a fifth, but shows sharp edges less exactly.
EncodedPicture encoded(const content::Image& picture, bool lossless);

}  // namespace snell::app
