// Ladders and costs in a real window: drop-downs, and the panels that show the errors and costs of rungs.
#include <algorithm>
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

// The rungs differ by known amounts in red where the quad is; behind it they agree.
constexpr const char* scene = R"(##OpenGL GLIB
Perspective 50
LookAt 0 0 4  0 0 0  0 1 0
Background 0 0 0
Ladder DETAIL far near <exact>
Vertex paint.vert
Fragment paint.frag
Program Paint uGreen <0. .4 1.>
QuadXY 0. 1.
)";
constexpr const char* vertex = "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
constexpr const char* fragment = R"(#version 330 compatibility
uniform float uGreen;
void main() {
#if DETAIL == DETAIL_far
    float red = .8;
#elif DETAIL == DETAIL_near
    float red = .4;
#else
    float red = .3;
#endif
    gl_FragColor = vec4(red, uGreen, .2, 1.);
}
)";

// A folder with the scene.
class LadderScene : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", scene);
        save("paint.vert", vertex);
        save("paint.frag", fragment);
    }
    static std::string with(const std::string& instead_of, const std::string& text) {
        std::string edited = fragment;
        return edited.replace(edited.find(instead_of), instead_of.size(), text);
    }
    bool shows(const std::string& widget) const { return state()["widgets"].contains(widget); }
    void expect_red(const Pixel& pixel, double red) { EXPECT_NEAR(pixel.red, std::lround(255 * red), 1); }
};

TEST_F(LadderScene, OpensWithTheRungsOfAPreset) {
    save("scene.quality.json", R"({"schema": 1, "renderer": "a test", "presets": {"fast": {"ladders": ["DETAIL=far"],
        "rmse": 0.1, "ms": 1.0, "ratio": "0.5", "settled": true, "trusted": true}}})");
    open("scene.glib", {"--quality", "fast"});
    EXPECT_EQ(state()["rungs"]["DETAIL"], "far");
    expect_red(scene_pixel(20, 20), .8);
}

TEST_F(LadderScene, TheNumberOfARungInThePlaceOfTheRungIsSaid) {
    save("scene.glib", "Ladder N 3 <8> 16\nVertex paint.vert\nFragment paint.frag\nProgram Paint\nQuadXY 0. 1.\n");
    save("paint.frag", "void main() { gl_FragColor = vec4(.1 * float(N)); }\n");
    open("scene.glib");
    EXPECT_NE(state()["problems"].get<std::string>().find("use N_VALUE"), std::string::npos) << state()["problems"];
}

TEST_F(LadderScene, AnyRungGoesBeforeThePreset) {
    open("scene.glib", {"--quality", "fast", "--ladder", "DETAIL=near"});
    EXPECT_EQ(state()["rungs"]["DETAIL"], "near");
    EXPECT_EQ(state()["errors"], 1) << "there is no preset";
    expect_red(scene_pixel(20, 20), .4);
}

class LadderWindow : public LadderScene {
protected:
    void SetUp() override {
        LadderScene::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        open("scene.glib", {"--size", "800x740"});  // sliders stay in sight below the panel's longest remark
    }

    bool wait_for_rung(const std::string& name) {
        return wait([&](const json& s) { return s["rungs"]["DETAIL"] == name; });
    }
    // Refined to the end.
    json refined() {
        EXPECT_TRUE(wait([](const json& s) {
            return s.contains("accuracy") && s["accuracy"]["samples"] == s["accuracy"]["wanted"];
        }));
        return state()["accuracy"];
    }
    void open_panel() {
        user("key a");
        settle();
        refined();
    }
};

TEST_F(LadderWindow, ARungIsChosenInItsDropDown) {
    expect_red(scene_pixel(20, 20), .3);
    click("DETAIL");
    click("DETAIL.far");
    ASSERT_TRUE(wait_for_rung("far"));
    settle();
    expect_red(scene_pixel(20, 20), .8);
    EXPECT_FALSE(state().contains("accuracy")) << "a closed panel measures nothing";
    const int frames = frames_of(state());
    click("DETAIL", .5, 3);
    ASSERT_TRUE(wait_for_rung("exact")) << "right click: as the scene says";
    settle();
    expect_red(scene_pixel(20, 20), .3);
    EXPECT_EQ(frames_of(state()), frames + 1);
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(LadderWindow, ErrorsAreThoseOfTheRungs) {
    open_panel();
    EXPECT_EQ(refined()["error"], 0);
    EXPECT_GT(refined()["points"][0]["milliseconds"], 0);
    std::array<double, 2> errors{};
    for (const char* rung : {"near", "far"}) {
        click(std::string("accuracy.rung.") + rung, .1);
        ASSERT_TRUE(wait_for_rung(rung));
        errors[rung[0] == 'f'] = refined()["error"];
    }
    // Red of .3, .4 and .8 is so much light (sRGB), in one of three channels, where the quad is.
    const auto light = [](double red) { return std::pow((red + .055) / 1.055, 2.4); };
    const double near = light(.4) - light(.3), far = light(.8) - light(.3);
    const std::array<double, 4> area = state()["scene"];
    const double side = std::min(area[2], area[3]) / (4 * std::tan(25 * M_PI / 180));
    const double covered = side * side / (area[2] * area[3]);
    EXPECT_NEAR(errors[1] / errors[0], far / near, .01);
    EXPECT_NEAR(errors[0], near * std::sqrt(covered / 3), .002);

    // All rungs, by the button.
    click("accuracy.measure");
    ASSERT_TRUE(wait([](const json& s) { return !s["accuracy"]["measuring"] && s["accuracy"]["points"].size() == 3; }));
    const json now = state();
    for (const json& point : now["accuracy"]["points"]) {
        const std::string name = point["name"];
        EXPECT_NEAR(point["error"].get<double>(), name == "exact" ? 0 : errors[name == "far"], 1e-6) << name;
        EXPECT_GT(point["milliseconds"], 0) << name;
        EXPECT_EQ(point["chosen"], name == "far");
    }
    // Then it rests.
    user("mousemove 100 100");
    EXPECT_TRUE(idle());
    // Another value is another reference.
    const double green = state()["controls"]["Paint.uGreen"][0];
    click("controls");
    drag(on("Paint.uGreen", .4), on("Paint.uGreen", .7));
    EXPECT_NE(state()["controls"]["Paint.uGreen"][0], green);
    EXPECT_NEAR(refined()["error"].get<double>(), errors[1], 1e-4) << "and the same error";
    EXPECT_EQ(refined()["points"].size(), 1) << "what was measured does not stand any more";
}

// Drawn, it would be as with the rung before.
TEST_F(LadderWindow, ARungWithErrorsIsLeftOutAndNamed) {
    save("paint.frag", with("float red = .8;", "float red = no_such_function();"));
    user("key F5");
    user("key a");
    settle();
    click("accuracy.measure");
    ASSERT_TRUE(wait([](const json& s) {
        return s["accuracy"]["remark"].get<std::string>().starts_with("'far' has errors, and is not measured. ");
    })) << state()["accuracy"];
    settle();
    for (const json& point : state()["accuracy"]["points"]) EXPECT_NE(point["name"], "far");
    EXPECT_EQ(state()["accuracy"]["points"].size(), 2U);
}

TEST_F(LadderWindow, ARungThatDoesNotCompileIsSaidAsABrokenEditIs) {
    save("paint.frag", with("float red = .8;", "float red = no_such_function();"));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    open_panel();
    EXPECT_EQ(state()["errors"], 0) << "the rung is not chosen";
    const json row = state()["widgets"]["accuracy.rung.far"];
    click("accuracy.rung.far", .1);
    ASSERT_TRUE(wait_for_rung("far"));
    settle();
    EXPECT_EQ(state()["widgets"]["accuracy.rung.far"], row) << "it stays under the pointer";
    expect_red(scene_pixel(20, 20), .3);
    EXPECT_EQ(state()["errors"], 1);
    EXPECT_TRUE(shows("problems.panel"));
    EXPECT_TRUE(shows("status.stale")) << "last good picture";
    EXPECT_FALSE(shows("accuracy.error")) << "it would be the error of another rung";
    EXPECT_EQ(state()["accuracy"]["note"].get<std::string>().find("DETAIL=far has errors"), 0U) << state()["accuracy"];
    keep("broken-rung");
    user("key s");
    settle();
    const std::string label = state()["states"][0];
    EXPECT_EQ(label.find("now: DETAIL far, last good picture: "), 0U) << label;
    click("accuracy.other");
    settle();
    EXPECT_FALSE(shows("accuracy.legend"));
    EXPECT_TRUE(shows("accuracy.no map"));
    user("key s");
    // Read again with that rung, the text has errors; with the next one it has none.
    user("key F5");
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == true; }));
    settle();
    click("accuracy.rung.near", .1);
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0 && s["stale"] == false; }));
    settle();
    expect_red(scene_pixel(20, 20), .4);
    EXPECT_FALSE(shows("status.stale"));
    EXPECT_GT(refined()["error"], 0);
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(LadderWindow, ASceneThatBeganWithABrokenRungIsMendedByAnother) {
    end_window();
    save("paint.frag", with("float red = .8;", "float red = no_such_function();"));
    open("scene.glib", {"--size", "800x740", "--ladder", "DETAIL=far"});
    EXPECT_EQ(state()["errors"], 1);
    click("DETAIL");
    click("DETAIL.near");
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }));
    settle();
    expect_red(scene_pixel(20, 20), .4);
}

TEST_F(LadderWindow, WithoutAReferenceThereIsNoHeatMapNorItsLegend) {
    click("DETAIL");
    click("DETAIL.far");
    user("key s");
    settle();
    const json before = state()["widgets"];
    click("accuracy.other");
    settle();
    EXPECT_TRUE(shows("accuracy.legend"));
    for (const char* button : {"accuracy.left", "accuracy.swap", "accuracy.other", "accuracy.right"})
        EXPECT_EQ(state()["widgets"][button], before[button]) << button << " stays under the mouse";
    save("paint.frag", with("float red = .3;", "float red = no_such_function();"));
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("accuracy.no map"); }));
    settle();
    EXPECT_EQ(state()["errors"], 0) << "the chosen rung has none";
    EXPECT_FALSE(shows("accuracy.legend"));
    keep("no-heat-map");
}

TEST_F(LadderWindow, WithoutAPictureOfTheReferenceTheHeatMapIsThePlainPicture) {
    click("DETAIL");
    click("DETAIL.near");
    settle();
    std::string broken = with("float red = .3;", "float red = no_such_function();");
    save("paint.frag", broken.replace(broken.find(".4;"), 2, "nope"));
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == true; }));
    user("key s");
    settle();
    EXPECT_GT(scene_pixel(40, 20).red, 240) << "that half is empty";
    click("accuracy.other");
    settle();
    for (const char* side : {"now", "swapped"}) {
        expect_red(scene_pixel(-40, 20), .4);
        expect_red(scene_pixel(40, 20), .4);
        EXPECT_TRUE(shows("accuracy.no map")) << side;
        EXPECT_FALSE(shows("accuracy.legend")) << side;
        click("accuracy.swap");
        settle();
    }
    // There are errors to compare with, but not of what was chosen.
    save("paint.frag", with("float red = .8;", "float red = no_such_function();"));
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == false; }));
    click("accuracy.right");
    click("right.DETAIL=far");
    settle();
    expect_red(scene_pixel(-40, 20), .4);
    EXPECT_TRUE(shows("accuracy.no map"));
}

TEST_F(LadderWindow, TheReferenceBesideThePictureAndWhereTheyDiffer) {
    click("DETAIL");
    click("DETAIL.far");
    open_panel();
    click("accuracy.Split", .2);
    refined();
    expect_red(scene_pixel(-40, 20), .8);
    expect_red(scene_pixel(40, 20), .3);
    const std::array<double, 4> area = state()["scene"];
    drag(on("accuracy.divider"), {static_cast<int>(area[2] / 2 + 60), static_cast<int>(area[3] / 2)});
    EXPECT_NEAR(state()["accuracy"]["divider"].get<double>(), .5 + 60 / area[2], .01);
    EXPECT_EQ(state()["view"]["rotate_y"], 0) << "the scene is not turned";
    expect_red(scene_pixel(40, 20), .8);
    expect_red(scene_pixel(90, 20), .3);

    click("accuracy.Heat map", .2);
    refined();
    const Pixel hot = scene_pixel(20, 20), cold = scene_pixel(0, 10 - static_cast<int>(area[3] / 2));
    EXPECT_GT(hot.red, 200) << "off by .29";
    EXPECT_LT(cold.red + cold.green + cold.blue, 20) << "no difference";

    click("accuracy");  // closed
    user("key s");
    ASSERT_TRUE(wait([](const json& s) { return !s.contains("accuracy"); }));
    settle();
    expect_red(scene_pixel(90, 20), .8);
    EXPECT_EQ(state()["gl_errors"], json::array());
}

// The costs panel follows the programs that are compiled for the values as they are.
class CostsInTheWindow : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("plain.vert",
             "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
             "gl_Position = ftransform(); }\n");
        // Programs are compiled for values only where frames are expensive.
        save("slow.frag",
             "#version 330 compatibility\nuniform float uMix, uTint;\nin vec2 vST;\nvoid main() {\n    vec3 c = "
             "vec3(vST, .5);\n    for (int i = 0; i < 400; ++i) c = fract(sin(c * 1.7) + .1);\n    gl_FragColor = "
             "vec4(uMix > 0. ? c + uMix * vec3(uTint) : c, 1.);\n}\n");
        save("scene.glib",
             "Perspective 50\nLookAt 0 0 2  0 0 0  0 1 0\nVertex plain.vert\nFragment slow.frag\n"
             "Program Slow uMix <0. 0. 1.> uTint <0. .5 1.>\nQuadXY 0. 1.\n");
    }
};

TEST_F(CostsInTheWindow, SayWhatValuesSwitchOffWhileNothingIsTouched) {
    open("scene.glib");
    click("tools");
    click("costs");
    const auto tells = [](const json& s) { return s["widgets"].contains("costs.Switched off by values"); };
    EXPECT_TRUE(wait(tells, 20));
    EXPECT_TRUE(idle()) << "nothing is left to show";
    click("controls");
    click("Slow.uMix", .7);
    click("tools");
    EXPECT_TRUE(wait([&](const json& s) { return !tells(s); })) << "programs for any values draw now";
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

}  // namespace
}  // namespace snell::test
