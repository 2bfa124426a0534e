// How a camera of the scene is projected while the user holds the view.
#pragma once

#include <array>
#include <optional>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell {

struct Lens {
    Camera camera;
    glm::dmat4 shift{1};  // in eye space, ahead of the projection
};

// `camera` with the projection that `chosen` says. Where it is not the camera's own, what lies in the plane through the
// world's origin keeps its size: an orthographic camera that is to have a perspective is moved back to where its angle
// spans its box; one with a perspective spans what its angle does at that distance, or its box where the origin is not
// in front. `view`: eye from world.
Lens lens_of(const Camera& camera, Projection chosen, const glm::dmat4& view);

// The camera of the last draw in the window; the default one where nothing is drawn.
Camera window_camera(const Scene& scene);

// How far something at `point` (eye space, the scene transformation done) moves, in its units, while it moves by one on
// a screen whose shorter side is `shorter` such steps.
double units_per_step(const Lens& lens, const glm::dvec3& point, double shorter);

// The background of that brightness: newer glman's blue.
std::array<double, 4> background_of(double brightness);

}  // namespace snell
