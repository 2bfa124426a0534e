#include "src/content/image/image.h"

#include <algorithm>
#include <cstring>

#include "parser/text/words.h"
#include "src/content/image/formats.h"

namespace snell::content {
namespace {

std::size_t channel_bytes(PixelType type) {
    constexpr std::array<std::size_t, 3> bytes{1, 2, 4};  // as PixelType
    return bytes[static_cast<std::size_t>(type)];
}

// The value 1 in a channel of this type.
std::array<std::byte, 4> one(PixelType type) {
    std::array<std::byte, 4> bytes{std::byte{255}};
    const std::uint16_t half = 0x3c00;
    const float full = 1;
    if (type == PixelType::f16) std::memcpy(bytes.data(), &half, 2);
    if (type == PixelType::f32) std::memcpy(bytes.data(), &full, 4);
    return bytes;
}

ImageResult not_a_picture(std::string_view format) {
    if (format == "git-lfs") {
        return image_failed("image-unreadable", "the file is a Git LFS pointer, not an image",
                            "run 'git lfs pull' to download the images");
    }
    return image_failed("image-unreadable", "the file contains " + raised(format) + ", not an image",
                        format == "html" ? "download the image itself, not the page that shows it"
                                         : "save the image as PNG, JPEG, BMP, HDR or EXR");
}

// Formats of light in floats, by the names that sniff() gives.
bool holds_light(std::string_view format) { return format == "hdr" || format == "openexr"; }

ImageResult decode_as(std::string_view format, std::string_view named, std::string_view bytes,
                      const ImageLimits& limits) {
    if (format == "bmp") return decode_bmp(bytes, limits);
    if (format == "png") return decode_png(bytes, limits);
    if (format == "tex") return decode_tex(bytes, limits);
    for (const std::string_view other : {"html", "svg", "pdf", "zip", "git-lfs"}) {
        if (format == other) return not_a_picture(format);
    }
    // Some of OpenImageIO's readers allocate memory for the whole image before its size can be queried.
    if (const auto header = format.empty() ? std::nullopt : read_header(bytes, bytes.size())) {
        if (auto issue = check_size(format, header->width, header->height, header->depth, 1, limits))
            return {{}, {*issue}};
    }
    return decode_other(bytes, format.empty() ? named : format, limits);
}

constexpr std::string_view magic = "SNELLIMG";
constexpr std::size_t header_bytes = magic.size() + 20;

}  // namespace

std::size_t Image::pixel_bytes() const { return static_cast<std::size_t>(channels) * channel_bytes(type); }

ImageResult image_failed(std::string code, std::string message, std::string help) {
    return {{}, {{true, std::move(code), std::move(message), std::move(help)}}};
}

std::optional<ImageIssue> check_size(std::string_view format, std::int64_t width, std::int64_t height,
                                     std::int64_t depth, std::size_t pixel_bytes, const ImageLimits& limits) {
    const auto too_large = [&](const std::string& limit, std::string help) {
        const std::string size =
            std::to_string(width) + " x " + std::to_string(height) + (depth > 1 ? " x " + std::to_string(depth) : "");
        return ImageIssue{true, "image-too-large", std::string(format) + " image: " + size + " texels exceed " + limit,
                          "reduce the image; " + std::move(help)};
    };
    if (std::max({width, height, depth}) > limits.side) {
        return too_large("the limit of " + std::to_string(limits.side) + " texels per side",
                         limit_help(static_cast<std::uint64_t>(limits.side), &Limits::texture_side));
    }
    if (width <= 0 || height <= 0 || depth <= 0) {
        return ImageIssue{true, "image-unreadable", std::string(format) + " image: width or height is 0",
                          "save the image again"};
    }
    // Each factor is below 2^31, so the product of two fits; that of three is computed in floating point.
    const double bytes =
        static_cast<double>(width * height) * static_cast<double>(depth) * static_cast<double>(pixel_bytes);
    if (bytes > static_cast<double>(limits.bytes)) {
        return too_large("the limit of " + std::to_string(limits.bytes >> 20) + " MiB",
                         limit_help(limits.bytes, &Limits::texture_bytes));
    }
    return std::nullopt;
}

ImageResult decode_image(const std::string& path, std::string_view bytes, const ImageLimits& limits) {
    if (bytes.empty()) return image_failed("image-unreadable", "the file is empty", "copy the file again");
    const std::string extension = extension_of(path);
    const std::string_view named = format_of_extension(extension);
    if (is_decoded_file(bytes)) {
        ImageResult result = read_decoded_file(bytes, limits);
        if (result.image) result.image->light = holds_light(named);
        return result;
    }
    std::string_view format = sniff(bytes);
    // Raw textures have no signature: a file whose size matches its first numbers exactly is treated as one under any
    // name.
    if (format.empty() && (named == "tex" || (named != "targa" && tex_header(bytes, bytes.size())))) format = "tex";
    if (format.empty() && (named == "bmp" || named == "png")) format = named;  // their decoders report what is wrong
    const bool misnamed = !format.empty() && !named.empty() && format != named;
    ImageResult result = decode_as(format, named, bytes, limits);
    if (result.image) result.image->light = holds_light(format);
    if (misnamed && result.image) {
        result.issues.push_back({false, "image-misnamed",
                                 "the extension is ." + extension + ", but the file is in " + std::string(format) +
                                     " format; it is read as " + std::string(format),
                                 "rename it to ." + std::string(format)});
    }
    return result;
}

Image checkerboard(int size) {
    Image image;
    image.width = image.height = std::max(size, 1);
    image.pixels.resize(image.bytes(), std::byte{0});
    const int square = std::max(image.width / 8, 1);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::byte* const pixel =
                image.pixels.data() +
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
            if ((x / square + y / square) % 2 == 0) pixel[0] = pixel[2] = std::byte{255};
            pixel[3] = std::byte{255};
        }
    }
    return image;
}

Image flipped(Image image) {
    const std::size_t row = image.row_bytes(), slice = row * static_cast<std::size_t>(image.height);
    std::vector<std::byte> kept(row);
    for (std::size_t z = 0; z < image.pixels.size(); z += slice)
        for (std::byte *a = image.pixels.data() + z, *b = a + slice - row; a < b; a += row, b -= row) {
            std::memcpy(kept.data(), a, row);
            std::memcpy(a, b, row);
            std::memcpy(b, kept.data(), row);
        }
    image.bottom_first = !image.bottom_first;
    return image;
}

Image oriented(const Image& image, int orientation) {
    if (orientation < 2 || orientation > 8 || image.depth != 1) return image;
    const bool transposed = orientation >= 5;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image result = image;
    if (transposed) std::swap(result.width, result.height);
    const std::size_t size = image.pixel_bytes();
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            int u = transposed ? y : x, v = transposed ? x : y;
            if (from_right) u = image.width - 1 - u;
            if (from_bottom) v = image.height - 1 - v;
            const std::size_t to =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) + static_cast<std::size_t>(x);
            const std::size_t from =
                static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(u);
            std::memcpy(result.pixels.data() + to * size, image.pixels.data() + from * size, size);
        }
    }
    return result;
}

Image to_rgba(Image image) {
    if (image.channels == 4) return image;
    Image result = image;
    result.channels = 4;
    result.pixels.resize(result.bytes());
    const std::size_t size = channel_bytes(image.type), from = image.pixel_bytes(), to = result.pixel_bytes();
    const bool grey = image.channels <= 2, alpha = image.channels == 2;
    const auto opaque = one(image.type);
    const std::byte* in = image.pixels.data();
    std::byte* out = result.pixels.data();
    for (const std::byte* const end = in + image.pixels.size(); in != end; in += from, out += to) {
        for (std::size_t c = 0; c < 3; ++c) std::memcpy(out + c * size, in + (grey ? 0 : c * size), size);
        std::memcpy(out + 3 * size, alpha ? in + size : opaque.data(), size);
    }
    return result;
}

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
