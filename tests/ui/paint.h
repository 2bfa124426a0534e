// What Dear ImGui would show, without a display: as a picture, and as letters that can be checked.
#pragma once

#include <string>
#include <vector>

#include "src/content/image/image.h"

struct ImDrawData;

namespace snell::ui {

// Opaque, top row first. The scene's place is filled with a pattern.
content::Image paint(const ImDrawData& data);

// What is cut off at a side, and letters that lie upon others; as text that says where. What is scrolled away is not
// meant, nor what pops up over the rest.
std::vector<std::string> flaws(const ImDrawData& data);

}  // namespace snell::ui
