// Any bytes as a raw texture, an OBJ, a shape file or the size of a cube map: shared by the fuzzer and the replay of
// its corpus.
#pragma once

#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "src/content/cubemap.h"
#include "src/content/image.h"
#include "src/content/mesh.h"

namespace snell::fuzz {

// `made`: the input was read to its end and something came of it.
inline std::string check_mesh(const content::MeshResult& result, bool& made) {
    made = !result.mesh.indices.empty();
    for (const auto& list : {result.mesh.positions, result.mesh.normals, result.mesh.texcoords})
        for (const auto& value : list)
            for (const float x : value)
                if (!std::isfinite(x)) return "a value that is not finite";
    for (const std::uint32_t index : result.mesh.indices)
        if (index >= result.mesh.positions.size()) return "an index outside";
    return {};
}

inline std::string check_texture(std::string_view bytes, bool& made) {
    const content::ImageLimits limits{4096, std::size_t{64} << 20};
    const content::ImageResult result = content::decode_image("a.tex", bytes, limits);
    if (!result.image) return result.issues.empty() ? "no picture and no reason" : "";
    made = true;
    const content::Image& image = *result.image;
    if (image.pixels.size() != image.bytes() || image.bytes() > limits.bytes) return "not as many pixels as it says";
    if (image.type != content::PixelType::f16) return {};
    for (std::size_t i = 0; i + 1 < image.pixels.size(); i += 2) {
        std::uint16_t half = 0;
        std::memcpy(&half, &image.pixels[i], 2);
        if (!std::isfinite(content::half_to_float(half))) return "a texel that is not finite";
    }
    return {};
}

inline std::string check_layout(std::string_view bytes, bool& made) {
    int size[2] = {0, 0};
    std::memcpy(size, bytes.data(), std::min(bytes.size(), sizeof size));
    const auto layout = content::detect_layout(size[0], size[1]);
    made = layout.has_value();
    return layout && (size[0] <= 0 || size[1] <= 0) ? "a layout of nothing" : "";
}

enum Kind { texture, layout, shape_file, obj };
inline Kind kind_of(std::string_view bytes) { return static_cast<Kind>(static_cast<unsigned char>(bytes.back()) & 3); }

// The last byte chooses what the others are. Empty when all is well, else what is wrong.
inline std::string check_content(std::string_view bytes, bool& made) {
    made = false;
    if (bytes.empty()) return {};
    const Kind kind = kind_of(bytes);
    const std::string_view rest = bytes.substr(0, bytes.size() - 1);
    // OpenImageIO has fuzzers of its own: what it would read is left out.
    if (kind == texture) return content::read_header(rest, rest.size(), "a.tex") ? check_texture(rest, made) : "";
    if (kind == layout) return check_layout(rest, made);
    const content::MeshLimits limits{100'000, 1 << 20};
    if (kind == shape_file) return check_mesh(content::parse_shp(rest, limits), made);
    const auto as = static_cast<ObjAs>(rest.size() % 3);
    return check_mesh(content::parse_obj(rest, as, rest.size() % 2 == 0, limits), made);
}

inline std::string check_content(std::string_view bytes) {
    bool made = false;
    return check_content(bytes, made);
}

}  // namespace snell::fuzz
