// The camera as the user has moved it, and its projections. A plain value: sliders, the mouse, flags and tests write
// the same one.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include <glm/glm.hpp>

#include "parser/scene.h"

namespace snell {

// The camera as the user has moved it. A plain value: sliders, the mouse, flags and tests write the same one.

// Rotations are kept as angles in degrees rather than as an accumulated matrix, so that rounding errors cannot pile up.
struct Transformation {
    double rotate_x = 0, rotate_y = 0;  // first about the vertical, then about the screen's X: up stays up
    double scale = 1;
    double x = 0, y = 0, z = 0;
    double rotate_z = 0;  // applied before the two others; turns textures in their plane
    bool operator==(const Transformation&) const = default;
    std::array<double, 7> numbers() const { return {rotate_x, rotate_y, rotate_z, scale, x, y, z}; }
    // Translate · rotate · scale. `vertical` is a unit vector in the space that the matrix acts in.
    glm::dmat4 matrix(const glm::dvec3& vertical = {0, 1, 0}) const;
};

// The projection: the scene's own, or the one the user chose.
enum class Projection : std::uint8_t { scene, perspective, ortho };

struct View {
    Transformation scene;    // multiplied into the projection, so eye coordinates stay as the scene made them
    Transformation eye;      // multiplied into the model-view matrix
    Transformation texture;  // gl_TextureMatrix[0]
    std::map<unsigned, Transformation> objects;  // by index into Scene::draws, see src/plan/objects.h
    Projection projection = Projection::scene;
    std::optional<double> background;  // the window's brightness, 0 to 1; nullopt: as the scene says
    bool axes = false;
    double mouse_x = 0, mouse_y = 0;
    bool operator==(const View&) const = default;
};

// The camera's up vector in eye space, of length 1. `view` is eye from world, by this camera, perhaps moved.
glm::dvec3 vertical_of(const Camera& camera, const glm::dmat4& view);
// Eye from world, with the user's eye transformation.
glm::dmat4 eye_from_world(const Camera& camera, const View& view);
// The user's scene transformation in the eye space of `view`: it acts about the world's origin.
glm::dmat4 about_origin(const Transformation& scene, const Camera& camera, const glm::dmat4& view);

// Projections for the camera while the user chooses perspective or orthographic.

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
