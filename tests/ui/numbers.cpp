// Numbers as they are shown, rounded, and typed.
#include "src/plan/values/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/plan/view.h"

namespace snell::ui {
namespace {

TEST(UiNumbers, WhatIsShownReadsBackCloseEnoughToSeeAStep) {
    for (const auto& [min, max] :
         {std::pair(0., 1.), {.1, 5.}, {0., 1e-5}, {0., 1e-9}, {-1e5, 1e5}, {0., 1e30}, {0., 0.}})
        for (double at : {0., .137, .5, 1.}) {
            const double value = min + at * (max - min);
            EXPECT_NEAR(std::stod(shown(value, min, max, false)), value, (max - min) * 1e-3 + 1e-30);
        }
    EXPECT_EQ(shown(1.1, .1, 5, false), "1.1000");
    EXPECT_EQ(shown(8, 1, 32, true), "8");
    EXPECT_EQ(shown(1e-5, 0, 1, false), "1e-05");
    EXPECT_EQ(shown(-.000123, -1, 1, false), "-0.000123");
    EXPECT_EQ(shown(.0002, 0, 1, false), "0.0002") << "as long as its neighbours of a drag";
    EXPECT_EQ(shown(.12345678, 0, 1, false), "0.1235");
}

TEST(UiNumbers, NothingIsMinusZero) {
    for (const auto& [min, max] : {std::pair(-1., 1.), {-1e-12, 1e-12}, {-1e9, 1e9}, {0., 0.}})
        EXPECT_EQ(shown(-0., min, max, false), shown(0., min, max, false));
    EXPECT_FALSE(std::signbit(tidy(-1e-20, -1, 1, false)));
    EXPECT_EQ(shown(-0., -1, 1, true), "0");
    EXPECT_EQ(exact(-0.), "0");
    for (const char* text : {"-0", "0*-1"}) {
        ASSERT_TRUE(typed(text, ValueType::float_)) << text;
        EXPECT_FALSE(std::signbit(*typed(text, ValueType::float_))) << text;
    }
}

TEST(UiNumbers, TypedNumbersAreFiniteFloats) {
    EXPECT_EQ(typed(" +1.5 ", ValueType::float_), 1.5);
    EXPECT_EQ(typed(".5", ValueType::float_), .5);
    EXPECT_EQ(typed("5.", ValueType::float_), 5.);
    EXPECT_EQ(typed("1e-3", ValueType::float_), 1e-3);
    EXPECT_EQ(typed("3.", ValueType::int_), 3.);
    for (const ValueType type : {ValueType::int_, ValueType::uint_})
        for (const char* text : {"2.6", "7,2", "7/2"}) EXPECT_EQ(typed(text, type), std::nullopt) << text;
    for (const char* text : {"", "+", "nan", "inf", "1e39", "0x10", "1 2", "+-1", "1e400"})
        EXPECT_EQ(typed(text, ValueType::float_), std::nullopt) << text;
    EXPECT_EQ(typed("3e9", ValueType::int_), std::nullopt);
    EXPECT_EQ(typed("3e9", ValueType::uint_), 3e9);
    EXPECT_EQ(typed("-5", ValueType::uint_), std::nullopt);
    EXPECT_EQ(typed("1e300", ValueType::double_), 1e300);
    EXPECT_EQ(typed("1e300", ValueType::float_), std::nullopt);
}

TEST(ColorDigits, GiveTheSameByteAndNoMoreDigitsThanNeeded) {
    for (int byte = 0; byte <= 255; ++byte) {
        const double value = tidy_color(byte / 255.);
        EXPECT_EQ(std::lround(value * 255), byte);
        EXPECT_LE(exact(value).size(), 5u) << exact(value);
    }
    EXPECT_EQ(tidy_color(209 / 255.), .82);
    EXPECT_EQ(tidy_color(1.), 1);
    EXPECT_EQ(tidy_color(2.34567), 2.346);
}

TEST(DraggedNumbers, AreRoundedToAHundredthOfAStep) {
    EXPECT_EQ(tidy_step(1.23456789, .01), 1.2346);
    EXPECT_EQ(tidy_step(-1.23456789, 1), -1.23);
    EXPECT_EQ(tidy_step(3e-6, .01), 0) << "0 is reached";
    EXPECT_EQ(tidy_step(1e308, 1e-3), 1e308);
}

TEST(Arithmetic, IsThatOfDoubles) {
    for (const auto& [text, value] : {std::pair("1/3", 1. / 3),
                                      {"2*pi", 2 * M_PI},
                                      {"1e3-5", 995.},
                                      {"2+3*4", 14.},
                                      {"(2+3)*4", 20.},
                                      {"-2", -2.},
                                      {"2--3", 5.},
                                      {"2*-3", -6.},
                                      {"8/4/2", 1.},
                                      {" ( 1,5 + .5 ) ", 2.},
                                      {"-(1-3)", 2.},
                                      {"1e-3", 1e-3},
                                      {"+1.5", 1.5},
                                      {"5.", 5.},
                                      {"1-2-3", -4.}}) {
        ASSERT_TRUE(evaluated(text)) << text;
        EXPECT_EQ(*evaluated(text), value) << text;
    }
    for (const char* text : {"",   " ",  "1/0", "0/0", "nan",   "inf",  "1 2", "1,2,3",       "(1", "1)",
                             "2*", "*2", "pi2", "--1", "1e400", "0x10", "abc", "1e309-1e309", "()", "2(3)"})
        EXPECT_EQ(evaluated(text), std::nullopt) << text;
    EXPECT_EQ(evaluated(std::string(100, '(') + "1"), std::nullopt);
    EXPECT_EQ(evaluated(std::string(100, '(') + "1" + std::string(100, ')')), 1.);
}

}  // namespace
}  // namespace snell::ui
