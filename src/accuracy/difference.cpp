#include "src/accuracy/difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "parser/text/ranges.h"

namespace snell::accuracy {

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
