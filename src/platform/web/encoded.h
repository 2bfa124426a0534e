// The way of a picture to the canvas.
#pragma once

#include "src/gl/present.h"

namespace snell {

// Copies the resolved picture into the canvas of the current context. The canvas takes encoded bytes: those of a
// picture of srgb8 are copied as they are, where a blit would decode them.
void show_encoded(const gl::Canvas& canvas, int width, int height, gl::Pixels pixels);

}  // namespace snell
