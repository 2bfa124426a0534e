// The picture that a window keeps, and how it comes onto the screen.
#pragma once

#include "src/gl/target.h"

namespace snell::gl {

// Drawn at its own size, multisampled, resolved once, and kept: what lies over it may change without drawing
// it again.
class Canvas {
public:
    // False: the context refused it. Nothing happens where nothing changes.
    bool resize(int width, int height, int samples);
    // To draw into.
    unsigned framebuffer() const { return drawn_.framebuffer.get(); }
    int samples() const { return drawn_.samples; }
    // After drawing.
    void resolve();
    // Copies the resolved picture into the default framebuffer, its bottom left at pixel (x, y).
    void show(int x, int y) const;

private:
    int wanted_ = 0;
    Target drawn_, resolved_;
};

// Fills the default framebuffer with one colour and leaves it bound, for the overlays.
void clear_window(int width, int height, float red, float green, float blue);

// Returns when all that was asked for has been drawn: to tell what it cost.
void finish();

}  // namespace snell::gl
