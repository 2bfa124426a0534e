#include "src/accuracy/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parser/text/ranges.h"
#include "src/content/image/image.h"

namespace snell::accuracy {

namespace {

bool counts(const Region& region, std::size_t pixel) { return region.empty() || region[pixel] != 0; }

bool finite3(const float* p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

// Accumulates the values of both pictures for Pearson's correlation coefficient.
struct Correlation {
    double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;

    void add(double x, double y) {
        n += 1;
        a += x;
        b += y;
        aa += x * x;
        bb += y * y;
        ab += x * y;
    }
    // Two constant pictures count as correlated, a constant and a varying one as uncorrelated.
    double value() const {
        if (n == 0) return 1;
        const double va = aa - a * a / n, vb = bb - b * b / n;
        const double tiny = 1e-9 * std::max(aa + bb, 1e-30);
        if (va <= tiny || vb <= tiny) return va <= tiny && vb <= tiny ? 1 : 0;
        return (ab - a * b / n) / std::sqrt(va * vb);
    }
    // A constant picture is not considered unrelated.
    bool unrelated() const {
        if (n == 0) return false;
        const double va = aa - a * a / n, vb = bb - b * b / n;
        return value() < .5 && va > vb / 4 && vb > va / 4;
    }
};

// The sums from which figures are made.
struct Sums {
    double sum = 0, squares = 0, max = 0;

    void add(double difference) {
        sum += difference;
        squares += difference * difference;
        max = std::max(max, difference);
    }
    Figures figures(std::size_t pixels) const {
        const double values = 3 * static_cast<double>(pixels), rmse = std::sqrt(squares / values);
        return {rmse, psnr(rmse), max, sum / values};
    }
};

constexpr double infinite = std::numeric_limits<double>::infinity(), unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

const Figures unknown_figures{unknown, unknown, unknown, unknown};

Region where_different(const Picture& a, const Picture& b, float threshold) {
    Region region(a.pixels(), 0);
    for (std::size_t i = 0; i < region.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            if (const float x = a.rgba[4 * i + c], y = b.rgba[4 * i + c];
                x != y && !(std::isnan(x) && std::isnan(y)) && !(std::abs(x - y) <= threshold))
                region[i] = 1;
    return region;
}

std::size_t count(const Region& region) {
    return static_cast<std::size_t>(ranges::count_if(region, [](std::uint8_t in) { return in != 0; }));
}

double psnr(double rmse) { return rmse == 0 ? infinite : -20 * std::log10(rmse); }

double decibels(double psnr, int decimals) {
    const double scale = std::pow(10, decimals);
    return std::round(psnr * scale) / scale + 0.;  // -0 + 0 is 0
}

Error compare(const Picture& picture, const Picture& reference, const Region& region) {
    Error error;
    Sums light, display;
    Correlation correlation;
    bool one_sided = false;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!counts(region, i)) continue;
        const float *a = &picture.rgba[4 * i], *b = &reference.rgba[4 * i];
        if (!finite3(a) || !finite3(b)) {
            ++error.nonfinite;
            one_sided = one_sided || finite3(a) || finite3(b);
            continue;
        }
        ++error.pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = static_cast<double>(a[c]), y = static_cast<double>(b[c]);
            correlation.add(x, y);
            if (x == y) continue;
            display.add(std::abs(x - y));
            light.add(std::abs(content::light_of_srgb(x) - content::light_of_srgb(y)));
        }
    }
    error.light = light.figures(error.pixels);
    error.display = display.figures(error.pixels);
    if (error.pixels == 0) error.light = error.display = unknown_figures;
    if (one_sided) error.light = error.display = {infinite, -infinite, infinite, infinite};
    error.correlation = correlation.value();
    error.unrelated = correlation.unrelated();
    return error;
}

NonFinite non_finite(const Picture& picture, const Region& region) {
    NonFinite found;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!counts(region, i) || finite3(&picture.rgba[4 * i])) continue;
        const auto width = static_cast<std::size_t>(picture.width);
        if (found.count++ == 0) found = {1, static_cast<int>(i % width), static_cast<int>(i / width)};
    }
    return found;
}

std::string text_of(const NonFinite& pixels) {
    return fmt::format("NaN or infinite in {} pixel{}, the first at ({}, {}) from the top left", pixels.count,
                       pixels.count > 1 ? "s" : "", pixels.x, pixels.y);
}

Degrees compare_directions(const Picture& picture, const Picture& reference, const Region& region) {
    std::vector<double> angles;
    bool one_sided = false;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        if (!counts(region, i)) continue;
        const float *p = &picture.rgba[4 * i], *q = &reference.rgba[4 * i];
        one_sided = one_sided || finite3(p) != finite3(q);
        if (!finite3(p) || !finite3(q)) continue;
        const double a[3]{p[0], p[1], p[2]}, b[3]{q[0], q[1], q[2]};
        const double la = std::hypot(a[0], a[1], a[2]), lb = std::hypot(b[0], b[1], b[2]);
        if (!(la > 0) || !(lb > 0)) continue;
        const double across =
            std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
        angles.push_back(std::atan2(across, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / std::numbers::pi);
    }
    Degrees result;
    result.pixels = angles.size();
    if (angles.empty() || one_sided) {
        result.mean = result.p99 = result.max = one_sided ? infinite : unknown;
        return result;
    }
    for (double angle : angles) result.mean += angle / static_cast<double>(angles.size());
    ranges::sort(angles);
    result.max = angles.back();
    result.p99 = angles[std::min(angles.size() - 1, angles.size() * 99 / 100)];
    return result;
}

double mean_of(std::span<const float> map, const Region& region) {
    double sum = 0, n = 0;
    for (std::size_t i = 0; i < map.size(); ++i)
        if (counts(region, i)) {
            sum += static_cast<double>(map[i]);
            n += 1;
        }
    return n > 0 ? sum / n : 0;
}

}  // namespace snell::accuracy
