// Prints a Scene as text that parses to an equal one.
#pragma once

#include <string>

#include "parser/scene.h"

namespace snell {

// Returns .glib text that parses to an equal scene: the same draws in the same state, programs, textures and passes.
// Transformations are printed as Translate, Rotate and Scale and are equal within rounding. Comments are lost.
std::string print_scene(const Scene& scene);

// Describes the differences between two scenes, other than spans and the sharing of states; empty if they are equal.
// Elements of matrices may differ by `tolerance` times the largest element.
std::string difference(const Scene& a, const Scene& b, double tolerance = 1e-9);

}  // namespace snell
