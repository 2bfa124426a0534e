#include "src/app/picture/tiles.h"

#include <fmt/format.h>

#include <algorithm>

namespace snell::app {

namespace {

constexpr double comfortable = 512. * 1024 * 1024;  // bytes; drawing more at once is not faster
// Parts begin at multiples of the block, so that the blocks in which drivers draw stay the same.
constexpr int block = 64;

// Every sample has colour, depth and stencil; the picture itself is added.
double bytes_of_pixel(const PictureSize& size) { return (size.samples * 8. + 16.) * (size.floats ? 2. : 1.); }

int rounded(double pixels) { return std::max(block, static_cast<int>(pixels) / block * block); }

}  // namespace

Tiling tile(const PictureSize& size, const Limits& limits, const gl::Caps& caps, int most) {
    if (static_cast<std::uint64_t>(std::max(size.width, size.height)) > limits.output_side)
        return {0, 0, fmt::format("{}x{} is too large", size.width, size.height),
                limit_help(limits, &Limits::output_side)};
    if (std::max(size.width, size.height) > caps.max_viewport)
        return {0, 0,
                fmt::format("{}x{} is more than this OpenGL draws ({})", size.width, size.height, caps.max_viewport)};
    const double pixel = bytes_of_pixel(size);
    const double pixels = std::min(comfortable, static_cast<double>(limits.output_bytes)) / pixel;
    const int side = most > 0 ? std::min(caps.max_texture, most) : caps.max_texture;
    Tiling tiling{size.width, size.height, {}};
    if (size.width > side) tiling.width = rounded(side);
    if (size.height > side) tiling.height = rounded(side);
    if (static_cast<double>(tiling.width) * tiling.height <= pixels) return tiling;
    if (tiling.width * static_cast<double>(block) > pixels) tiling.width = rounded(pixels / block);
    tiling.height = rounded(pixels / tiling.width);
    if (static_cast<double>(tiling.width) * tiling.height <= pixels) return tiling;
    return {0, 0, fmt::format("{}x{} with {} samples takes too much memory", size.width, size.height, size.samples),
            limit_help(limits, &Limits::output_bytes)};
}

std::vector<PixelRect> parts_of(const PictureSize& size, const Tiling& tiling) {
    std::vector<PixelRect> parts;
    for (int row = (size.height - 1) / tiling.height; row >= 0; --row)
        for (int left = 0; left < size.width; left += tiling.width)
            parts.push_back({left, row * tiling.height, std::min(tiling.width, size.width - left),
                             std::min(tiling.height, size.height - row * tiling.height)});
    return parts;
}

}  // namespace snell::app
