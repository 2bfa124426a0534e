// How a picture of any size is drawn: at once, or part by part.
#pragma once

#include <string>
#include <vector>

#include "parser/limits.h"
#include "src/gl/caps.h"
#include "src/runtime/runtime.h"

namespace snell::app {

struct PictureSize {
    int width = 0, height = 0, samples = 1;
    bool floats = false;  // the driver's pixels are
    bool operator==(const PictureSize&) const = default;
};

// What is drawn at once, in pixels.
struct Tiling {
    int width = 0, height = 0;
    std::string error;  // why it can't be; with a help where there is one
    bool whole(const PictureSize& size) const { return width >= size.width && height >= size.height; }
};

// As much at once as memory allows within the limits; `most`: and no more pixels along a side; 0: no such bound.
Tiling tile(const PictureSize& size, const Limits& limits, const gl::Caps& caps, int most = 0);

// From the top down, each row of them from the left. They begin at multiples of the tiling's size, from the bottom
// left.
std::vector<Surface::Part> parts_of(const PictureSize& size, const Tiling& tiling);

}  // namespace snell::app
