// Reads the size of an image from its first bytes.
#include <algorithm>
#include <charconv>
#include <limits>

#include "parser/text/words.h"
#include "src/content/image/formats.h"

namespace snell::content {
namespace {

using std::string_view_literals::operator""sv;

int big_endian_16(std::string_view b, std::size_t at) {
    return static_cast<unsigned char>(b[at]) << 8 | static_cast<unsigned char>(b[at + 1]);
}

std::int64_t big_endian_32(std::string_view b, std::size_t at) { return read_big_u32(b, at); }

ImageHeader header_of(std::string_view format, std::int64_t width, std::int64_t height) {
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return {std::string(format), static_cast<int>(std::min(width, most)), static_cast<int>(std::min(height, most)), 1};
}

// The size is in the start-of-frame segment.
std::optional<ImageHeader> jpeg_header(std::string_view b) {
    for (std::size_t at = 2; at + 9 <= b.size();) {
        if (static_cast<unsigned char>(b[at]) != 0xff) return std::nullopt;
        const auto marker = static_cast<unsigned char>(b[at + 1]);
        if (marker == 0xff) {  // fill byte
            ++at;
            continue;
        }
        const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) return ImageHeader{"jpeg", big_endian_16(b, at + 7), big_endian_16(b, at + 5), 1};
        at += 2 + static_cast<std::size_t>(big_endian_16(b, at + 2));
    }
    return std::nullopt;
}

// Reads the line "-Y height +X width" that ends the header.
std::optional<ImageHeader> hdr_header(std::string_view b) {
    std::size_t at = b.find("\n-Y ");
    if (at == std::string_view::npos) return std::nullopt;
    ImageHeader header{"hdr", 0, 0, 1};
    const char* const end = b.data() + b.size();
    const auto height = std::from_chars(b.data() + at + 4, end, header.height);
    at = b.find(" +X ", at);
    if (height.ec != std::errc{} || at == std::string_view::npos) return std::nullopt;
    if (std::from_chars(b.data() + at + 4, end, header.width).ec != std::errc{}) return std::nullopt;
    return header;
}

// Reads the attribute "dataWindow" of type "box2i".
std::optional<ImageHeader> exr_header(std::string_view b) {
    constexpr std::string_view key = "dataWindow\0box2i\0"sv;
    const std::size_t at = b.find(key);
    if (at == std::string_view::npos || at + key.size() + 20 > b.size()) return std::nullopt;
    const auto number = [&](std::size_t i) { return std::int64_t{read_i32(b, at + key.size() + 4 + 4 * i)}; };
    const std::int64_t width = number(2) - number(0) + 1, height = number(3) - number(1) + 1;
    if (width <= 0 || height <= 0) return std::nullopt;
    return header_of("exr", width, height);
}

std::optional<ImageHeader> gif_header(std::string_view b) {
    if (b.size() < 10) return std::nullopt;
    return header_of("gif", read_u16(b, 6), read_u16(b, 8));
}

// Reads the first chunk: of the simple format (RFC 6386, 9.1), the lossless format, or the extended format with its
// canvas.
std::optional<ImageHeader> webp_header(std::string_view b) {
    if (b.size() < 30) return std::nullopt;
    const std::string_view chunk = b.substr(12, 4);
    if (chunk == "VP8 ") return header_of("webp", read_u16(b, 26) & 0x3fff, read_u16(b, 28) & 0x3fff);
    if (chunk == "VP8L") {
        const std::uint32_t sides = read_u32(b, 21);
        return header_of("webp", 1 + (sides & 0x3fff), 1 + (sides >> 14 & 0x3fff));
    }
    if (chunk == "VP8X") return header_of("webp", 1 + (read_u32(b, 23) >> 8), 1 + (read_u32(b, 26) >> 8));
    return std::nullopt;
}

// Reads the SIZ segment at the beginning of a codestream: the image's extent on the reference grid, and its offset
// there.
std::optional<ImageHeader> jpeg2000_header(std::string_view b) {
    const std::size_t at = b.find("\xff\x4f\xff\x51");
    if (at == std::string_view::npos || at + 24 > b.size()) return std::nullopt;
    return header_of("jpeg2000", std::max<std::int64_t>(big_endian_32(b, at + 8) - big_endian_32(b, at + 16), 0),
                     std::max<std::int64_t>(big_endian_32(b, at + 12) - big_endian_32(b, at + 20), 0));
}

// The largest extent of all items in the file: thumbnails and tiles have extents too.
std::optional<ImageHeader> heif_header(std::string_view b) {
    constexpr std::string_view extents = "ispe\0\0\0\0"sv;
    std::int64_t width = 0, height = 0;
    for (std::size_t at = b.find(extents); at != std::string_view::npos && at + 16 <= b.size();
         at = b.find(extents, at + 1)) {
        width = std::max(width, big_endian_32(b, at + 8));
        height = std::max(height, big_endian_32(b, at + 12));
    }
    return width > 0 && height > 0 ? std::optional(header_of("heif", width, height)) : std::nullopt;
}

std::optional<ImageHeader> psd_header(std::string_view b) {
    if (b.size() < 22) return std::nullopt;
    return header_of("psd", big_endian_32(b, 18), big_endian_32(b, 14));
}

}  // namespace

std::optional<ImageHeader> png_header(std::string_view first_bytes) {
    if (first_bytes.size() < 24 || sniff(first_bytes) != "png") return std::nullopt;
    return ImageHeader{"png", static_cast<int>(read_big_u32(first_bytes, 16)),
                       static_cast<int>(read_big_u32(first_bytes, 20)), 1};
}

std::optional<ImageHeader> read_header(std::string_view first_bytes, std::size_t file_size) {
    const std::string_view format = sniff(first_bytes);
    if (format.empty()) return tex_header(first_bytes, file_size);
    if (format == "bmp") return bmp_header(first_bytes);
    if (format == "png") return png_header(first_bytes);
    if (format == "jpeg") return jpeg_header(first_bytes);
    if (format == "hdr") return hdr_header(first_bytes);
    if (format == "openexr") return exr_header(first_bytes);
    if (format == "gif") return gif_header(first_bytes);
    if (format == "webp") return webp_header(first_bytes);
    if (format == "jpeg2000") return jpeg2000_header(first_bytes);
    if (format == "heif") return heif_header(first_bytes);
    if (format == "psd") return psd_header(first_bytes);
    return std::nullopt;
}

// Recognises the format of a file by its first bytes or its name.
namespace {

using std::string_view_literals::operator""sv;

struct Signature {
    std::string_view format;
    std::size_t at;
    std::string_view bytes;
};

constexpr Signature signatures[] = {
    {"png", 0, "\x89PNG\r\n\x1a\n"},
    {"jpeg", 0, "\xff\xd8\xff"},
    {"openexr", 0, "\x76\x2f\x31\x01"},
    {"hdr", 0, "#?RADIANCE"},
    {"hdr", 0, "#?RGBE"},
    {"tiff", 0, "II*\0"sv},
    {"tiff", 0, "MM\0*"sv},
    {"tiff", 0, "II+\0"sv},
    {"tiff", 0, "MM\0+"sv},
    {"gif", 0, "GIF87a"},
    {"gif", 0, "GIF89a"},
    {"webp", 8, "WEBP"},
    {"psd", 0, "8BPS"},
    {"dds", 0, "DDS "},
    {"jpeg2000", 4, "jP  \r\n"},
    {"jpeg2000", 0, "\xff\x4f\xff\x51"},
    {"heif", 4, "ftyp"},
    {"dpx", 0, "SDPX"},
    {"dpx", 0, "XPDS"},
    {"fits", 0, "SIMPLE  ="},
    {"sgi", 0, "\x01\xda"},
    {"git-lfs", 0, "version https://git-lfs"},
    {"html", 0, "<!DOCTYPE"},
    {"html", 0, "<!doctype"},
    {"html", 0, "<html"},
    {"svg", 0, "<svg"},
    {"svg", 0, "<?xml"},
    {"pdf", 0, "%PDF-"},
    {"zip", 0, "PK\x03\x04"},
};

struct Extension {
    std::string_view extension, format;
};

constexpr Extension extensions[] = {
    {"bmp", "bmp"},     {"dib", "bmp"}, {"tex", "tex"},      {"png", "png"},   {"jpg", "jpeg"},  {"jpeg", "jpeg"},
    {"exr", "openexr"}, {"hdr", "hdr"}, {"rgbe", "hdr"},     {"pic", "hdr"},   {"tif", "tiff"},  {"tiff", "tiff"},
    {"tga", "targa"},   {"gif", "gif"}, {"webp", "webp"},    {"psd", "psd"},   {"dds", "dds"},   {"dpx", "dpx"},
    {"ppm", "pnm"},     {"pgm", "pnm"}, {"pbm", "pnm"},      {"pnm", "pnm"},   {"pfm", "pnm"},   {"sgi", "sgi"},
    {"rgb", "sgi"},     {"ico", "ico"}, {"jp2", "jpeg2000"}, {"heic", "heif"}, {"avif", "heif"}, {"fits", "fits"},
};

// A letter, a digit and a blank, such as "P6\n".
bool is_pnm(std::string_view b) {
    return b.size() > 2 && b[0] == 'P' && ((b[1] >= '1' && b[1] <= '6') || b[1] == 'F' || b[1] == 'f') &&
           (b[2] == '\n' || b[2] == ' ' || b[2] == '\r' || b[2] == '\t');
}

}  // namespace

std::string_view sniff(std::string_view first_bytes) {
    if (first_bytes.starts_with("BM") && bmp_header(first_bytes)) return "bmp";
    for (const Signature& s : signatures) {
        if (first_bytes.size() >= s.at && first_bytes.substr(s.at).starts_with(s.bytes)) return s.format;
    }
    return is_pnm(first_bytes) ? "pnm" : "";
}

std::string extension_of(std::string_view path) {
    const std::size_t name = path.find_last_of("/\\") + 1;
    const std::size_t dot = path.rfind('.');
    if (dot == std::string_view::npos || dot < name) return {};
    return lowered(path.substr(dot + 1));
}

std::string_view format_of_extension(std::string_view extension) {
    const auto* const found = std::find_if(std::begin(extensions), std::end(extensions),
                                           [&](const Extension& e) { return e.extension == extension; });
    return found == std::end(extensions) ? "" : found->format;
}

}  // namespace snell::content
