// The surface of the teapot. Internal to src/content.
#pragma once

#include "parser/scene.h"

namespace snell::content {

inline constexpr int teapot_patches = 32;

struct SurfacePoint {
    Vec3 position, normal;  // the normal points outward; it is not of unit length, but never 0
};
// Evaluates patch 0..31 (rim 4, body 8, lid 8, bottom 4, handle 4, spout 4) at s and t in 0..1.
SurfacePoint teapot_point(int patch, double s, double t);

}  // namespace snell::content
