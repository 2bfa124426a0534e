// A picture made on the CPU, such as a measured difference, to show in the window.
#pragma once

#include <cstddef>
#include <span>

#include "src/gl/handle.h"

namespace snell::gl {

class Still {
public:
    // Uploads RGBA bytes, top row first.
    void set(int width, int height, std::span<const std::byte> rgba);
    // Copies the columns from `first` on into the default framebuffer. (x, y) is the pixel of the bottom left corner of
    // the whole picture. Does nothing before set() was called.
    void show(int x, int y, int first) const;

private:
    int width_ = 0, height_ = 0;
    Texture texture_;
    Framebuffer framebuffer_;
};

}  // namespace snell::gl
