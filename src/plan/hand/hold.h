// The transformation of the view that the mouse and the panel change.
#pragma once

#include <cstdint>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell {

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

}  // namespace snell
