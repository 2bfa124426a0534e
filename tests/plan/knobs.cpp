// Knobs change what they say and nothing else.
#include "src/content/cube/convolve.h"
#include "src/plan/plan.h"
#include "tests/oracle/light.h"
#include "tests/std.h"

namespace snell {
namespace {

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
