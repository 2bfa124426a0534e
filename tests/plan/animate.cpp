// Sliders that move by themselves, judged by what a triangle of time must be.
#include <gtest/gtest.h>

#include <cmath>

#include "src/plan/values/animate.h"

namespace snell {
namespace {

Controls one(double min, double value, double max, ValueType type = ValueType::float_) {
    Control control;
    control.name = "u";
    control.type = type;
    control.widget = Widget::slider;
    control.min = min;
    control.max = max;
    control.value = control.initial = {value};
    return {{control}, {}};
}

double at(Controls& controls, const Animated& motion, double time) {
    std::vector<Animated> motions{motion};
    animate(controls, motions, time);
    return controls.items[0].value[0];
}

TEST(Animate, GoesThereAndBackAndRepeats) {
    Controls controls = one(-1, 0, 3);
    const Animated motion = animated_from(controls.items[0], 0, 8, 100);
    EXPECT_EQ(at(controls, motion, 100), 0) << "begins where the slider is";
    EXPECT_EQ(at(controls, motion, 101), 1) << "upwards, with even speed";
    EXPECT_EQ(at(controls, motion, 103), 3);
    EXPECT_EQ(at(controls, motion, 107), -1);
    EXPECT_EQ(at(controls, motion, 100 + 2. / 3), .6667) << "with as few digits as a drag has";
    for (double t = 0; t < 8; t += .37) {
        const double now = at(controls, motion, t);
        EXPECT_NEAR(at(controls, motion, t + 8 * 12345), now, 1e-3) << "a period later";
        EXPECT_NEAR(at(controls, motion, t + 4), 2 - now, 1e-3) << "half a period later: mirrored";
        EXPECT_NEAR(at(controls, motion, t - 8), now, 1e-3) << "before its beginning, too";
    }
}

TEST(Animate, StaysWithinTheRangeAndTheType) {
    Controls whole = one(1, 2, 4, ValueType::int_);
    const Animated steps = animated_from(whole.items[0], 0, 3, 0);
    for (double t = 0; t < 3; t += .01) {
        const double value = at(whole, steps, t);
        EXPECT_EQ(value, std::round(value));
        EXPECT_TRUE(value >= 1 && value <= 4);
    }
    Controls huge = one(-1e308, 0, 1e308, ValueType::double_);
    const Animated far = animated_from(huge.items[0], 0, 3, 0);
    for (double t = 0; t < 3; t += .1) EXPECT_TRUE(std::isfinite(at(huge, far, t)));
    Controls none = one(2, 2, 2);
    EXPECT_EQ(at(none, animated_from(none.items[0], 0, 0, 0), 1), 2) << "neither a range nor a period";
}

TEST(Animate, OfALogarithmicSliderHasEqualRatiosInEqualTimes) {
    Controls controls = one(.01, .01, 100);
    Animated motion = animated_from(controls.items[0], 0, 8, 0);
    motion.logarithmic = true;
    for (int i = 0; i <= 4; ++i) EXPECT_NEAR(at(controls, motion, i) / (.01 * std::pow(10, i)), 1, 1e-4) << i;
}

TEST(Animate, EndsWhenItsSliderIsGone) {
    Controls controls = one(0, .5, 1);
    std::vector<Animated> motions{{0, "uOther"}, {0, "u", 3}};
    animate(controls, motions, 1);
    EXPECT_TRUE(motions.empty());
    EXPECT_EQ(controls.items[0].value[0], .5);
    motions = {{0, "u"}, {0, "uOther"}, {1, "u"}};
    stop(motions, controls.items[0], 0);
    EXPECT_EQ(motions.size(), 2u);
    stop_all(motions, 0);
    EXPECT_EQ(motions.size(), 1u);
}

}  // namespace
}  // namespace snell
