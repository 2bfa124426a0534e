// Pictures in 32-bit floats, as the mean of several.
#pragma once

#include <cstddef>
#include <vector>

#include "src/gl/handle.h"
#include "src/gl/target.h"

namespace snell::gl {

// To draw a picture into, or many of which it keeps the sum.
class ExactTarget {
public:
    // What the context refuses leaves valid() false. `multisample`: samples a pixel by the driver; `es`: of the
    // context.
    ExactTarget(int width, int height, int multisample, bool es);

    bool valid() const { return static_cast<bool>(sum_framebuffer_); }
    int width() const { return width_; }
    int height() const { return height_; }
    // To draw into.
    unsigned framebuffer() const;
    // After drawing: makes one sample a pixel of several.
    void resolve() const;
    // Empties the sum.
    void begin() const;
    // Resolves, and adds what was drawn, times `weight`.
    void add(float weight) const;
    // What was resolved last, or the sum: rows top first, RGBA.
    std::vector<float> read(bool sum) const;

private:
    int width_ = 0, height_ = 0;
    Target multisampled_;  // empty: drawn into drawn_ itself
    Texture drawn_;
    TextureTarget drawn_target_;
    Texture sum_;
    Framebuffer sum_framebuffer_;
    Program program_;
    VertexArray nothing_;
};

// How long the GPU says that it worked between begin and end: a timer query. Only where the context has them.
// Whether any fragment passes from begin() to end(): one that is neither discarded nor behind another. In every
// context.
class AnySamples {
public:
    AnySamples() { glGenQueries(1, &id_); }
    ~AnySamples() { glDeleteQueries(1, &id_); }
    AnySamples(const AnySamples&) = delete;
    AnySamples& operator=(const AnySamples&) = delete;
    void begin() const { glBeginQuery(GL_ANY_SAMPLES_PASSED, id_); }
    void end() const { glEndQuery(GL_ANY_SAMPLES_PASSED); }
    // Waits for the draws.
    bool passed() const {
        GLuint any = 0;
        glGetQueryObjectuiv(id_, GL_QUERY_RESULT, &any);
        return any != 0;
    }

private:
    GLuint id_ = 0;
};

class TimerQuery {
public:
    TimerQuery();
    ~TimerQuery();
    TimerQuery(const TimerQuery&) = delete;
    TimerQuery& operator=(const TimerQuery&) = delete;

    bool available() const { return id_ != 0; }
    void begin() const;
    // Waits. Milliseconds.
    double end() const;

private:
    GLuint id_ = 0;
};

}  // namespace snell::gl
