// Scenes are display lists: every draw has the state that stood at its statement.
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

const std::array<int, 3> red_rgb{255, 0, 0}, green_rgb{0, 255, 0}, blue_rgb{0, 0, 255}, white_rgb{255, 255, 255};

class DisplayList : public PlainTest {
protected:
    void SetUp() override {
        PlainTest::SetUp();
        folder.write("red.bmp", bmp(2, 2, {red_rgb, red_rgb, red_rgb, red_rgb}));
        folder.write("green.bmp", bmp(2, 2, {green_rgb, green_rgb, green_rgb, green_rgb}));
        folder.write("corners.bmp", bmp(2, 2, {red_rgb, green_rgb, blue_rgb, white_rgb}));
    }
};

TEST_F(DisplayList, AUnitThatIsReassignedChangesOnlyTheDrawsThatFollow) {
    const Picture picture = draw(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram T uUnit 6\nPushMatrix\n"
        "Texture2D 6 red.bmp\nTranslate -.5 0 0\nQuadXY 0 .4\nPopMatrix\n"
        "Texture2D 6 green.bmp\nTranslate .5 0 0\nQuadXY 0 .4\n");
    EXPECT_TRUE(near(picture.at(16, 32), red));
    EXPECT_TRUE(near(picture.at(48, 32), green));
}

TEST_F(DisplayList, AUnitThatIsBoundOnlyLaterReadsWhatTheNextRoundWouldFind) {
    const Picture picture = draw(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram T uUnit 6\nQuadXY\nTexture2D 6 "
        "green.bmp\n");
    EXPECT_TRUE(near(picture.center(), green));
}

TEST_F(DisplayList, TheImagesBottomRowIsAtTheTexturesBottom) {
    folder.write("corners4.bmp",
                 bmp(4, 4,
                     {red_rgb, red_rgb, green_rgb, green_rgb, red_rgb, red_rgb, green_rgb, green_rgb, blue_rgb,
                      blue_rgb, white_rgb, white_rgb, blue_rgb, blue_rgb, white_rgb, white_rgb}));
    const Picture picture = draw(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nTexture2D 6 corners4.bmp\nProgram T uUnit "
        "6\nQuadXY\n");
    EXPECT_TRUE(near(picture.at(20, 20), red));
    EXPECT_TRUE(near(picture.at(44, 20), green));
    EXPECT_TRUE(near(picture.at(20, 44), blue));
    EXPECT_TRUE(near(picture.at(44, 44), white));
}

TEST_F(DisplayList, OneUnitHoldsAPictureAndACubeMapAtOnce) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        folder.write(std::string(face) + ".bmp", bmp(2, 2, {blue_rgb, blue_rgb, blue_rgb, blue_rgb}));
    folder.write(
        "both.frag",
        "uniform sampler2D uFlat;\nuniform samplerCube uCube;\nin vec2 vST;\n"
        "void main() { gl_FragColor = vST.s < .5 ? texture(uFlat, vST) : texture(uCube, vec3(1., 0., 0.)); }\n");
    const Picture picture = draw(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment both.frag\nTexture2D 6 red.bmp\n"
        "CubeMap 6 px.bmp nx.bmp py.bmp ny.bmp pz.bmp nz.bmp\nProgram Both uFlat 6 uCube 6\nQuadXY\n");
    EXPECT_TRUE(near(picture.at(16, 32), red));
    EXPECT_TRUE(near(picture.at(48, 32), blue));
}

TEST_F(DisplayList, TransformationsConcatenateAndTheLastListedActsFirst) {
    const Picture picture =
        draw("Ortho -2 2 -2 2\nColor 1 0 0\nTranslate 1 0 0\nScale .25\nQuadXY\n", {.width = 80, .height = 80});
    // Scaled about its own centre, then moved: from .75 to 1.25 of -2..2.
    EXPECT_EQ(picture.count(red), 10 * 10);
    EXPECT_TRUE(near(picture.at(60, 40), red));
}

TEST_F(DisplayList, PerspectiveAndOrthoPutKnownPointsOnKnownPixels) {
    // At distance 2 with 90 degrees the picture is 4 units high: a square of side 2 covers its middle half.
    const Picture perspective =
        draw("Perspective 90\nLookAt 0 0 2 0 0 0 0 1 0\nColor 1 0 0\nQuadXY 0 1\n", {.width = 80, .height = 80});
    EXPECT_EQ(perspective.count(red), 40 * 40);
    const Picture ortho = draw("Ortho -4 4 -4 4\nColor 1 0 0\nQuadXY 0 1\n", {.width = 80, .height = 80});
    EXPECT_EQ(ortho.count(red), 20 * 20);
}

TEST_F(DisplayList, AWideWindowShowsMoreAtTheSidesAndNothingIsStretched) {
    const Picture wide = draw("Ortho -1 1 -1 1\nColor 1 0 0\nQuadXY 0 .5\n", {.width = 160, .height = 80});
    EXPECT_EQ(wide.count(red), 40 * 40);
    const Picture tall =
        draw("Perspective 90\nLookAt 0 0 2 0 0 0 0 1 0\nColor 1 0 0\nQuadXY 0 1\n", {.width = 80, .height = 120});
    EXPECT_EQ(tall.count(red), 40 * 40);
}

TEST_F(DisplayList, EachDrawUsesTheCameraThatStoodWhenItWasRead) {
    const Picture picture =
        draw("Color 1 0 0\nOrtho -4 4 -4 4\nQuadXY .1 1\nColor 0 1 0\nOrtho -1 1 -1 1\nQuadXY .2 .1\n",
             {.width = 80, .height = 80});
    EXPECT_EQ(picture.count(red) + picture.count(green), 20 * 20);
    EXPECT_EQ(picture.count(green), 8 * 8);
}

TEST_F(DisplayList, BlendingIsOnAndDepthIsTested) {
    const Picture blended = draw("Ortho -1 1 -1 1\nBackground 0 0 0\nColor 1 0 0 .5\nQuadXY\n");
    EXPECT_TRUE(near(blended.center(), {128, 0, 0, 255}));
    const Picture opaque = draw("Ortho -1 1 -1 1\nBackground 0 0 0\nBlend off\nColor 1 0 0 .5\nQuadXY\n");
    EXPECT_TRUE(near(opaque.center(), red));
    const Picture hidden = draw("Ortho -1 1 -1 1\nColor 1 0 0\nQuadXY .5 1\nColor 0 1 0\nQuadXY -.5 1\n");
    EXPECT_TRUE(near(hidden.center(), red));
    const Picture untested =
        draw("Ortho -1 1 -1 1\nColor 1 0 0\nQuadXY .5 1\nDepthTest off\nColor 0 1 0\nQuadXY -.5 1\n");
    EXPECT_TRUE(near(untested.center(), green));
}

TEST_F(DisplayList, TwoProgramsKeepTheirOwnValuesOfOneName) {
    const Picture picture = draw(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment color.frag\nProgram A uColor [1. 0. 0. 1.]\nTranslate -.5 0 0\n"
        "QuadXY 0 .4\nProgram B uColor [0. 1. 0. 1.]\nTranslate 1 0 0\nQuadXY 0 .4\n");
    EXPECT_TRUE(near(picture.at(16, 32), red));
    EXPECT_TRUE(near(picture.at(48, 32), green));
}

TEST_F(DisplayList, TheBackgroundClearsAndDefaultsToGlmans) {
    EXPECT_TRUE(near(draw("Ortho\n").center(), {18, 27, 33, 255}));
    EXPECT_TRUE(near(draw("Background 2 .5 -1\n").center(), {255, 128, 0, 255}));
}

}  // namespace
}  // namespace snell::test
