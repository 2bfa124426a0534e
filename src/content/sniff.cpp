// Which format a file is in, and how large the picture is, from its first bytes.
#include <algorithm>
#include <charconv>
#include <limits>

#include "src/content/formats.h"

namespace snell::content {
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

// "P6\n": a letter, a digit, a blank.
bool is_pnm(std::string_view b) {
    return b.size() > 2 && b[0] == 'P' && ((b[1] >= '1' && b[1] <= '6') || b[1] == 'F' || b[1] == 'f') &&
           (b[2] == '\n' || b[2] == ' ' || b[2] == '\r' || b[2] == '\t');
}

int big_endian(std::string_view b, std::size_t at) {
    return static_cast<unsigned char>(b[at]) << 8 | static_cast<unsigned char>(b[at + 1]);
}

// The size stands in the start-of-frame segment.
std::optional<ImageHeader> jpeg_header(std::string_view b) {
    for (std::size_t at = 2; at + 9 <= b.size();) {
        if (static_cast<unsigned char>(b[at]) != 0xff) return std::nullopt;
        const auto marker = static_cast<unsigned char>(b[at + 1]);
        if (marker == 0xff) {  // fill byte
            ++at;
            continue;
        }
        const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) return ImageHeader{"jpeg", big_endian(b, at + 7), big_endian(b, at + 5), 1};
        at += 2 + static_cast<std::size_t>(big_endian(b, at + 2));
    }
    return std::nullopt;
}

// The line "-Y height +X width" that ends the header.
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

// The attribute "dataWindow" of type "box2i".
std::optional<ImageHeader> exr_header(std::string_view b) {
    constexpr std::string_view key = "dataWindow\0box2i\0"sv;
    const std::size_t at = b.find(key);
    if (at == std::string_view::npos || at + key.size() + 20 > b.size()) return std::nullopt;
    const auto number = [&](std::size_t i) { return std::int64_t{read_i32(b, at + key.size() + 4 + 4 * i)}; };
    const std::int64_t width = number(2) - number(0) + 1, height = number(3) - number(1) + 1;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    if (width <= 0 || height <= 0 || width > most || height > most) return std::nullopt;
    return ImageHeader{"exr", static_cast<int>(width), static_cast<int>(height), 1};
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
    std::string extension(path.substr(dot + 1));
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension;
}

std::string_view format_of_extension(std::string_view extension) {
    const auto* const found = std::find_if(std::begin(extensions), std::end(extensions),
                                           [&](const Extension& e) { return e.extension == extension; });
    return found == std::end(extensions) ? "" : found->format;
}

std::optional<ImageHeader> read_header(std::string_view first_bytes, std::size_t file_size, std::string_view) {
    const std::string_view format = sniff(first_bytes);
    if (format == "bmp") return bmp_header(first_bytes);
    if (format == "png") return png_header(first_bytes);
    if (format == "jpeg") return jpeg_header(first_bytes);
    if (format == "hdr") return hdr_header(first_bytes);
    if (format == "openexr") return exr_header(first_bytes);
    if (format == "gif" && first_bytes.size() >= 10) {
        return ImageHeader{"gif", static_cast<int>(read_u16(first_bytes, 6)),
                           static_cast<int>(read_u16(first_bytes, 8)), 1};
    }
    return format.empty() ? tex_header(first_bytes, file_size) : std::nullopt;
}

}  // namespace snell::content
