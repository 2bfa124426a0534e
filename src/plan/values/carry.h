// How values are found again in another text: the names of controls, and what a control takes from another one.
#pragma once

#include <string>
#include <vector>

#include "src/plan/values/controls.h"

namespace snell {

// "Glass.uEta" for each control, or "Glass#2.uEta" in the second program of that name.
std::vector<std::string> control_names(const Scene& scene, const Controls& controls);

// Whether a value that the text has changed since follows the text.
enum class Follow : bool { memory, text };

// Gives a control the value of another one. Its range stays that of the text, unless the text has not changed it, or
// the value does not follow the text, and the value, outside of it, needs a wider one.
void take_value(const Control& from, Control& control, Follow follow = Follow::text);

}  // namespace snell
