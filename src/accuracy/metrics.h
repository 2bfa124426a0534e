// How far a picture is from its reference. Linear light, before quantisation; no GL here.
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

// By pixel: whether it counts. Empty: all do.
using Region = std::vector<std::uint8_t>;

// Where any channel of two pictures of one size differs by more than `threshold`.
Region where_different(const Picture& a, const Picture& b, float threshold = 0);
std::size_t count(const Region& region);

// Over red, green and blue of the pixels that count; alpha is no light. A pixel with a component that is not finite
// in either picture is counted in `nonfinite` and left out of all else.
struct Error {
    double rmse = 0, psnr = 0, max = 0, mean = 0;  // psnr: dB against a peak of 1; infinite for equal pictures
    double correlation = 1;                        // of the pictures
    // As far from the reference as another picture of its kind would be: the two vary alike, and not together. rmse no
    // longer ranks.
    bool unrelated = false;
    std::size_t pixels = 0, nonfinite = 0;
};
// Precondition: both of one size.
Error compare(const Picture& picture, const Picture& reference, const Region& region = {});

double psnr(double rmse);

// Angles between two pictures of directions (xyz in red, green, blue; any length), in degrees. Pixels where either
// has no direction (zero or not finite) are left out. Angles by atan2: acos loses all digits below a hundredth of a
// degree.
struct Degrees {
    double mean = 0, p99 = 0, max = 0;
    std::size_t pixels = 0;
};
Degrees compare_directions(const Picture& picture, const Picture& reference, const Region& region = {});

// The difference that an eye sees when the two pictures alternate: FLIP for low dynamic range (Andersson and others,
// "FLIP: A Difference Evaluator for Alternating Images", 2020), 0 (none) to 1. Components are clamped to 0..1, and
// what is not finite is 0. Cost grows with pixels_per_degree; 67 is a monitor of .7 m width and 3840 pixels seen
// from .7 m.
std::vector<float> flip_map(const Picture& picture, const Picture& reference, double pixels_per_degree = 67);
double mean_of(std::span<const float> map, const Region& region = {});

}  // namespace snell::accuracy
