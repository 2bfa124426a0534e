// Framebuffers to draw into and to read back.
#pragma once

#include <cstddef>
#include <vector>

#include "src/gl/handle.h"
#include "src/gl/texture.h"

namespace snell::gl {

// A framebuffer of its own: colour and depth renderbuffers, multisampled or not.
struct Target {
    Framebuffer framebuffer;
    Renderbuffer color, depth;
    int width = 0, height = 0, samples = 1;
};
// Samples are rounded up to what the context has. Empty framebuffer: the context refused it.
Target make_target(int width, int height, int samples, Pixels type = Pixels::rgba8);

// A framebuffer over textures (levels 0), with its own depth. `faces`: GL_TEXTURE_2D or a cube face for each.
struct Attachment {
    GLuint texture = 0;
    GLenum target = GL_TEXTURE_2D;
};
struct TextureTarget {
    Framebuffer framebuffer;
    Renderbuffer depth;
};
TextureTarget make_texture_target(const std::vector<Attachment>& attachments, int width, int height);

// Before another target is drawn to, or a picture is read. llvmpipe's threads may still be about to unlock the fence of
// the last target when the driver frees it, which ends the process now and then: glFinish and glReadPixels look at a
// fence without its lock, glWaitSync takes the lock, and nothing is left to unlock then. GPUs do nothing here.
void settle();

// Rows top first, RGBA bytes or floats. Resolves multisampled framebuffers.
std::vector<std::byte> read_rgba8(GLuint framebuffer, int width, int height, int samples);
std::vector<float> read_rgba32f(GLuint framebuffer, int width, int height, int samples);

}  // namespace snell::gl
