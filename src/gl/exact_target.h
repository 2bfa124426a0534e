// Pictures in 32-bit floats, and their weighted sums: the mean of many samples.
#pragma once

#include <cstddef>
#include <vector>

#include "src/gl/handle.h"
#include "src/gl/target.h"

namespace snell::gl {

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
    void begin() const { glBeginQuery(GL_ANY_SAMPLES_PASSED, query_.get()); }
    void end() const { glEndQuery(GL_ANY_SAMPLES_PASSED); }
    // Waits for the draws.
    bool passed() const {
        GLuint any = 0;
        glGetQueryObjectuiv(query_.get(), GL_QUERY_RESULT, &any);
        return any != 0;
    }

private:
    Query query_{make(glGenQueries)};
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

}  // namespace snell::gl
