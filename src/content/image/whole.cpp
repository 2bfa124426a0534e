#include "src/content/image/whole.h"

#include <zlib.h>

#include "parser/text/ranges.h"
#include "src/content/image/formats.h"

namespace snell::content {

namespace {

using std::string_view_literals::operator""sv;

// Decoders of other formats, such as TIFF and GIF, also accept files that were cut off.
constexpr std::string_view provable[] = {"png", "jpeg", "openexr", "hdr", "targa", "bmp"};

// Length, name, data, checksum of name and data; nothing behind the last one.
bool has_whole_chunks(std::string_view bytes) {
    constexpr std::size_t signature = 8, around = 12;
    bool pixels = false;
    for (std::size_t at = signature; at + around <= bytes.size();) {
        const std::size_t length = read_big_u32(bytes, at);
        if (length > bytes.size() - at - around) return false;
        const std::string_view named = bytes.substr(at + 4, 4 + length);
        const auto* data = reinterpret_cast<const Bytef*>(named.data());
        if (crc32_z(0, data, named.size()) != read_big_u32(bytes, at + 8 + length)) return false;
        at += around + length;
        pixels = pixels || named.starts_with("IDAT");
        if (named == "IEND") return pixels && at == bytes.size();
    }
    return false;
}

}  // namespace

bool is_whole(const std::string& path, std::string_view bytes, const ImageLimits& limits) {
    const std::string_view format = format_of_extension(extension_of(path));
    if (ranges::find(provable, format) == std::end(provable)) return false;
    if (sniff(bytes) != (format == "targa" ? "" : format)) return false;  // TGA has no signature
    if (format == "png") return has_whole_chunks(bytes);
    if (format == "jpeg" && !bytes.ends_with("\xff\xd9")) return false;
    if (format == "targa" && !bytes.ends_with("TRUEVISION-XFILE.\0"sv)) return false;
    if (format == "bmp" && (bytes.size() < 6 || read_u32(bytes, 2) != bytes.size())) return false;
    const ImageResult result = decode_image(path, bytes, limits);
    return result.image && ranges::none_of(result.issues, [](const ImageIssue& issue) {
               return issue.code == "image-truncated" || issue.code == "image-damaged";
           });
}

}  // namespace snell::content
