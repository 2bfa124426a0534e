// Pixels as numbers in a real window: I held, N pressed, and what frames cost.
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

class Pixels : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("plain.vert",
             "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
             "gl_Position = ftransform(); }\n");
        // The left half is NaN, the right one above 1 but for a slider.
        save("odd.frag",
             "#version 330 compatibility\nuniform float uZero, uMost;\nin vec2 vST;\nvoid main() {\n"
             "    gl_FragColor = vST.s < .5 ? vec4(uZero / uZero, .2, .3, 1.) : vec4(.25, uMost, .75, 1.);\n}\n");
        save("scene.glib",
             "##OpenGL GLIB\nPerspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex plain.vert\n"
             "Fragment odd.frag\nProgram Odd uZero <0. 0. 1.> uMost <0. 2.5 5.>\nQuadXY 0. 1.\n");
    }
    void press(const char* key) {
        user(std::string("key ") + key);
        settle();
    }
    std::array<int, 2> middle(int right = 0) const {
        const json scene = state()["scene"];
        return {static_cast<int>(scene[0].get<double>() + scene[2].get<double>() / 2) + right,
                static_cast<int>(scene[1].get<double>() + scene[3].get<double>() / 2) + 20};
    }
};

TEST_F(Pixels, HoldingITellsWhatThePixelIs) {
    open("scene.glib");
    press("r");
    EXPECT_FALSE(state().contains("pixels"));
    const auto [x, y] = middle(60);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " keydown i");
    ASSERT_TRUE(wait([](const json& s) { return s.contains("pixels") && s["widgets"].contains("inspector"); }));
    settle();
    json pixels = state()["pixels"];
    EXPECT_EQ(pixels["rgba"], (json{"0.25", "2.5", "0.75", "1"}));
    EXPECT_EQ(pixels["at"], (json{x, y}));
    EXPECT_NEAR(pixels["distance"].get<double>(), 4, 1e-3) << "of the eye from the wall";
    EXPECT_EQ(pixels["statement"], "QuadXY 0. 1.");
    EXPECT_EQ(pixels["place"], "scene.glib:8");
    const auto [edge, row] = middle(1);
    user("mousemove " + std::to_string(edge) + " " + std::to_string(row));
    settle();
    keep("guide-pixels");
    EXPECT_NEAR(state()["pixels"]["distance"].get<double>(), 4, 1e-3) << "of the wall, not of the axis before it";
    const auto [left, same] = middle(-60);
    user("mousemove " + std::to_string(left) + " " + std::to_string(same));
    ASSERT_TRUE(wait([](const json& s) { return s["pixels"]["rgba"][0] == "NaN"; }));
    user("mousemove 4 4");
    ASSERT_TRUE(wait([](const json& s) { return s["pixels"].contains("place") && s["pixels"]["place"] == ""; }));
    EXPECT_EQ(state()["pixels"]["rgba"], (json{"0", "0", "0", "1"})) << "the background";
    user("keyup i");
    ASSERT_TRUE(wait([](const json& s) { return !s.contains("pixels"); }));
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

TEST_F(Pixels, NPaintsWhatIsNoColor) {
    open("scene.glib");
    settle();
    const json before = state();
    EXPECT_EQ(before["counters"]["frames"], before["frames"]) << "off, nothing is drawn for it";
    press("n");
    const json flags = state()["pixels"]["flags"];
    const Pixel nan = scene_pixel(-60, 20), above = scene_pixel(60, 20), none = scene_pixel(-60, -380);
    EXPECT_EQ(nan, (Pixel{255, 0, 220}));
    EXPECT_EQ(above, (Pixel{255, 106, 0}));
    EXPECT_EQ(none.red, none.green);
    EXPECT_EQ(flags["NaN"].get<int>() > 5000, true) << flags;
    EXPECT_NEAR(flags["NaN"].get<double>(), flags["above 1"].get<double>(), 1200) << "halves of a wall";
    EXPECT_EQ(flags["infinite"], 0);
    EXPECT_EQ(flags["negative"], 0);
    // A drag of a slider paints anew.
    drag(on("Odd.uMost", .5), on("Odd.uMost", .1));
    settle();
    EXPECT_EQ(state()["pixels"]["flags"]["above 1"], 0);
    press("n");
    EXPECT_FALSE(state().contains("pixels"));
    EXPECT_NE(scene_pixel(-60, 20), nan);
    const json off = state();
    drag(on("Odd.uMost", .1), on("Odd.uMost", .3));
    settle();
    const json after = state();
    EXPECT_EQ(after["counters"]["frames"].get<int>() - off["counters"]["frames"].get<int>(),
              after["frames"].get<int>() - off["frames"].get<int>())
        << "off again, it costs nothing";
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

TEST_F(Pixels, FramesHaveTheirCost) {
    open("scene.glib");
    EXPECT_FALSE(state().contains("frame_cost"));
    click("tools");
    click("frame cost");
    click("controls");
    drag(on("Odd.uMost", .3), on("Odd.uMost", .9));
    settle();
    click("tools");
    json cost = state()["frame_cost"];
    EXPECT_GE(cost["pictures"].get<int>(), 2);
    EXPECT_GT(cost["median"].get<double>(), 0);
    EXPECT_GE(cost["high"].get<double>(), cost["median"].get<double>());
    click("frame cost.measure");
    ASSERT_TRUE(wait([](const json& s) { return s["frame_cost"]["apart"].size() >= 2; }));
    settle();
    cost = state()["frame_cost"];
    EXPECT_EQ(cost["apart"][0]["name"], "window");
    EXPECT_EQ(cost["apart"][1]["name"], "QuadXY 0. 1.");
    EXPECT_TRUE(cost["apart"][1]["draw"].get<bool>());
    EXPECT_LE(cost["apart"][1]["milliseconds"].get<double>(), cost["apart"][0]["milliseconds"].get<double>());
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

}  // namespace
}  // namespace snell::test
