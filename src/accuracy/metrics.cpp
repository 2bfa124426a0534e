#include "src/accuracy/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

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
    return fmt::format("NaN or infinite in {}, the first at ({}, {}) from the top left", counted(pixels.count, "pixel"),
                       pixels.x, pixels.y);
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

// FLIP for low dynamic range: colour differences, filtered by the eye's contrast sensitivity and amplified where edges
// and points differ. The constants are those of the paper.

namespace {

using Color = std::array<float, 3>;

// An image of one number per pixel.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};

constexpr std::array<double, 3> white{.950428545, 1, 1.088900371};  // the white point of linear sRGB, in XYZ

std::array<double, 3> to_xyz(const Color& c) {
    const double r = static_cast<double>(c[0]), g = static_cast<double>(c[1]), b = static_cast<double>(c[2]);
    return {.4124564 * r + .3575761 * g + .1804375 * b, .2126729 * r + .7151522 * g + .0721750 * b,
            .0193339 * r + .1191920 * g + .9503041 * b};
}

// Converts to the colour space of the filters: luminance and two colour differences.
Color to_opponent(const Color& linear) {
    const std::array<double, 3> xyz = to_xyz(linear);
    const double x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
    return {static_cast<float>(116 * y - 16), static_cast<float>(500 * (x - y)), static_cast<float>(200 * (y - z))};
}

Color from_opponent(const Color& c) {
    const double y = (static_cast<double>(c[0]) + 16) / 116, x = static_cast<double>(c[1]) / 500 + y,
                 z = y - static_cast<double>(c[2]) / 200;
    const double X = x * white[0], Y = y * white[1], Z = z * white[2];
    const auto unit = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
    return {unit(3.2404542 * X - 1.5371385 * Y - .4985314 * Z), unit(-.9692660 * X + 1.8760108 * Y + .0415560 * Z),
            unit(.0556434 * X - .2040259 * Y + 1.0572252 * Z)};
}

// Converts to CIELAB, with less chroma in dark colours (Hunt effect).
Color to_hunt_lab(const Color& linear) {
    const std::array<double, 3> xyz = to_xyz(linear);
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const double x = f(xyz[0] / white[0]), y = f(xyz[1] / white[1]), z = f(xyz[2] / white[2]);
    const double lightness = 116 * y - 16;
    return {static_cast<float>(lightness), static_cast<float>(.01 * lightness * 500 * (x - y)),
            static_cast<float>(.01 * lightness * 200 * (y - z))};
}

double hyab(const Color& a, const Color& b) {
    return std::abs(static_cast<double>(a[0] - b[0])) +
           std::hypot(static_cast<double>(a[1] - b[1]), static_cast<double>(a[2] - b[2]));
}

// Filters rows with one kernel, then columns with another; edge pixels are repeated. Kernels have 2 radius + 1 weights.
// Whole rows are weighted and added, so that the compiler handles several pixels at a time.
Plane filtered(const Plane& in, const std::vector<double>& along, const std::vector<double>& down) {
    const auto width = static_cast<std::size_t>(in.width);
    const auto add = [width](std::vector<double>& sum, double weight, const float* row) {
        for (std::size_t x = 0; x < width; ++x) sum[x] += weight * static_cast<double>(row[x]);
    };
    const auto store = [width](const std::vector<double>& sum, float* row) {
        for (std::size_t x = 0; x < width; ++x) row[x] = static_cast<float>(sum[x]);
    };
    Plane rows(in.width, in.height), columns(in.width, in.height);
    const std::size_t radius = along.size() / 2;
    std::vector<float> wide(width + 2 * radius);
    for (int y = 0; y < in.height; ++y) {
        const float* row = &in.values[static_cast<std::size_t>(y) * width];
        std::fill_n(wide.begin(), radius, row[0]);
        std::copy_n(row, width, wide.begin() + static_cast<std::ptrdiff_t>(radius));
        std::fill_n(wide.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
        std::vector<double> sum(width, 0);
        for (std::size_t k = 0; k < along.size(); ++k) add(sum, along[k], &wide[k]);
        store(sum, &rows.values[static_cast<std::size_t>(y) * width]);
    }
    const int reach = static_cast<int>(down.size()) / 2;
    for (int y = 0; y < in.height; ++y) {
        std::vector<double> sum(width, 0);
        for (int k = -reach; k <= reach; ++k)
            add(sum, down[static_cast<std::size_t>(k + reach)],
                &rows.values[static_cast<std::size_t>(std::clamp(y + k, 0, in.height - 1)) * width]);
        store(sum, &columns.values[static_cast<std::size_t>(y) * width]);
    }
    return columns;
}

// exp(-pi² d² / b), with d in degrees; the caller normalises the sum over the plane.
std::vector<double> gaussian(double b, double pixels_per_degree, int radius) {
    std::vector<double> kernel;
    for (int k = -radius; k <= radius; ++k) {
        const double d = k / pixels_per_degree;
        kernel.push_back(std::exp(-std::numbers::pi * std::numbers::pi * d * d / b));
    }
    return kernel;
}

double sum_of(const std::vector<double>& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.); }

// Filters a channel by the eye's contrast sensitivity: a sum of two Gaussians with weights a and widths b.
Plane behind_eye(const Plane& in, std::array<double, 2> a, std::array<double, 2> b, double pixels_per_degree) {
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(.04 / (2 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
    Plane out(in.width, in.height);
    double total = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        if (a[i] == 0) continue;
        const std::vector<double> kernel = gaussian(b[i], pixels_per_degree, radius);
        const double weight = a[i] * std::sqrt(std::numbers::pi / b[i]);
        total += weight * sum_of(kernel) * sum_of(kernel);
        const Plane part = filtered(in, kernel, kernel);
        for (std::size_t p = 0; p < out.values.size(); ++p)
            out.values[p] += static_cast<float>(weight) * part.values[p];
    }
    for (float& value : out.values) value /= static_cast<float>(total);
    return out;
}

std::vector<Color> perceived(const std::array<Plane, 3>& opponent, double pixels_per_degree) {
    const Plane light = behind_eye(opponent[0], {1, 0}, {.0047, 1e-5}, pixels_per_degree);
    const Plane red_green = behind_eye(opponent[1], {1, 0}, {.0053, 1e-5}, pixels_per_degree);
    const Plane blue_yellow = behind_eye(opponent[2], {34.1, 13.5}, {.04, .025}, pixels_per_degree);
    std::vector<Color> colors;
    Color before{}, color{};  // neighbours are often alike, and roots cost more than the comparison
    for (std::size_t p = 0; p < light.values.size(); ++p) {
        const Color here{light.values[p], red_green.values[p], blue_yellow.values[p]};
        if (p == 0 || here != before) color = to_hunt_lab(from_opponent(here));
        before = here;
        colors.push_back(color);
    }
    return colors;
}

// The first or second derivative of a Gaussian; positive and negative weights each sum to one.
std::vector<double> feature_kernel(double sigma, int radius, bool edges) {
    std::vector<double> kernel;
    double positive = 0, negative = 0;
    for (int k = -radius; k <= radius; ++k) {
        const double g = std::exp(-k * k / (2 * sigma * sigma));
        const double w = edges ? -k * g : (k * k / (sigma * sigma) - 1) * g;
        kernel.push_back(w);
        (w > 0 ? positive : negative) += std::abs(w);
    }
    for (double& w : kernel) w /= w > 0 ? positive : negative;
    return kernel;
}

// The strength of edges (or points) at each pixel.
Plane features(const Plane& light, double pixels_per_degree, bool edges) {
    const double sigma = .5 * .082 * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<double> smooth;
    for (int k = -radius; k <= radius; ++k) smooth.push_back(std::exp(-k * k / (2 * sigma * sigma)));
    const double sum = sum_of(smooth);
    for (double& w : smooth) w /= sum;
    const std::vector<double> kernel = feature_kernel(sigma, radius, edges);
    Plane along = filtered(light, kernel, smooth);
    const Plane down = filtered(light, smooth, kernel);
    for (std::size_t p = 0; p < along.values.size(); ++p) along.values[p] = std::hypot(along.values[p], down.values[p]);
    return along;
}

std::array<Plane, 3> opponent_planes(const Picture& picture) {
    std::array<Plane, 3> planes{Plane(picture.width, picture.height), Plane(picture.width, picture.height),
                                Plane(picture.width, picture.height)};
    for (std::size_t p = 0; p < picture.pixels(); ++p) {
        Color linear;
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = picture.rgba[4 * p + c];
            const double shown = std::isfinite(value) ? std::clamp(static_cast<double>(value), 0.0, 1.0) : 0.0;
            linear[c] = static_cast<float>(content::light_of_srgb(shown));
        }
        const Color color = to_opponent(linear);
        for (std::size_t c = 0; c < 3; ++c) planes[c].values[p] = color[c];
    }
    return planes;
}

// Large colour differences, which are all equally bad, are compressed to the last twentieth of the scale.
double compressed(double difference, double largest) {
    constexpr double exponent = .7, knee = .4, share = .95;
    const double powered = std::pow(difference, exponent), limit = std::pow(largest, exponent);
    if (powered < knee * limit) return share / (knee * limit) * powered;
    return share + (powered - knee * limit) / (limit - knee * limit) * (1 - share);
}

}  // namespace

std::vector<float> flip_map(const Picture& picture, const Picture& reference, double pixels_per_degree) {
    std::array<Plane, 3> a = opponent_planes(picture), b = opponent_planes(reference);
    const std::vector<Color> seen_a = perceived(a, pixels_per_degree), seen_b = perceived(b, pixels_per_degree);
    const double largest = hyab(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1}));
    std::array<Plane, 2> light{std::move(a[0]), std::move(b[0])};
    for (Plane& plane : light)
        for (float& value : plane.values) value = (value + 16) / 116;
    const Plane edge_a = features(light[0], pixels_per_degree, true),
                edge_b = features(light[1], pixels_per_degree, true);
    const Plane point_a = features(light[0], pixels_per_degree, false),
                point_b = features(light[1], pixels_per_degree, false);
    std::vector<float> map(picture.pixels());
    double color = 0;
    for (std::size_t p = 0; p < map.size(); ++p) {
        if (p == 0 || seen_a[p] != seen_a[p - 1] || seen_b[p] != seen_b[p - 1])
            color = std::min(compressed(hyab(seen_a[p], seen_b[p]), largest), 1.0);
        const float feature =
            std::max(std::abs(edge_a.values[p] - edge_b.values[p]), std::abs(point_a.values[p] - point_b.values[p]));
        const double amplify = std::min(std::sqrt(static_cast<double>(feature) / std::numbers::sqrt2), 1.0);
        map[p] = static_cast<float>(color > 0 ? std::pow(color, 1 - amplify) : 0);
        if (finite3(&picture.rgba[4 * p]) != finite3(&reference.rgba[4 * p])) map[p] = 1;
    }
    return map;
}

namespace {

using Bytes = std::array<std::uint8_t, 4>;

std::uint8_t byte_of(float value) {
    if (std::isnan(value)) return 0;
    return static_cast<std::uint8_t>(std::lround(std::clamp(static_cast<double>(value), 0., 1.) * 255));
}

Bytes bytes_of(const Picture& picture, std::size_t pixel) {
    Bytes bytes{};
    for (std::size_t c = 0; c < 4; ++c) bytes[c] = byte_of(picture.rgba[4 * pixel + c]);
    return bytes;
}

// The largest difference of the channels of a pixel, of which alpha is one.
double most_apart(const Picture& a, const Picture& b, std::size_t pixel) {
    double most = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        const float x = a.rgba[4 * pixel + c], y = b.rgba[4 * pixel + c];
        if (x == y || (std::isnan(x) && std::isnan(y))) continue;
        const double d = std::abs(static_cast<double>(x) - static_cast<double>(y));
        most = std::max(most, std::isnan(d) ? std::numeric_limits<double>::infinity() : d);
    }
    return most;
}

Bytes background_of(const Picture& picture) {
    std::map<Bytes, std::size_t> seen;
    const auto width = static_cast<std::size_t>(picture.width), height = static_cast<std::size_t>(picture.height);
    for (std::size_t x = 0; x < width; ++x) {
        ++seen[bytes_of(picture, x)];
        ++seen[bytes_of(picture, (height - 1) * width + x)];
    }
    for (std::size_t y = 0; y < height; ++y) {
        ++seen[bytes_of(picture, y * width)];
        ++seen[bytes_of(picture, y * width + width - 1)];
    }
    return ranges::max_element(seen, [](const auto& a, const auto& b) { return a.second < b.second; })->first;
}

}  // namespace

PictureDifference picture_difference(const Picture& picture, const Picture& reference, double threshold,
                                     bool perceived) {
    PictureDifference result;
    const Picture shown = as_bytes(picture), other = as_bytes(reference);
    result.error = compare(shown, other);
    if (shown != picture || other != reference) result.error.light = compare(picture, reference).light;
    if (perceived) result.map = flip_map(shown, other);
    result.flip = mean_of(result.map);
    const auto width = static_cast<std::size_t>(picture.width);
    // Steps of a byte are not exact in binary: this is far less than one, and far more than rounding makes.
    const double most = threshold + .0005 / 255;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        const double d = most_apart(shown, other, i);
        beyond += d > most;
        if (d > result.largest) {
            result.largest = d;
            result.x = i % width;
            result.y = i / width;
        }
    }
    result.share = static_cast<double>(beyond) / static_cast<double>(std::max<std::size_t>(picture.pixels(), 1));
    result.cover[0] = coverage(picture);
    result.cover[1] = coverage(reference);
    return result;
}

Picture as_bytes(Picture picture) {
    for (float& value : picture.rgba)
        if (std::isfinite(value)) value = static_cast<float>(byte_of(value)) / 255;
    return picture;
}

double coverage(const Picture& picture) {
    if (picture.pixels() == 0) return 0;
    std::size_t covered = 0;
    bool transparent = false;
    for (std::size_t i = 0; i < picture.pixels(); ++i) transparent = transparent || picture.rgba[4 * i + 3] < 1;
    const Bytes background = background_of(picture);
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        covered += transparent ? picture.rgba[4 * i + 3] > 0 : bytes_of(picture, i) != background;
    return static_cast<double>(covered) / static_cast<double>(picture.pixels());
}

double mean_light(const Picture& picture) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        if (i % 4 == 3 || !std::isfinite(picture.rgba[i])) continue;
        sum += content::light_of_srgb(static_cast<double>(picture.rgba[i]));
        count += 1;
    }
    return count > 0 ? sum / count : 0;
}

bool uniform(const Picture& picture) {
    for (std::size_t i = 1; i < picture.pixels(); ++i)
        if (bytes_of(picture, i) != bytes_of(picture, 0)) return false;
    return true;
}

Picture mirrored(Picture picture) {
    const auto width = static_cast<std::size_t>(picture.width), height = static_cast<std::size_t>(picture.height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width / 2; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                std::swap(picture.rgba[4 * (y * width + x) + c], picture.rgba[4 * (y * width + width - 1 - x) + c]);
    return picture;
}

Picture displayed_picture(const content::Image& image, bool light) {
    const content::Image straight = image.bottom_first ? content::flipped(image) : image;
    Picture picture{image.width, image.height, {}};
    const auto channels = static_cast<std::size_t>(image.channels);
    picture.rgba.reserve(4 * picture.pixels());
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const bool alpha = c == 3, held = alpha ? channels % 2 == 0 : true;
            const std::size_t from = alpha ? channels - 1 : channels < 3 ? 0 : c;
            float value = held ? content::value_at(straight, i * channels + from) : 1;
            if (light && !alpha) value = static_cast<float>(content::srgb_of_light(static_cast<double>(value)));
            picture.rgba.push_back(value);
        }
    return picture;
}

content::Image map_image(const std::vector<float>& map, int width, int height) {
    // The map "magma" of matplotlib at five places, between which it is nearly straight.
    constexpr std::array<std::array<double, 3>, 5> ramp{
        {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}}};
    content::Image image{.width = width, .height = height, .channels = 3};
    image.pixels.reserve(map.size() * 3);
    for (const float value : map) {
        const double at = std::clamp(static_cast<double>(value), 0., 1.) * 4;
        const auto low = static_cast<std::size_t>(std::min(at, 3.));
        const double part = at - static_cast<double>(low);
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels.push_back(
                static_cast<std::byte>(std::lround(ramp[low][c] * (1 - part) + ramp[low + 1][c] * part)));
    }
    return image;
}

}  // namespace snell::accuracy
