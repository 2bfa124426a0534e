// Which way to look into an environment that is not infinitely far.
#pragma once

#include <functional>

#include <glm/glm.hpp>

namespace snell::optics {

// A room, axis-aligned, and the point in it that its cube map was taken from: the centre.
struct Room {
    glm::dvec3 centre{0}, half{5};
};

// Direction, from the room's centre, of the wall that a ray from `point` meets (Lagarde and Zanuttini 2012): exact if
// the cube map shows exactly these walls. A point on or beyond a wall is first moved just inside, to .9999 of the
// half size, so the result is defined for every point; a direction component of zero meets no wall. Any length but
// zero, and so is the result's.
glm::dvec3 box_direction(const glm::dvec3& point, const glm::dvec3& direction, const Room& room);

// The same for an environment of which only the distance in each direction is known, seen from the centre
// (Szirmay-Kalos and others 2005): starting with the distance in the ray's own direction, `iterations` (clamped to
// 0..8) corrections d += D(P + d r) - |P + d r|, d >= 0. Converges where the surroundings are convex; no proof beyond.
// `direction` of unit length; `point` relative to the centre.
glm::dvec3 impostor_direction(const glm::dvec3& point, const glm::dvec3& direction, int iterations,
                              const std::function<double(const glm::dvec3&)>& distance);

// Distance from the room's centre to its wall in a direction of unit length.
double wall_distance(const glm::dvec3& direction, const glm::dvec3& half);

}  // namespace snell::optics
