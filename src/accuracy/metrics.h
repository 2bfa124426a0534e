// Error metrics of a picture compared with its reference, in linear light before quantisation. No GL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

// The pixels in which any channel of two pictures of equal size differs by more than `threshold`.
Region where_different(const Picture& a, const Picture& b, float threshold = 0);
std::size_t count(const Region& region);

// Errors over red, green and blue of the pixels that count; alpha is ignored. A pixel with a component that is not
// finite in either picture is counted in `nonfinite` and excluded from everything else.
struct Error {
    double rmse = 0, psnr = 0, max = 0, mean = 0;  // psnr: dB relative to a peak of 1; infinite for equal pictures
    double correlation = 1;                        // between the two pictures
    // The pictures vary alike, but independently: an unrelated picture of the same kind would have the same error, so
    // RMSE no longer ranks.
    bool unrelated = false;
    std::size_t pixels = 0, nonfinite = 0;
};
// Both pictures must have the same size.
Error compare(const Picture& picture, const Picture& reference, const Region& region = {});

// In dB relative to a peak of 1; infinite for an RMSE of 0.
double psnr(double rmse);

// Angles, in degrees, between two pictures of directions (xyz in red, green and blue, of any length). Pixels in which
// either has no direction (zero or not finite) are excluded. Angles are computed by atan2, because acos is inaccurate
// below a hundredth of a degree.
struct Degrees {
    double mean = 0, p99 = 0, max = 0;
    std::size_t pixels = 0;
};
// Both pictures must have the same size.
Degrees compare_directions(const Picture& picture, const Picture& reference, const Region& region = {});

// The difference that a viewer perceives when the two pictures alternate: FLIP for low dynamic range (Andersson and
// others, "FLIP: A Difference Evaluator for Alternating Images", 2020), from 0 (none) to 1. Components are clamped to
// 0..1, and those that are not finite become 0. The cost grows with pixels_per_degree; 67 is a monitor of .7 m width
// and 3840 pixels, seen from .7 m.
std::vector<float> flip_map(const Picture& picture, const Picture& reference, double pixels_per_degree = 67);
// The mean over the pixels that count; 0 if there are none.
double mean_of(std::span<const float> map, const Region& region = {});

}  // namespace snell::accuracy
