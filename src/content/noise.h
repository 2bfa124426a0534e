// The built-in noise textures: four octaves of gradient noise in RGBA, centred on one half, tiling.
#pragma once

#include "src/content/image.h"

namespace snell::content {

// Square (dimensions = 2) or cubic (3) textures of `size` texels a side, u8 RGBA, bottom_first.
// Deterministic. Runs on all cores. Octave c has 4·2^c lattice cells across; texels on lattice points are
// exactly 127 (glman's own files are so); standard deviations as glib-language states them.
Image make_noise(int dimensions, int size);

// The name of the file that stands in for generated noise: "noise3d.064.tex".
std::string noise_file_name(int dimensions, int size);

}  // namespace snell::content
