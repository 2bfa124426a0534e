// How coarse pictures are while something is dragged.
#include "src/document/coarseness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace snell {
namespace {

// A machine that needs so many milliseconds for a sharp picture, and as much less for a coarser one as it has fewer
// samples and pixels.
class Dragged : public ::testing::Test {
protected:
    double cost(int grain) const {
        const Grain& how = grains[static_cast<std::size_t>(grain)];
        return fixed_ms + sharp_ms * (how.samples == 1 ? .6 : 1) / (how.divide * how.divide);
    }
    // Draws a frame if `next` asks for another one than the last; returns its grain.
    int step(bool moved, bool held = true) {
        const int grain = coarseness.next(moved, held, now);
        if (moved || grain != last) {
            last = grain;
            now += cost(grain) / 1e3;
            coarseness.drew(cost(grain));
        }
        return grain;
    }
    // Looks ahead; returns true if the next picture is coarse. `most` is that of foresee().
    bool foresees(double most = std::numeric_limits<double>::infinity()) {
        coarseness.next(true, false, now);
        double spent = 0;
        const bool coarse = coarseness.foresee(
            [&](int grain) {
                const double ms = cost(grain) + std::exchange(compiler_ms, 0);
                spent += ms / 1e3;
                return ms;
            },
            now, most);
        now += spent;
        return coarse;
    }
    // The scene is open for a while.
    void opened() {
        step(true, false);
        now += 1;
        step(true, false);
        now += 1;
    }

    Coarseness coarseness;
    double sharp_ms = 90, now = 10;
    double fixed_ms = 0, compiler_ms = 0;  // of what grows with no pixels; of the next picture that looks ahead
    int last = -1;
};

TEST_F(Dragged, SlowPicturesBecomeCoarserAndSharpAgainAfterTheLastMove) {
    opened();
    EXPECT_EQ(step(false), 0);
    EXPECT_TRUE(std::isinf(coarseness.due()));
    for (int i = 0; i < 20; ++i) step(true);
    EXPECT_EQ(last, 2) << "fewer samples, then half size";
    const double due = coarseness.due();
    EXPECT_LE(due, now + Coarseness::rest);
    now = due - .01;
    EXPECT_EQ(step(false), 2) << "not yet";
    now = due;
    EXPECT_EQ(step(false), 0);
    EXPECT_TRUE(std::isinf(coarseness.due()));
    EXPECT_EQ(step(true), 2) << "the next drag begins where the last one ended";
}

TEST_F(Dragged, TheReleaseIsSharpAtOnce) {
    opened();
    for (int i = 0; i < 20; ++i) step(true);
    ASSERT_GT(last, 0);
    ASSERT_GT(coarseness.due(), now);
    coarseness.released();
    EXPECT_LE(coarseness.due(), now);
    EXPECT_EQ(step(false, false), 0);
    EXPECT_EQ(step(true), 2) << "the next drag begins where the last one ended";
}

TEST_F(Dragged, FastPicturesStaySharp) {
    sharp_ms = 20;
    opened();
    for (int i = 0; i < 50; ++i) EXPECT_EQ(step(true), 0);
}

TEST_F(Dragged, ThePicturesAreAsSharpAsTheyCanBe) {
    sharp_ms = 45;
    opened();
    for (int i = 0; i < 20; ++i) step(true);
    EXPECT_EQ(last, 1) << "27 ms";
    sharp_ms = 1500;
    for (int i = 0; i < 20; ++i) step(true);
    EXPECT_EQ(last, 3) << "the coarsest one, 56 ms";
    sharp_ms = 8;  // what is slow went out of view
    for (int i = 0; i < 20; ++i) step(true);
    EXPECT_EQ(last, 0);
}

TEST_F(Dragged, TheCostDoesNotSwingBetweenTwoGrains) {
    for (const double ms : {34., 40., 55., 60., 90., 150., 220., 500.}) {
        coarseness = {};
        sharp_ms = ms;
        opened();
        for (int i = 0; i < 10; ++i) step(true);
        const int settled = last;
        for (int i = 0; i < 30; ++i) EXPECT_EQ(step(true), settled) << ms;
    }
}

TEST_F(Dragged, OneChangeWithoutAButtonIsSharp) {
    opened();
    EXPECT_EQ(step(true, false), 0) << "a reset, a typed value";
    now += .1;
    EXPECT_GT(step(true, false), 0) << "keys and the wheel repeat";
}

TEST_F(Dragged, PicturesThatLastBeginCoarse) {
    EXPECT_FALSE(coarseness.lasts()) << "nothing is known";
    sharp_ms = 480;
    EXPECT_FALSE(foresees()) << "a sharp picture in half a second";
    EXPECT_TRUE(std::isinf(coarseness.due()));
    sharp_ms = 5000;
    EXPECT_TRUE(foresees());
    EXPECT_TRUE(coarseness.lasts());
    EXPECT_DOUBLE_EQ(coarseness.due(), now + Coarseness::rest);
    EXPECT_EQ(step(true), 3) << "a drag goes on as coarse as it begins";
    now = coarseness.due();
    EXPECT_EQ(step(false), 0);
}

// The driver compiles in the first one, and vertices take as long in all.
TEST_F(Dragged, LookingAheadIsQuickHoweverLongASharpPictureTakes) {
    for (const double compiler : {0., 300., 700.})
        for (const double vertices : {0., 1., 40., 400.})
            for (const double ms : {5., 100., 1e3, 5e3, 20e3, 60e3, 200e3}) {
                coarseness = {};
                sharp_ms = ms;
                fixed_ms = vertices;
                compiler_ms = compiler;
                const double before = now;
                const bool coarse = foresees();
                SCOPED_TRACE(testing::Message() << ms << " ms, compiler " << compiler << ", vertices " << vertices);
                EXPECT_TRUE(coarse || ms < 900) << "it would be drawn at once";
                EXPECT_TRUE(!coarse || ms + 16 * vertices > 480);
                EXPECT_LT(now - before, 1.3 + (4 * vertices + compiler + ms / 50) / 1e3);
                EXPECT_TRUE(!coarse || coarseness.foreseen() > .5 * ms);
                const bool told = coarse && ms > 1000 && vertices < 40;
                EXPECT_TRUE(!told || coarseness.foreseen() < ms + 300 * vertices);
            }
}

// Of a press on a track: the picture while it is held, if that is coarse, and the sharp one.
TEST_F(Dragged, WhereVerticesTakeLongNothingIsCoarseOnceThatIsKnown) {
    sharp_ms = 5;
    for (const double vertices : {600., 2000., 60000.}) {
        coarseness = {};
        fixed_ms = vertices;
        opened();
        EXPECT_FALSE(foresees(4 * (sharp_ms + vertices))) << "in vain";
        for (int press = 0; press < 5; ++press) {
            now += 1;
            EXPECT_EQ(step(true), press == 0 ? coarsest : 0) << "a second time, in which no compiler is at work";
            coarseness.released();
            EXPECT_EQ(step(false), 0);
        }
        sharp_ms = 10 * vertices;
        for (int i = 0; i < 5; ++i) step(true);
        EXPECT_GT(last, 0) << "now it is the pixels that take long";
        sharp_ms = 5;
    }
    // The compiler alone.
    coarseness = {};
    fixed_ms = 0;
    sharp_ms = 900;
    opened();
    compiler_ms = 900;
    EXPECT_FALSE(foresees(4 * 900));
    for (int i = 0; i < 4; ++i) step(true);
    EXPECT_GT(last, 0);
    EXPECT_LT(cost(last), 200);
}

TEST_F(Dragged, TheFirstPictureOfAGrainMayCompile) {
    opened();
    step(true);
    const int first = last;
    coarseness = {};
    opened();
    coarseness.next(true, true, now);
    coarseness.drew(900);
    now += .9;
    EXPECT_EQ(coarseness.next(true, true, now), first) << "is not judged";
}

// Rows from `begin` to `end` are where the work of a picture is; a strip costs a little besides.
struct Drawing {
    int width, height, begin, end;
    double ms;

    double of(const PixelRect& strip) const {
        const int rows = std::max(std::min(strip.bottom + strip.height, end) - std::max(strip.bottom, begin), 0);
        return 2 + ms * rows * strip.width / (static_cast<double>(end - begin) * width);
    }
};

TEST(Strips, CoverThePictureAndNoneTakesLong) {
    for (const int width : {3, 320, 1280})
        for (const int height : {1, 7, 200, 721})
            for (const double ms : {600., 5e3, 60e3, 600e3})
                for (const int share : {1, 2, 4}) {
                    const Drawing drawing{width, height, height - (height + share - 1) / share, height, ms};
                    SCOPED_TRACE(testing::Message() << width << " x " << height << ", " << ms << " ms in 1/" << share);
                    Strips strips(width, height, ms);
                    std::vector<int> drawn(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
                    double longest = 0;
                    int slow = 0, count = 0;
                    for (bool last = false; !last;) {
                        double spent = 0;
                        last = strips.draw([&](const PixelRect& strip) {
                            ++count;
                            EXPECT_EQ(strip.bottom % 4 + strip.left % 4, 0);
                            for (int y = strip.bottom; y < strip.bottom + strip.height; ++y)
                                for (int x = strip.left; x < strip.left + strip.width; ++x)
                                    ++drawn.at(static_cast<std::size_t>(y * width + x));
                            spent += drawing.of(strip);
                            return drawing.of(strip);
                        });
                        longest = std::max(longest, spent);
                        slow += spent > 250 ? 1 : 0;
                    }
                    EXPECT_EQ(std::count(drawn.begin(), drawn.end(), 1), width * height) << "each pixel once";
                    EXPECT_DOUBLE_EQ(strips.share(), 1);
                    if (ms / width / height > 1) continue;  // pixels take long
                    EXPECT_LT(longest, 2.6 * Strips::aim * share) << "where the work begins";
                    EXPECT_LE(slow, 2 * (share - 1)) << "and then no more";
                    EXPECT_LT(count, 16 * share + 40 + ms / Strips::aim * 4) << "not many more than must be";
                }
}

// As where vertices take long, or on a busy machine, where each strip waits for a processor first.
TEST(Strips, AreFewWhereEachTakesLongHoweverSmallItIs) {
    for (const double ms : {2e3, 5e3, 20e3})
        for (const double fixed : {20., 60., 120., 300., 1500.}) {
            const Drawing drawing{1280, 720, 0, 720, ms};
            Strips strips(1280, 720, ms);
            double all = 0;
            for (bool last = false; !last;)
                last = strips.draw([&](const PixelRect& strip) {
                    all += drawing.of(strip) + fixed;
                    return drawing.of(strip) + fixed;
                });
            EXPECT_LT(all, ms * 2.1 + 8 * fixed) << ms << " ms, " << fixed << " for each strip";
        }
}

TEST(Strips, OfAQuickPictureAreOne) {
    Strips strips(1281, 721, 0);
    EXPECT_TRUE(strips.draw([](const PixelRect& strip) {
        EXPECT_EQ(strip.width, 1281);
        EXPECT_EQ(strip.height, 721);
        return 30;
    }));
}

// A machine on which a picture takes so many milliseconds for what does not grow with it and for its pixels, the first
// one what the compiler takes besides, and any up to `noise` times as much.
struct Machine {
    double fixed, pixels, compiler, noise, rounds = 1;

    static constexpr int width = 1280, height = 720;
    double whole() const { return fixed + pixels; }
    double foreseen(double enough, double point, std::mt19937& random, double& spent) const {
        bool first = true;
        Foresight known{point, 1};
        return foresee(width, height, rounds, enough, known, [&](const Trial& trial) {
            const double share = static_cast<double>(trial.width) * trial.height / width / height;
            const double steady = (fixed + pixels * share) * trial.rounds / rounds;
            const double factor = std::uniform_real_distribution<>(1, noise)(random);
            const double milliseconds = steady * factor + (std::exchange(first, false) ? compiler : 0);
            spent += milliseconds;
            return milliseconds;
        });
    }
};

TEST(Foresee, WhatAPictureTakesWhereSomethingElseKeepsTheMachineBusy) {
    std::mt19937 random{7};
    constexpr double enough = 5000, infinity = std::numeric_limits<double>::infinity();
    for (const double fixed : {.2, 5., 100., 400., 900., 1800.})
        for (const double pixels : {.1, 20., 500., 2500., 20e3, 400e3, 3.6e6})
            for (const double compiler : {0., 300., 700.})
                for (const double noise : {1., 1.2, 1.3})
                    for (int i = 0; i < 50; ++i) {
                        const Machine machine{fixed, pixels, compiler, noise};
                        double spent = 0;
                        const double before = std::array{infinity, .2, fixed}[static_cast<std::size_t>(i) % 3];
                        const double milliseconds = machine.foreseen(enough, before, random, spent);
                        SCOPED_TRACE(testing::Message() << fixed << " + " << pixels << " ms, compiler " << compiler
                                                        << ", noise " << noise << ": " << milliseconds);
                        const double whole = machine.whole();
                        const bool both = fixed > 1000 && pixels > 1000;  // then the pixels are not seen
                        EXPECT_TRUE(both || whole < 2 * enough || milliseconds > enough) << "it would be drawn";
                        EXPECT_TRUE(whole > enough / 4 || milliseconds < 4 * enough) << "minutes are foreseen";
                        EXPECT_TRUE(both || noise > 1 || whole < enough || std::abs(milliseconds / whole - 1) < .5);
                        EXPECT_LT(spent, 20e3) << "looking ahead takes long itself";
                        if (HasFailure()) return;
                    }
}

TEST(Foresee, OneSmallPictureIsEnoughAfterTheFirstTime) {
    std::mt19937 random{7};
    const Machine machine{1, 40, 0, 1};
    double spent = 0;
    machine.foreseen(5000, 1, random, spent);
    EXPECT_LT(spent, 1.1);
}

TEST(Foresee, LoopsOfVerticesAreToldByShorterOnes) {
    std::mt19937 random{7};
    constexpr double enough = 5000;
    for (const double fixed : {100., 3000., 30e3, 3.6e6})
        for (const double noise : {1., 1.3}) {
            const Machine machine{fixed, 50, 300, noise, 1000};
            double spent = 0;
            const double milliseconds =
                machine.foreseen(enough, std::numeric_limits<double>::infinity(), random, spent);
            SCOPED_TRACE(testing::Message() << fixed << " ms, noise " << noise << ": " << milliseconds);
            EXPECT_TRUE(fixed < enough || std::abs(milliseconds / machine.whole() - 1.2) < .5);
            EXPECT_TRUE(fixed > enough || milliseconds < enough * 1.5);
            EXPECT_LT(spent, fixed > enough ? 8e3 : 6 * fixed * noise + 1e3) << "looking ahead takes long itself";
        }
}

}  // namespace
}  // namespace snell
