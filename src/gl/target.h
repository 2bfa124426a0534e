// Framebuffers to draw into and to read back, and queries of what was drawn and how long it took.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "src/gl/handle.h"
#include "src/gl/texture.h"

namespace snell::gl {

// A framebuffer with its own colour and depth renderbuffers, multisampled if `samples` is above 1.
struct Target {
    Framebuffer framebuffer;
    Renderbuffer color, depth;
    int width = 0, height = 0, samples = 1;
    Pixels pixels = Pixels::rgba8;
};
// `samples` is rounded up to a number that the context supports. The framebuffer is empty if the context refuses it.
Target make_target(int width, int height, int samples, Pixels type = Pixels::rgba8);

// One colour attachment of a framebuffer: level 0 of a texture. `target` is GL_TEXTURE_2D or a face of a cube map.
struct Attachment {
    GLuint texture = 0;
    GLenum target = GL_TEXTURE_2D;
};
// A framebuffer that draws into textures, with its own depth renderbuffer.
struct TextureTarget {
    Framebuffer framebuffer;
    Renderbuffer depth;
};
TextureTarget make_texture_target(const std::vector<Attachment>& attachments, int width, int height);

// To be called before another target is drawn to, and before pixels are read. llvmpipe's threads may still be about to
// unlock the fence of the last target when the driver frees it, which sometimes crashes the process: glFinish and
// glReadPixels look at a fence without its lock. glWaitSync takes the lock, so nothing is left to unlock. Has no effect
// on GPUs.
void settle();

// While it exists, what is drawn or resolved into a framebuffer of srgb8 is light, which OpenGL encodes after blending
// and averaging. `on`: false for other framebuffers. OpenGL ES does so by itself.
class Encoded {
public:
    explicit Encoded(bool on);
    ~Encoded();
    Encoded(const Encoded&) = delete;
    Encoded& operator=(const Encoded&) = delete;

private:
    bool on_;
};

// Reads pixels back: RGBA, top row first, as bytes or floats. Resolves multisampled framebuffers first. `pixels` is the
// framebuffer's type, rgba8 or srgb8; the bytes are those that a display gets.
std::vector<std::byte> read_rgba8(GLuint framebuffer, int width, int height, int samples,
                                  Pixels pixels = Pixels::rgba8);
std::vector<float> read_rgba32f(GLuint framebuffer, int width, int height, int samples);

// Pictures in 32-bit floats, and their weighted sums: the mean of many samples.

// A framebuffer to draw a picture into, with a second one that accumulates a weighted sum of such pictures.
class ExactTarget {
public:
    // `multisample` is the number of samples per pixel that the driver takes; `es` says that the context is OpenGL ES.
    // If the context refuses the framebuffer, valid() is false.
    ExactTarget(int width, int height, int multisample, bool es);

    bool valid() const { return static_cast<bool>(sum_framebuffer_); }
    int width() const { return width_; }
    int height() const { return height_; }
    // The framebuffer to draw into.
    unsigned framebuffer() const;
    // Resolves the multisampled picture to one value per pixel. Call it after drawing.
    void resolve() const;
    // Sets the sum to zero.
    void begin() const;
    // Resolves the picture, multiplies it by `weight` and adds it to the sum.
    void add(float weight) const;
    // Returns the sum, or the picture that was resolved last: RGBA, top row first.
    std::vector<float> read(bool sum) const;

private:
    int width_ = 0, height_ = 0;
    Target multisampled_;  // empty without multisampling: the picture is then drawn into drawn_ itself
    Texture drawn_;
    TextureTarget drawn_target_;
    Texture sum_;
    Framebuffer sum_framebuffer_;
    Program program_;
    VertexArray nothing_;
};

// Finds whether any fragment passes between begin() and end(), that is, is neither discarded nor behind another. Works
// in every context.
class AnySamples {
public:
    // May begin again after its end: all draws in between count.
    void begin() {
        queries_.emplace_back(make(glGenQueries));
        glBeginQuery(GL_ANY_SAMPLES_PASSED, queries_.back().get());
    }
    void end() const { glEndQuery(GL_ANY_SAMPLES_PASSED); }
    // Waits for the draws.
    bool passed() const {
        GLuint any = 0;
        for (auto query = queries_.begin(); any == 0 && query != queries_.end(); ++query)
            glGetQueryObjectuiv(query->get(), GL_QUERY_RESULT, &any);
        return any != 0;
    }

private:
    std::vector<Query> queries_;
};

// Measures the GPU's time between begin() and end() with a timer query, if the context has one.
class TimerQuery {
public:
    TimerQuery();

    bool available() const { return static_cast<bool>(query_); }
    void begin() const;
    // Waits for the GPU and returns milliseconds.
    double end() const;

private:
    Query query_;
};

// Times on the GPU's own clock, by timestamp queries.
class Marks {
public:
    // True if the context has timestamp queries. Software renderers have them, but their times are wrong.
    bool available();
    // Records the time at which the GPU has finished all commands issued so far. Does not wait.
    void mark();
    std::size_t count() const { return used_; }
    // Returns the milliseconds between consecutive marks, one value fewer than there are marks, and clears the marks.
    // Waits for the GPU.
    std::span<const double> take();

private:
    enum class Known { not_yet, yes, no };
    Known known_ = Known::not_yet;
    std::vector<Query> queries_;
    std::size_t used_ = 0;
    std::vector<double> times_;
};

}  // namespace snell::gl
