// Differences between two pictures.
#pragma once

#include <optional>

#include "src/content/image/image.h"

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

}  // namespace snell::content
