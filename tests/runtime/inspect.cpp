// What pixels are before they are made bytes: against values that shaders write on purpose, and depth against the
// formula of the projection.
#include "src/runtime/inspect.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Inspect : public GlTest {
protected:
    static constexpr int width = 64, height = 48;

    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        // Columns of pixels that no picture of bytes tells apart.
        folder.write("odd.frag",
                     "#version 330 compatibility\nuniform float uZero;\nvoid main() {\n"
                     "    int column = int(gl_FragCoord.x);\n"
                     "    vec4 c = vec4(.25, .5, .75, 1.);\n"
                     "    if (column == 3) c.g = uZero / uZero;\n"
                     "    if (column == 5) c.r = 1. / uZero;\n"
                     "    if (column == 7) c.b = -1. / uZero;\n"
                     "    if (column == 9) c.r = -.125;\n"
                     "    if (column == 11) c.g = 2.5;\n"
                     "    if (column == 13) c = vec4(-.5, 2.5, .5, 1.);\n"
                     "    if (column == 15) c.a = 3.;\n"
                     "    if (column == 17) c.a = uZero / uZero;\n"
                     "    gl_FragColor = c;\n}\n");
    }
    static constexpr std::string_view odd =
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment odd.frag\nProgram P uZero <0. 0. 1.>\nQuadXY 0. 5.\n";

    std::unique_ptr<Document> ready(std::string_view scene) {
        auto document = open(scene);
        expect_clean(*document);
        EXPECT_TRUE(floats_.resize(width, height));
        return document;
    }
    // Two draws off-screen, and one of the window that shows them.
    std::unique_ptr<Document> two_passes() {
        folder.write("texture.frag", texture_fragment);
        folder.write("color.frag", color_fragment);
        return ready(
            "Blend off\nTexture2D 5 16 16\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment color.frag\n"
            "Program A uColor {.2 .4 .6 1.}\nRenderToTexture 5\nQuadXY 0. 5.\nQuadXY .5 2.\nRenderToTexture\n"
            "Fragment texture.frag\nProgram B uUnit 5\nQuadXY 0. 5.\n");
    }
    Frame frame(Document& document) const { return {.time = 0, .view = view_, .controls = document.controls}; }
    Inspection at(Document& document, int x, int y, int radius = 0) {
        Inspection found;
        floats_.inspect(*document.runtime, frame(document), x, y, radius, found);
        return found;
    }

    FloatPicture floats_;
    View view_;
};

TEST_F(Inspect, ValuesAreThoseThatTheShaderWrote) {
    auto document = ready(odd);
    const auto value = [&](int x) {
        const Inspection found = at(*document, x, 20);
        return std::array{found.pixel()[0], found.pixel()[1], found.pixel()[2], found.pixel()[3]};
    };
    EXPECT_EQ(value(2), (std::array{.25F, .5F, .75F, 1.F}));
    EXPECT_TRUE(std::isnan(value(3)[1]));
    EXPECT_EQ(value(3)[0], .25F);
    EXPECT_EQ(value(5)[0], std::numeric_limits<float>::infinity());
    EXPECT_EQ(value(7)[2], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(value(9)[0], -.125F);
    EXPECT_EQ(value(11)[1], 2.5F);
    EXPECT_EQ(value(15)[3], 3.F);
}

// Bytes clamp alpha before blending; floats must not triple a colour for it.
TEST_F(Inspect, AnAlphaBeyondOneIsAnOpaqueColor) {
    auto document = ready("Background 1 1 1\n" + std::string(odd));
    const Inspection found = at(*document, 15, 20);
    EXPECT_EQ(found.pixel()[0], .25F);
    EXPECT_EQ(found.pixel()[2], .75F);
    EXPECT_EQ(flag_of(found.pixel()), Flag::none);
    // What is between 0 and 1 blends as ever.
    folder.write("glass.frag", "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(2., 0., 0., .25); }\n");
    document =
        ready("Background 1 1 1\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment glass.frag\nProgram P\nQuadXY 0. 5.\n");
    EXPECT_EQ(at(*document, 15, 20).pixel()[0], 1.25F);
    EXPECT_EQ(at(*document, 15, 20).pixel()[1], .75F);
}

TEST_F(Inspect, PixelsAreCountedByWhatIsWorstAboutThem) {
    auto document = ready(odd);
    std::vector<float> rgba;
    floats_.draw(*document->runtime, frame(*document), rgba);
    ASSERT_EQ(rgba.size(), std::size_t{4} * width * height);
    const FlagCounts counts = count_flags(rgba);
    EXPECT_EQ(counts[Flag::nan], 2U * height) << "one of them in alpha";
    EXPECT_EQ(counts[Flag::infinite], 2U * height);
    EXPECT_EQ(counts[Flag::negative], 2U * height) << "negative outweighs what is above 1 in the same pixel";
    EXPECT_EQ(counts[Flag::above_one], 1U * height) << "alpha above 1 shows nowhere";
    EXPECT_EQ(counts[Flag::none], std::size_t{width - 7} * height);
    std::vector<std::byte> picture;
    paint_flags(rgba, picture);
    const auto painted = [&](std::size_t x) {
        const std::byte* p = &picture[4 * (20 * width + x)];
        return std::array{std::to_integer<std::uint8_t>(p[0]), std::to_integer<std::uint8_t>(p[1]),
                          std::to_integer<std::uint8_t>(p[2])};
    };
    EXPECT_EQ(painted(3), color_of(Flag::nan));
    EXPECT_EQ(painted(17), color_of(Flag::nan));
    EXPECT_EQ(painted(5), color_of(Flag::infinite));
    EXPECT_EQ(painted(13), color_of(Flag::negative));
    EXPECT_EQ(painted(11), color_of(Flag::above_one));
    EXPECT_EQ(painted(2)[0], painted(2)[1]) << "gray";
    EXPECT_LT(painted(2)[0], 128) << "and dim";
}

TEST(Flags, WhatIsNotMarkedIsRecognisedAndNotTakenForAMark) {
    const auto painted = [](float level) {
        std::vector<std::byte> picture;
        paint_flags(std::array{level, level, level, 1.F}, picture);
        EXPECT_TRUE(picture[0] == picture[1] && picture[1] == picture[2]);
        return std::to_integer<int>(picture[0]);
    };
    EXPECT_EQ(painted(0), 0);
    // In dark scenes; and steps that are seen in the picture are seen here.
    EXPECT_GT(painted(.05F), 30);
    for (int i = 1; i < 16; ++i) {
        const float level = static_cast<float>(i) / 16;
        EXPECT_GE(painted(level + 1.F / 16), painted(level) + 5) << level;
    }
    for (const Flag flag : {Flag::nan, Flag::infinite, Flag::negative, Flag::above_one}) {
        const auto [low, high] = std::ranges::minmax(color_of(flag));
        EXPECT_GT(high - low, 160) << "no grey is near";
        EXPECT_GT(high, painted(1) + 60) << "and none is as bright";
    }
}

// A scene of perspective, depth, blending, a shader that reads gl_FragCoord, a Clear, axes: drawn as a whole and square
// by square, every bit is the same.
TEST_F(Inspect, ASquareHasTheBitsOfTheWholePicture) {
    folder.write("where.frag",
                 "#version 330 compatibility\nin vec2 vST;\nvoid main() { gl_FragColor = vec4(fract(gl_FragCoord.xy * "
                 ".37), dFdx(vST.s) * 90. + vST.t, .5 + .5 * sin(40. * vST.s)); }\n");
    auto document = ready(
        "Background .1 .2 .3\nPerspective 60\nLookAt 0 0 3  0 0 0  0 1 0\nVertex plain.vert\nFragment where.frag\n"
        "Program P\nSphere 1. 20 20\nClear\nBlend on\nPushMatrix\nTranslate .4 .2 .5\nSphere .7 16 16\n"
        "PopMatrix\nQuadXY -.3 1.2\n");
    view_.axes = true;
    view_.scene.rotate_y = 20;
    std::vector<float> whole;
    floats_.draw(*document->runtime, frame(*document), whole);
    int different_colors = 0;
    for (const auto& [x, y] : {std::pair{32, 24}, {20, 30}, {0, 0}, {63, 47}, {1, 46}, {40, 12}, {31, 2}}) {
        const int radius = 4;
        const Inspection found = at(*document, x, y, radius);
        for (int down = -radius; down <= radius; ++down)
            for (int right = -radius; right <= radius; ++right) {
                const int px = x + right, py = y + down;
                const bool inside = px >= 0 && py >= 0 && px < width && py < height;
                ASSERT_EQ(found.inside[found.at(right, down)], inside ? 1 : 0);
                if (!inside) continue;
                const float* expected = &whole[4 * static_cast<std::size_t>(py * width + px)];
                EXPECT_EQ(std::memcmp(found.pixel(right, down).data(), expected, 4 * sizeof(float)), 0)
                    << px << ", " << py;
                different_colors += std::memcmp(expected, whole.data(), 4 * sizeof(float)) != 0;
            }
    }
    EXPECT_GT(different_colors, 100) << "there was something to see";
}

TEST_F(Inspect, DepthIsThatOfTheProjectionAndDistanceThatOfTheSurface) {
    folder.write("color.frag", color_fragment);
    // A wall at z = -2.5 that fills the view of an eye at 4, looking down the z axis.
    auto document = ready(
        "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nVertex plain.vert\nFragment color.frag\n"
        "Program P uColor {.2 .3 .4 1.}\nQuadXY -2.5 40.\n");
    for (const auto& [x, y] : {std::pair{32, 24}, {3, 40}, {60, 5}}) {
        const Inspection found = at(*document, x, y);
        ASSERT_TRUE(found.depth && found.distance);
        EXPECT_NEAR(*found.distance, 6.5, 1e-5 * 6.5) << "a wall that faces the eye is as far everywhere";
    }
    // Without planes that fit: near .1, far 1000.
    folder.write("moves.vert",
                 "#version 330 compatibility\nvoid main() { gl_Position = gl_ModelViewProjectionMatrix * (gl_Vertex + "
                 "vec4(0., 0., 1., 0.)); }\n");
    document = ready(
        "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nVertex moves.vert\nFragment color.frag\n"
        "Program P uColor {.2 .3 .4 1.}\nQuadXY -2.5 40.\n");
    const double near = .1, far = 1000, z = 5.5;
    const Inspection found = at(*document, 10, 10);
    EXPECT_NEAR(*found.depth, far / (far - near) * (1 - near / z), 2e-7) << "1 / 2^23 of rounding";
    EXPECT_NEAR(*found.distance, z, 2e-3);
    // Orthographic: depth is linear between -1000 and 1000.
    document = ready(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment color.frag\nProgram P uColor {1. 1. 1. 1.}\n"
        "QuadXY 3. 5.\n");
    const Inspection flat = at(*document, 10, 10);
    const double eye = 3;  // the default eye looks down the z axis from the origin
    EXPECT_NEAR(*flat.depth, (1000 - eye) / 2000, 1e-6);
    EXPECT_NEAR(*flat.distance, -eye, 1e-3);
}

TEST_F(Inspect, TheHeldSceneIsWhereItIsSeen) {
    folder.write("color.frag", color_fragment);
    auto document = ready(
        "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nVertex plain.vert\nFragment color.frag\n"
        "Program P uColor {.2 .3 .4 1.}\nQuadXY 0. 40.\n");
    view_.scene.z = 1.5;
    EXPECT_NEAR(at(*document, 32, 24).distance.value_or(0), 2.5, 1e-4);
}

TEST_F(Inspect, WhereNothingIsThereIsNoDistance) {
    auto document = ready("Background .5 .25 0\nPerspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nSphere .2 10 10\n");
    const Inspection found = at(*document, 2, 2, 2);
    EXPECT_EQ(found.pixel()[0], .5F);
    EXPECT_EQ(found.pixel()[1], .25F);
    EXPECT_EQ(found.depth, 1.0);
    EXPECT_FALSE(found.distance);
}

// What was drawn off-screen stands: only the window's draws are done again, and see the same.
TEST_F(Inspect, AStandingFrameDrawsOnlyTheWindow) {
    auto document = two_passes();
    std::vector<float> first, again;
    floats_.draw(*document->runtime, frame(*document), first);
    const Counters before = document->runtime->counters();
    Frame standing = frame(*document);
    standing.standing = true;
    floats_.draw(*document->runtime, standing, again);
    EXPECT_EQ(document->runtime->counters().draws - before.draws, 1U);
    EXPECT_EQ(first, again);
    EXPECT_NEAR(first[0], .2F, .5F / 255);
}

// Every draw and every pass is told of, in the order in which they are drawn.
TEST_F(Inspect, FramesTellOfTheirSteps) {
    auto document = two_passes();
    std::vector<Step> steps;
    const std::function<void(const Step&)> listen = [&](const Step& step) { steps.push_back(step); };
    Frame told = frame(*document);
    told.after = &listen;
    std::vector<float> rgba;
    floats_.draw(*document->runtime, told, rgba);
    std::vector<Index> draws;
    std::size_t passes = 0;
    for (const Step& step : steps) {
        if (step.draw != none) draws.push_back(step.draw);
        passes += step.draw == none;
        if (step.draw == 2) {
            EXPECT_EQ(document->scene().passes[step.pass].kind, Pass::Kind::window);
        }
    }
    EXPECT_EQ(draws, (std::vector<Index>{0, 1, 2}));
    EXPECT_GE(passes, 2U);
}

}  // namespace
}  // namespace snell::test
