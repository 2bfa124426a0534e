// From the text of a scene to plan and controls.
#include "parser/read/parse.h"
#include "src/plan/plan.h"
#include "tests/plan/uniforms.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

struct Planned {
    Plan plan;
    Sources sources;
    Diagnostics diagnostics;
};

void plan_text(Planned& planned, const std::string& text, Files& files) {
    Parsed parsed = parse(planned.sources.add("scene.glib", text), planned.sources);
    planned.diagnostics.append(parsed.diagnostics);
    planned.plan = make_plan(std::move(parsed.scene), files, planned.sources, planned.diagnostics);
}

ActiveUniform uniform(const char* name, const char* type) {
    ActiveUniform made = active(type);
    made.name = name;
    return made;
}

TEST(PlannedScene, ValuesOfEveryKindReachTheirTypes) {
    const Scratch folder;
    folder.write("a.vert", "v");
    folder.write("a.frag", "f");
    Files files(folder.path());
    Planned planned;
    plan_text(planned,
              "##OpenGL GLIB\n"
              "Vertex A.vert\nFragment a\n"
              "Program Glass \\\n"
              "    uEta <.1 1.1 5.> uCount <0 3 9> uOn <true> uOff <0> uHalf <.5> uIntOne <1> \\\n"
              "    uColor {1. .5 0.} uLight [1. 2. 3.] uTexUnit 6 uTwo <0. 1.>\n"
              "Sphere 1 20 20\nSphere 1 20 20\n",
              files);
    EXPECT_EQ(planned.plan.meshes.size(), 1U);
    EXPECT_TRUE(planned.plan.programs.at(0).readable);
    EXPECT_FALSE(planned.diagnostics.has_errors());
    Diagnostics diagnostics;
    Controls controls = make_controls(
        planned.plan.scene,
        {{uniform("uEta", "float"), uniform("uCount", "int"), uniform("uOn", "bool"), uniform("uOff", "bool"),
          uniform("uHalf", "float"), uniform("uIntOne", "int"), uniform("uColor", "vec4"), uniform("uLight", "vec3"),
          uniform("uTexUnit", "samplerCube"), uniform("uTwo", "float")}},
        diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << render(diagnostics, planned.sources);
    const auto widget = [&](const char* name) { return controls.find(0, name)->widget; };
    EXPECT_EQ(widget("uEta"), Widget::slider);
    EXPECT_EQ(controls.find(0, "uEta")->min, .1);
    EXPECT_EQ(controls.find(0, "uEta")->max, 5);
    EXPECT_EQ(controls.find(0, "uEta")->value, std::vector<double>{1.1});
    EXPECT_EQ(widget("uCount"), Widget::slider);
    EXPECT_EQ(widget("uOn"), Widget::check_box);
    EXPECT_EQ(widget("uOff"), Widget::check_box);
    EXPECT_EQ(widget("uHalf"), Widget::none);
    EXPECT_EQ(widget("uIntOne"), Widget::none);
    EXPECT_EQ(controls.find(0, "uColor")->value, (std::vector<double>{1, .5, 0, 1}));
    EXPECT_EQ(controls.find(0, "uTexUnit")->value, std::vector<double>{6});
    EXPECT_EQ(controls.find(0, "uTwo")->max, 1);
    EXPECT_EQ(controls.find(0, "uTwo")->widget, Widget::slider);
}

TEST(PlannedScene, WallsShareAUnitOneAfterTheOther) {
    const Scratch folder;
    for (const char* name : {"a.bmp", "b.bmp"}) folder.write(name, "x");
    Files files(folder.path());
    Planned planned;
    plan_text(planned, "Texture2D 6 a.bmp\nQuadXY -5 5\nTexture2D 6 b.bmp\nQuadXY 5 5\n", files);
    const Scene& scene = planned.plan.scene;
    ASSERT_EQ(scene.draws.size(), 2U);
    const auto name = [&](Index draw) {
        return scene.textures[find_texture(scene, scene.draws[draw], 6, TextureTarget::d2)].files[0].name;
    };
    EXPECT_EQ(name(0), "a.bmp");
    EXPECT_EQ(name(1), "b.bmp");
}

TEST(PlannedScene, ThePrintedRoom) {
    const std::string text = bytes_of("../shared/corpus/bailey/cubemap.glib");
    if (text.empty()) GTEST_SKIP() << "../shared is not there";
    const Scratch folder;
    Files files(folder.path());
    Planned planned;
    plan_text(planned, text, files);
    Diagnostics ignored;
    Controls controls = make_controls(planned.plan.scene, {}, ignored);
    const auto has_slider = [&](const char* name, double min, double value, double max) {
        for (const Control& control : controls.items) {
            if (control.name == name && control.widget == Widget::slider) {
                return control.min == min && control.value[0] == value && control.max == max;
            }
        }
        return false;
    };
    EXPECT_TRUE(has_slider("uEta", .1, 1.1, 5));
    EXPECT_TRUE(has_slider("uMix", 0, 0, 1));
    EXPECT_EQ(files.counters().opened, 0U) << "nothing was there to open";
    EXPECT_TRUE(planned.diagnostics.has_errors());
    EXPECT_FALSE(dump_plan(planned.plan, planned.sources).empty());
    EXPECT_EQ(folder.entries(), 0U) << "and nothing was created";
}

}  // namespace
}  // namespace snell
