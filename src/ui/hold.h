// What of the view the mouse and the panel change.
#pragma once

#include <cstdint>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell::ui {

enum class Held : std::uint8_t { scene, eye, object, texture };

struct HoldMemory {
    Held held = Held::scene;  // object: only while one is picked
    bool picking = false;     // a click picks
    Index object = none;      // Scene::draws: the picked one
};

// The object that the user holds from now on; none: the scene again.
void hold_object(HoldMemory& hold, Index object);

Transformation held(const View& view, const HoldMemory& hold);
// What an object has lost all of is no longer in the view.
void set_held(View& view, const HoldMemory& hold, const Transformation& transformation);

// All as the scene says it; axes stay.
void reset_view(View& view);

}  // namespace snell::ui
