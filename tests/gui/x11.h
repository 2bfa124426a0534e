// What other programs do on a display.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/gui/desk.h"

namespace snell::test {

// Drags files into a window, by the XDND protocol: onto the middle of the one that takes drops. False: there is none,
// or it did not finish.
bool drop_files(const std::string& display, const std::vector<std::string>& paths);

// Asks the windows to close, as their close buttons do. False: there are none.
bool close_windows(const std::string& display);

// Calls `tell` when all windows were sent the input that the display has had, and then wakes them. False: no display.
bool tell_windows(const std::string& display, const std::function<void()>& tell);

// What the screen shows; without pixels if there is no such display.
Picture screen_of(const std::string& display);

// Makes a display without windows what it was when it began. False: a button or a key is held down, or there is none.
bool renew(const std::string& display);

// What desktops set for screens of many dots per inch, before windows are opened.
bool set_dots_per_inch(const std::string& display, int dots);

}  // namespace snell::test
