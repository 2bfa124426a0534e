// The window's last picture, and its way to the screen.
#pragma once

#include <cstddef>
#include <span>

#include "src/gl/handle.h"
#include "src/gl/target.h"
#include "src/gl/texture.h"

namespace snell::gl {

// A multisampled framebuffer of a size of its own. Its picture is resolved once and kept, so that overlays can change
// without drawing it again.
class Canvas {
public:
    // Returns false if the context refuses the size. Does nothing if all is the same as before. `pixels` is rgba8 or
    // srgb8.
    bool resize(int width, int height, int samples, Pixels pixels);
    // The framebuffer to draw into.
    unsigned framebuffer() const { return drawn_.framebuffer.get(); }
    int samples() const { return drawn_.samples; }
    // Resolves the multisampled picture. Call it after drawing.
    void resolve();
    // Reads the resolved picture: RGBA bytes, top row first.
    std::vector<std::byte> read() const;
    // Copies the resolved picture into a framebuffer of bytes, the default one if none is named, with its bottom left
    // corner at pixel (x, y), enlarged to the size in pixels. `first`: without the columns before it.
    void show(int x, int y, int width, int height, GLuint to = 0, int first = 0) const;

private:
    int wanted_ = 0;
    Pixels pixels_ = Pixels::rgba8;
    Target drawn_, resolved_;
    // Of srgb8 in OpenGL ES, which decodes what it copies: the picture is resolved into a texture, and shown by a
    // program that encodes again.
    Texture light_;
    Program encode_;
    VertexArray nothing_;

    bool make_light(int width, int height);
    void encode(int x, int y, int width, int height, GLuint to, int first) const;
};

// Fills the default framebuffer with one colour and leaves it bound, so that overlays can be drawn.
void clear_window(int width, int height, float red, float green, float blue);

// Waits until the GPU has executed all commands, so that their time can be measured.
void finish();

// A picture made on the CPU, such as a measured difference, to show in the window.

class Still {
public:
    // Uploads RGBA bytes, top row first.
    void set(int width, int height, std::span<const std::byte> rgba);
    // Copies it into the default framebuffer, so many times larger. (x, y) is the pixel of the bottom left corner;
    // `first` as of Canvas. Does nothing before set() was called.
    void show(int x, int y, int enlarged, int first = 0) const;

private:
    int width_ = 0, height_ = 0;
    Texture texture_;
    Framebuffer framebuffer_;
};

}  // namespace snell::gl
