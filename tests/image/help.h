// What the tests of pictures share.
#pragma once

#include "src/content/image/image.h"
#include "tests/oracle/compare.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::content {

using Texel = std::array<int, 4>;

// A file put together byte by byte.
class Bytes {
public:
    Bytes& text(std::string_view t) { return bytes_ += t, *this; }
    Bytes& u8(std::uint32_t v) { return bytes_ += static_cast<char>(v), *this; }
    Bytes& list(std::initializer_list<std::uint32_t> values) {
        for (const std::uint32_t v : values) u8(v);
        return *this;
    }
    Bytes& u16(std::uint32_t v) { return u8(v & 255).u8(v >> 8 & 255); }
    Bytes& u32(std::uint32_t v) { return u16(v & 65535).u16(v >> 16); }
    Bytes& i32(std::int32_t v) { return u32(static_cast<std::uint32_t>(v)); }
    Bytes& f32(float v) { return u32(std::bit_cast<std::uint32_t>(v)); }
    Bytes& zeros(std::size_t n) { return bytes_.append(n, '\0'), *this; }
    std::size_t size() const { return bytes_.size(); }
    const std::string& str() const { return bytes_; }

private:
    std::string bytes_;
};

// An 8-bit texel as RGBA: grey is spread, alpha is 255 where there is none.
inline Texel texel(const Image& image, int x, int y, int z = 0) {
    const auto row =
        (static_cast<std::size_t>(z) * static_cast<std::size_t>(image.height) + static_cast<std::size_t>(y));
    const std::byte* p =
        image.pixels.data() + row * image.row_bytes() + static_cast<std::size_t>(x) * image.pixel_bytes();
    const auto c = [&](std::size_t i) { return std::to_integer<int>(p[i]); };
    switch (image.channels) {
        case 1:
            return {c(0), c(0), c(0), 255};
        case 2:
            return {c(0), c(0), c(0), c(1)};
        case 3:
            return {c(0), c(1), c(2), 255};
        default:
            return {c(0), c(1), c(2), c(3)};
    }
}

inline bool has_issue(const ImageResult& result, std::string_view code) {
    for (const ImageIssue& issue : result.issues) {
        if (issue.code == code) return true;
    }
    return false;
}

inline std::string describe(const ImageResult& result) {
    std::string text;
    for (const ImageIssue& issue : result.issues) text += "[" + issue.code + "] " + issue.message + "\n";
    return text;
}

// Of any type, filled by value(x, y, channel).
template <class Value>
Image paint(int width, int height, int channels, PixelType type, const Value& value) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.type = type;
    image.pixels.resize(image.bytes());
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c, ++i) {
                const auto v = static_cast<float>(value(x, y, c));
                const std::uint16_t half = float_to_half(v);
                if (type == PixelType::u8) image.pixels[i] = static_cast<std::byte>(std::lround(v * 255));
                if (type == PixelType::f16) std::memcpy(image.pixels.data() + 2 * i, &half, 2);
                if (type == PixelType::f32) std::memcpy(image.pixels.data() + 4 * i, &v, 4);
            }
        }
    }
    return image;
}

inline ImageResult read_file(const std::filesystem::path& path) { return decode_image(path.string(), bytes_of(path)); }

// A folder of its own for each test, gone afterwards.
class ScratchFolder : public ::testing::Test {
protected:
    std::string file(const std::string& name) const { return folder_.path(name); }
    std::string put(const std::string& name, std::string_view bytes) const { return folder_.write(name, bytes); }
    std::size_t entries() const { return folder_.entries(); }

    const Scratch folder_;
};

}  // namespace snell::content
