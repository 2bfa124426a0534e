#include "src/accuracy/sample_mean.h"

#include <cmath>

#include "src/accuracy/clock.h"
#include "src/content/image/image.h"
#include "src/gl/present.h"

namespace snell::accuracy {

namespace {

// The digits of the number, mirrored at the point (radical inverse).
double halton(int number, int base) {
    double result = 0, place = 1;
    for (; number > 0; number /= base) {
        place /= base;
        result += place * (number % base);
    }
    return result;
}

}  // namespace

std::array<double, 2> sample_position(int index) {
    const auto around_first = [index](int base) {
        const double moved = halton(index + 1, base) - halton(1, base);
        return moved - std::floor(moved + .5);
    };
    return {around_first(2), around_first(3)};
}

double SampleMean::add(Runtime& runtime, Frame frame, bool cpu) {
    frame.shift = sample_position(samples_);
    gl::finish();
    const double start = cpu ? cpu_milliseconds() : wall_milliseconds();
    runtime.draw(frame, {target_.framebuffer(), target_.width(), target_.height()});
    gl::finish();
    const double took = (cpu ? cpu_milliseconds() : wall_milliseconds()) - start;
    if (samples_++ == 0) target_.begin();
    target_.add(1);
    return took;
}

Picture displayed(Picture picture, const Runtime& runtime) {
    if (runtime.display_pixels() != gl::Pixels::srgb8) return picture;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) picture.rgba[i] = static_cast<float>(content::srgb_of_light(picture.rgba[i]));
    return picture;
}

Picture SampleMean::picture(const Runtime& runtime) const {
    Picture picture{target_.width(), target_.height(), target_.read(true)};
    for (float& value : picture.rgba) value /= static_cast<float>(samples_);
    return displayed(std::move(picture), runtime);
}

}  // namespace snell::accuracy
