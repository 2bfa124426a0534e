#include "src/gl/still.h"

#include "src/gl/texture.h"

namespace snell::gl {

void Still::set(int width, int height, std::span<const std::byte> rgba) {
    if (rgba.size() < static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) return;
    width_ = width;
    height_ = height;
    texture_ =
        make_texture(GL_TEXTURE_2D, {Pixels::rgba8, width, height, 1, rgba.data()}, {Sampling::Mode::nearest, 1, true});
    framebuffer_ = Framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.get(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Still::show(int x, int y, int first) const {
    if (!framebuffer_ || first >= width_) return;
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    // The blit flips the picture: its first row is the top one, but GL's first row is the bottom one.
    glBlitFramebuffer(first, 0, width_, height_, x + first, y + height_, x + width_, y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace snell::gl
