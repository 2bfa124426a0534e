// Sliders that move by themselves, judged by what a triangle of time must be.
#include <cmath>

#include "src/plan/values/animate.h"
#include "tests/ui/screen.h"

namespace snell::ui {
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
    const Animated motion = animated_from(controls.items[0], 0, 8, 0, true);
    for (int i = 0; i <= 4; ++i) EXPECT_NEAR(at(controls, motion, i) / (.01 * std::pow(10, i)), 1, 1e-4) << i;
    Controls middle = one(.01, 1, 100);
    EXPECT_NEAR(at(middle, animated_from(middle.items[0], 0, 8, 5, true), 5), 1, 1e-4) << "begins where the slider is";
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

class Motion : public UiTest {
protected:
    void press(Key which) {
        frame({key(which, true)});
        frame({key(which, false)});
    }
    double value() const { return controls_.items[0].value[0]; }
};

TEST_F(Motion, AnAnimatedSliderGoesThereAndBack) {
    add_slider("uMix", 0, .5, 2);
    memory_.clock.time = 10;
    click(place("uMix.name"), MouseButton::right);
    click(place("uMix.animate"));
    ASSERT_TRUE(memory_.animating());
    const auto at = [&](double time) {
        animate(controls_, memory_.animated, time);
        return value();
    };
    EXPECT_NEAR(at(10), .5, 1e-12) << "it begins where it is";
    EXPECT_NEAR(at(11), 1.5, 1e-12);
    EXPECT_NEAR(at(11.5), 2, 1e-12);
    EXPECT_NEAR(at(13.5), 0, 1e-12);
    EXPECT_NEAR(at(10 + 4 * 1000), .5, 1e-9);
    click(place("uMix.period"), MouseButton::left, .5, {.ctrl = true});
    type("8");
    memory_.clock.time = 10;
    EXPECT_EQ(memory_.animated[0].period, 8);
    EXPECT_NEAR(at(10), .5, 1e-9) << "another period does not make it jump";
    EXPECT_NEAR(at(12), 1.5, 1e-9);
    press(Key::escape);
    click(place("uMix.dot"));
    EXPECT_FALSE(memory_.animating()) << "one click stops it";
    EXPECT_NEAR(value(), 1.5, 1e-9) << "where it is";
}

TEST_F(Motion, AnotherScaleDoesNotMakeItJump) {
    add_slider("uMix", .01, 1, 100);
    for (const double time : {10., 11., 13.}) {
        memory_.logarithmic.clear();
        memory_.clock.time = 10;
        controls_.items[0].value[0] = 1;
        memory_.animated = {animated_from(controls_.items[0], 0, 4, 10)};
        memory_.clock.time = time;
        for (const char* scale : {"logarithmic", "linear"}) {
            animate(controls_, memory_.animated, time);
            const double before = value();
            const auto later = [&] {
                Controls controls = controls_;
                animate(controls, memory_.animated, time + .01);
                return controls.items[0].value[0];
            };
            const bool rises = later() > before;
            click(place("uMix.name"), MouseButton::right);
            click(place("uMix.logarithmic"));
            press(Key::escape);
            ASSERT_TRUE(memory_.animating());
            animate(controls_, memory_.animated, time);
            EXPECT_NEAR(value() / before, 1, 1e-3) << scale << " at " << time;
            EXPECT_EQ(later() > before, rises) << scale << " at " << time;
        }
    }
}

TEST_F(Motion, MovingAnAnimatedSliderStopsIt) {
    add_slider("uMix", 0, .5, 2);
    const auto start = [&] { memory_.animated = {animated_from(controls_.items[0], 0, 4, 0)}; };
    start();
    click(place("Glass.uMix"), MouseButton::left, .8);
    EXPECT_FALSE(memory_.animating());
    start();
    press(Key::right);
    EXPECT_FALSE(memory_.animating());
    start();
    click(place("Glass.uMix"), MouseButton::right);
    EXPECT_FALSE(memory_.animating());
    start();
    click(place("Glass.reset"));
    EXPECT_FALSE(memory_.animating());
}

TEST_F(Motion, WhatIsTakenBackEndsNoMotion) {
    add_slider("uMix", 0, .5, 2);
    memory_.clock.used = true;  // as it is once it moved
    const Rect bar = place("Glass.uMix");
    const auto press_at = [&](double part) {
        memory_.animated = {animated_from(controls_.items[0], 0, 4, 0)};
        frame({move(bar.x + bar.width * part, bar.y + bar.height / 2)});
        frame({button(true)});
        ASSERT_FALSE(memory_.animating());
    };
    press_at(.8);
    frame({button(false)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_EQ(value(), .5);
    EXPECT_TRUE(memory_.animating()) << "a double click types";
    press(Key::escape);
    EXPECT_TRUE(memory_.animating());
    frame({}, 1);
    press_at(.6);
    press(Key::escape);
    frame({button(false)});
    EXPECT_EQ(value(), .5);
    EXPECT_TRUE(memory_.animating()) << "Escape ends the drag";
}

TEST_F(Motion, TheControlsOfTimeStayWhereTheyAre) {
    add_slider("uMix", 0, .5, 2);
    EXPECT_FALSE(has("play"));
    facts_.timed = true;
    const Rect there = place("Glass.uMix");
    EXPECT_TRUE(has("play"));
    for (const bool animated : {true, false}) {
        facts_.animated = animated;
        memory_.clock.paused = false;
        EXPECT_EQ(place("Glass.uMix"), there) << "whether the values need time, or not";
        press(Key::space);
        EXPECT_TRUE(memory_.clock.paused);
    }
    facts_.timed = false;
    EXPECT_FALSE(has("play"));
    memory_.animated = {animated_from(controls_.items[0], 0, 4, 0)};
    EXPECT_TRUE(has("play"));
    memory_.animated.clear();
    EXPECT_EQ(place("Glass.uMix"), there) << "the mouse may have stopped it, which is over the slider then";
}

TEST_F(Motion, TheSpaceBarPausesAnAnimatedSlider) {
    add_slider("uMix", 0, .5, 2);
    memory_.animated = {animated_from(controls_.items[0], 0, 4, 0)};
    frame();
    press(Key::space);
    EXPECT_TRUE(memory_.clock.paused);
    press(Key::space);
    EXPECT_FALSE(memory_.clock.paused);
}

}  // namespace
}  // namespace snell::ui
