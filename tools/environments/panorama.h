// The light around a point with its true brightness, in one picture.
#pragma once

#include <string>
#include <vector>

#include "tools/environments/faces.h"

namespace snell::environments {

// Equirectangular: the middle looks along -Z, +X is right of it, the top row is up; rows top first.
struct Panorama {
    int width = 0, height = 0;
    std::vector<Colour> texels;
};

// `samples` × `samples` rays through each texel, averaged as light. Height is half the width.
Panorama render_panorama(const Radiance& radiance, int width, int samples);

// Radiance RGBE with run lengths (Ward, Graphics Gems II): a common exponent for each texel, so .8 % of its largest
// channel is the coarsest step. Precondition: width 8 to 32767, texels finite and not negative.
std::string encode_hdr(const Panorama& panorama);

}  // namespace snell::environments
