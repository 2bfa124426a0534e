// What a gesture does to the view, whether a mouse or a finger makes it.
#pragma once

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/plan/hand/hold.h"
#include "src/plan/view.h"

namespace snell {

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
