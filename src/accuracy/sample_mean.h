// A picture as the mean of many, each at another position within the pixel. Needs a current context.
#pragma once

#include <array>

#include "src/accuracy/metrics.h"
#include "src/gl/exact_target.h"
#include "src/runtime/runtime.h"

namespace snell::accuracy {

// The positions follow each other so that any number of the first ones is spread evenly (Halton, bases 2 and 3). In
// pixels, within half of one; the first is where pictures always stand.
std::array<double, 2> sample_position(int index);

class SampleMean {
public:
    SampleMean(int width, int height, bool es) : target_(width, height, 1, es) {}

    // False: the context has no such targets, and nothing below may be called.
    bool valid() const { return target_.valid(); }
    int samples() const { return samples_; }
    void restart() { samples_ = 0; }
    // Draws the next sample; frame.shift is ignored. What drawing took, in milliseconds: process CPU time with
    // `cpu`, else by the wall's clock.
    double add(Runtime& runtime, Frame frame, bool cpu);
    // Precondition: samples() > 0.
    Picture picture() const;

private:
    gl::ExactTarget target_;
    int samples_ = 0;
};

}  // namespace snell::accuracy
