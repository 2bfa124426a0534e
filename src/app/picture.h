// What was drawn, as a picture to be written.
#pragma once

#include <string>

#include "src/content/image.h"
#include "src/gl/target.h"
#include "src/runtime/runtime.h"

namespace snell::app {

// Formats of floats get what the shaders wrote, not a byte of it.
bool holds_floats(const std::string& path);

// Formats that a picture without its background can be written in.
bool holds_alpha(const std::string& path);

struct PictureKind {
    bool floats = false;
    // Four channels, without the background: it is drawn twice, over black and over white, and what differs shows
    // through. Floats are multiplied by alpha, as EXR means it; bytes are not, as PNG means it. Else three channels:
    // what blending left in the alpha channel is nobody's.
    bool transparent = false;
};

// Draws into the target, which has room for the surface's part, or for all of it.
content::Image draw_picture(Runtime& runtime, Frame frame, const gl::Target& target, Surface surface,
                            const PictureKind& kind);

}  // namespace snell::app
