// The window as a user meets it: real events, real pixels.
#include <algorithm>
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

constexpr const char* scene = R"(##OpenGL GLIB
Perspective 50
LookAt 0 0 4  0 0 0  0 1 0
Background 0 0 0
Vertex paint.vert
Fragment paint.frag
Program Paint uRed <0. .2 1.> uUnused <0. 1. 2.>
QuadXY 0. 1.
)";

constexpr const char* vertex = "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";

// Green tells which text is shown; red is the slider.
std::string fragment(const std::string& green) {
    return "#version 330 compatibility\nuniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, " + green +
           ", .2, 1.); }\n";
}

int byte(double value) { return static_cast<int>(std::lround(255 * value)); }

class Window : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", scene);
        save("paint.vert", vertex);
        save("paint.frag", fragment(".4"));
    }

    double red() const { return state()["controls"]["Paint.uRed"][0]; }
    void expect_pixel(double r, double g) const {
        const Pixel pixel = scene_pixel(20, 20);
        EXPECT_NEAR(pixel.red, byte(r), 1);
        EXPECT_NEAR(pixel.green, byte(g), 1);
        EXPECT_NEAR(pixel.blue, byte(.2), 1);
    }
};

TEST_F(Window, ADraggedSliderChangesTheUniformAndThePicture) {
    open("scene.glib", {"--no-specialise"});  // where frames are slow, programs for values are compiled later
    EXPECT_EQ(red(), .2);
    expect_pixel(.2, .4);
    const json before = state();
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    EXPECT_NEAR(red(), .75, .02);
    expect_pixel(red(), .4);
    const json after = state();
    EXPECT_GT(after["frames"], before["frames"]);
    EXPECT_EQ(after["counters"]["programs_compiled"], before["counters"]["programs_compiled"])
        << "a slider compiles nothing";
    EXPECT_EQ(after["counters"]["bytes_uploaded"], before["counters"]["bytes_uploaded"])
        << "and uploads nothing but its uniform";
    click("Paint.uRed", .5, 3);
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] == .2; })) << "right click resets";
    settle();
    expect_pixel(.2, .4);
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(Window, AValueIsTypedAfterADoubleClick) {
    open("scene.glib");
    const auto [x, y] = on("Paint.uRed", .9);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1 sleep .6 click 1");
    settle();
    EXPECT_NEAR(red(), .9, .03) << "two clicks that are no double click leave the value there";
    user("click --repeat 2 --delay 60 1");
    settle();
    user("key ctrl+a type --delay 8 0.6");
    user("key Return");
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] == .6; }));
    settle();
    expect_pixel(.6, .4);
}

TEST_F(Window, AnIdleWindowDrawsNothing) {
    open("scene.glib");
    user("mousemove 200 200");
    EXPECT_TRUE(idle()) << "no frame, nothing presented";
    ASSERT_TRUE(alive());
    const json before = state();
    // A mouse that only passes over the panel draws the panel, not the scene.
    const auto [x, y] = on("Paint.uRed");
    user("mousemove " + std::to_string(x) + " " + std::to_string(y));
    EXPECT_TRUE(wait([&](const json& s) { return s["presents"] > before["presents"]; }));
    settle();
    EXPECT_EQ(state()["frames"], before["frames"]);
}

TEST_F(Window, ATooltipAppearsByItselfAndThenNothingIsDrawn) {
    open("scene.glib");
    const auto [x, y] = on("reload");
    user("mousemove " + std::to_string(x) + " " + std::to_string(y));
    settle();
    const json before = state();
    EXPECT_TRUE(wait([&](const json& s) { return s["presents"] > before["presents"]; }));
    EXPECT_TRUE(idle());
    EXPECT_EQ(state()["frames"], before["frames"]) << "the scene is not drawn again";
}

TEST_F(Window, ASavedShaderIsShownWithinHalfASecond) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .5));
    const double slid = red();
    for (bool in_place : {false, true}) {
        const json before = state();
        save("paint.frag", fragment(in_place ? ".8" : ".6"), in_place);
        EXPECT_TRUE(wait([&](const json& s) { return s["frames"] > before["frames"]; }, .5));
        settle();
        EXPECT_EQ(red(), slid) << "the slider keeps its value";
        expect_pixel(slid, in_place ? .8 : .6);
    }
}

TEST_F(Window, ASavedSceneKeepsSlidersAndFollowsTheText) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .5));
    const double slid = red();
    std::string text = scene;
    text.replace(text.find("QuadXY 0. 1."), 12, "QuadXY 0. .1");
    save("scene.glib", text);
    EXPECT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    settle();
    EXPECT_EQ(red(), slid);
    EXPECT_EQ(scene_pixel(100, 100), (Pixel{0, 0, 0}));
}

// A picture of one colour: 2 x 2 pixels, 24 bits.
std::string bitmap(unsigned char red, unsigned char green, unsigned char blue) {
    std::string file("BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\2\0\0\0\2\0\0\0\1\0\x18\0", 30);
    file.resize(54, '\0');
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column)
            for (unsigned char channel : {blue, green, red}) file += static_cast<char>(channel);
        file += std::string(2, '\0');
    }
    return file;
}

TEST_F(Window, IncludedScenesIncludedShadersAndImagesAreWatchedToo) {
    save("scene.glib",
         "Perspective 50\nLookAt 0 0 4 0 0 0 0 1 0\nTexture2D 6 wall.bmp\nVertex paint.vert\n"
         "Fragment paint.frag\nProgram Paint uWall 6\nInclude shape.glib\n");
    save("shape.glib", "QuadXY 0. 1.\n");
    save("tint.glsl", "float tint() { return .5; }\n");
    save("paint.frag",
         "#version 330 compatibility\n#include \"tint.glsl\"\nuniform sampler2D uWall;\n"
         "void main() { gl_FragColor = vec4(texture(uWall, vec2(.5)).rg, tint(), 1.); }\n");
    save("wall.bmp", bitmap(200, 100, 0));
    open("scene.glib");
    EXPECT_EQ(state()["errors"], 0);
    EXPECT_EQ(scene_pixel(20, 20), (Pixel{200, 100, 128}));
    const auto saved = [&](const std::string& name, const std::string& text) {
        const auto revision = state()["revision"];
        save(name, text);
        EXPECT_TRUE(wait([&](const json& s) { return s["revision"] > revision; })) << name;
        settle();
    };
    saved("wall.bmp", bitmap(50, 250, 0));
    EXPECT_EQ(scene_pixel(20, 20), (Pixel{50, 250, 128}));
    saved("tint.glsl", "float tint() { return 1.; }\n");
    EXPECT_EQ(scene_pixel(20, 20), (Pixel{50, 250, 255}));
    saved("shape.glib", "QuadXY 0. .02\n");
    EXPECT_NE(scene_pixel(20, 20), (Pixel{50, 250, 255}));
}

TEST_F(Window, ABrokenEditKeepsTheLastGoodPictureAndSaysWhatIsWrong) {
    open("scene.glib");
    const auto frames = state()["frames"];
    user("key ctrl+1");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"] == "snapshot 1 is in scene.snapshots.json"; }));
    save("paint.frag", fragment(".6 + nonsense"));
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] > 0; }));
    settle();
    const json broken = state();
    EXPECT_EQ(broken["notice"], "") << "that is no outcome of the edit";
    EXPECT_TRUE(broken["stale"]);
    EXPECT_TRUE(broken["widgets"].contains("problems.hide")) << "the messages lie over the picture";
    const std::string problems = broken["problems"];
    EXPECT_NE(problems.find("paint.frag:3:"), std::string::npos) << problems;
    EXPECT_NE(problems.find("nonsense"), std::string::npos) << problems;
    expect_pixel(.2, .4);
    // What is shown can still be worked with.
    drag(on("Paint.uRed", .2), on("Paint.uRed", .5));
    const double slid = red();
    expect_pixel(slid, .4);
    EXPECT_GT(state()["frames"], frames);

    save("scene.glib", "Sphere what\nSphare 1\n");  // the scene as well
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 3; }));
    settle();
    EXPECT_TRUE(state()["stale"]);
    expect_pixel(slid, .4);

    save("scene.glib", scene);
    save("paint.frag", fragment(".6"));
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }));
    settle();
    EXPECT_FALSE(state()["stale"]);
    EXPECT_FALSE(state()["widgets"].contains("problems.hide"));
    EXPECT_EQ(red(), slid);
    expect_pixel(slid, .6);
}

TEST_F(Window, AMissingFileIsFoundWhenItAppears) {
    std::filesystem::remove(file("paint.frag"));
    open("scene.glib");
    EXPECT_GT(state()["errors"], 0);
    save("paint.frag", fragment(".6"));
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }));
    settle();
    expect_pixel(.2, .6);
}

TEST_F(Window, DraggingInTheSceneTurnsItAndTheWheelScalesIt) {
    open("scene.glib");
    const auto paint = [](const Pixel& p) { return p.green > 50; };
    const std::array<double, 4> area = state()["scene"];
    const std::array<int, 2> middle{static_cast<int>(area[2] / 2), static_cast<int>(area[3] / 2)};
    // The quad reaches .27 of the shorter side from the middle.
    const double shorter = std::min(area[2], area[3]);
    const int inside = static_cast<int>(shorter * .22), outside = static_cast<int>(shorter * .32);
    ASSERT_TRUE(paint(scene_pixel(inside, 20)));
    ASSERT_FALSE(paint(scene_pixel(outside, 20)));

    drag(middle, {middle[0] + 150, middle[1]});
    EXPECT_NEAR(state()["view"]["rotate_y"].get<double>(), 75, 1);
    EXPECT_FALSE(paint(scene_pixel(inside, 20))) << "turned by 75 degrees the quad is narrow";
    EXPECT_TRUE(paint(scene_pixel(3, 20)));
    choose("view", "reset view");
    EXPECT_TRUE(paint(scene_pixel(inside, 20)));

    user("mousemove " + std::to_string(middle[0]) + " " + std::to_string(middle[1]) + " click --repeat 6 --delay 20 4");
    settle();
    EXPECT_NEAR(state()["view"]["scale"].get<double>(), std::pow(1.1, 6), 1e-9);
    EXPECT_TRUE(paint(scene_pixel(outside, 20))) << "larger";
    user("key r");
    settle();
    EXPECT_EQ(state()["view"]["scale"], 1);

    drag(middle, {middle[0] + outside, middle[1]}, 3);
    EXPECT_TRUE(paint(scene_pixel(outside, 20))) << "the quad follows a right drag";
    EXPECT_TRUE(paint(scene_pixel(static_cast<int>(outside + shorter * .15), 20)));
    EXPECT_FALSE(paint(scene_pixel(-10, 20)));
}

TEST_F(Window, TheAxesAreACheckBoxAndOnAtFirst) {
    std::string text = scene;
    save("scene.glib", text.replace(text.find("QuadXY 0. 1."), 12, "QuadXY 0. 1. 2 2"));  // not a flat picture
    open("scene.glib");
    EXPECT_TRUE(state()["view"]["axes"]);
    const auto count_gray = [&] {
        const Picture picture = look();
        const std::array<double, 4> area = state()["scene"];
        int count = 0;
        for (int py = 0; py < static_cast<int>(area[3]); ++py)
            for (int px = 0; px < static_cast<int>(area[2]); ++px) {
                const Pixel p = picture.at(px, py);
                count += p.red > 90 && p.green > 90 && p.blue > 90;
            }
        return count;
    };
    EXPECT_GT(count_gray(), 200);
    choose("view", "axes");
    ASSERT_TRUE(wait([](const json& s) { return s["view"]["axes"] == false; }));
    settle();
    EXPECT_EQ(count_gray(), 0);
}

TEST_F(Window, ASceneWithTimerGoesOnByItself) {
    save("paint.frag",
         "#version 330 compatibility\nuniform float Timer, uRed;\n"
         "void main() { gl_FragColor = vec4(uRed, .4, Timer, 1.); }\n");
    open("scene.glib");
    const json before = state();
    EXPECT_TRUE(wait([&](const json& s) { return s["frames"].get<int>() > before["frames"].get<int>() + 5; }));
    EXPECT_GT(state()["time"], before["time"]);
    // It stands while Accuracy is in sight.
    user("key a");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("accuracy.hold time"); }));
    settle();
    const double held = state()["time"];
    EXPECT_FALSE(wait([&](const json& s) { return s["time"] > held; }, .4));
    click("controls");
    EXPECT_TRUE(wait([&](const json& s) { return s["time"] > held; }));
}

TEST_F(Window, APictureFollowsTheWindowsSize) {
    open("scene.glib");
    user("search --sync --name snell windowsize 1000 500");
    ASSERT_TRUE(wait([](const json& s) { return s["size"] == json::array({1000, 500}); }));
    settle();
    const json now = state();
    EXPECT_LT(now["scene"][2], 1000);
    EXPECT_LT(now["scene"][3], 500);
    expect_pixel(.2, .4);
    EXPECT_EQ(now["gl_errors"], json::array());
}

TEST_F(Window, HHidesAllAndTheHintFadesUntilNothingIsDrawnAnyMore) {
    open("scene.glib");
    choose("view", "axes");
    ASSERT_EQ(state()["view"]["axes"], true);
    user("mousemove 300 300 key h");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("hint"); }));
    EXPECT_EQ(state()["scene"], json::array({0, 0, 800, 600}));
    ASSERT_TRUE(wait([](const json& s) { return !s["widgets"].contains("hint"); }));
    EXPECT_TRUE(idle()) << "no frame, nothing presented";
    const Picture bare = look();
    EXPECT_EQ(bare.at(795, 300), (Pixel{0, 0, 0})) << "where the panel was";
    EXPECT_EQ(bare.at(400, 598), (Pixel{0, 0, 0})) << "and the line below";
    user("key h");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("reload"); }));
    EXPECT_TRUE(state()["view"]["axes"]) << "hidden with the rest, they are back";
}

TEST_F(Window, F11FillsTheScreenAndGivesTheWindowItsPlaceBack) {
    open("scene.glib");
    user("mousemove 100 100 key F11");
    ASSERT_TRUE(wait([](const json& s) { return s["size"] == json::array({1024, 768}); }));
    settle();
    expect_pixel(.2, .4);
    user("key F11");
    ASSERT_TRUE(wait([](const json& s) { return s["size"] == json::array({800, 600}); }));
    user("key F11");
    ASSERT_TRUE(wait([](const json& s) { return s["size"] == json::array({1024, 768}); }));
    // Escape ends what is above the picture first.
    user("key F1");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("close keys"); }));
    user("key Escape");
    ASSERT_TRUE(wait([](const json& s) { return !s["widgets"].contains("close keys"); }));
    EXPECT_EQ(state()["size"], json::array({1024, 768}));
    user("key Escape");
    ASSERT_TRUE(wait([](const json& s) { return s["size"] == json::array({800, 600}); }));
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(Window, MessagesNameFilesFromTheScenesFolderAndPrintThemWhole) {
    save("paint.frag", fragment("nonsense"));
    open("scene.glib");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("problem.0.place"); }));
    settle();
    const std::array<double, 4> place = state()["widgets"]["problem.0.place"];
    EXPECT_LT(place[2], 20 * 9) << "no more than paint.frag:3:45";
    EXPECT_NE(std::string(state()["problems"]).find(file("paint.frag") + ":3:"), std::string::npos);
    EXPECT_NE(bytes("out/errors").find(file("paint.frag") + ":3:"), std::string::npos);
}

TEST_F(Window, WhatTheLintsFindIsCountedBelowThePictureAndListedOnRequest) {
    save("scene.glib", std::string(scene).replace(14, 0, "Ladder WAY plain <power>\n"));
    // llvmpipe's own warning about the loop is there before the picture, and is not told twice.
    save("paint.vert",
         "#version 330 compatibility\nvoid main() {\n    float x = 0.;\n"
         "    for (int i = 0; i < 70000; ++i) x += gl_Vertex.x;\n    gl_Position = ftransform() + x * 1e-20;\n}\n");
    save("paint.frag", fragment("\n#if WAY == 1\n    pow(uRed - .5, 2.)\n#else\n    .4\n#endif\n"));
    const auto told = [](const json& s, const std::string& code) {
        const std::string text = s["problems"];
        int count = 0;
        for (std::size_t at = text.find(code); at != text.npos; at = text.find(code, at + 1)) ++count;
        return count;
    };
    const auto powers = [&](int count) {
        return wait(
            [&](const json& s) { return told(s, "[pow-of-negative]") == count && s["widgets"].contains("problems"); });
    };
    open("scene.glib");
    ASSERT_TRUE(powers(1)) << state()["problems"];
    EXPECT_EQ(told(state(), "[many-rounds]"), 1) << state()["problems"];
    EXPECT_EQ(state()["errors"], 0);
    EXPECT_FALSE(state()["widgets"].contains("problems.panel")) << "nothing lies over the picture";
    click("problems");
    EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("problems.panel"); }));
    keep("lints");
    click("problems.hide");
    for (const auto& [rung, count] : {std::pair("WAY.plain", 0), std::pair("WAY.power", 1)}) {
        click("WAY");
        click(rung);
        EXPECT_TRUE(powers(count)) << rung << state()["problems"];
        EXPECT_EQ(told(state(), "[many-rounds]"), 1) << state()["problems"];
    }
    save("paint.vert", vertex);
    save("paint.frag", fragment(".4"));
    EXPECT_TRUE(wait([&](const json& s) { return told(s, "[many-rounds]") == 0; }));
    EXPECT_TRUE(idle());
    EXPECT_EQ(told(state(), "[pow-of-negative]"), 0) << state()["problems"];
}

TEST_F(Window, WhatCanNotBeOpenedHasAnExitStatus) {
    EXPECT_EQ(run({file("none.glib")}, display_), 1);
    EXPECT_FALSE(std::filesystem::exists(file("none.glib")));
    EXPECT_NE(shell("DISPLAY=" + display_ + " snell none.glib 2>reason"), 0);
    EXPECT_NE(bytes("reason").find("cannot read 'none.glib': No such file or directory"), std::string::npos)
        << bytes("reason");
    EXPECT_EQ(run({file("scene.glib")}, ""), 3) << "no display";
    EXPECT_EQ(run({file("scene.glib"), "--size", "big"}, display_), 2);
    EXPECT_EQ(run({file("scene.glib"), "--exit-after", ".5"}, display_), 0);
}

}  // namespace
}  // namespace snell::test
