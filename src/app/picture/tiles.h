// Divides a picture of any size into parts that fit into memory.
#pragma once

#include <string>
#include <vector>

#include "parser/text/limits.h"
#include "src/gl/context.h"
#include "src/runtime/runtime.h"

namespace snell::app {

struct PictureSize {
    int width = 0, height = 0, samples = 1;
    bool floats = false;  // of the framebuffer's pixels
    bool operator==(const PictureSize&) const = default;
};

// The size of the part that is drawn at once, in pixels.
struct Tiling {
    int width = 0, height = 0;
    std::string error;      // why the picture cannot be drawn
    std::string help = {};  // what the user can do about it; may be empty
    bool whole(const PictureSize& size) const { return width >= size.width && height >= size.height; }
};

// Returns the largest part that memory allows within the limits. With `most` above 0, its sides are at most that many
// pixels.
Tiling tile(const PictureSize& size, const Limits& limits, const gl::Caps& caps, int most = 0);

// Lists the parts from top to bottom, each row from left to right. They begin at multiples of the tiling's size,
// counted from the bottom left.
std::vector<PixelRect> parts_of(const PictureSize& size, const Tiling& tiling);

}  // namespace snell::app
