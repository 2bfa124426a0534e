#include "src/runtime/resources/computed.h"

#include <algorithm>

namespace snell::runtime {

namespace {

// A map of a file is computed once, but a map of something drawn perhaps for every frame.
constexpr int largest_by_default = 128, largest_drawn_by_default = 64;

CubeLevels levels_of(const std::vector<content::CubeLight>& lights) {
    CubeLevels result;
    for (const content::CubeLight& light : lights) result.faces.push_back(content::half_faces(light));
    for (const content::CubeFaces& faces : result.faces) {
        auto& level = result.texels.emplace_back();
        for (std::size_t face = 0; face < 6; ++face) {
            level[face] = {gl::Pixels::rgba16f, faces[face].width, faces[face].height, 1, faces[face].pixels.data()};
            result.bytes += faces[face].bytes();
        }
    }
    return result;
}

content::CubeLight black(int size) {
    content::CubeLight light;
    light.size = size;
    light.texels.resize(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    return light;
}

}  // namespace

content::CubeLight read_light(GLuint cube, int size) {
    auto rows = gl::read_cube(cube, size);
    content::CubeFaces faces;
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face].width = faces[face].height = size;
        faces[face].pixels = std::move(rows[face]);
    }
    return content::cube_light(faces);
}

int computed_size(const Scene& scene, const Texture& declared, int source_size) {
    if (declared.size[0] > 0) return declared.size[0];
    const bool drawn = scene.textures[declared.source].files.empty();
    return content::prefilter_size(source_size, drawn ? largest_drawn_by_default : largest_by_default);
}

CubeLevels computed_levels(Computed computed, const content::CubeLight& light, int size) {
    if (computed == Computed::irradiance) return levels_of({content::irradiance(light, size)});
    return levels_of(content::prefiltered(light, size));
}

CubeLevels black_levels(Computed computed, int size) {
    std::vector<content::CubeLight> lights;
    const int levels = computed == Computed::irradiance ? 1 : content::prefilter_levels(size);
    for (int level = 0; level < levels; ++level) lights.push_back(black(size >> level));
    return levels_of(lights);
}

}  // namespace snell::runtime
