#include "src/accuracy/report/slide/crops.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace snell::accuracy {

namespace {

// FLIP of a pixel depends on those that are nearer than this; the margin keeps the edges of a window as they are.
constexpr int flip_reach = 12;

std::size_t index(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

float shown(float value) { return std::isfinite(value) ? std::clamp(value, 0.F, 1.F) : 0.F; }

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0., 1.))); }

Picture part(const Picture& picture, const Window& window) {
    Picture result{window.width, window.height, {}};
    for (int y = 0; y < window.height; ++y) {
        const auto row =
            picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * index(window.x, window.y + y, picture.width));
        result.rgba.insert(result.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(window.width));
    }
    return result;
}

Window grown(const Window& window, int by, int width, int height) {
    const int x0 = std::max(window.x - by, 0), y0 = std::max(window.y - by, 0);
    const int x1 = std::min(window.x + window.width + by, width), y1 = std::min(window.y + window.height + by, height);
    return {x0, y0, x1 - x0, y1 - y0};
}

}  // namespace

std::vector<float> disagreement(std::span<const Picture* const> pictures, const Picture& reference) {
    std::vector<float> result(reference.pixels(), 0);
    for (std::size_t p = 0; p < result.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = 4 * p + c;
            const float first = shown(pictures.size() > 1 ? pictures.front()->rgba[at] : reference.rgba[at]);
            float low = first, high = first;
            bool odd = false;
            for (const Picture* picture : pictures) {
                low = std::min(low, shown(picture->rgba[at]));
                high = std::max(high, shown(picture->rgba[at]));
                odd = odd || std::isfinite(picture->rgba[at]) != std::isfinite(reference.rgba[at]);
            }
            result[p] += (odd ? 1 : high - low) / 3;
        }
    return result;
}

Window largest_window(const std::vector<float>& values, int width, int height, int window_width, int window_height) {
    Window best{0, 0, std::min(window_width, width), std::min(window_height, height)};
    // sums[x, y]: of all values above and to the left of it.
    const int across = width + 1;
    std::vector<double> sums(index(0, height + 1, across), 0);
    for (int y = 0; y < height; ++y) {
        double row = 0;
        for (int x = 0; x < width; ++x) {
            row += static_cast<double>(values[index(x, y, width)]);
            sums[index(x + 1, y + 1, across)] = sums[index(x + 1, y, across)] + row;
        }
    }
    double most = -1;
    for (int y = 0; y + best.height <= height; ++y)
        for (int x = 0; x + best.width <= width; ++x) {
            const int x1 = x + best.width, y1 = y + best.height;
            const double sum = sums[index(x1, y1, across)] - sums[index(x, y1, across)] - sums[index(x1, y, across)] +
                               sums[index(x, y, across)];
            // Sums of the same values differ by rounding.
            if (sum <= most * (1 + 1e-9)) continue;
            most = sum;
            best.x = x;
            best.y = y;
        }
    return best;
}

Raster crop(const Picture& picture, const Window& window) {
    Raster raster{window.width, window.height, {}};
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                raster.rgb.push_back(byte(static_cast<double>(
                    shown(picture.rgba[4 * index(window.x + x, window.y + y, picture.width) + c]))));
    return raster;
}

std::vector<float> flip_in(const Picture& picture, const Picture& reference, const Window& window) {
    const Window around = grown(window, flip_reach, picture.width, picture.height);
    const std::vector<float> map = flip_map(part(picture, around), part(reference, around));
    std::vector<float> result;
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x)
            result.push_back(map[index(window.x - around.x + x, window.y - around.y + y, around.width)]);
    return result;
}

// A polynomial through the colours of "magma": its lightness rises evenly, so it also reads in grey.
std::array<std::uint8_t, 3> map_color(double part) {
    static constexpr std::array<std::array<double, 7>, 3> terms{
        {{-.002136, .251661, 8.353717, -27.668733, 52.176140, -50.768525, 18.655706},
         {-.000750, .677523, -3.577720, 14.264731, -27.943606, 29.046583, -11.489774},
         {-.005386, 2.494027, .314468, -13.649213, 12.944169, 4.234153, -5.601962}}};
    const double t = std::clamp(part, 0., 1.);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) {
        double value = 0;
        for (std::size_t i = terms[c].size(); i-- > 0;) value = value * t + terms[c][i];
        color[c] = byte(value);
    }
    return color;
}

Raster colored(std::span<const float> values, const Window& window, double scale) {
    Raster raster{window.width, window.height, {}};
    for (const float value : values) {
        const auto color = map_color(static_cast<double>(value) / scale);
        raster.rgb.insert(raster.rgb.end(), color.begin(), color.end());
    }
    return raster;
}

Raster magnified(const Raster& raster, int width, int height) {
    const int factor = std::max(1, std::min(width / std::max(raster.width, 1), height / std::max(raster.height, 1)));
    Raster result{raster.width * factor, raster.height * factor, {}};
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                result.rgb.push_back(raster.rgb[3 * index(x / factor, y / factor, raster.width) + c]);
    return result;
}

Raster reduced(const Picture& picture, int width, int height) {
    const double factor =
        std::min({static_cast<double>(width) / picture.width, static_cast<double>(height) / picture.height, 1.});
    const auto size = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * factor))); };
    Raster raster{size(picture.width), size(picture.height), {}};
    const auto from = [](int i, int all, int of) { return static_cast<int>(static_cast<std::int64_t>(i) * of / all); };
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) {
            const int x0 = from(x, raster.width, picture.width), y0 = from(y, raster.height, picture.height);
            const int x1 = std::max(x0 + 1, from(x + 1, raster.width, picture.width));
            const int y1 = std::max(y0 + 1, from(y + 1, raster.height, picture.height));
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (int j = y0; j < y1; ++j)
                    for (int i = x0; i < x1; ++i)
                        sum += static_cast<double>(shown(picture.rgba[4 * index(i, j, picture.width) + c]));
                raster.rgb.push_back(byte(sum / ((x1 - x0) * (y1 - y0))));
            }
        }
    return raster;
}

}  // namespace snell::accuracy
