// Error metrics of a picture compared with its reference, before quantisation. No GL. Pictures hold display values: a
// scene's colours are encoded for a display, by the curve of sRGB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/content/image/image.h"

namespace snell::accuracy {

// RGBA, tightly packed, top row first.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgba;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    bool operator==(const Picture&) const = default;
};

// For each pixel, whether it counts. Empty: all pixels count.
using Region = std::vector<std::uint8_t>;

// The pixels in which any channel of two pictures of equal size differs by more than `threshold`. Where both are NaN
// they do not differ.
Region where_different(const Picture& a, const Picture& b, float threshold = 0);
std::size_t count(const Region& region);

// Errors over red, green and blue; alpha is ignored. If a pixel is finite in only one of the pictures, all are infinite
// (and the psnr minus infinity). Without any pixel that is finite in both, they are NaN.
struct Figures {
    double rmse = 0, psnr = 0, max = 0, mean = 0;  // psnr: dB relative to a peak of 1; infinite for equal pictures
};

extern const Figures unknown_figures;

// Errors over the pixels that count.
struct Error {
    Figures light;           // of the light that a display emits
    Figures display;         // of the values as the scene wrote them
    double correlation = 1;  // between the two pictures
    // The pictures vary alike, but independently: an unrelated picture of the same kind would have the same error, so
    // RMSE no longer ranks.
    bool unrelated = false;
    std::size_t pixels = 0;     // that are finite in both pictures
    std::size_t nonfinite = 0;  // that are not finite in either
};
// Both pictures must have the same size.
Error compare(const Picture& picture, const Picture& reference, const Region& region = {});

// In dB relative to a peak of 1; infinite for an RMSE of 0.
double psnr(double rmse);
// For printing with that many decimals: nothing is printed as "-0".
double decibels(double psnr, int decimals);

// The first pixel that counts and is not finite, and how many there are.
struct NonFinite {
    std::size_t count = 0;
    int x = 0, y = 0;  // of the first; from the top left
};
NonFinite non_finite(const Picture& picture, const Region& region = {});
// Such as "NaN or infinite in 2 pixels, the first at (3, 0) from the top left".
std::string text_of(const NonFinite& pixels);

// Angles, in degrees, between two pictures of directions (xyz in red, green and blue, of any length). Pixels in which
// either has no direction (zero, or not finite in both) are excluded; those finite in only one make the angles
// infinite. Without any pixel they are NaN. Angles are computed by atan2, because acos is inaccurate below a hundredth
// of a degree.
struct Degrees {
    double mean = 0, p99 = 0, max = 0;
    std::size_t pixels = 0;
};
// Both pictures must have the same size.
Degrees compare_directions(const Picture& picture, const Picture& reference, const Region& region = {});

// The difference that a viewer perceives when the two pictures alternate: FLIP for low dynamic range (Andersson and
// others, "FLIP: A Difference Evaluator for Alternating Images", 2020), from 0 (none) to 1. Components are clamped to
// 0..1, and decoded from sRGB. Pixels that are finite in only one of the pictures differ by 1. The cost grows with
// pixels_per_degree; 67 is a monitor of .7 m width and 3840 pixels, seen from .7 m.
std::vector<float> flip_map(const Picture& picture, const Picture& reference, double pixels_per_degree = 67);
// The mean over the pixels that count; 0 if there are none.
double mean_of(std::span<const float> map, const Region& region = {});

// How far one picture is from another, as `snell compare` and `snell grade` tell it.

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
