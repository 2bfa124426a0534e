// Decodes Windows and OS/2 bitmaps: headers of 12, 40 (Windows 3), 52, 56, 64 (OS/2 2), 108 (V4) and 124 (V5) bytes; 1,
// 2, 4 and 8 bits with a palette, also run-length coded; 16, 24 and 32 bits, with or without bit masks.
#include <algorithm>
#include <bit>
#include <limits>

#include "src/content/image/formats.h"

namespace snell::content {
namespace {

constexpr std::size_t file_header = 14;
enum Compression : std::uint32_t { rgb = 0, rle8 = 1, rle4 = 2, bitfields = 3, alpha_bitfields = 6 };

struct Rgba {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
};

// The contents of the headers.
struct Layout {
    std::int64_t width = 0, height = 0;
    bool top_down = false;
    std::uint32_t bits = 0, compression = rgb;
    std::size_t header_size = 0, palette_at = 0, pixels_at = 0;
    std::size_t palette_entry = 4;
    std::array<std::uint32_t, 4> masks{};  // in the order r g b a
    std::array<Rgba, 256> palette{};

    std::size_t stride() const { return (static_cast<std::size_t>(width) * bits + 31) / 32 * 4; }
    bool run_length() const { return compression == rle8 || compression == rle4; }
};

bool known_header(std::uint32_t size) {
    return size == 12 || size == 40 || size == 52 || size == 56 || size == 64 || size == 108 || size == 124;
}

std::string read_sizes(std::string_view bytes, Layout& layout) {
    if (bytes.size() < file_header + 12) return "the file ends within its header";
    layout.header_size = read_u32(bytes, file_header);
    if (!known_header(static_cast<std::uint32_t>(layout.header_size)))
        return "the header has " + std::to_string(layout.header_size) + " bytes, which is not a valid BMP header size";
    if (bytes.size() < file_header + layout.header_size) return "the file ends within its header";
    if (layout.header_size == 12) {
        layout.width = read_u16(bytes, 18);
        layout.height = read_u16(bytes, 20);
        layout.bits = read_u16(bytes, 24);
        layout.palette_entry = 3;
    } else {
        layout.width = read_i32(bytes, 18);
        layout.height = read_i32(bytes, 22);
        layout.bits = read_u16(bytes, 28);
        layout.compression = read_u32(bytes, 30);
    }
    layout.top_down = layout.height < 0;
    if (layout.top_down) layout.height = -layout.height;
    if (layout.width <= 0 || layout.height <= 0)
        return "invalid size " + std::to_string(layout.width) + " x " + std::to_string(layout.height);
    return {};
}

std::string check_coding(const Layout& layout) {
    const std::string bits = std::to_string(layout.bits) + " bits per pixel";
    switch (layout.compression) {
        case rgb:
            for (const std::uint32_t known : {1u, 2u, 4u, 8u, 16u, 24u, 32u}) {
                if (layout.bits == known) return {};
            }
            return bits + " are not supported";
        case rle8:
            return layout.bits == 8 ? "" : "8-bit run-length coding cannot have " + bits;
        case rle4:
            return layout.bits == 4 ? "" : "4-bit run-length coding cannot have " + bits;
        case bitfields:
        case alpha_bitfields:
            return layout.bits == 16 || layout.bits == 32 ? "" : "bit masks cannot have " + bits;
        default:
            return "compression type " + std::to_string(layout.compression) + " is not supported";
    }
}

// Masks are inside of headers of 52 bytes and more, but follow the one of 40 bytes.
void read_masks(std::string_view bytes, Layout& layout) {
    layout.palette_at = file_header + layout.header_size;
    if (layout.bits == 16) layout.masks = {0x7c00, 0x03e0, 0x001f, 0};
    if (layout.bits == 32) layout.masks = {0xff0000, 0xff00, 0xff, 0xff000000};
    if (layout.compression != bitfields && layout.compression != alpha_bitfields) return;
    std::size_t count = layout.header_size >= 56 || layout.compression == alpha_bitfields ? 4 : 3;
    if (layout.header_size == 64) count = 3;
    constexpr std::size_t masks_at = 54;
    layout.masks = {};
    for (std::size_t i = 0; i < count && masks_at + 4 * i + 4 <= bytes.size(); ++i)
        layout.masks[i] = read_u32(bytes, masks_at + 4 * i);
    if (layout.header_size == 40) layout.palette_at += 4 * count;
}

void read_palette(std::string_view bytes, Layout& layout) {
    std::size_t count = 0;
    if (layout.bits <= 8) {
        count = std::size_t{1} << layout.bits;
        const std::size_t used = layout.header_size >= 40 ? read_u32(bytes, 46) : 0;
        if (used != 0 && used < count) count = used;
    }
    std::size_t end = bytes.size();
    if (layout.pixels_at > layout.palette_at && layout.pixels_at < end) end = layout.pixels_at;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = layout.palette_at + i * layout.palette_entry;
        if (at + 3 > end) return;
        const auto byte = [&](std::size_t k) { return static_cast<std::uint8_t>(bytes[at + k]); };
        layout.palette[i] = {byte(2), byte(1), byte(0), 255};
    }
}

// The start of the pixels if the file's value is missing or invalid.
std::size_t natural_start(std::string_view bytes, const Layout& layout) {
    std::size_t colors = layout.bits <= 8 ? std::size_t{1} << layout.bits : 0;
    const std::size_t used = layout.header_size >= 40 ? read_u32(bytes, 46) : 0;
    if (used != 0 && used <= 256) colors = used;
    return layout.palette_at + colors * layout.palette_entry;
}

// Extracts a mask's bits and scales them to 0..255, rounded.
struct Channel {
    std::uint32_t mask = 0;
    int shift = 0;
    std::uint64_t top = 0;

    explicit Channel(std::uint32_t m) : mask(m), shift(m ? std::countr_zero(m) : 0), top(m >> shift) {}
    std::uint8_t of(std::uint32_t pixel, std::uint8_t absent) const {
        if (mask == 0) return absent;
        const std::uint64_t value = (pixel & mask) >> shift;
        return static_cast<std::uint8_t>(top == 255 ? value : (value * 255 + top / 2) / top);
    }
};

class Rows {
public:
    Rows(const Layout& layout, Image& image) : layout_(layout), image_(image) {}

    Rgba* row(std::int64_t from_start) {
        const std::int64_t y = layout_.top_down ? from_start : layout_.height - 1 - from_start;
        return reinterpret_cast<Rgba*>(image_.pixels.data() + static_cast<std::size_t>(y) * image_.row_bytes());
    }
    // `data` must hold `count` whole pixels.
    void decode(std::string_view data, std::size_t count, Rgba* out) const {
        if (layout_.bits <= 8) return palette(data, count, out);
        if (layout_.bits == 24) {
            for (std::size_t x = 0; x < count; ++x) {
                const auto* p = reinterpret_cast<const std::uint8_t*>(data.data()) + 3 * x;
                out[x] = {p[2], p[1], p[0], 255};
            }
            return;
        }
        for (std::size_t x = 0; x < count; ++x) {
            const std::uint32_t p = layout_.bits == 16 ? read_u16(data, 2 * x) : read_u32(data, 4 * x);
            out[x] = {r_.of(p, 0), g_.of(p, 0), b_.of(p, 0), a_.of(p, 255)};
        }
    }

private:
    void palette(std::string_view data, std::size_t count, Rgba* out) const {
        const std::size_t bits = layout_.bits;
        for (std::size_t x = 0; x < count; ++x) {
            const auto byte = static_cast<unsigned char>(data[x * bits / 8]);
            const std::size_t shift = 8 - bits - x * bits % 8;
            out[x] = layout_.palette[byte >> shift & ((1u << bits) - 1u)];
        }
    }

    const Layout& layout_;
    Image& image_;
    Channel r_{layout_.masks[0]}, g_{layout_.masks[1]}, b_{layout_.masks[2]}, a_{layout_.masks[3]};
};

// Both functions return the number of complete rows.
std::int64_t decode_plain(std::string_view data, const Layout& layout, Rows rows) {
    const auto width = static_cast<std::size_t>(layout.width);
    const std::size_t stride = layout.stride();
    for (std::int64_t y = 0; y < layout.height; ++y) {
        const std::size_t start = std::min(data.size(), static_cast<std::size_t>(y) * stride);
        const std::string_view rest = data.substr(start);
        // The padding of the last row may be missing.
        const std::size_t there = std::min(width, rest.size() * 8 / layout.bits);
        rows.decode(rest, there, rows.row(y));
        if (there < width) return y;
    }
    return layout.height;
}

std::int64_t decode_runs(std::string_view data, const Layout& layout, Rows rows) {
    for (std::int64_t y = 0; y < layout.height; ++y) std::fill_n(rows.row(y), layout.width, layout.palette[0]);
    const bool nibbles = layout.compression == rle4;
    const auto color = [&](unsigned byte, unsigned k) -> Rgba {
        return layout.palette[nibbles ? (k % 2 == 0 ? byte >> 4 : byte & 15u) : byte];
    };
    std::int64_t x = 0, y = 0;
    const auto put = [&](Rgba value) {
        if (x < layout.width && y < layout.height) rows.row(y)[x] = value;
        ++x;
    };
    std::size_t at = 0;
    const auto next = [&] { return static_cast<unsigned char>(data[at++]); };
    while (at + 2 <= data.size() && y < layout.height) {
        const unsigned count = next(), value = next();
        if (count > 0) {
            for (unsigned k = 0; k < count; ++k) put(color(value, k));
        } else if (value == 0) {  // end of the row
            x = 0;
            ++y;
        } else if (value == 1) {  // end of the image
            return layout.height;
        } else if (value == 2) {  // skip
            if (at + 2 > data.size()) break;
            x += next();
            y += next();
        } else {  // literal pixels, padded to 16 bits
            const std::size_t size = nibbles ? (value + 1) / 2 : value;
            if (at + size > data.size()) break;
            for (unsigned k = 0; k < value; ++k)
                put(color(static_cast<unsigned char>(data[at + (nibbles ? k / 2 : k)]), k));
            at += size + size % 2;
        }
    }
    if (y == layout.height - 1 && x >= layout.width) return layout.height;
    return y;
}

// Makes a 32-bit bitmap opaque if its alpha is 0 everywhere: its writer did not set it.
void mend_alpha(Image& image) {
    auto* const first = reinterpret_cast<Rgba*>(image.pixels.data());
    Rgba* const last = first + image.pixels.size() / sizeof(Rgba);
    if (std::any_of(first, last, [](const Rgba& p) { return p.a != 0; })) return;
    std::for_each(first, last, [](Rgba& p) { p.a = 255; });
}

ImageResult unreadable(const std::string& why) {
    return image_failed("image-unreadable", "BMP image: " + why, "save it as a 24-bit BMP or as PNG");
}

}  // namespace

std::optional<ImageHeader> bmp_header(std::string_view first_bytes) {
    Layout layout;
    if (!read_sizes(first_bytes, layout).empty()) return std::nullopt;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return ImageHeader{"bmp", static_cast<int>(layout.width), static_cast<int>(std::min(layout.height, most)), 1};
}

ImageResult decode_bmp(std::string_view bytes, const ImageLimits& limits) {
    Layout layout;
    if (const std::string why = read_sizes(bytes, layout); !why.empty()) return unreadable(why);
    if (const std::string why = check_coding(layout); !why.empty()) return unreadable(why);
    if (auto issue = check_size("BMP", layout.width, layout.height, 1, sizeof(Rgba), limits)) return {{}, {*issue}};
    read_masks(bytes, layout);
    layout.pixels_at = read_u32(bytes, 10);
    if (layout.pixels_at < file_header + layout.header_size || layout.pixels_at > bytes.size())
        layout.pixels_at = natural_start(bytes, layout);
    read_palette(bytes, layout);
    if (layout.pixels_at >= bytes.size()) return unreadable("the file ends before the first pixel");

    ImageResult result;
    Image& image = result.image.emplace();
    image.width = static_cast<int>(layout.width);
    image.height = static_cast<int>(layout.height);
    image.pixels.resize(image.bytes());
    const std::string_view data = bytes.substr(layout.pixels_at);
    const Rows rows(layout, image);
    const std::int64_t whole = layout.run_length() ? decode_runs(data, layout, rows) : decode_plain(data, layout, rows);
    if (whole < layout.height) {
        result.issues.push_back({false, "image-truncated",
                                 "BMP image: the file ends after " + std::to_string(whole) + " of " +
                                     std::to_string(layout.height) + " rows; the missing rows are empty",
                                 "copy the file again, it is incomplete"});
    }
    if (layout.bits == 32) mend_alpha(image);
    return result;
}

}  // namespace snell::content
