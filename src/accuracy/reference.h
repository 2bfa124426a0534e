// The pictures that errors are measured against: the last rungs, with finer knobs than any scene is drawn with, and the
// mean of many pictures that are shifted by fractions of a pixel.
#pragma once

#include <array>
#include <map>

#include "src/accuracy/bench.h"
#include "src/accuracy/metrics.h"
#include "src/gl/target.h"
#include "src/runtime/runtime.h"

namespace snell::accuracy {

// The finest picture that the time allowed, and the same at half its knobs. The knobs are doubled until then, so the
// picture is nearer to the limit than the distance of the two.
struct Reference {
    Picture picture;  // empty if this context cannot draw it
    Picture half;     // empty if there was no time for finer knobs than the scene's own
    Knobs knobs;      // of `picture`
};

// Draws references on demand and keeps them, because the sweeps of a report share them.
class References {
public:
    // For each reference, at most about `seconds` are used.
    explicit References(double seconds) : seconds_(seconds) {}
    double seconds() const { return seconds_; }
    const Reference& of(Bench& bench, const Rungs& rungs, const Stop& stop);

private:
    double seconds_;
    std::map<Rungs, Reference> known_;
};

// A picture as the mean of many, each shifted by a fraction of a pixel. Needs a current context.

// The shift of a sample in pixels, at most half a pixel. The first one is 0, and any number of the first samples is
// evenly distributed (Halton sequence, bases 2 and 3).
std::array<double, 2> sample_position(int index);

// The values that a display gets of a picture of floats that the runtime drew: encoded if the scene's output is light.
Picture displayed(Picture picture, const Runtime& runtime);

class SampleMean {
public:
    SampleMean(int width, int height, bool es) : target_(width, height, 1, es) {}

    // If false, the context has no float targets, and the functions below must not be called.
    bool valid() const { return target_.valid(); }
    int samples() const { return samples_; }
    void restart() { samples_ = 0; }
    // Draws the next sample, and returns the time of the drawing; frame.shift is ignored.
    Times add(Runtime& runtime, Frame frame, const FrameClock& clock);
    // Where samples are drawn.
    Surface surface() const { return {target_.framebuffer(), target_.width(), target_.height()}; }
    // What a display gets of the mean. samples() must be above 0; `runtime` drew them.
    Picture picture(const Runtime& runtime) const;

private:
    gl::ExactTarget target_;
    int samples_ = 0;
};

}  // namespace snell::accuracy
