// Where to move a scene of which nothing is in view.
#pragma once

#include <span>
#include <vector>

#include "src/plan/plan.h"
#include "src/plan/view.h"

namespace snell {

// Views that may show what lies in the boxes (eye space), `current` moved: straight away from the eye first, then to
// the middle of the picture, then smaller, too. In round numbers. Where shaders move what they draw, none of them need
// show it: they are to be tried. Empty: there is nothing finite in the boxes.
std::vector<View> views_to_try(std::span<const DepthBox> boxes, const Camera& camera, const View& current);

}  // namespace snell
