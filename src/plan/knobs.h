// What a frame may trade for accuracy in any scene, without the scene's help. Plain values; the command line and
// tests write the same ones.
#pragma once

#include <optional>

#include "src/plan/plan.h"

namespace snell {

// Two that differ need different meshes or textures.
struct PlanKnobs {
    double tessellation = 1;       // factor of the slices, stacks, sides and rings of shapes
    std::optional<Filter> filter;  // of all textures from files; none: as the scene says
    int cube_size = 0;             // texels a side of cube maps, at most those of the files; 0: as the scene says
    int cube_bits = 0;             // of a channel of cube maps: 8 or 16; 0: as files and scene say
    bool operator==(const PlanKnobs&) const = default;
};

struct Knobs {
    int grid = 1;         // each pixel is the mean of grid x grid pictures, shifted by parts of a pixel
    int multisample = 1;  // samples a pixel, by the driver
    PlanKnobs plan = {};
    bool operator==(const Knobs&) const = default;
};

// The plan with its shapes and textures as the knobs say. Counts of slices stay within 3 and 2000.
Plan with_knobs(Plan plan, const PlanKnobs& knobs);

// What a knob could change in the scene.
bool has_round_shapes(const Scene& scene);
bool has_textures(const Scene& scene);
bool has_cube_maps(const Scene& scene);

}  // namespace snell
