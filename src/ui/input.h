// Events of a window → Dear ImGui's input.
#pragma once

#include <span>

#include "src/platform/window.h"

namespace snell::ui {

// How many of the first events one frame may take: up to the first press or release, so that none is missed and
// each is seen where the mouse was.
std::size_t batch(std::span<const Event> events);

// Into the current Dear ImGui context.
void feed(std::span<const Event> events);
// Once per context: which key is which, and keys that are held.
void map_keys();

}  // namespace snell::ui
