// Pictures for people: made smaller, and the colours of numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "src/content/image/image.h"

namespace snell::content {

// RGB in bytes, not larger than that: the mean of `value(x, y, channel)` over the pixels that become one. NaN is black.
template <class Value>
Image reduced(int width, int height, int most_width, int most_height, const Value& value) {
    const double factor =
        std::min({static_cast<double>(most_width) / width, static_cast<double>(most_height) / height, 1.});
    const auto size = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * factor))); };
    const auto from = [](int i, int all, int of) { return static_cast<int>(std::int64_t{i} * of / all); };
    Image image{.width = size(width), .height = size(height), .channels = 3};
    image.pixels.reserve(image.bytes());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0, count = 0;
                for (int j = from(y, image.height, height); j < from(y + 1, image.height, height); ++j)
                    for (int i = from(x, image.width, width); i < from(x + 1, image.width, width); ++i, ++count)
                        sum += static_cast<double>(value(i, j, c));
                image.pixels.push_back(
                    static_cast<std::byte>(std::lround(sum > 0 ? std::min(sum / count, 1.) * 255 : 0)));
            }
    return image;
}

// The colour of errors for a fraction 0..1, from black over violet and orange to nearly white. A darker colour always
// means less, in print and for every eye; NaN is as wrong as can be.
inline std::array<float, 3> heat(double fraction) {
    constexpr std::array<std::array<float, 3>, 5> colors{
        {{0, 0, .02F}, {.32F, .07F, .48F}, {.72F, .21F, .47F}, {.99F, .55F, .38F}, {.99F, .99F, .75F}}};
    const double at = std::isnan(fraction) ? 4 : std::clamp(fraction, 0., 1.) * 4;
    const auto index = std::min(static_cast<std::size_t>(at), colors.size() - 2);
    const float part = static_cast<float>(at - static_cast<double>(index));
    std::array<float, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = colors[index][c] * (1 - part) + colors[index + 1][c] * part;
    return color;
}

}  // namespace snell::content
