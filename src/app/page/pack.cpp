#include "src/app/page/pack.h"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <nlohmann/json.hpp>

namespace snell::app {

std::string archive(std::span<const PackedFile> files) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PackedFile& file : files)
        list.push_back({{"name", file.name}, {"size", file.bytes.size()}, {"decoded", file.decoded}});
    std::string all = nlohmann::ordered_json{{"files", list}}.dump() + '\n';
    for (const PackedFile& file : files) all += file.bytes;
    return all;
}

std::string gzipped(std::string_view bytes) {
    constexpr int gzip = 16;  // added to the size of the window, it asks for the header of gzip
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzip, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) !=
        Z_OK)
        throw std::bad_alloc();
    gz_header header{};
    header.os = 255;  // not known: the bytes are the same on every system
    deflateSetHeader(&stream, &header);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i) text += i <= count ? digits[group >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

}  // namespace snell::app
