// Differences between two pictures.
#pragma once

#include <string>

#include "src/content/image.h"

namespace snell::content {

// Statistics over all channels of all texels, in units where 8-bit 255 is 1. `over` counts texels with a channel that
// differs by more than the threshold. A value that is finite in only one of the pictures counts as an infinite
// difference.
struct Difference {
    double max = 0, mean = 0, rms = 0;
    std::size_t over = 0;
};

// Returns nullopt if the pictures differ in size or number of channels. Their types and row orders may differ.
std::optional<Difference> compare(const Image& a, const Image& b, double threshold = 0);

// OpenImageIO's statistics for pictures of the same size, type and row order. Its model of vision (Yee's) is not used:
// version 2.4 finds no difference between black and white.
struct ModuleDifference {
    double mean = 0, rms = 0, psnr = 0, max = 0;
    std::size_t over = 0;
};

// Returns an empty string, or why the pictures could not be compared.
std::string compare_by_module(const Image& a, const Image& b, double threshold, ModuleDifference& difference);

// Returns one channel as a number; u8 is scaled to 0..1. `index` counts channels from the start of the pixels.
float value_at(const Image& image, std::size_t index);

}  // namespace snell::content
