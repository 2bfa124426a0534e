// What the user's view does to the picture.
#include "src/plan/view.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Viewed : public GlTest {
protected:
    const std::string quads =
        "Perspective 50\nLookAt 0 0 4 0 0 0 0 1 0\nBackground 0 0 1\nColor 1 0 0\nPushMatrix\nTranslate -.8 0 0\nScale "
        ".1\n"
        "QuadXY 0. 4.\nPopMatrix\nColor 0 1 0\nTranslate .8 0 0\nQuadXY 0. .4\n";
    const Pixel red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255};
};

TEST_F(Viewed, TheBackgroundIsTheScenesUntilItIsChosen) {
    auto document = open(quads);
    EXPECT_EQ(draw(*document).at(2, 2), blue);
    Look look;
    look.view.background = .5;
    const Pixel dim = draw(*document, look).at(2, 2);
    const auto color = background_of(.5);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(dim[i], 255 * color[i], 1);
}

TEST_F(Viewed, AnObjectMovesAndTurnsAlone) {
    auto document = open(quads);
    const Picture before = draw(*document, {256, 256});
    // 256 pixels show 2 * 4 * tan(25 degrees) = 3.730 units.
    const double unit = 256 / 3.730;
    Look look{256, 256};
    look.view.objects[0].y = .5;
    const Picture moved = draw(*document, look);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            if (before.at(x, y) == green) {
                ASSERT_EQ(moved.at(x, y), green);
            }
    EXPECT_NEAR(moved.count(red), before.count(red), 60) << "whatever Scale it stands under";
    const auto center = [&](const Picture& picture, const Pixel& color) {
        double sum = 0, count = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                if (picture.at(x, y) == color) sum += y, ++count;
        return sum / count;
    };
    EXPECT_NEAR(center(before, red) - center(moved, red), .5 * unit, .6);
    look.view.projection = Projection::ortho;  // which keeps the size of what is at the origin
    look.view.objects[0] = {};
    look.view.objects[0].rotate_y = 60;
    const double thinner = static_cast<double>(draw(*document, look).count(red)) / before.count(red);
    EXPECT_NEAR(thinner, .5, .03) << "cos 60";
    look.view.objects[0].rotate_y = 0;
    look.view.objects[0].rotate_z = 90;
    EXPECT_NEAR(draw(*document, look).count(red), before.count(red), 60) << "a square turned in its plane";
}

// Coarse pictures are enlarged: at a quarter of the size, a line of a pixel is four pixels wide.
TEST_F(Viewed, AxesAreNoThickerInCoarsePictures) {
    auto document = open("Perspective 50\nLookAt 2 2 4 0 0 0 0 1 0\nBackground 0 0 0\nColor 0 0 0\nQuadXY -9. .1\n");
    const auto covered = [&](int divide) {
        Look look{512 / divide, 512 / divide};
        look.enlarged = divide;
        look.view.axes = true;
        const Picture picture = draw(*document, look);
        return divide * divide * (picture.width * picture.height - picture.count({0, 0, 0, 255}, 60));
    };
    const double fine = covered(1);
    EXPECT_GT(fine, 500);
    EXPECT_NEAR(covered(2) / fine, 1.2, .2) << "widths are whole";
    EXPECT_NEAR(covered(4) / fine, 1.33, .2) << "a line has at least one pixel";
}

TEST_F(Viewed, AxesAreReadableOnAnyBackground) {
    for (const char* background : {"0", ".5", "1"})
        for (const int divide : {1, 2, 4}) {
            const std::string gray = std::string(" ") + background + " " + background + " " + background;
            auto document = open("Perspective 50\nLookAt 2 2 4 0 0 0 0 1 0\nBackground" + gray + "\nColor" + gray +
                                 "\nQuadXY -9. .1\n");
            Look look{512 / divide, 512 / divide};
            look.enlarged = divide;
            look.view.axes = true;
            const Picture picture = draw(*document, look);
            const double level = std::stod(background), most = picture.width * picture.height;
            const auto other = [&](unsigned char shade) {
                return picture.count({shade, shade, shade, 255}, 60) / most;
            };
            // What differs by half of all levels from the background.
            const double seen = (level < .75 ? other(255) : 0) + (level > .25 ? other(0) : 0);
            EXPECT_GT(seen, .004) << background << ", 1 / " << divide;
        }
}

TEST_F(Viewed, TheOtherProjectionKeepsThePlaneOfTheOrigin) {
    auto document = open(quads);
    Look look{128, 128};
    const Picture before = draw(*document, look);
    look.view.projection = Projection::ortho;
    EXPECT_TRUE(draw(*document, look) == before) << "all lies in that plane";
    look.view.axes = true;
    look.view.scene.rotate_x = 30;
    const Picture flat = draw(*document, look);
    look.view.projection = Projection::scene;
    EXPECT_FALSE(draw(*document, look) == flat);
    auto boxed = open("Ortho -2 2 -2 2\nBackground 0 0 1\nColor 1 0 0\nQuadXY 0. 1.\n");
    Look deep{128, 128};
    const Picture plain = draw(*boxed, deep);
    deep.view.projection = Projection::perspective;
    EXPECT_TRUE(draw(*boxed, deep) == plain);
    EXPECT_EQ(plain.count(red), 64 * 64);
}

TEST_F(Viewed, TheTextureTransformationIsTheTextureMatrixAndNothingElse) {
    folder.write("t.vert",
                 "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = (gl_TextureMatrix[0] * "
                 "gl_MultiTexCoord0).st; gl_Position = ftransform(); }\n");
    folder.write("t.frag",
                 "#version 330 compatibility\nin vec2 vST;\nvoid main() { gl_FragColor = vec4(vST, 0., 1.); }\n");
    auto document = open("Ortho -1 1 -1 1\nVertex t.vert\nFragment t.frag\nProgram T\nQuadXY 0. 1.\n");
    const auto at = [&](const Look& look) { return draw(*document, look).at(48, 16); };  // s = .758, t = .742
    EXPECT_NEAR(at({})[0], 255 * .758, 1);
    Look look;
    look.view.texture.x = -.25;
    look.view.texture.scale = .5;
    EXPECT_NEAR(at(look)[0], 255 * (.758 * .5 - .25), 1);
    EXPECT_NEAR(at(look)[1], 255 * .742 * .5, 1);
    look.view.texture = {};
    look.view.texture.rotate_z = 90;
    look.view.texture.x = 1;
    EXPECT_NEAR(at(look)[0], 255 * (1 - .742), 1);
    EXPECT_NEAR(at(look)[1], 255 * .758, 1);
}

}  // namespace
}  // namespace snell::test
