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

}  // namespace snell::app
