#include "src/accuracy/reference.h"

#include "src/accuracy/clock.h"

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

}  // namespace snell::accuracy
