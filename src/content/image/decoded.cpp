#include "src/content/image/decoded.h"

#include <array>
#include <cstring>

#include "src/content/image/formats.h"

namespace snell::content {

namespace {

constexpr std::string_view magic = "SNELLIMG";
constexpr std::size_t header_bytes = magic.size() + 20;

}  // namespace

std::vector<std::byte> decoded_file(const Image& image) {
    const Image top_first = image.bottom_first ? flipped(image) : image;
    std::vector<std::byte> file(header_bytes);
    std::memcpy(file.data(), magic.data(), magic.size());
    std::size_t at = magic.size();
    for (const int number : {image.width, image.height, image.depth, image.channels, static_cast<int>(image.type)})
        for (int shift = 0; shift < 32; shift += 8)
            file[at++] = static_cast<std::byte>(static_cast<std::uint32_t>(number) >> shift);
    file.insert(file.end(), top_first.pixels.begin(), top_first.pixels.end());
    return file;
}

bool is_decoded_file(std::string_view bytes) { return bytes.starts_with(magic); }

ImageResult read_decoded_file(std::string_view bytes, const ImageLimits& limits) {
    const auto damaged = [] { return image_failed("image-unreadable", "the decoded image is damaged"); };
    if (bytes.size() < header_bytes) return damaged();
    Image image;
    image.width = read_i32(bytes, 8);
    image.height = read_i32(bytes, 12);
    image.depth = read_i32(bytes, 16);
    image.channels = read_i32(bytes, 20);
    const std::uint32_t type = read_u32(bytes, 24);
    if (image.channels < 1 || image.channels > 4 || type > 2) return damaged();
    image.type = static_cast<PixelType>(type);
    if (auto issue = check_size("decoded", image.width, image.height, image.depth, image.pixel_bytes(), limits))
        return {{}, {*issue}};
    if (bytes.size() - header_bytes != image.bytes()) return damaged();
    const auto* first = reinterpret_cast<const std::byte*>(bytes.data()) + header_bytes;
    image.pixels.assign(first, first + image.bytes());
    ImageResult result;
    result.image = std::move(image);
    return result;
}

}  // namespace snell::content
