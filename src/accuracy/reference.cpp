#include "src/accuracy/reference.h"

#include <cmath>

#include "src/content/image/image.h"

namespace snell::accuracy {

namespace {

constexpr int finest = 8;  // samples along each side of a pixel, and the factor of tessellation

// Filters approximate what many samples of linearly interpolated texels give.
Variant variant_of(const Scene& scene, const Rungs& rungs, int fineness) {
    Variant variant{rungs, {.grid = fineness}};
    if (has_round_shapes(scene)) variant.knobs.plan.tessellation = fineness;
    if (has_textures(scene)) variant.knobs.plan.filter = Filter{Filter::Mode::linear, 1};
    return variant;
}

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

const Reference& References::of(Bench& bench, const Rungs& rungs, const Stop& stop) {
    if (const auto found = known_.find(rungs); found != known_.end()) return found->second;
    Reference& reference = known_[rungs];
    const double start = wall_milliseconds(), end = start + 1e3 * seconds_;
    const Stop enough = [&] { return wall_milliseconds() > end || (stop && stop()); };
    double took = 0;
    for (int fineness = 1; fineness <= finest; fineness *= 2) {
        // Four times the samples, at least; of the first picture, most of the time goes into compiling and loading.
        const double begin = wall_milliseconds();
        if (begin + (fineness > 2 ? 4 : 1) * took > end && fineness > 1) break;
        const Variant variant = variant_of(bench.scene(), rungs, fineness);
        auto finer = bench.picture(variant, nullptr, fineness > 1 ? enough : stop);
        if (!finer) break;
        took = wall_milliseconds() - begin;
        reference = {std::move(*finer), std::move(reference.picture), variant.knobs};
    }
    return reference;
}

std::array<double, 2> sample_position(int index) {
    const auto around_first = [index](int base) {
        const double moved = halton(index + 1, base) - halton(1, base);
        return moved - std::floor(moved + .5);
    };
    return {around_first(2), around_first(3)};
}

Times SampleMean::add(Runtime& runtime, Frame frame, const FrameClock& clock) {
    frame.shift = sample_position(samples_);
    const Times took = clock.of([&] { runtime.draw(frame, surface()); });
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
