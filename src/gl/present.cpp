#include "src/gl/present.h"

namespace snell::gl {

namespace {

// The scissor test is disabled because it clips blits and clears too.
void copy(const Target& from, GLuint to, int x, int y, int width, int height) {
    const bool enlarged = width != from.width || height != from.height;
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, from.width, from.height, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                      enlarged ? GL_LINEAR : GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace

bool Canvas::resize(int width, int height, int samples, Pixels pixels) {
    if (drawn_.framebuffer && drawn_.width == width && drawn_.height == height && wanted_ == samples &&
        pixels_ == pixels)
        return true;
    // The old targets are freed first: memory may be too small for both.
    drawn_ = {};
    resolved_ = {};
    wanted_ = samples;
    pixels_ = pixels;
    drawn_ = make_target(width, height, samples, pixels);
    // A multisampled blit requires equal formats, and the default framebuffer's may differ: resolve into a target of
    // our own.
    if (drawn_.samples > 1) resolved_ = make_target(width, height, 1, pixels);
    return drawn_.framebuffer && (drawn_.samples <= 1 || resolved_.framebuffer);
}

void Canvas::resolve() {
    if (!resolved_.framebuffer) return;
    settle();
    const Encoded encoded(pixels_ == Pixels::srgb8);
    copy(drawn_, resolved_.framebuffer.get(), 0, 0, drawn_.width, drawn_.height);
}

void Canvas::show(int x, int y, int width, int height) const {
    const Target& shown = resolved_.framebuffer ? resolved_ : drawn_;
    if (shown.framebuffer) copy(shown, 0, x, y, width, height);
}

void clear_window(int width, int height, float red, float green, float blue) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glViewport(0, 0, width, height);
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void finish() {
    settle();
    glFinish();
}

}  // namespace snell::gl
