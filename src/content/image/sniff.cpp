// Recognises the format of a file by its first bytes or its name.
#include <algorithm>

#include "parser/text/tidy.h"
#include "src/content/image/formats.h"

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
