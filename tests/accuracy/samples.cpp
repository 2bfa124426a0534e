// Where samples lie within a pixel; and the rung of a knob that is called the scene's own draws the scene as it is.
#include "src/accuracy/bench.h"
#include "src/accuracy/measure.h"
#include "tests/std.h"

namespace snell::accuracy {
namespace {

TEST(SamplePositions, BeginWherePicturesAlwaysStand) { EXPECT_EQ(sample_position(0), (std::array<double, 2>{0, 0})); }

TEST(SamplePositions, AreSpreadEvenlyHoweverManyThereAre) {
    for (int count : {4, 16, 64}) {
        double x = 0, y = 0;
        std::array<int, 4> quadrants{};
        for (int i = 0; i < count; ++i) {
            const auto [right, up] = sample_position(i);
            ASSERT_LE(std::abs(right), .5);
            ASSERT_LE(std::abs(up), .5);
            x += right;
            y += up;
            ++quadrants[(right < 0 ? 0U : 1U) + (up < 0 ? 0U : 2U)];
        }
        // A mean of random ones would be off by .29 / sqrt(count).
        EXPECT_LT(std::hypot(x, y) / count, .5 / std::sqrt(count)) << count;
        for (int inside : quadrants) EXPECT_NEAR(inside, count / 4., .2 * count + 1) << count;
    }
}

Texture cube_of(int size, bool from_file) {
    Texture texture;
    texture.target = TextureTarget::cube;
    texture.size[0] = size;
    if (from_file) texture.files.resize(1);
    return texture;
}

Texture picture_with(Filter filter) {
    Texture texture;
    texture.files.resize(1);
    texture.filter = filter;
    return texture;
}

Sweep knob(const Scene& scene, const std::string& name) {
    Diagnostics problems;
    const std::vector<Sweep> sweeps = knob_sweeps(scene, {}, {name}, From::scene, true, problems);
    return sweeps.size() == 1 ? sweeps[0] : Sweep{};
}

// The name of the current rung, or what it changes.
std::string own_rung(const Scene& scene, const std::string& name) {
    const Sweep sweep = knob(scene, name);
    if (sweep.rungs.empty()) return "none";
    const SweepRung& own = sweep.rungs[sweep.current];
    Plan plan;
    plan.scene = scene;
    const std::vector<Texture> drawn = with_knobs(plan, own.variant.knobs.plan).scene.textures;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Texture &a = drawn[i], &b = scene.textures[i];
        const bool bytes = a.files.empty() && (a.bits == 16) != (b.bits == 16);
        const bool smaller = a.size[0] != b.size[0] && (a.size[0] > 0 || b.size[0] > 0);
        if (a.filter != b.filter || bytes || smaller) return "'" + own.name + "' is not the scene's own";
    }
    return own.name;
}

TEST(KnobsOfAScene, CubeMapsOfAnySize) {
    Scene scene;
    for (const int size : {16, 64, 300, 1000, 2048, 4096}) {
        scene.textures = {cube_of(size, false)};
        EXPECT_EQ(own_rung(scene, "cube-size"), std::to_string(size));
        const Sweep sweep = knob(scene, "cube-size");
        EXPECT_TRUE(
            std::ranges::is_sorted(sweep.rungs, {}, [](const SweepRung& rung) { return std::stoi(rung.name); }));
        EXPECT_EQ(sweep.reference, sweep.rungs.size() - 1);
    }
    scene.textures = {cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-size"), "files");
    scene.textures = {cube_of(300, false), cube_of(128, false), cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-size"), "300") << "the others keep their sizes, too";
}

TEST(KnobsOfAScene, CubeMapsThatAreDrawnToHaveBytes) {
    Scene scene;
    scene.textures = {cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-precision"), "half");
    scene.textures = {cube_of(64, false)};
    EXPECT_EQ(own_rung(scene, "cube-precision"), "8bit");
    scene.textures = {cube_of(64, false), cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-precision"), "scene");
    EXPECT_EQ(knob(scene, "cube-precision").rungs.back().name, "half");
}

TEST(KnobsOfAScene, FiltersOfAllFiles) {
    using Mode = Filter::Mode;
    Scene scene;
    scene.textures = {picture_with({Mode::mipmap, 1})};
    EXPECT_EQ(own_rung(scene, "filter"), "mipmap");
    scene.textures.push_back(picture_with({Mode::nearest, 1}));
    EXPECT_EQ(own_rung(scene, "filter"), "scene") << "two filters";
    EXPECT_EQ(knob(scene, "filter").rungs.back().name, "linear_8x8");
    scene.textures = {picture_with({Mode::anisotropic, 16})};
    EXPECT_EQ(own_rung(scene, "filter"), "scene") << "more than is offered";
    scene.textures = {picture_with({Mode::anisotropic, 8})};
    EXPECT_EQ(own_rung(scene, "filter"), "anisotropic8");
}

}  // namespace
}  // namespace snell::accuracy
