// Combinations whose costs and errors are known: the one that is advised is the one that must be.
#include "src/accuracy/advice.h"
#include "tests/accuracy/gl/common.h"

namespace snell::test {
namespace {

using namespace accuracy;

class Advising : public AccuracyTest {
protected:
    // Rung k of each of three ladders takes 2^k units. A and B are 1/10^k off, and alone: off by both, the larger
    // shows. C costs and corrects nothing.
    Bench& ladders(bool many) {
        folder.write("full.vert",
                     "#version 330 compatibility\nvoid main() { gl_Position = vec4(gl_Vertex.xy, 0., 1.); }\n");
        folder.write("work.frag", R"(#version 330 compatibility
uniform float uStep;
float off(int rung, int last) { return rung == last ? 0. : pow(10., -float(rung) - 1.); }
void main() {
    float x = gl_FragCoord.x;
    int units = (1 << A) + (1 << B) + (1 << C);
    for (int i = 0; i < 40 * units; ++i) x = x * .999 + uStep * sin(x);
    gl_FragColor = vec4(vec3(.25 + max(off(A, A_exact), off(B, B_exact)) + 1e-30 * x), 1.);
}
)");
        const std::string rungs = many ? "bad fair good <exact>\n" : "bad fair <exact>\n";
        return bench_of_text("Ladder A " + rungs + "Ladder B " + rungs + "Ladder C " + rungs +
                                 "Vertex full.vert\nFragment work.frag\nProgram Work uStep <0. .001 1.>\nQuadXY 0 1\n",
                             32, 32);
    }
    Counsel counsel(Bench& b, const std::vector<Wish>& wishes) {
        MeasureOptions options;
        options.rounds = 15;   // 10 rungs have 45 pairs, which need 11
        options.seconds = 40;  // more than it takes
        options.at_least = .1;
        return advise(b, plan().rungs, wishes, options);
    }
    static std::string named(const Counsel& counsel, std::size_t wish) {
        const Advice& advice = counsel.advice.at(wish);
        return counsel.sweeps.at(advice.sweep).rungs.at(advice.rung).name;
    }
};

TEST_F(Advising, OfFewCombinationsAllAreMeasuredOnce) {
    Bench& b = ladders(false);
    Counsel found;
    // Another process may disturb some frames of .3 ms so much that another combination looks quicker; not every time.
    for (int attempt = 0; attempt < 4 && (attempt == 0 || named(found, 0) != "bad bad bad"); ++attempt)
        found = counsel(b, {Wish{}, Wish{.alone = .02}, Wish{.error = 1e-6}, Wish{.milliseconds = 1e-4}});
    EXPECT_EQ(found.sweeps.size(), 1U);
    EXPECT_EQ(found.sweeps[0].rungs.size(), 27U);
    EXPECT_EQ(named(found, 0), "bad bad bad");
    EXPECT_TRUE(named(found, 1).starts_with("fair fair")) << named(found, 1);
    EXPECT_TRUE(named(found, 2).starts_with("exact exact")) << named(found, 2);
    EXPECT_TRUE(found.advice[2].met);
    EXPECT_EQ(named(found, 3), "bad bad bad") << "nothing is that quick: the nearest";
    EXPECT_FALSE(found.advice[3].met);
}

TEST_F(Advising, OfManyItGoesFromNeighbourToNeighbour) {
    Bench& b = ladders(true);
    Counsel found;
    // Of the last ladder the first two rungs may cost the same where the machine is noisy.
    const auto right = [&] { return named(found, 0) == "fair fair bad" || named(found, 0) == "fair fair fair"; };
    for (int attempt = 0; attempt < 3 && (attempt == 0 || !right()); ++attempt)
        found = counsel(b, {Wish{.error = .02}});
    EXPECT_TRUE(right()) << named(found, 0);
    EXPECT_TRUE(found.advice[0].met);
    EXPECT_TRUE(found.advice[0].settled);
    EXPECT_FALSE(found.advice[0].everything);
    EXPECT_GE(found.sweeps.size(), 4U) << "three ladders move, then none is better";
    for (const SweepResult& sweep : found.sweeps) EXPECT_LT(sweep.rungs.size(), 13U);
}

}  // namespace
}  // namespace snell::test
