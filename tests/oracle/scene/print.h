// The second consumer of a Scene: text that reads back to an equal one.
#pragma once

#include <string>

#include "parser/scene.h"

namespace snell {

// A .glib text that parses to an equal scene: same draws in the same state, programs, textures and passes.
// Transformations come out as Translate, Rotate and Scale, equal within rounding; comments are lost.
std::string print_scene(const Scene& scene);

// What is different between two scenes, spans and the sharing of states aside; empty when they are equal.
// Matrices may differ by `tolerance` times their largest element.
std::string difference(const Scene& a, const Scene& b, double tolerance = 1e-9);

}  // namespace snell
