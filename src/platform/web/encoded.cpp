#include "src/platform/web/encoded.h"

namespace snell {

namespace {

// The bytes go through a buffer on the GPU, which knows nothing of encodings, into a texture of plain bytes.
gl::Texture plain_copy(unsigned framebuffer, int width, int height) {
    const gl::Buffer bytes(gl::make(glGenBuffers));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, bytes.get());
    glBufferData(GL_PIXEL_PACK_BUFFER, GLsizeiptr{4} * width * height, nullptr, GL_STREAM_COPY);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl::Texture texture(gl::make(glGenTextures));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, bytes.get());
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    return texture;
}

}  // namespace

void show_encoded(const gl::Canvas& canvas, int width, int height, gl::Pixels pixels) {
    if (pixels != gl::Pixels::srgb8) return canvas.show(0, 0, width, height);
    const gl::Texture plain = plain_copy(canvas.resolved(), width, height);
    const gl::Framebuffer framebuffer(gl::make(glGenFramebuffers));
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.get());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, plain.get(), 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace snell
