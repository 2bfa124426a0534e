// Choosing rungs by name, and keeping the choice when the text changes.
#include "src/plan/values/rungs.h"
#include "parser/read/parse.h"
#include "src/content/cube/convolve.h"
#include "src/plan/plan.h"
#include "tests/oracle/light.h"
#include "tests/std.h"

namespace snell {
namespace {

Scene scene(std::string text) {
    Sources sources;
    const FileId file = sources.add("scene.glib", std::move(text));
    return parse(file, sources).scene;
}

TEST(Rungs, AreChosenByName) {
    const Scene s = scene("Ladder FRESNEL f0 <schlick> exact\nLadder WAVES 3 8 16\n");
    Rungs rungs = marked_rungs(s);
    EXPECT_EQ(rungs, (Rungs{1, 0}));
    Diagnostics problems;
    EXPECT_TRUE(choose_rung(rungs, s, "FRESNEL=exact", problems));
    EXPECT_TRUE(choose_rung(rungs, s, "WAVES=16", problems));
    EXPECT_EQ(rungs, (Rungs{2, 2}));
    EXPECT_TRUE(problems.empty());
}

TEST(Rungs, WhatIsNotThereIsAnErrorThatSuggests) {
    const Scene s = scene("Ladder FRESNEL f0 <schlick> exact\n");
    for (const auto& [text, code, help] :
         {std::array{"FRESNELL=exact", "unknown-ladder", "did you mean 'FRESNEL'?"},
          std::array{"FRESNEL=exakt", "unknown-rung", "did you mean 'exact'?"},
          std::array{"FRESNEL=quite-another", "unknown-rung", "available: f0, schlick, exact"},
          std::array{"FRESNEL=", "unknown-rung", "available: f0, schlick, exact"},
          std::array{"FRESNEL", "bad-assignment", "write LADDER=rung"}}) {
        Rungs rungs = marked_rungs(s);
        Diagnostics problems;
        EXPECT_FALSE(choose_rung(rungs, s, text, problems)) << text;
        ASSERT_EQ(problems.errors(), 1u) << text;
        EXPECT_EQ(problems.items()[0].code, code) << text;
        EXPECT_EQ(problems.items()[0].help, help) << text;
        EXPECT_EQ(rungs, Rungs{1}) << text;
    }
}

TEST(Rungs, CarryOverByName) {
    const Scene before = scene("Ladder A x <y> z\nLadder B p q\n");
    const Scene after = scene("Ladder B q p <p2>\nLadder A z x <y>\nLadder C one\n");
    Rungs rungs = marked_rungs(after);
    carry_over(Rungs{2, 1}, before, rungs, after);
    EXPECT_EQ(rungs[1], 0u) << "A: z";
    EXPECT_EQ(rungs[0], 2u) << "B: the text marks another rung than before";
    EXPECT_EQ(rungs[2], 0u);
    const Scene without = scene("Ladder A x <y>\n");
    rungs = marked_rungs(without);
    carry_over(Rungs{2, 1}, before, rungs, without);
    EXPECT_EQ(rungs, Rungs{1}) << "the chosen rung is gone";
}

// ---- Knobs change what they say and nothing else.

Plan plan_with(const Shape& shape) {
    Plan plan;
    plan.scene.draws.push_back({.shape = shape});
    plan.meshes.push_back({shape, false, {}});
    return plan;
}

TEST(Knobs, TessellationScalesRoundShapesOnly) {
    const Plan ball = with_knobs(plan_with(Sphere{1, 60, 30}), {.tessellation = 2});
    EXPECT_EQ(std::get<Sphere>(ball.meshes[0].shape).slices, 120);
    EXPECT_EQ(std::get<Sphere>(ball.scene.draws[0].shape).stacks, 60);
    const Plan coarse = with_knobs(plan_with(Sphere{1, 4, 4}), {.tessellation = .1});
    EXPECT_EQ(std::get<Sphere>(coarse.meshes[0].shape).slices, 3) << "fewer are no ball";
    EXPECT_TRUE(has_round_shapes(ball.scene));
    EXPECT_FALSE(has_round_shapes(plan_with(Box{}).scene));
}

TEST(Knobs, OnlySamplesLeaveThePlanAsItIs) {
    const PlanKnobs plain;
    const Knobs samples{.grid = 4, .multisample = 4};
    EXPECT_EQ(plain, samples.plan);
    EXPECT_NE(plain, (PlanKnobs{.tessellation = 2}));
    EXPECT_NE(plain, (PlanKnobs{.filter = Filter{Filter::Mode::nearest, 1}}));
    EXPECT_NE(plain, (PlanKnobs{.cube_size = 32}));
    EXPECT_NE(plain, (PlanKnobs{.cube_bits = 8}));
}

TEST(Knobs, CubeMapsFromFilesAreMadeSmallerAndKeepTheirLight) {
    Plan plan;
    Texture texture;
    texture.target = TextureTarget::cube;
    for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"})
        texture.files.push_back({std::string(face) + ".bmp", {}});
    plan.scene.textures.push_back(texture);
    Files files(SNELL_ROOT "/scenes/environments/room");
    Diagnostics problems;
    const content::CubeFaces whole = load_cube(plan.scene, 0, files, problems);
    const content::CubeFaces small = load_cube(with_knobs(plan, {.cube_size = 16}).scene, 0, files, problems);
    EXPECT_FALSE(problems.has_errors());
    EXPECT_EQ(small[0].width, 16);
    EXPECT_EQ(small[0].type, whole[0].type);
    const auto before = content::mean_radiance(content::cube_light(whole));
    const auto after = content::mean_radiance(content::cube_light(small));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], .002);
}

}  // namespace
}  // namespace snell
