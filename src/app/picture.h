// What was drawn, as a picture to be written.
#pragma once

#include <string>

#include "src/content/image.h"
#include "src/gl/target.h"

namespace snell::app {

// Formats of floats get what the shaders wrote, not a byte of it.
bool holds_floats(const std::string& path);

// Three channels: what blending left in the alpha channel is nobody's.
content::Image read_picture(const gl::Target& target, bool floats);

}  // namespace snell::app
