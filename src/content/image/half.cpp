#include <bit>
#include <cstring>

#include "src/content/image/image.h"

namespace snell::content {

float half_to_float(std::uint16_t half) {
    const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000u) << 16;
    const std::uint32_t magnitude = half & 0x7fffu;
    if (magnitude >= 0x7c00u) {  // infinity or NaN
        return std::bit_cast<float>(sign | 0x7f800000u | (magnitude & 0x3ffu) << 13);
    }
    // After the shift the exponent has the wrong bias. Multiplication by 2^112 corrects normal and subnormal numbers
    // alike, exactly.
    const float unbiased = std::bit_cast<float>(magnitude << 13) * 0x1p112f;
    return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(unbiased));
}

std::uint16_t float_to_half(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) return static_cast<std::uint16_t>(sign | 0x7e00u);   // NaN
    if (magnitude >= 0x477ff000u) return static_cast<std::uint16_t>(sign | 0x7c00u);  // rounds to 65536 or more
    if (magnitude < 0x38800000u) {
        // For subnormal results, adding 1/2 makes the floating-point unit round to a multiple of 2^-24, to nearest
        // even.
        const float shifted = std::bit_cast<float>(magnitude) + 0.5f;
        return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(shifted) - 0x3f000000u));
    }
    const std::uint32_t odd = magnitude >> 13 & 1u;
    return static_cast<std::uint16_t>(sign | (magnitude - 0x38000000u + 0xfffu + odd) >> 13);
}

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

Image to_half(const Image& image) {
    if (image.type == PixelType::f16) return image;
    Image result = image;
    result.type = PixelType::f16;
    result.pixels.resize(result.bytes());
    for (std::size_t i = 0; i < result.pixels.size() / 2; ++i) {
        const std::uint16_t half = float_to_half(value_at(image, i));
        std::memcpy(result.pixels.data() + 2 * i, &half, 2);
    }
    return result;
}

}  // namespace snell::content
