// The camera as the user has moved it, and its projections. A plain value: sliders, the mouse, flags and tests write
// the same one.
// What a gesture does to the view, whether a mouse or a finger makes it, and the transformation that it changes.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

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
    std::map<unsigned, Transformation> objects;  // by index into Scene::draws
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

// The transformation of the view that the mouse and the panel change.

enum class Held : std::uint8_t { scene, eye, object, texture };

struct HoldMemory {
    Held held = Held::scene;     // `object` only while an object is picked
    bool picking = false;        // a click on the scene picks the object there
    Index object = none;         // the picked object, an index into Scene::draws
    bool flipped = false;        // the drag began with the scene upside down, so that it turns the other way
    std::optional<View> before;  // the view when the drag began, which Escape restores
    bool cancelled = false;      // it did: until the button is up, the mouse moves nothing
};

// Picks an object, so that the user moves it from now on. With none, the user moves the scene again.
void hold_object(HoldMemory& hold, Index object);

// The transformation that is held.
Transformation held(const View& view, const HoldMemory& hold);
// Sets the transformation that is held. An object whose transformation becomes the identity is removed from the view.
void set_held(View& view, const HoldMemory& hold, const Transformation& transformation);

// Resets everything to what the scene says, except for the axes.
void reset_view(View& view);

// What a gesture does to the view, whether a mouse or a finger makes it.

// In points of the window: pixels of a screen of ordinary density.
struct ViewGesture {
    glm::dvec3 move{0};  // right, up, toward the viewer
    glm::dvec2 turn{0};  // right, down
    double scale = 1;
};

// True if the tilt has put the scene upside down: the vertical then points down on the screen.
bool upside_down(const Transformation& t, const Scene& scene);

// Changes the transformation that is held, so that what is dragged stays under the pointer. `shorter` is the shorter
// side of the picture in points.
void apply(const ViewGesture& made, const Scene& scene, double shorter, View& view, const HoldMemory& hold);

// Rounds to a hundredth of a step, so that numbers that are dragged to are short and 0 can be reached again.
double tidy_step(double value, double step);

struct DepthBox;

// Views that may show what lies in the boxes (eye space), `current` moved: straight away from the eye first, then to
// the middle of the picture, then smaller, too. In round numbers. Where shaders move what they draw, none of them need
// show it: they are to be tried. Empty: there is nothing finite in the boxes.
std::vector<View> views_to_try(std::span<const DepthBox> boxes, const Camera& camera, const View& current);

// Objects that the user moves: draws of the scene, identified by their statements.

// World from model with the user's transformation of the object: about the object's own origin, along the axes of the
// scene's camera, in world units.
glm::dmat4 placed(const Transformation& object, const Camera& camera, const glm::dmat4& model);

// One name for each of Scene::draws: what it draws, and how many draws before it draw the same.
std::vector<std::string> object_names(const Scene& scene);

// True if all that the window shows is one plane of undivided quads, such as a picture that fills it: axes through its
// middle would only hide it.
bool flat_picture(const Scene& scene);

// Finds an object again after the scene was read again: by its index if there are as many draws as before (a parameter
// was edited), otherwise by its name. Returns none if the object is gone.
Index carried(const std::vector<std::string>& from, const std::vector<std::string>& to, Index object);

// Moves the transformations of objects to their new indices; those of objects that are gone are removed.
void carry_objects(const std::vector<std::string>& from, const std::vector<std::string>& to, View& view);

}  // namespace snell
