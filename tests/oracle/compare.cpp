#include "tests/oracle/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snell::content {
namespace {

double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double d = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

}  // namespace

std::optional<Difference> compare(const Image& a, const Image& b, double threshold) {
    if (a.width != b.width || a.height != b.height || a.depth != b.depth || a.channels != b.channels)
        return std::nullopt;
    if (a.bottom_first != b.bottom_first) return compare(a, flipped(b), threshold);
    const auto channels = static_cast<std::size_t>(a.channels);
    const std::size_t texels = a.bytes() / std::max<std::size_t>(a.pixel_bytes(), 1);
    Difference result;
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < texels; ++i) {
        double worst = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            const double d = distance(value_at(a, i * channels + c), value_at(b, i * channels + c));
            worst = std::max(worst, d);
            sum += d;
            squares += d * d;
        }
        result.max = std::max(result.max, worst);
        if (worst > threshold) ++result.over;
    }
    const double values = static_cast<double>(std::max<std::size_t>(texels * channels, 1));
    result.mean = sum / values;
    result.rms = std::sqrt(squares / values);
    return result;
}

}  // namespace snell::content
