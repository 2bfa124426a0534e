// The built-in noise textures: four octaves of gradient noise in RGBA, centred on one half, tileable.
#pragma once

#include "src/content/image/image.h"

namespace snell::content {

// Makes a square (dimensions = 2) or cubic (3) texture of `size` texels per side: u8 RGBA, bottom_first. Deterministic;
// runs on all cores. Octave c has 4·2^c lattice cells across. Texels on lattice points are exactly 127, as in glman's
// own files; the standard deviations of the channels are constants in noise.cpp.
Image make_noise(int dimensions, int size);

// The name of the file that replaces generated noise, such as "noise3d.064.tex".
std::string noise_file_name(int dimensions, int size);
// The size that such a name, in whatever case, is of; 0 for other names.
int noise_file_size(int dimensions, std::string_view name);

}  // namespace snell::content
