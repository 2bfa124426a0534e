// What a gesture does to the view, whether a mouse or a finger makes it, and the transformation that it changes.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell {

// The transformation of the view that the mouse and the panel change.

enum class Held : std::uint8_t { scene, eye, object, texture };

struct HoldMemory {
    Held held = Held::scene;  // `object` only while an object is picked
    bool picking = false;     // a click on the scene picks the object there
    Index object = none;      // the picked object, an index into Scene::draws
    bool flipped = false;     // the drag began with the scene upside down, so that it turns the other way
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

}  // namespace snell
