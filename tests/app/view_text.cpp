// The view as an option of the command line: what is written reads back to the same bits. What is said of two states.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "src/app/open/states.h"
#include "src/plan/setup.h"

namespace snell {
namespace {

View view_of(const std::string& text) {
    View view;
    EXPECT_EQ(parse_view(text, view), "") << text;
    return view;
}

TEST(ViewText, AViewAsItWasAtFirstIsNoText) {
    EXPECT_EQ(view_text({}), "");
    EXPECT_EQ(view_of(""), View{});
    View view;
    view.axes = true;
    view.mouse_x = 3;
    EXPECT_EQ(view_text(view), "") << "axes and mouse are not in it";
}

TEST(ViewText, AnyViewReadsBackToTheSameBits) {
    std::mt19937_64 random(7);
    const auto any = [&random] {
        double value = 0;
        do {
            const std::uint64_t bits = random();
            std::memcpy(&value, &bits, sizeof value);
        } while (!std::isfinite(value));
        return value;
    };
    for (int i = 0; i < 200; ++i) {
        View view;
        for (Transformation* t : {&view.scene, &view.eye, &view.texture, &view.objects[0], &view.objects[4000000000U]})
            *t = {any(), any(), any(), any(), any(), any(), any()};
        if (i % 2 == 0) view.projection = i % 4 == 0 ? Projection::ortho : Projection::perspective;
        if (i % 3 == 0) view.background = std::abs(std::remainder(any(), 1.));
        EXPECT_EQ(view_of(view_text(view)), view) << view_text(view);
    }
    View tiny;
    tiny.scene.x = std::numeric_limits<double>::denorm_min();
    tiny.scene.y = -1. / 3;
    EXPECT_EQ(view_of(view_text(tiny)), tiny);
}

TEST(ViewText, PartsAreNamedOnceEach) {
    View view;
    view.scene.rotate_x = 30;
    view.eye.z = -2;
    view.objects[3].scale = .5;
    EXPECT_EQ(view_text(view), "rotate_x=30,eye.z=-2,object3.scale=0.5");
}

TEST(ViewText, WhatIsWrongIsSaid) {
    for (const char* text : {"rotate_x",
                             "rotate_x=",
                             "rotate_x=abc",
                             "rotate_x=1x",
                             "rotate_x=nan",
                             "rotate_x=inf",
                             "rotate_x=1e999",
                             "rotat_x=1",
                             "eye.=1",
                             ".x=1",
                             "lens.x=1",
                             "object.x=1",
                             "object-1.x=1",
                             "objectx.x=1",
                             "object99999999999.x=1",
                             "x=1,,y=2",
                             "x=1,y",
                             "=1",
                             "scale=0",
                             "eye.scale=-0",
                             "object0.scale=0",
                             "projection=fisheye",
                             "background=2",
                             "background=-1",
                             "x=1;y=2",
                             "x = 1"}) {
        View view;
        EXPECT_NE(parse_view(text, view), "") << text;
    }
}

TEST(StateDifference, NamesEachValueWhereThereAreSome) {
    const auto told = [](const snell::Setup& left, const snell::Setup& right) {
        const auto [a, b] = difference(left, right);
        return a + " | " + b;
    };
    EXPECT_EQ(told({{"--set March.uSteps", "40000"}}, {{"--set March.uSteps", "5000"}}), "uSteps 40000 | 5000");
    EXPECT_EQ(told({{"--set M.uA", "4.53512"}, {"--set M.uSteps", "1234567"}, {"--set M.uB", "1"}},
                   {{"--set M.uA", "1"}, {"--set M.uSteps", "5e9"}, {"--set M.uB", "1"}}),
              "uA 4.535, uSteps 1234567 | uA 1, uSteps 5e+09");
    EXPECT_EQ(told({{"--set M.uA", "1.0001"}}, {{"--set M.uA", "1"}}), "uA 1.0001 | 1") << "as many digits as it takes";
    EXPECT_EQ(told({{"--set M.uA", "1"}}, {{"--set M.uA", "1"}}), " | ");
    EXPECT_EQ(told({{"--set Ball.uIndex", "1.33"}, {"--set Glass.uIndex", "1.5"}},
                   {{"--set Ball.uIndex", "2.4"}, {"--set Glass.uIndex", "1.5"}}),
              "Ball.uIndex 1.33 | 2.4")
        << "the program, where two have a uniform of that name";
    EXPECT_EQ(told({{"--ladder Ball.uIndex", "a"}, {"--set Glass.uIndex", "1"}, {"--set Glass.uMyuIndex", "1"}},
                   {{"--ladder Ball.uIndex", "a"}, {"--set Glass.uIndex", "2"}, {"--set Glass.uMyuIndex", "1"}}),
              "uIndex 1 | 2");
}

}  // namespace
}  // namespace snell
