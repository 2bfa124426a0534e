// Events of a window → Dear ImGui's input.
#pragma once

#include <span>

#include "src/platform/window.h"

namespace snell::ui {

// How many of the first events one frame may take: one press or release, or what lies between two. So none is
// missed, each is seen where the mouse was, and a drag ends where the button was released.
std::size_t batch(std::span<const Event> events);

// Into the current Dear ImGui context.
void feed(std::span<const Event> events);
// Once per context: which key is which, and keys that are held.
void map_keys();

}  // namespace snell::ui
