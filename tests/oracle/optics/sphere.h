// Light through a glass ball: every path, exactly.
#pragma once

#include <vector>

#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {

// One way out of the ball.
struct Exit {
    int order = 0;            // 0: mirrored outside; 1: straight through; k: after k - 1 reflections inside
    glm::dvec3 normal{0};     // where it leaves: the unit vector from the centre to that point
    glm::dvec3 direction{0};  // unit length, away from the ball
    double energy = 0;        // share of the light, with unpolarised reflectances multiplied at every interface
};

struct SphereLight {
    std::vector<Exit> exits;
    double inside = 0;  // share (unpolarised) that still was in the ball when the series stopped
};

inline constexpr double series_end = 1e-4;
inline constexpr int series_limit = 32;

// All exits of light that meets a ball of index n_inside in a medium of index n_outside, in direction `incident`, at
// the point with outward normal `normal` (any lengths; directions only: the radius doesn't matter). Stops when less
// than series_end is left inside, and after `orders` exits besides the mirrored one (at most series_limit).
// The path lies in one plane, and each chord turns it by the same angle π - 2 θt: exit k is the first turned k - 1
// times, so that no refraction is computed on leaving, which near grazing would be taken for total reflection.
// Past the critical angle (n_inside < n_outside) there is the mirrored exit alone, with energy 1.
// Empty: a vector without direction, an index that is not positive and finite, or light from the inside.
SphereLight through_sphere(const glm::dvec3& incident, const glm::dvec3& normal, double n_outside, double n_inside,
                           int orders = series_limit);

}  // namespace snell::optics
