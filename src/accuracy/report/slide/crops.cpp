#include "src/accuracy/report/slide/slide.h"

#include <algorithm>
#include <cmath>

#include "src/content/image/image.h"

namespace snell::accuracy {

namespace {

// FLIP of a pixel depends on those that are nearer than this; the margin keeps the edges of a window as they are.
constexpr int flip_reach = 12;

std::size_t index(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

float shown(float value) { return std::isfinite(value) ? std::clamp(value, 0.F, 1.F) : 0.F; }

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

content::Image crop(const Picture& picture, const Window& window) {
    return content::reduced(window.width, window.height, window.width, window.height, [&](int x, int y, std::size_t c) {
        return shown(picture.rgba[4 * index(window.x + x, window.y + y, picture.width) + c]);
    });
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

content::Image colored(std::span<const float> values, const Window& window, double scale) {
    return content::reduced(window.width, window.height, window.width, window.height, [&](int x, int y, std::size_t c) {
        return content::heat(static_cast<double>(values[index(x, y, window.width)]) / scale)[c];
    });
}

}  // namespace snell::accuracy
