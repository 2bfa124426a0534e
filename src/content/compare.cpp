#include "src/content/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "src/content/module.h"

namespace snell::content {
namespace {

double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double d = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

}  // namespace

float value_at(const Image& image, std::size_t index) {
    switch (image.type) {
        case PixelType::u8:
            return static_cast<float>(std::to_integer<int>(image.pixels[index])) / 255.0f;
        case PixelType::f16: {
            std::uint16_t half = 0;
            std::memcpy(&half, image.pixels.data() + 2 * index, 2);
            return half_to_float(half);
        }
        case PixelType::f32: {
            float value = 0;
            std::memcpy(&value, image.pixels.data() + 4 * index, 4);
            return value;
        }
    }
    return 0;
}

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

std::string compare_by_module(const Image& a, const Image& b, double threshold, ModuleDifference& difference) {
    const OiioModule& module = oiio_module();
    if (!module.error.empty()) return module.error;
    const bool alike = a.width == b.width && a.height == b.height && a.depth == b.depth && a.channels == b.channels &&
                       a.type == b.type && a.bottom_first == b.bottom_first;
    if (!alike) return "the pictures differ in size or type";
    const SnellOiioShape shape = module_shape(a);
    SnellOiioDifference found{};
    std::array<char, 1024> message{};
    if (module.compare(&shape, a.pixels.data(), b.pixels.data(), threshold, &found, message.data(), message.size()) !=
        0) {
        return message.data();
    }
    difference = {found.mean, found.rms, found.psnr, found.max, found.over_threshold};
    return {};
}

}  // namespace snell::content
