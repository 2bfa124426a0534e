#include "src/app/page/scene_files.h"

#include <array>
#include <cstdlib>
#include <new>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include "src/app/open/write_copy.h"
#include "src/content/image/image.h"
#include "src/document/document.h"
#include "src/plan/identity.h"
#include "src/plan/plan.h"
#include "src/plan/texts.h"

namespace snell::app {

namespace {

struct Used {
    std::vector<std::string> paths;
    std::set<std::string> images;
    std::string error;
};

Used used_by(const std::string& scene, Files& files) {
    Sources sources;
    Diagnostics unheard(files.limits());  // these are reported when the scene is opened
    const auto plan = read_plan(scene, files, sources, unheard);
    if (!plan) return {{}, {}, fmt::format("cannot read '{}'", shown_path(scene))};
    Used used{used_files(*plan, sources, files), {}, {}};
    for (Index i = 0; i < plan->scene.textures.size(); ++i)
        for (std::string& path : texture_identity(plan->scene, i, files).files) used.images.insert(std::move(path));
    return used;
}

// The formats that a page decodes, exactly as snell does. Raw textures and TGA have no signature.
bool page_decodes(const std::string& path, std::string_view bytes) {
    using namespace std::string_view_literals;
    for (const std::string_view signature :
         {"\x89PNG"sv, "BM"sv, "\xff\xd8\xff"sv, "GIF8"sv, "8BPS"sv, "#?RADIANCE"sv, "#?RGBE"sv, "P5"sv, "P6"sv})
        if (bytes.starts_with(signature)) return true;
    const auto header = content::read_header(bytes, bytes.size());
    if (header) return header->format == "tex";
    return path.ends_with(".tga") || path.ends_with(".TGA");
}

// Nothing where snell does not decode it either, which a page reports in the same way.
std::optional<PackedFile> decoded(const PackedFile& file, const Limits& limits) {
    const content::ImageLimits most{static_cast<int>(limits.texture_side), limits.texture_bytes};
    const content::ImageResult read = content::decode_image(file.name, file.bytes, most);
    if (!read.image) return std::nullopt;
    const std::vector<std::byte> decoded = content::decoded_file(*read.image);
    return PackedFile{file.name, {reinterpret_cast<const char*>(decoded.data()), decoded.size()}, true};
}

std::string too_much(const std::vector<PackedFile>& files) {
    std::uint64_t bytes = 0;
    for (const PackedFile& file : files) bytes += file.bytes.size();
    if (bytes <= most_page_bytes && files.size() <= most_page_files) return {};
    return fmt::format("the scene reads {} files of {} MB: a page holds at most {} files of {} MB", files.size(),
                       bytes >> 20, most_page_files, most_page_bytes >> 20);
}

std::uint32_t number_at(std::string_view bytes, std::size_t at, int size) {
    std::uint32_t number = 0;
    for (int i = size; i-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[at + static_cast<unsigned>(i)]);
    return number;
}

// The pixels of a BMP image of 24 or 32 bits without compression: where they begin, and bytes of a pixel and of a row.
std::optional<std::array<std::size_t, 3>> bmp_rows(std::string_view bytes) {
    if (bytes.size() < 54 || !bytes.starts_with("BM")) return std::nullopt;
    const std::size_t begin = number_at(bytes, 10, 4), width = number_at(bytes, 18, 4), bits = number_at(bytes, 28, 2);
    const bool plain = (bits == 24 || bits == 32) && number_at(bytes, 30, 4) == 0;
    if (!plain || begin < 54 || begin > bytes.size() || width == 0 || width > bytes.size()) return std::nullopt;
    return std::array{begin, bits / 8, (width * bits + 31) / 32 * 4};
}

// Each byte of the pixels less what its neighbours foretell, as in PNG: that packs into half of the bytes, and
// web/page/archive.ts undoes it.
std::string without_foretold(std::string_view bytes, const std::array<std::size_t, 3>& rows) {
    const auto [begin, pixel, row] = rows;
    std::string rest(bytes);
    for (std::size_t i = begin; i < bytes.size(); ++i) {
        const auto before = [&](std::size_t distance) {
            return i < begin + distance ? 0 : static_cast<int>(static_cast<unsigned char>(bytes[i - distance]));
        };
        const int left = before(pixel), above = before(row), corner = before(row + pixel),
                  guess = left + above - corner;
        const int a = std::abs(guess - left), b = std::abs(guess - above), c = std::abs(guess - corner);
        rest[i] = static_cast<char>(bytes[i] - (a <= b && a <= c ? left : b <= c ? above : corner));
    }
    return rest;
}

}  // namespace

SceneFiles scene_files(const std::string& scene, const Access& access) {
    const std::string marked = marked_path(scene);
    Files files(scene_folder(marked), access);
    const Used used = used_by(marked, files);
    if (!used.error.empty()) return {{}, {}, used.error};
    CopyNames names = copy_names(marked, used.paths, "a page");
    SceneFiles found{names.scene, {}, names.error};
    for (const NamedFile& named : names.files) {
        if (!found.error.empty()) return found;
        std::string error;
        auto bytes = files.read(named.path, error);
        if (!bytes) {
            found.error = fmt::format("cannot read '{}': {}", shown_path(named.path), error);
            return found;
        }
        found.files.push_back({named.name, std::move(*bytes)});
        const PackedFile& file = found.files.back();
        if (used.images.contains(named.path) && !page_decodes(named.name, file.bytes))
            if (auto twin = decoded(file, access.limits)) found.files.push_back(std::move(*twin));
        found.error = too_much(found.files);
    }
    return found;
}

std::string archive(std::span<const PackedFile> files) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string all;
    for (const PackedFile& file : files) {
        const auto rows = bmp_rows(file.bytes);
        list.push_back({{"name", file.name}, {"size", file.bytes.size()}, {"decoded", file.decoded}});
        if (rows) list.back()["rows"] = *rows;
        all += rows ? without_foretold(file.bytes, *rows) : file.bytes;
    }
    return nlohmann::ordered_json{{"files", list}}.dump() + '\n' + all;
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
