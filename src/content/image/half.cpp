#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "parser/text/words.h"
#include "src/content/bits.h"
#include "src/content/image/formats.h"
#include "src/content/image/image.h"

namespace snell::content {

float half_to_float(std::uint16_t half) {
    const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000u) << 16;
    const std::uint32_t magnitude = half & 0x7fffu;
    if (magnitude >= 0x7c00u) {  // infinity or NaN
        return bits_as<float>(sign | 0x7f800000u | (magnitude & 0x3ffu) << 13);
    }
    // After the shift the exponent has the wrong bias. Multiplication by 2^112 corrects normal and subnormal numbers
    // alike, exactly.
    const float unbiased = bits_as<float>(magnitude << 13) * 0x1p112f;
    return bits_as<float>(sign | bits_as<std::uint32_t>(unbiased));
}

std::uint16_t float_to_half(float value) {
    const std::uint32_t bits = bits_as<std::uint32_t>(value);
    const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) return static_cast<std::uint16_t>(sign | 0x7e00u);   // NaN
    if (magnitude >= 0x477ff000u) return static_cast<std::uint16_t>(sign | 0x7c00u);  // rounds to 65536 or more
    if (magnitude < 0x38800000u) {
        // For subnormal results, adding 1/2 makes the floating-point unit round to a multiple of 2^-24, to nearest
        // even.
        const float shifted = bits_as<float>(magnitude) + 0.5f;
        return static_cast<std::uint16_t>(sign | (bits_as<std::uint32_t>(shifted) - 0x3f000000u));
    }
    const std::uint32_t odd = magnitude >> 13 & 1u;
    return static_cast<std::uint16_t>(sign | (magnitude - 0x38000000u + 0xfffu + odd) >> 13);
}

namespace {

double light_by_curve(double encoded) {
    const double c = std::abs(encoded);
    return std::copysign(c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4), encoded);
}

// What number_at() makes of a byte.
double number_of_byte(std::size_t byte) { return static_cast<double>(static_cast<float>(byte) / 255.0f); }

float light_of_byte(std::byte value) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] = static_cast<float>(light_of_srgb(static_cast<double>(i) / 255));
        return light;
    }();
    return table[std::to_integer<std::size_t>(value)];
}

bool is_alpha(const Image& image, std::size_t index) {
    const auto channels = static_cast<std::size_t>(image.channels);
    return channels % 2 == 0 && index % channels == channels - 1;
}

float number_at(const Image& image, std::size_t index) {
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

float decoded(const Image& image, std::size_t index) {
    if (image.type == PixelType::u8) return light_of_byte(image.pixels[index]);
    return static_cast<float>(light_of_srgb(number_at(image, index)));
}

}  // namespace

// Pictures of bytes have 256 numbers, which are looked up: powers cost more than all else that is done with them.
double light_of_srgb(double encoded) {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i) light[i] = light_by_curve(number_of_byte(i));
        return light;
    }();
    const double scaled = encoded * 255;
    const std::size_t byte = scaled > 0 && scaled < 255.5 ? static_cast<std::size_t>(scaled + .5) : 0;
    return byte > 0 && encoded == number_of_byte(byte) ? table[byte] : light_by_curve(encoded);
}

double srgb_of_light(double light) {
    const double c = std::abs(light);
    return std::copysign(c <= .0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - .055, light);
}

float value_at(const Image& image, std::size_t index) {
    return image.srgb && !is_alpha(image, index) ? decoded(image, index) : number_at(image, index);
}

Image to_half(const Image& image) {
    if (image.type == PixelType::f16 && !image.srgb) return image;
    Image result = image;
    result.type = PixelType::f16;
    result.srgb = false;
    result.pixels.resize(result.bytes());
    for (std::size_t i = 0; i < result.pixels.size() / 2; ++i) {
        const std::uint16_t half = float_to_half(value_at(image, i));
        std::memcpy(result.pixels.data() + 2 * i, &half, 2);
    }
    return result;
}

Image to_bytes(const Image& image) {
    if (image.type == PixelType::u8) return image;
    Image result = image;
    result.type = PixelType::u8;
    result.srgb = false;
    result.pixels.resize(result.bytes());
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        const float value = value_at(image, i);
        const float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;
        result.pixels[i] = static_cast<std::byte>(std::lround(clamped * 255.0f));
    }
    return result;
}

// Replaces non-finite values of floating-point images, because filtering would spread a single NaN over the whole mip
// chain.

namespace {

constexpr float half_max = 65504.0f;

// Accesses width · height · depth · channels values in place.
class Grid {
public:
    Grid(const Image& shape, const std::vector<float>& values) : shape_(shape), values_(values) {}

    // Calls each(k) for the value itself and its eight neighbours in the same slice and channel.
    template <class Each>
    void around(std::size_t i, Each each) const {
        const auto channels = static_cast<std::size_t>(shape_.channels);
        const auto width = static_cast<std::int64_t>(shape_.width), height = static_cast<std::int64_t>(shape_.height);
        const auto texel = static_cast<std::int64_t>(i / channels);
        const std::int64_t x = texel % width, y = texel / width % height, slice = texel / width / height;
        for (std::int64_t v = std::max<std::int64_t>(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
            for (std::int64_t u = std::max<std::int64_t>(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                each(static_cast<std::size_t>((slice * height + v) * width + u) * channels + i % channels);
    }

    // The mean of the finite values around it; NaN if none is finite.
    float mean_around(std::size_t i) const {
        double sum = 0;
        int count = 0;
        around(i, [&](std::size_t k) {
            if (!std::isfinite(values_[k])) return;
            sum += static_cast<double>(values_[k]);
            ++count;
        });
        return count > 0 ? static_cast<float>(sum / count) : std::nanf("");
    }

private:
    const Image& shape_;
    const std::vector<float>& values_;
};

// Fills each hole from its edge inwards, one ring per round, so that the result does not depend on the order in which
// texels are visited. What has no finite value around it becomes 0. Returns the indices of the values that were
// replaced.
std::vector<std::size_t> mend(const Image& shape, std::vector<float>& values) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i])) all.push_back(i);
    const Grid grid(shape, values);
    std::vector<std::size_t> ring = all;  // later only what is next to the last ring: a hole may be wide
    while (!ring.empty()) {
        std::vector<std::pair<std::size_t, float>> found;
        for (const std::size_t i : ring)
            if (const float mean = grid.mean_around(i); !std::isnan(mean)) found.emplace_back(i, mean);
        for (const auto& [i, mean] : found) values[i] = mean;
        ring.clear();
        for (const auto& [i, mean] : found)
            grid.around(i, [&](std::size_t k) {
                if (!std::isfinite(values[k])) ring.push_back(k);
            });
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    }
    for (const std::size_t i : all)
        if (!std::isfinite(values[i])) values[i] = 0;
    return all;
}

}  // namespace

ImageResult half_image(Image shape, std::vector<float> values) {
    ImageResult result;
    result.replaced = mend(shape, values);
    if (const std::size_t count = result.replaced.size(); count > 0) {
        result.issues.push_back(
            {false, "image-non-finite",
             counted(count, "value") + " of the image " + (count == 1 ? "is" : "are") +
                 (count == 1 ? " infinite or NaN; it is replaced by the mean of its neighbours"
                             : " infinite or NaN; they are replaced by the mean of their neighbours"),
             "save the image with finite values"});
    }
    shape.type = PixelType::f16;
    shape.pixels.resize(shape.bytes());
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        float value = values[i];
        if (std::abs(value) > half_max) {
            value = std::copysign(half_max, value);
            ++clamped;
        }
        const std::uint16_t half = float_to_half(value);
        std::memcpy(shape.pixels.data() + 2 * i, &half, 2);
    }
    if (clamped > 0) {
        result.issues.push_back({false, "image-clamped",
                                 counted(clamped, "value") + " of the image " +
                                     (clamped == 1 ? "exceeds 65504, the largest half float; it is clamped"
                                                   : "exceed 65504, the largest half float; they are clamped"),
                                 "scale the image's values down"});
    }
    result.image = std::move(shape);
    return result;
}

}  // namespace snell::content
