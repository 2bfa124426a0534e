// Rendering to textures and cube maps, and reading them again.
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

const Pixel black{0, 0, 0, 255};

class Passes : public PlainTest {
protected:
    void SetUp() override {
        PlainTest::SetUp();
        folder.write("two.frag",
                     "#version 330\nlayout(location = 0) out vec4 first;\nlayout(location = 1) out vec4 second;\n"
                     "void main() { first = vec4(1., 0., 0., 1.); second = vec4(0., 1., 0., 1.); }\n");
        folder.write("cube.vert",
                     "out vec3 vDir;\nvoid main() { vDir = gl_Vertex.xyz; gl_Position = "
                     "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write(
            "cube.frag",
            "uniform samplerCube uCube;\nin vec3 vDir;\nvoid main() { gl_FragColor = texture(uCube, vDir); }\n");
    }
    static constexpr std::string_view show =
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram Show uUnit 5\nQuadXY\n";
};

TEST_F(Passes, ATextureThatWasRenderedToShowsWhatWasDrawn) {
    const Picture picture = draw(
        "Texture2D 5 32 32\nOrtho -1 1 -1 1\nRenderToTexture 5\nColor 1 0 0\nTranslate -.5 0 0\nQuadXY 0 .5\n"
        "Translate .5 0 0\nRenderToTexture\n" +
        std::string(show));
    EXPECT_TRUE(near(picture.at(16, 32), red));
    EXPECT_TRUE(near(picture.at(48, 32), Pixel{18, 27, 33, 255}));  // cleared to 0 with alpha 0: the window shows
}

TEST_F(Passes, SeveralUnitsAreOutputsByLocation) {
    const std::string scene =
        "Texture2D 5 16 16\nTexture2D 6 16 16\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment two.frag\nProgram Two\n"
        "RenderToTexture 5 6\nQuadXY\nRenderToTexture\nVertex plain.vert\nFragment texture.frag\n";
    EXPECT_TRUE(near(draw(scene + "Program Show uUnit 5\nQuadXY\n").center(), red));
    EXPECT_TRUE(near(draw(scene + "Program Show uUnit 6\nQuadXY\n").center(), green));
}

TEST_F(Passes, FragColorIsTheColorOfEveryTarget) {
    folder.write("one.frag", "void main() { gl_FragColor = vec4(1., 0., 0., 1.); }\n");
    const std::string scene =
        "Texture2D 5 16 16\nTexture2D 6 16 16\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment one.frag\nProgram One\n"
        "RenderToTexture 5 6\nQuadXY\nRenderToTexture\nVertex plain.vert\nFragment texture.frag\n";
    EXPECT_TRUE(near(draw(scene + "Program Show uUnit 5\nQuadXY\n").center(), red));
    EXPECT_TRUE(near(draw(scene + "Program Show uUnit 6\nQuadXY\n").center(), red));
}

TEST_F(Passes, BackgroundAndClearActOnTheCurrentTarget) {
    const Picture picture = draw(
        "Background 0 0 1\nTexture2D 5 16 16\nRenderToTexture 5\nBackground 0 1 0\nClear\nRenderToTexture\n"
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram Show uUnit 5\nQuadXY 0 .5\n");
    EXPECT_TRUE(near(picture.center(), green));
    EXPECT_TRUE(near(picture.at(2, 2), blue));
}

TEST_F(Passes, EachTargetHasItsOwnDepth) {
    const Picture picture = draw(
        "Texture2D 5 16 16\nOrtho -1 1 -1 1\nRenderToTexture 5\nColor 1 0 0\nQuadXY .9 1\nRenderToTexture\n" +
        std::string("Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram Show uUnit 5\nQuadXY -.9 1\n"));
    EXPECT_TRUE(near(picture.center(), red));
}

TEST_F(Passes, ReadingTheTargetIsAnErrorThatNamesBothStatements) {
    auto document = open(
        "Texture2D 5 16 16\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram Show uUnit 5\n"
        "RenderToTexture 5\nQuadXY\nRenderToTexture\nQuadXY\n");
    ASSERT_TRUE(document->diagnostics.has_errors());
    const Diagnostic& error = document->diagnostics.items().front();
    EXPECT_EQ(document->sources.position(error.span.file, error.span.begin).line, 7);
    ASSERT_FALSE(error.notes.empty());
    EXPECT_EQ(document->sources.position(error.notes[0].span.file, error.notes[0].span.begin).line, 6);
    draw(*document);
}

TEST_F(Passes, AnUnreadPassIsNotDrawn) {
    auto document =
        open("Texture2D 5 16 16\nOrtho -1 1 -1 1\nRenderToTexture 5\nQuadXY\nRenderToTexture\nColor 1 0 0\nQuadXY\n");
    EXPECT_TRUE(near(draw(*document).center(), red));
    EXPECT_TRUE(has(*document, "unread-pass"));
    EXPECT_EQ(document->runtime->counters().draws, 1U);
}

// Six small quads of different colours around the centre; a box that shows the cube map by its own position
// must show each colour in that direction.
TEST_F(Passes, ACubeThatWasRenderedToShowsEachDirection) {
    std::string scene = "CubeMap 7 32\nRenderToCube 7 0 0 0\n";
    const std::array<std::pair<const char*, const char*>, 6> walls{{{"1 0 0", "QuadYZ 5 5"},
                                                                    {"0 1 0", "QuadYZ -5 5"},
                                                                    {"0 0 1", "QuadXZ 5 5"},
                                                                    {"1 1 0", "QuadXZ -5 5"},
                                                                    {"0 1 1", "QuadXY 5 5"},
                                                                    {"1 0 1", "QuadXY -5 5"}}};
    for (const auto& [color, wall] : walls) scene += std::string("Color ") + color + "\n" + wall + "\n";
    scene += "RenderToTexture\nVertex cube.vert\nFragment cube.frag\nProgram Show uCube 7\nPerspective 90\n";
    const std::array<std::pair<const char*, Pixel>, 6> looks{{{"1 0 0 0 1 0", red},
                                                              {"-1 0 0 0 1 0", green},
                                                              {"0 1 0 0 0 1", blue},
                                                              {"0 -1 0 0 0 1", {255, 255, 0, 255}},
                                                              {"0 0 1 0 1 0", {0, 255, 255, 255}},
                                                              {"0 0 -1 0 1 0", {255, 0, 255, 255}}}};
    for (const auto& [look, color] : looks) {
        auto document = open(scene + "LookAt 0 0 0 " + look + "\nBox 4 4 4\n");
        expect_clean(*document);
        const Picture picture = draw(*document);
        EXPECT_TRUE(near(picture.center(), color)) << look;
        EXPECT_GT(picture.count(color), 64 * 64 * 9 / 10) << look;
        // Nothing moved: the second frame draws the box alone.
        const std::uint64_t before = document->runtime->counters().draws;
        EXPECT_TRUE(draw(*document) == picture);
        EXPECT_EQ(document->runtime->counters().draws - before, 1U);
    }
}

// Half of the +X wall is another colour: up in the world must be up on the cube's face.
TEST_F(Passes, ACubeThatWasRenderedToIsNotMirrored) {
    const std::string scene =
        "CubeMap 7 64\nRenderToCube 7\nColor 1 0 0\nQuadYZ 5 5\nColor 0 1 0\nTranslate 0 5 5\nQuadYZ 4.9 5\n"
        "Translate 0 -5 -5\nRenderToTexture\nVertex cube.vert\nFragment cube.frag\nProgram Show uCube 7\n"
        "Perspective 80\nLookAt 0 0 0 1 0 0 0 1 0\nBox 4 4 4\n";
    const Picture picture = draw(scene);
    // Looking along +X with Y up, +Z is to the right.
    EXPECT_TRUE(near(picture.at(48, 16), green));
    EXPECT_TRUE(near(picture.at(16, 16), red));
    EXPECT_TRUE(near(picture.at(48, 48), red));
}

}  // namespace
}  // namespace snell::test
