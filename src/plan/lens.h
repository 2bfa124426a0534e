// Projections for the camera while the user chooses perspective or orthographic.
#pragma once

#include <array>
#include <optional>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell {

struct Lens {
    Camera camera;
    glm::dmat4 shift{1};  // applied in eye space, before the projection
};

// Returns `camera` with the projection that `chosen` names. If that is not the camera's own, objects in the plane
// through the world's origin keep their size on the screen: an orthographic camera that gets a perspective is moved
// back until its angle spans its box; a perspective camera that becomes orthographic spans what its angle spans at that
// distance, or its box if the origin is not in front of it. `view` is eye from world.
Lens lens_of(const Camera& camera, Projection chosen, const glm::dmat4& view);

// The camera of the last draw in the window; the default camera if nothing is drawn there.
Camera window_camera(const Scene& scene);

// How far an object at `point` (in eye space, after the scene transformation) moves, in its own units, for each step on
// the screen, where the screen's shorter side is `shorter` steps.
double units_per_step(const Lens& lens, const glm::dvec3& point, double shorter);

// The background of that brightness, in newer glman's shade of blue.
std::array<double, 4> background_of(double brightness);

}  // namespace snell
