// The pixel inspector, the view of pixels that are no colours, and the frame's cost: in memory.
#include <algorithm>
#include <cmath>
#include <limits>

#include "src/runtime/inspect.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class UiPixels : public UiTest {
protected:
    UiPixels() {
        found_.x = 12;
        found_.y = 34;
        found_.radius = 4;
        found_.rgba.assign(4 * 81, .5F);
        found_.inside.assign(81, 1);
        found_.rgba[4 * 40] = std::numeric_limits<float>::quiet_NaN();
        found_.depth = .98765;
        found_.distance = 3.25;
        pixels_.inspection = &found_;
        pixels_.at = "pixel 12, 34";
        pixels_.statement = "Sphere 1. 50 50";
        pixels_.place = "scene.glib:12";
    }
    bool inside(const Rect& a, const Rect& b) const {
        return a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;
    }

    Inspection found_;
    PixelFacts pixels_;
};

TEST_F(UiPixels, IIsHeldOverThePicture) {
    add_slider("uEta", 0, 0, 1);
    frame({move(300, 200), key(Key::i, true)});
    frame({});
    EXPECT_TRUE(memory_.pixels.inspecting);
    EXPECT_EQ(memory_.pixels.x, 300);
    EXPECT_EQ(memory_.pixels.y, 200);
    frame({move(1200, 200)});
    EXPECT_FALSE(memory_.pixels.inspecting) << "over the panel";
    frame({move(300, 200)});
    EXPECT_TRUE(memory_.pixels.inspecting);
    frame({key(Key::i, false)});
    EXPECT_FALSE(memory_.pixels.inspecting);
}

TEST_F(UiPixels, TheInspectorIsSeenWholeAndLeavesThePointerFree) {
    facts_.pixels = &pixels_;
    frame({key(Key::i, true)});
    for (const auto& [x, y] : {std::pair{300., 200.}, {5., 5.}, {900., 760.}, {5., 770.}, {900., 5.}, {500., 400.}}) {
        frame({move(x, y)});
        const Rect box = place("inspector");
        EXPECT_TRUE(inside(box, memory_.scene)) << x << ", " << y;
        EXPECT_FALSE(box.contains(x, y));
    }
    EXPECT_TRUE(has("inspector.depth.depth 0.98765 (0 near, 1 far)"));
    EXPECT_TRUE(has("inspector.distance.along the view axis: 3.25")) << "a pixel at the side is farther from the eye";
    const Rect whole = place("inspector"), last = place("inspector.place");
    EXPECT_LT(last.y + last.height, whole.y + whole.height) << "its last line is not cut";
    // Where neither side has room, it is above or below.
    screen_.width = 800;
    screen_.height = 600;
    for (const double y : {5., 200., 300., 400., 570.}) {
        frame({move(224, y)});
        const Rect box = place("inspector");
        EXPECT_TRUE(inside(box, memory_.scene)) << y;
        EXPECT_FALSE(box.contains(224, y));
    }
    frame({key(Key::i, false)});
    EXPECT_FALSE(has("inspector"));
}

TEST_F(UiPixels, NShowsWhatIsNoColorAndHowMuchOfIt) {
    EXPECT_FALSE(has("flag counts"));
    frame({key(Key::n, true)});
    frame({key(Key::n, false)});
    EXPECT_TRUE(memory_.pixels.flags);
    facts_.pixels = &pixels_;
    EXPECT_GT(place("flag counts").width, ImGui::CalcTextSize("looking\u2026").x) << "no empty box before them";
    pixels_.flags = {{"", FlagCounts{{100, 2, 30, 4, 5}}}};
    EXPECT_TRUE(inside(place("flag counts"), memory_.scene));
    memory_.tab = Tab::tools;
    click(place("pixels"));
    click(place("flags"));
    EXPECT_FALSE(memory_.pixels.flags);
    EXPECT_FALSE(has("flag counts"));
}

TEST_F(UiPixels, WhatIsTypedIntoAFieldIsNoKey) {
    add_slider("uEta", 0, 0, 1);
    click(place("Glass.uEta"), MouseButton::left, .5, {.ctrl = true});
    frame({key(Key::n, true)});
    frame({key(Key::n, false)});
    EXPECT_FALSE(memory_.pixels.flags);
}

// Four flags differ from each other and from greys, in light and hue.
TEST(Flags, ColorsAreToldApart) {
    for (std::size_t a = 1; a < flag_count; ++a) {
        const auto one = color_of(static_cast<Flag>(a));
        EXPECT_GT(*std::ranges::max_element(one) - *std::ranges::min_element(one), 150);
        for (std::size_t b = a + 1; b < flag_count; ++b) {
            const auto other = color_of(static_cast<Flag>(b));
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(one[c] - other[c]));
            EXPECT_GE(most, 100);
        }
    }
}

TEST(Flags, TheWorstOfAPixelCounts) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    const auto flag = [](std::array<float, 4> rgba) { return flag_of(rgba); };
    EXPECT_EQ(flag({0, .5F, 1, 1}), Flag::none);
    EXPECT_EQ(flag({-0.F, 0, 0, 0}), Flag::none);
    EXPECT_EQ(flag({2, -1, 0, 1}), Flag::negative);
    EXPECT_EQ(flag({2, -1, -infinite, 1}), Flag::infinite);
    EXPECT_EQ(flag({2, -1, infinite, nan}), Flag::nan);
    EXPECT_EQ(flag({1, 1, 1, 3}), Flag::none);
    EXPECT_EQ(flag({1, 1, 1, infinite}), Flag::infinite);
    EXPECT_EQ(flag({std::nextafter(1.F, 2.F), 0, 0, 1}), Flag::above_one);
    EXPECT_EQ(flag({-std::numeric_limits<float>::denorm_min(), 0, 0, 1}), Flag::negative);
}

TEST_F(UiPixels, TheFrameCostShowsItsRowsAndAsksForMore) {
    std::vector<float> frames;
    for (int i = 0; i < 200; ++i) frames.push_back(4 + i % 7 * .1F);
    const std::vector<CostRow> rows{
        {"window", "", 4, false},
        {"Sphere 1. 50 50", "scene.glib:3", 3, true},
        {"VertexList with a name that is longer than the whole panel is wide", "s.glib:9", 1, true}};
    FrameCostFacts cost;
    cost.frames = frames;
    cost.median = 4.3F;
    cost.high = 4.6F;
    cost.apart = rows;
    cost.apart_clock = "apart";
    facts_.frame_cost = &cost;
    EXPECT_FALSE(memory_.frame_cost);
    memory_.tab = Tab::tools;
    click(place("frame cost"));
    EXPECT_TRUE(memory_.frame_cost);
    const Rect plot = place("frame cost.plot");
    EXPECT_GT(plot.width, 200);
    EXPECT_LE(place("frame cost.Sphere 1. 50 50").x + 10, screen_.width);
    EXPECT_EQ(place("frame cost.time.window").width, ImGui::CalcTextSize("4.000 ms").x) << "with its unit";
    // One picture, which takes a second to compile, makes no plot with a line at 1000 ms.
    const auto plotted = [&](std::vector<float> times) {
        cost.frames = times;
        cost.median = cost.high = times.empty() ? 0 : times[0];
        frame({move(5, 5)});
        frame();
        return picture_;
    };
    EXPECT_EQ(plotted({1000}), plotted({}));
    EXPECT_EQ(plotted({1000, 17}), plotted({})) << "nor do two";
    EXPECT_NE(plotted({1000}), plotted({16, 17, 18}));
    const auto said = [&](bool moves) {
        facts_.animated = moves;
        return place("frame cost.not plotted").width;
    };
    cost.frames = std::span(frames).first(1);
    EXPECT_EQ(said(false), ImGui::CalcTextSize("The next pictures are plotted here.").x);
    EXPECT_EQ(said(true), ImGui::CalcTextSize("Measuring: 1 of 3 pictures").x) << "they come by themselves";
    facts_.animated = false;
    cost.frames = frames;
    const Rect button_ = place("frame cost.measure");
    frame({move(button_.x + 5, button_.y + 5)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_TRUE(requests_.measure_frame);
    frame({});
    EXPECT_FALSE(requests_.measure_frame);
}

}  // namespace
}  // namespace snell::ui
