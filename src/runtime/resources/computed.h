// Cube maps that are computed from others, as levels to upload.
#pragma once

#include <array>
#include <vector>

#include "parser/scene.h"
#include "src/content/cube/convolve.h"
#include "src/gl/texture.h"

namespace snell::runtime {

struct CubeLevels {
    std::vector<content::CubeFaces> faces;  // what `texels` point to
    std::vector<std::array<gl::Texels, 6>> texels;
    std::size_t bytes = 0;

    int size() const { return faces[0][0].width; }
};

// The light that was drawn into a cube map.
content::CubeLight read_light(GLuint cube, int size);

// The size of the first level: as declared, otherwise by the size of the source.
int computed_size(const Scene& scene, const Texture& declared, int source_size);
CubeLevels computed_levels(Computed computed, const content::CubeLight& light, int size);
// For a source into which nothing was drawn yet.
CubeLevels black_levels(Computed computed, int size);

}  // namespace snell::runtime
