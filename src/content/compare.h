// How far two pictures are apart.
#pragma once

#include <string>

#include "src/content/image.h"

namespace snell::content {

// Over all channels of all texels, in units where 8-bit 255 is 1. `over` counts texels with a channel that
// differs by more than the threshold. A value that is not finite in one picture only differs infinitely.
struct Difference {
    double max = 0, mean = 0, rms = 0;
    std::size_t over = 0;
};

// nullopt: the pictures differ in size or number of channels. Types and row order may differ.
std::optional<Difference> compare(const Image& a, const Image& b, double threshold = 0);

// OpenImageIO's figures for pictures of one size, type and row order. Its model of vision (Yee's) is not among
// them: version 2.4 finds no difference between black and white.
struct ModuleDifference {
    double mean = 0, rms = 0, psnr = 0, max = 0;
    std::size_t over = 0;
};

// Empty string: done; else why not.
std::string compare_by_module(const Image& a, const Image& b, double threshold, ModuleDifference& difference);

// One channel as a number: u8 is 0..1. `index` counts channels from the start of the pixels.
float value_at(const Image& image, std::size_t index);

}  // namespace snell::content
