// Settings that trade accuracy for speed and apply to any scene. They are plain values; the command line and tests
// write the same ones.
#pragma once

#include <optional>

#include "src/plan/plan.h"

namespace snell {

// Values that differ need different meshes or textures.
struct PlanKnobs {
    double tessellation = 1;       // factor for the slices, stacks, sides and rings of shapes
    std::optional<Filter> filter;  // for all textures from files; nullopt: as the scene says
    int cube_size = 0;             // texels per side of a cube map, at most those of its files; 0: as the scene says
    int cube_bits = 0;             // bits per channel of cube maps, 8 or 16; 0: as files and scene say
    bool operator==(const PlanKnobs&) const = default;
};

struct Knobs {
    int grid = 1;         // each pixel is the mean of grid x grid pictures, shifted by fractions of a pixel
    int multisample = 1;  // samples per pixel, taken by the driver
    PlanKnobs plan = {};
    bool operator==(const Knobs&) const = default;
};

// Applies the knobs to the plan's shapes and textures. Slice counts stay between 3 and 2000.
Plan with_knobs(Plan plan, const PlanKnobs& knobs);

// Whether the scene has anything that the respective knobs change.
bool has_round_shapes(const Scene& scene);
bool has_textures(const Scene& scene);
bool has_cube_maps(const Scene& scene);

}  // namespace snell
