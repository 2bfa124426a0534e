// Any bytes as a raw texture, an OBJ, a shape file or a cube map's layout: shared by the fuzzers and the replay of
// their corpora. Each returns what is wrong, empty when all is well; `made`: something came of the input.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <string_view>

#include "src/content/cube/cubemap.h"
#include "src/content/image/image.h"
#include "src/content/mesh/mesh.h"

namespace snell::fuzz {

inline std::string check_mesh(const content::MeshResult& result, const content::MeshLimits& limits, bool& made) {
    const content::Mesh& mesh = result.mesh;
    made = !mesh.indices.empty();
    for (const auto& list : {mesh.positions, mesh.normals, mesh.texcoords}) {
        if (!list.empty() && list.size() != mesh.positions.size()) return "arrays of different lengths";
        for (const auto& value : list)
            for (const float x : value)
                if (!std::isfinite(x)) return "a value that is not finite";
    }
    if (mesh.positions.size() > limits.vertices) return "more vertices than the limit";
    for (const std::uint32_t index : mesh.indices)
        if (index >= mesh.positions.size()) return "an index outside";
    return {};
}

// How an OBJ is read hangs on its length.
inline std::string check_obj(std::string_view bytes, bool& made) {
    const content::MeshLimits limits{100'000, 1 << 20};
    const auto as = static_cast<ObjAs>(bytes.size() % 3);
    return check_mesh(content::parse_obj(bytes, as, bytes.size() % 2 == 0, limits), limits, made);
}

inline std::string check_shape(std::string_view bytes, bool& made) {
    const content::MeshLimits limits{100'000, 1 << 20};
    return check_mesh(content::parse_shp(bytes, limits), limits, made);
}

inline std::string check_pixels(const content::Image& image) {
    if (image.pixels.size() != image.bytes()) return "not as many pixels as it says";
    if (image.type != content::PixelType::f16) return {};
    for (std::size_t i = 0; i + 1 < image.pixels.size(); i += 2) {
        std::uint16_t half = 0;
        std::memcpy(&half, &image.pixels[i], 2);
        if (!std::isfinite(content::half_to_float(half))) return "a texel that is not finite";
    }
    return {};
}

// Raw textures, and the other formats that are read here: what OpenImageIO would read is left out.
inline std::string check_texture(std::string_view bytes, bool& made) {
    made = false;
    const auto header = content::read_header(bytes, bytes.size());
    if (!header || (header->format != "tex" && header->format != "bmp" && header->format != "png")) return {};
    const content::ImageLimits limits{1024, std::size_t{1} << 20};
    const content::ImageResult result = content::decode_image("a.tex", bytes, limits);
    if (!result.image) return result.issues.empty() ? "no picture and no reason" : "";
    made = true;
    if (result.image->bytes() > limits.bytes) return "more bytes than the limit";
    return check_pixels(*result.image);
}

// The least and the greatest of the picture's values: those of f16 as numbers.
inline std::pair<float, float> range_of(const content::Image& image) {
    std::pair<float, float> range{1e30f, -1e30f};
    const std::size_t step = image.type == content::PixelType::f16 ? 2 : 1;
    for (std::size_t i = 0; i + step <= image.pixels.size(); i += step) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, &image.pixels[i], step);
        const float value = step == 2 ? content::half_to_float(bits) : static_cast<float>(bits);
        range = {std::min(range.first, value), std::max(range.second, value)};
    }
    return range;
}

// A small picture from bytes: channels, type, order of rows, then pixels over and over.
inline content::Image picture_from(std::string_view bytes, int width, int height) {
    content::Image image;
    const auto kind = static_cast<unsigned char>(bytes.front());
    image.width = width;
    image.height = height;
    image.channels = 1 + kind % 4;
    image.type = kind & 4 ? content::PixelType::f16 : content::PixelType::u8;
    image.bottom_first = kind & 8;
    image.pixels.resize(image.bytes());
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(bytes[1 + i % (bytes.size() - 1)]);
    // What decodes a picture has mended what is not finite.
    if (image.type == content::PixelType::f16)
        for (std::size_t i = 1; i < image.pixels.size(); i += 2)
            if ((image.pixels[i] & std::byte{0x7c}) == std::byte{0x7c}) image.pixels[i] ^= std::byte{0x40};
    return image;
}

// Width and height (32 bits each, as the machine has them), the size of a face (0: to be chosen), then a picture.
inline std::string check_cube(std::string_view bytes, bool& made) {
    int size[2] = {0, 0};
    std::memcpy(size, bytes.data(), std::min(bytes.size(), sizeof size));
    const auto layout = content::detect_layout(size[0], size[1]);
    made = layout.has_value();
    if (!layout) return {};
    if (size[0] <= 0 || size[1] <= 0) return "a layout of nothing";
    if (size[0] > 64 || size[1] > 64 || bytes.size() < 11) return {};
    const content::Image image = picture_from(bytes.substr(9), size[0], size[1]);
    const int asked = static_cast<unsigned char>(bytes[8]) % 20;
    const content::CubeFaces faces = content::split_cube(image, *layout, asked);
    const auto [low, high] = range_of(image);
    // Floats between two texels are off by their rounding, of the larger of the two; a face's by a half's least step.
    const float off = std::max(std::abs(low), std::abs(high)) * 1e-6F + 6e-8F;
    for (const content::Image& face : faces) {
        if (face.width != face.height || face.width < 1) return "a face that is no square";
        if (face.width != faces[0].width || (asked > 0 && face.width != asked)) return "a face of another size";
        if (face.channels != image.channels || face.type != image.type) return "a face of another kind";
        if (std::string wrong = check_pixels(face); !wrong.empty()) return wrong;
        const auto [least, greatest] = range_of(face);
        if (least < low - off || greatest > high + off) return "light that the picture does not have";
    }
    return {};
}

}  // namespace snell::fuzz
