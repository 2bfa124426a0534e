// Ladders, samples and found rungs together; and the steps of a search.
#include "src/accuracy/found/together.h"

#include <gtest/gtest.h>

#include "tests/accuracy/gl/common.h"

namespace snell::test {
namespace {

using namespace accuracy;

constexpr std::string_view whole_scene =
    "Vertex full.vert\nFragment full.frag\nProgram Full uGain <1. 1. 1.>\nQuadXY 0 1\n";

class FoundTogether : public AccuracyTest {
protected:
    void read_scene(std::string_view scene) { bench_of_text(scene, 32, 32); }
    Original original() { return {folder.path("scene.glib"), read->plan, *read->files, read->sources}; }
    const BenchSettings settings{32, 32, 0, {}};

    FoundResult search(std::vector<Change> changes) {
        SearchOptions options;
        options.rounds = 9;
        options.at_least = .5;
        Search found(original(), std::move(changes), caps, settings, options);
        while (found.step()) continue;
        return found.take();
    }
    MixAdvice advise(const FoundResult& found, const Wish& wish) {
        References references(2);
        MixOptions options;
        options.measuring.references = &references;
        options.measuring.rounds = 9;
        options.measuring.at_least = .5;
        options.rungs = {Rungs{0}};
        return advise_together(original(), found, *bench, caps, settings, wish, options);
    }
};

// A rung of the ladder and a found rung take half of the time each, and .04 of the light.
TEST_F(FoundTogether, ErrorsAreThoseOfThePicturesThatAreDrawn) {
    write_full(R"(
float encoded(float x) { return x <= .0031308 ? 12.92 * x : 1.055 * pow(x, 1. / 2.4) - .055; }
void main() {
    float sum = .5;
#if SHADE == SHADE_exact
    for (int i = 0; i < 1500; ++i) sum += .04 / 1500.;
#endif
    for (int k = 0; k < 1500; ++k) sum += .04 / 1500.;
    gl_FragColor = vec4(vec3(encoded(sum)), 1.);
}
)");
    read_scene("Ladder SHADE cheap <exact>\n" + std::string(whole_scene));
    const FoundResult found = search({change(ChangeKind::fewer_rounds, "k < 1500", "k < 15")});
    ASSERT_TRUE(found.times(found.rungs[0])) << found.rungs[0].reason;
    const MixAdvice narrow = advise(found, {.error = .06}), wide = advise(found, {.error = .1});
    for (const MixAdvice* advice : {&narrow, &wide}) {
        ASSERT_TRUE(advice->best);
        EXPECT_TRUE(advice->met);
        for (std::size_t i = 0; i < advice->mixes.size(); ++i) {
            const Mix& mix = advice->mixes[i];
            const double error = (mix.rungs[0] == 0 ? .04 : 0) + (mix.changes.empty() ? 0 : .0396);
            EXPECT_NEAR(advice->sweep.rungs[i].own.light.rmse, error, 1e-3) << advice->sweep.rungs[i].name;
        }
    }
    EXPECT_NEAR(narrow.sweep.rungs[*narrow.best].own.light.rmse, .04, 1e-3) << "both would be .08";
    // Four samples of what hardly costs anything may cost the same, and are finer.
    const Mix& best = wide.mixes[*wide.best];
    EXPECT_EQ(best, (Mix{{0}, best.samples, {0}})) << wide.sweep.rungs[*wide.best].name;
    EXPECT_LT(wide.sweep.rungs[*wide.best].ratio.high, 1);
}

// A window rests between the steps.
TEST_F(FoundTogether, AStepDrawsAPlaceOrTimesARung) {
    write_full("void main() { float c = .5; c += .1; gl_FragColor = vec4(vec3(c), 1.); }\n");
    read_scene(whole_scene);
    SearchOptions options;
    options.rounds = 9;
    options.at_least = .5;
    Search found({folder.path("scene.glib"), read->plan, *read->files, read->sources},
                 {change(ChangeKind::without_term, "c += .1;", ";"), change(ChangeKind::no_draw, "QuadXY 0 1", "")},
                 caps, {32, 32, 0, {}}, options);
    std::size_t most = 0, drawn = 0;
    const auto places = [&] {
        std::size_t count = 0;
        for (const FoundRung& rung : found.result().rungs) count += rung.at.size();
        return count;
    };
    while (found.step()) {
        most = std::max(most, places() - std::min(places(), drawn));
        drawn = places();
    }
    EXPECT_GE(drawn, 4u);
    EXPECT_EQ(most, 1u) << "places of one rung in a step";
}

}  // namespace
}  // namespace snell::test
