// Found rungs in a real window: they are sought while nothing moves, and shown in place of the scene.
#include <algorithm>
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

// The loop makes red; the second quad lies behind the first, so that it may be left out.
constexpr const char* loop_scene = R"(##OpenGL GLIB
Perspective 50
LookAt 0 0 4  0 0 0  0 1 0
Background 0 0 0
Vertex paint.vert
Fragment paint.frag
Program Paint uGreen <0. .4 1.>
QuadXY 0. 1.
)";
constexpr const char* loop_vertex =
    "#version 330 compatibility\nout vec2 vAt;\n"
    "void main() { vAt = gl_Vertex.xy; gl_Position = ftransform(); }\n";
constexpr const char* loop_fragment = R"(#version 330 compatibility
uniform float uGreen;
in vec2 vAt;
void main() {
    float red = 0.;
    for (int i = 0; i < 16; ++i)
        red += .05 * (1. + sin(float(i) + 3. * vAt.x)) * .5;
    gl_FragColor = vec4(red, uGreen, .2, 1.);
}
)";

class FoundWindow : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", loop_scene);
        save("paint.vert", loop_vertex);
        save("paint.frag", loop_fragment);
        open("scene.glib", {"--size", "640x740"});
        user("key a");
        settle();
    }

    void seek() {
        click("found.find");
        ASSERT_TRUE(wait([](const json& s) { return s.contains("found"); }));
    }
    json found() {
        EXPECT_TRUE(wait([](const json& s) { return s.contains("found") && !s["found"]["searching"]; }, 60));
        away();
        return state()["found"];
    }
    // The name of the rung with fewer rounds, as soon as it was tried; the search is stopped then.
    std::string fewer_rounds() {
        seek();
        const auto tried = [](const json& s) { return !first_of(s["found"]["rows"], "fewer-rounds").empty(); };
        EXPECT_TRUE(wait(tried, 30));
        if (state()["found"]["searching"]) click("found.find");
        return first_of(found()["rows"], "fewer-rounds");
    }
    // No tooltip lies over anything.
    void away() {
        user("mousemove 5 5");
        settle();
    }
    static std::string first_of(const json& rows, const std::string& kind) {
        for (const json& row : rows)
            if (row["kind"] == kind) return row["name"];
        return {};
    }
    bool wait_shown(const std::string& name) {
        const bool shown = wait([&](const json& s) { return s["found"]["shown"] == name; });
        away();
        return shown;
    }
    // The pixels of the scene's area.
    std::vector<Pixel> scene_now() {
        const Picture all = look();
        const std::array<int, 4> area = state()["scene"];
        std::vector<Pixel> pixels;
        for (int y = 0; y < area[3]; ++y)
            for (int x = 0; x < area[2]; ++x) pixels.push_back(all.at(area[0] + x, area[1] + y));
        return pixels;
    }
    // What `snell render` draws of a scene in the size of the scene's area.
    std::vector<Pixel> rendered(const std::string& name) {
        const std::array<int, 4> area = state()["scene"];
        const std::string size = std::to_string(area[2]) + "x" + std::to_string(area[3]);
        EXPECT_EQ(run({"render", file(name), "-o", file("out/picture.png"), "--size", size, "--samples", "4"}, ""), 0);
        const Picture picture = read_picture("out/picture.png");
        std::vector<Pixel> pixels;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) pixels.push_back(picture.at(x, y));
        return pixels;
    }
};

TEST_F(FoundWindow, ARungIsShownAsItWouldBeWrittenAndTheSceneComesBack) {
    away();
    EXPECT_FALSE(state().contains("found")) << "nobody asked";
    EXPECT_TRUE(state()["widgets"].contains("found.find"));
    EXPECT_TRUE(idle()) << "and it costs nothing";
    const std::vector<Pixel> before = scene_now();
    EXPECT_EQ(before, rendered("scene.glib"));
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    EXPECT_EQ(state()["found"]["remark"], "The search was stopped.");
    EXPECT_EQ(scene_now(), before) << "the search shows nothing";

    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name)) << state();
    const std::vector<Pixel> shown = scene_now();
    ASSERT_EQ(run({"accuracy", file("scene.glib"), "--apply", name, "-o", file("applied")}, ""), 0);
    EXPECT_EQ(shown, rendered("applied/scene.glib"));
    EXPECT_NE(shown, before);

    user("key Escape");
    ASSERT_TRUE(wait_shown(""));
    EXPECT_EQ(scene_now(), before);
    EXPECT_EQ(bytes("paint.frag"), loop_fragment);
    EXPECT_EQ(bytes("scene.glib"), loop_scene);
    EXPECT_EQ(state()["gl_errors"], json::array());
}

// Two states that were compared before do not come back with it.
TEST_F(FoundWindow, WhateverEndsARungShowsTheSceneAgain) {
    const std::vector<Pixel> before = scene_now();
    user("key s");
    settle();
    click("accuracy.right");
    click("right.settings");
    user("type --delay 8 uGreen=0.9");
    user("key Return");
    settle();
    user("key s");
    settle();
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    const auto split = [&] {
        click("found.row." + name, .9);
        ASSERT_TRUE(wait_shown(name));
        click("accuracy.Split", .2);
        away();
        EXPECT_TRUE(state().contains("states"));
    };
    const auto expect_scene = [&](const char* what) {
        EXPECT_FALSE(state().contains("states")) << what;
        EXPECT_EQ(scene_now(), before) << what;
    };
    split();
    user("key Escape");
    ASSERT_TRUE(wait_shown(""));
    expect_scene("Esc");
    split();
    click("accuracy");
    away();
    expect_scene("the panel was closed");
    click("accuracy");
    settle();
    // A comparison that was there before the rung is there after it.
    user("key s");
    settle();
    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name));
    user("key Escape");
    ASSERT_TRUE(wait_shown(""));
    ASSERT_TRUE(state().contains("states"));
    EXPECT_EQ(state()["states"][1], "uGreen 0.9");
    user("key s");
    settle();
    split();
    save("paint.frag", std::string(loop_fragment) + "\n");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    away();
    expect_scene("a file was saved");
}

TEST_F(FoundWindow, RungsHaveErrorsAndCosts) {
    save("paint.vert",
         "#version 330 compatibility\nvoid main() { gl_Position = gl_ModelViewProjectionMatrix * "
         "(gl_Vertex + vec4(0., gl_Vertex.x * gl_Vertex.x, 0., 0.)); }\n");
    save("paint.frag", "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(1.); }\n");
    save("scene.glib",
         "LookAt 0 0 4  0 0 0  0 1 0\nVertex paint.vert\nFragment paint.frag\nProgram Paint\nQuadXY 0. 1. 2 2\n");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].empty(); }));
    settle();
    const auto fewer_cells = [](const json& s) {
        const json& rows = s["found"]["rows"];
        const auto row = std::ranges::find(rows, "fewer-cells", [](const json& r) { return r["kind"]; });
        return row == rows.end() ? json{{"ratio", 0}} : *row;
    };
    seek();
    ASSERT_TRUE(wait([&](const json& s) { return fewer_cells(s)["ratio"] > 0; }, 120));
    EXPECT_GT(fewer_cells(state())["error"], 0);
}

// What little there is to change is tried to the end: without the triangle nothing is left, so that it has no rung.
TEST_F(FoundWindow, ASearchEndsByItself) {
    save("scene.glib",
         "LookAt 0 0 4  0 0 0  0 1 0\nglBegin gl_triangles\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 0 1 0\nglEnd\n");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].empty(); }));
    settle();
    const std::vector<Pixel> before = scene_now();
    seek();
    const json all = found();
    EXPECT_EQ(all["remark"].get<std::string>().find("The search was stopped"), std::string::npos) << all["remark"];
    EXPECT_EQ(all["rows"], json::array());
    EXPECT_EQ(scene_now(), before);
    EXPECT_TRUE(idle());
}

TEST_F(FoundWindow, ASliderStopsTheSearchAndMovesTheShownRung) {
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name));
    const Pixel shown = scene_pixel(20, 20);
    EXPECT_NEAR(shown.green, std::lround(255 * .4), 1);
    click("controls");
    drag(on("Paint.uGreen", .4), on("Paint.uGreen", .7));
    away();
    const double green = state()["controls"]["Paint.uGreen"][0];
    EXPECT_GT(green, .5);
    EXPECT_NEAR(scene_pixel(20, 20).green, std::lround(255 * green), 1);
    EXPECT_EQ(scene_pixel(20, 20).red, shown.red) << "still the rung";
    EXPECT_TRUE(state()["found"]["older"]);
    // A search that goes on is stopped by the next change.
    click("tools");
    seek();
    EXPECT_FALSE(state()["found"]["older"]);
    EXPECT_TRUE(state()["found"]["searching"]) << state()["found"];
    click("controls");
    drag(on("Paint.uGreen", green), on("Paint.uGreen", .2));
    EXPECT_TRUE(wait([](const json& s) { return s["found"]["older"] && !s["found"]["searching"]; }));
    EXPECT_NE(state()["found"]["remark"], "");
}

TEST_F(FoundWindow, RungsOfAnOlderTextAreNotShown) {
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name));
    std::string edited = loop_fragment;
    edited.replace(edited.find(".2, 1."), 2, ".9");
    save("paint.frag", edited);
    ASSERT_TRUE(wait([](const json& s) { return s["found"]["stale"] && s["found"]["shown"] == ""; }));
    away();
    EXPECT_EQ(scene_now(), rendered("scene.glib"));
    click("found.row." + name, .9);
    away();
    EXPECT_EQ(state()["found"]["shown"], "");
    // What is broken is not sought in, and what is mended is.
    save("paint.frag", "nonsense");
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == true; }));
    click("found.find");
    EXPECT_FALSE(state()["found"]["searching"]);
    save("paint.frag", edited);
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }));
    settle();
    click("found.find");
    EXPECT_TRUE(wait([](const json& s) { return !s["found"]["stale"]; }));
    EXPECT_TRUE(alive());
}

TEST_F(FoundWindow, TheSplitShowsTheSceneBesideTheRung) {
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    const std::vector<Pixel> before = scene_now();
    const Pixel left = scene_pixel(-40, 20), right = scene_pixel(40, 20);
    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name));
    EXPECT_NE(scene_pixel(-40, 20), left);
    EXPECT_NE(scene_pixel(40, 20), right);
    ASSERT_TRUE(wait(
        [](const json& s) { return s.contains("accuracy") && s["accuracy"]["samples"] == s["accuracy"]["wanted"]; }));
    EXPECT_GT(state()["accuracy"]["error"], 0);
    click("accuracy.Split", .2);
    away();
    EXPECT_NE(scene_pixel(-40, 20), left);
    const Pixel beside = scene_pixel(40, 20);
    EXPECT_NEAR(beside.red, right.red, 1);
    EXPECT_NEAR(beside.green, right.green, 1);
    user("key s key a");  // closed, and with it the showing
    away();
    EXPECT_EQ(scene_now(), before);
    EXPECT_FALSE(state().contains("found"));
    EXPECT_EQ(state()["gl_errors"], json::array());
    user("key a");
    away();
    EXPECT_EQ(first_of(state()["found"]["rows"], "fewer-rounds"), name) << "what was found is still known";
    EXPECT_EQ(state()["found"]["shown"], "");
}

TEST_F(FoundWindow, TheSearchWaitsWhileThePictureMoves) {
    std::string moving = loop_fragment;
    moving.replace(moving.find("uniform float uGreen"), 13, "uniform float Timer, ");
    moving.replace(moving.find("uGreen, .2"), 10, "uGreen, .2 * Timer");
    save("paint.frag", moving);
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("accuracy.hold time"); }));
    settle();
    click("accuracy.hold time", .1);
    user("mousemove 5 5");
    click("found.find");
    ASSERT_TRUE(wait([](const json& s) { return s.contains("found") && s["found"]["waiting"]; }));
    const std::size_t frames = state()["frames"];
    ASSERT_TRUE(wait([&](const json& s) { return s["frames"] > frames + 5; })) << "time goes on";
    EXPECT_EQ(state()["found"]["rows"], json::array());
    EXPECT_TRUE(state()["found"]["searching"]);
    user("key space");
    const auto tried = [](const json& s) { return !s["found"]["rows"].empty() && !s["found"]["waiting"]; };
    EXPECT_TRUE(wait(tried, 30)) << "and now it does not";
}

TEST_F(FoundWindow, ARungIsWrittenIntoAFolder) {
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name));
    click("found.copy");
    EXPECT_EQ(state()["notice"].get<std::string>().find("copied: snell accuracy "), 0U) << state()["notice"];
    click("found.write");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("write rung save"); }));
    EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("write rung folder"); }));
    settle();
    click("write rung save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().find("wrote ") == 0; }));
    ASSERT_EQ(run({"accuracy", file("scene.glib"), "--apply", name, "-o", file("applied")}, ""), 0);
    const std::string folder = "scene-rung-" + name + "/";
    for (const char* each : {"scene.glib", "paint.frag", "paint.vert"})
        EXPECT_EQ(bytes(folder + each), bytes(std::string("applied/") + each)) << each;
    EXPECT_EQ(bytes("paint.frag"), loop_fragment) << "the author's own stays";
}

TEST_F(FoundWindow, RungsAreSoughtAtTheChosenOnes) {
    save("ways.glib",
         "##OpenGL GLIB\nOrtho -1 1 -1 1\nLadder WAY <short> long\nVertex paint.vert\nFragment ways.frag\n"
         "Program Paint\nQuadXY 0. 1.\n");
    save("ways.frag",
         "#version 330 compatibility\nin vec2 vAt;\nvoid main() {\n  float a = 0.;\n#if WAY == WAY_long\n"
         "  for (int i = 0; i < 24; ++i) a += .04 * sin(float(i) + vAt.x);\n#else\n"
         "  for (int i = 0; i < 16; ++i) a += .04 * cos(float(i) + vAt.x);\n#endif\n  gl_FragColor = vec4(a);\n}\n");
    end_window();
    open("ways.glib", {"--size", "800x740", "--ladder", "WAY=long"});
    user("key a");
    settle();
    const std::string name = fewer_rounds();
    ASSERT_NE(name, "");
    const json rows = state()["found"]["rows"];
    EXPECT_NE(rows.dump().find("ways.frag:6\""), std::string::npos) << rows;
    EXPECT_EQ(rows.dump().find("ways.frag:8\""), std::string::npos) << rows;
    user("mousemove 700 400 click --repeat 12 5");  // the rows are below those of the ladder
    settle();
    click("found.row." + name, .9);
    ASSERT_TRUE(wait_shown(name));
    click("found.copy");
    EXPECT_NE(state()["notice"].get<std::string>().find(" --ladder WAY=long --apply " + name), std::string::npos)
        << state()["notice"];
}

}  // namespace
}  // namespace snell::test
