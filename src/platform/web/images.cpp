// Decodes images by stb_image, which a page has in place of libpng and OpenImageIO.
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_NO_BMP
#define STBI_NO_PIC
#include <stb/stb_image.h>

#include "src/content/image/formats.h"

namespace snell::content {

namespace {

using Pixels = std::unique_ptr<void, decltype(&stbi_image_free)>;

struct Picture {
    std::string_view bytes, name;
    const stbi_uc* data() const { return reinterpret_cast<const stbi_uc*>(bytes.data()); }
    int size() const { return static_cast<int>(bytes.size()); }
};

ImageResult unreadable(const Picture& picture, const std::string& why) {
    return image_failed("image-unreadable", std::string(picture.name) + " image: " + why, "save it as PNG");
}

std::size_t values_of(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
           static_cast<std::size_t>(image.channels);
}

ImageResult from_floats(Image image, const Picture& picture) {
    const Pixels pixels(
        stbi_loadf_from_memory(picture.data(), picture.size(), &image.width, &image.height, &image.channels, 0),
        stbi_image_free);
    if (!pixels) return unreadable(picture, stbi_failure_reason());
    const auto* first = static_cast<const float*>(pixels.get());
    return half_image(image, std::vector<float>(first, first + values_of(image)));
}

ImageResult from_16_bits(Image image, const Picture& picture) {
    const Pixels pixels(
        stbi_load_16_from_memory(picture.data(), picture.size(), &image.width, &image.height, &image.channels, 0),
        stbi_image_free);
    if (!pixels) return unreadable(picture, stbi_failure_reason());
    const auto* first = static_cast<const stbi_us*>(pixels.get());
    std::vector<float> values(first, first + values_of(image));
    for (float& value : values) value /= 65535.0f;
    return half_image(image, std::move(values));
}

ImageResult from_bytes(Image image, const Picture& picture) {
    const Pixels pixels(
        stbi_load_from_memory(picture.data(), picture.size(), &image.width, &image.height, &image.channels, 0),
        stbi_image_free);
    if (!pixels) return unreadable(picture, stbi_failure_reason());
    const auto* first = static_cast<const std::byte*>(pixels.get());
    image.pixels.assign(first, first + values_of(image));
    ImageResult result;
    result.image = std::move(image);
    return result;
}

ImageResult decode(const Picture& picture, const ImageLimits& limits) {
    Image image;
    if (!stbi_info_from_memory(picture.data(), picture.size(), &image.width, &image.height, &image.channels))
        return unreadable(picture, stbi_failure_reason());
    const bool hdr = stbi_is_hdr_from_memory(picture.data(), picture.size());
    const bool wide = stbi_is_16_bit_from_memory(picture.data(), picture.size());
    const std::size_t pixel_bytes = static_cast<std::size_t>(image.channels) * (hdr || wide ? 2 : 1);
    if (auto issue = check_size(picture.name, image.width, image.height, 1, pixel_bytes, limits)) return {{}, {*issue}};
    return hdr    ? from_floats(std::move(image), picture)
           : wide ? from_16_bits(std::move(image), picture)
                  : from_bytes(std::move(image), picture);
}

// Finds the orientation in the first directory of EXIF's data, which is a TIFF file; 1 if there is none.
int orientation_in(std::string_view tiff) {
    constexpr std::uint32_t tag = 0x0112, entry_bytes = 12;
    const bool little = tiff.starts_with("II");
    const auto u16 = [&](std::size_t at) { return little ? read_u16(tiff, at) : read_big_u32(tiff, at) >> 16; };
    const auto u32 = [&](std::size_t at) { return little ? read_u32(tiff, at) : read_big_u32(tiff, at); };
    if (tiff.size() < 8 || (!little && !tiff.starts_with("MM"))) return 1;
    std::size_t at = u32(4);
    if (at > tiff.size() || tiff.size() - at < 4) return 1;
    const std::uint32_t count = u16(at);
    at += 2;
    for (std::uint32_t i = 0; i < count && at + entry_bytes <= tiff.size(); ++i, at += entry_bytes)
        if (u16(at) == tag) return static_cast<int>(u16(at + 8));
    return 1;
}

// A JPEG file is a list of segments, with their lengths, until the picture begins.
int orientation_of(std::string_view jpeg) {
    using std::string_view_literals::operator""sv;
    for (std::size_t at = 2; at + 4 <= jpeg.size() && jpeg[at] == '\xff' && jpeg[at + 1] != '\xda';) {
        const std::size_t length =
            static_cast<unsigned char>(jpeg[at + 2]) * 256U + static_cast<unsigned char>(jpeg[at + 3]);
        const std::string_view segment = jpeg.substr(at + 4, length < 2 ? 0 : length - 2);
        if (jpeg[at + 1] == '\xe1' && segment.starts_with("Exif\0\0"sv)) return orientation_in(segment.substr(6));
        at += 2 + length;
    }
    return 1;
}

}  // namespace

ImageResult decode_png(std::string_view bytes, const ImageLimits& limits) { return decode({bytes, "PNG"}, limits); }

ImageResult decode_other(std::string_view bytes, std::string_view format, const ImageLimits& limits) {
    for (const std::string_view known : {"jpeg", "targa", "hdr", "gif", "psd", "pnm", ""})
        if (format == known) {
            ImageResult result = decode({bytes, format.empty() ? "unknown" : format}, limits);
            if (result.image && format == "jpeg") result.image = oriented(*result.image, orientation_of(bytes));
            return result;
        }
    return image_failed("image-unreadable",
                        "a page in a browser reads no " + std::string(format) +
                            " images: it reads PNG, JPEG, BMP, TGA, HDR, GIF, PSD, PNM and raw textures",
                        "save it as PNG; 'snell web' puts images of other formats into the page decoded");
}

}  // namespace snell::content
