// How far one picture is from another, as `snell compare` and `snell grade` tell it. No GL.
#pragma once

#include <cstddef>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/content/image/image.h"

namespace snell::accuracy {

struct PictureDifference {
    Error error;               // `display` is that of the bytes, `light` that of the light itself, also above 1
    double flip = 0;           // mean
    std::vector<float> map;    // FLIP of each pixel
    double share = 0;          // of the pixels that differ by more than the threshold, 0 to 1
    std::size_t x = 0, y = 0;  // of the largest difference of the values, from the top left
    double largest = 0;        // infinite if only one of the pictures is finite there
    double cover[2] = {0, 0};  // of each picture, the share that is not background
};

// A difference of one step of a byte is not more than this.
constexpr double one_step = 1.5 / 255;

// Both pictures must have the same size. All but the light is of the bytes that the pictures are written as.
// `threshold` is a difference of these in any channel, 0 to 1. Without `perceived`, which takes most of the time,
// `flip` and `map` stay empty.
PictureDifference picture_difference(const Picture& picture, const Picture& reference, double threshold = one_step,
                                     bool perceived = true);

// The share of the pixels that are not background, 0 to 1: those that are not transparent if any is, otherwise those
// whose bytes differ from the most frequent bytes of the picture's edge.
double coverage(const Picture& picture);

// The values of the bytes of a PNG: clamped to 0 to 1, in steps of 1/255. What is not finite stays.
Picture as_bytes(Picture picture);

// The mean of the light of red, green and blue, as a display emits it; pixels that are not finite are left out.
double mean_light(const Picture& picture);

// All pixels have the same bytes.
bool uniform(const Picture& picture);

Picture mirrored(Picture picture);  // left and right are exchanged

// The values that a display is given. Numbers of formats that hold light (EXR, HDR) are encoded by the curve of sRGB,
// unless they are displayed values already.
Picture displayed_picture(const content::Image& image, bool light);

// A map of differences from 0 (black) over violet and orange to 1 (pale yellow).
content::Image map_image(const std::vector<float>& map, int width, int height);

}  // namespace snell::accuracy
