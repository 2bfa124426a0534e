// Decodes glman's raw textures: one, two or three little-endian 32-bit sizes, then RGBA texels, either all bytes or all
// floats. Only the size of the file tells which.
#include <algorithm>
#include <cstring>
#include <limits>

#include "src/content/image/formats.h"

namespace snell::content {
namespace {

struct RawLayout {
    int dimensions = 0;
    bool floats = false;
    std::array<std::int64_t, 3> size{1, 1, 1};

    std::size_t data_at() const { return static_cast<std::size_t>(dimensions) * 4; }
    std::string text() const {
        std::string result = std::to_string(size[0]);
        for (int i = 1; i < dimensions; ++i) result += " x " + std::to_string(size[static_cast<std::size_t>(i)]);
        return result + (floats ? " floats" : " bytes");
    }
};

// The size of a whole file with this layout, in bytes; 0 if no file can be that large.
std::size_t file_bytes(const RawLayout& reading) {
    std::uint64_t texels = 1;
    for (const std::int64_t side : reading.size) {
        if (side <= 0 || texels > (std::uint64_t{1} << 48) / static_cast<std::uint64_t>(side)) return 0;
        texels *= static_cast<std::uint64_t>(side);
    }
    return texels * (reading.floats ? 16 : 4) + reading.data_at();
}

std::vector<RawLayout> readings(std::string_view first_bytes, std::size_t file_size) {
    std::vector<RawLayout> result;
    RawLayout reading;
    for (reading.dimensions = 1; reading.dimensions <= 3; ++reading.dimensions) {
        const auto i = static_cast<std::size_t>(reading.dimensions - 1);
        if (first_bytes.size() < 4 * i + 4) break;
        reading.size[i] = read_i32(first_bytes, 4 * i);
        if (reading.size[i] <= 0) break;
        for (const bool floats : {false, true}) {
            reading.floats = floats;
            if (file_bytes(reading) == file_size) result.push_back(reading);
        }
    }
    return result;
}

ImageResult no_reading(std::string_view bytes) {
    std::string numbers;
    for (std::size_t at = 0; at + 4 <= bytes.size() && at < 12; at += 4)
        numbers += " " + std::to_string(read_i32(bytes, at));
    std::string message = "raw texture: the file has " + std::to_string(bytes.size()) + " bytes, ";
    message += numbers.empty() ? "too few for a size"
                               : "which does not match the sizes at its start (" + numbers.substr(1) + ")";
    return image_failed("image-unreadable", message,
                        "a .tex file is 1, 2 or 3 sizes of 4 bytes, then RGBA texels of 4 bytes or of 4 floats");
}

}  // namespace

std::optional<ImageHeader> tex_header(std::string_view first_bytes, std::size_t file_size) {
    const auto found = readings(first_bytes, file_size);
    if (found.size() != 1) return std::nullopt;
    const auto& size = found.front().size;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    const auto side = [&](std::size_t i) { return static_cast<int>(std::min(size[i], most)); };
    return ImageHeader{"tex", side(0), side(1), side(2)};
}

ImageResult decode_tex(std::string_view bytes, const ImageLimits& limits) {
    const auto found = readings(bytes, bytes.size());
    if (found.empty()) return no_reading(bytes);
    if (found.size() > 1) {
        return image_failed("image-ambiguous",
                            "raw texture: " + std::to_string(bytes.size()) +
                                " bytes are ambiguous: " + found[0].text() + " or " + found[1].text(),
                            "save it as PNG, or change its size by one texel");
    }
    const RawLayout& reading = found.front();
    const auto [width, height, depth] = reading.size;
    if (auto issue = check_size("raw texture", width, height, depth, reading.floats ? 8 : 4, limits))
        return {{}, {*issue}};
    Image image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.depth = static_cast<int>(depth);
    image.bottom_first = true;
    const std::string_view texels = bytes.substr(reading.data_at());
    if (reading.floats) {
        std::vector<float> values(texels.size() / sizeof(float));
        std::memcpy(values.data(), texels.data(), values.size() * sizeof(float));
        return half_image(std::move(image), std::move(values));
    }
    image.pixels.resize(texels.size());
    std::memcpy(image.pixels.data(), texels.data(), texels.size());
    ImageResult result;
    result.image = std::move(image);
    return result;
}

}  // namespace snell::content
