// Draws pictures in the form in which they are written.
#pragma once

#include <string>

#include "src/content/image/image.h"
#include "src/gl/target.h"
#include "src/runtime/runtime.h"

namespace snell::app {

// True for formats that store floats, which get the shaders' values without rounding to bytes.
bool holds_floats(const std::string& path);

// True for formats that store alpha, which a picture without background needs.
bool holds_alpha(const std::string& path);

struct PictureKind {
    bool floats = false;
    // Makes four channels, without the background: the picture is drawn over black and over white, and the difference
    // is its transparency. Floats are multiplied by alpha, as EXR requires; bytes are not, as PNG requires. If false,
    // makes three channels: the alpha that blending leaves has no meaning.
    bool transparent = false;
};

// Draws into the target, which must be large enough for the surface's part, or for the whole surface.
content::Image draw_picture(Runtime& runtime, Frame frame, const gl::Target& target, Surface surface,
                            const PictureKind& kind);

}  // namespace snell::app
