// Passes a window's events to Dear ImGui.
#pragma once

#include <span>

#include "src/platform/window.h"

namespace snell::ui {

// How many of the first events one frame may take: one press or release, or the events between two of them. So no click
// is missed, each is seen at the pointer's position at that time, and a drag ends where the button was released.
std::size_t batch(std::span<const Event> events);

// Passes the events to the current Dear ImGui context.
void feed(std::span<const Event> events);
// True if the key was pressed in this frame; with `repeat` also while it repeats.
bool pressed(Key key, bool repeat = false);
// The same without Ctrl, which makes it another key.
bool plain(Key key);
// True if any key was pressed in this frame, except for those that only modify others.
bool any_pressed();
// Hides the press from everything that asks later in this frame.
void take(Key key);
// Call once per context, before feed(): maps Dear ImGui's keys to those of Key.
void map_keys();

}  // namespace snell::ui
