// tests/cases: one scene for each command, each drawn, and facts about what it shows.
#include "parser/commands/commands.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

const Pixel white{255, 255, 255, 255}, black{0, 0, 0, 255};

class Cases : public GlTest {
protected:
    static std::string file(std::string_view command) {
        return SNELL_ROOT "/tests/cases/" + std::string(command) + ".glib";
    }
    Picture picture_of(std::string_view command, const Look& look = {.width = 128, .height = 128}) {
        auto document = open_file(file(command));
        expect_clean(*document);
        return draw(*document, look);
    }
    // Rows of the column in which the pixel is not the background.
    static int covered_rows(const Picture& picture, int x, int from, int to) {
        int rows = 0;
        for (int y = from; y < to; ++y) rows += !near(picture.at(x, y), picture.at(1, 1));
        return rows;
    }
};

TEST_F(Cases, EveryCommandHasOneThatShowsSomething) {
    for (const Command& row : commands()) {
        SCOPED_TRACE(row.name);
        ASSERT_TRUE(std::filesystem::exists(file(row.name))) << "no case for " << row.name;
        const Picture picture = picture_of(row.name);
        EXPECT_LT(picture.count(picture.at(1, 1)), 128 * 128 - 60);
    }
}

TEST_F(Cases, EveryCaseIsOfACommand) {
    std::set<std::string> names;
    for (const Command& row : commands()) names.insert(std::string(row.name));
    for (const auto& entry : std::filesystem::directory_iterator(SNELL_ROOT "/tests/cases")) {
        if (entry.path().extension() != ".glib") continue;
        EXPECT_TRUE(names.contains(entry.path().stem().string())) << entry.path();
    }
}

TEST_F(Cases, LinesAreAsWideAsTheySay) {
    const Picture picture = picture_of("LineWidth", {.width = 300, .height = 300});
    EXPECT_EQ(covered_rows(picture, 150, 0, 100), 12);
    EXPECT_EQ(covered_rows(picture, 150, 100, 200), 5);
    EXPECT_EQ(covered_rows(picture, 150, 200, 300), 1);
}

TEST_F(Cases, PointsAreAsLargeAsTheySay) {
    const Picture picture =
        draw("Ortho -1 1 -1 1\nBackground 0 0 0\nPointSize 9\nglBegin gl_points\nglVertex .01 .01 0\nglEnd\n");
    EXPECT_EQ(picture.count(white), 81);
    folder.write("p.vert",
                 "void main() { gl_PointSize = 5.; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("p.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    const std::string scene =
        "Ortho -1 1 -1 1\nBackground 0 0 0\nPointSize 9\nVertex p.vert\nFragment p.frag\nProgram P\n";
    const std::string point = "glBegin gl_points\nglVertex .01 .01 0\nglEnd\n";
    EXPECT_EQ(draw(scene + "PointSizeMode 1\n" + point).count(white), 25);
    EXPECT_EQ(draw(scene + "PointSizeMode 0\n" + point).count(white), 81);
}

TEST_F(Cases, FlatTakesOneColourATriangleAndSmoothBlendsThem) {
    const Picture flat = picture_of("Flat"), smooth = picture_of("Smooth");
    std::set<Pixel> flat_colors, smooth_colors;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            flat_colors.insert(flat.at(x, y));
            smooth_colors.insert(smooth.at(x, y));
        }
    EXPECT_EQ(flat_colors.size(), 3U);  // two triangles and the background
    EXPECT_GT(smooth_colors.size(), 100U);
}

TEST_F(Cases, ClampRepeatsTheEdgeAndNearestHasNoSteps) {
    const Picture clamped = picture_of("Clamp", {.width = 192, .height = 192});
    // Left of the letter everything is the left edge's colour of that row.
    EXPECT_TRUE(near(clamped.at(40, 96), clamped.at(60, 96)));
    const Picture nearest = picture_of("Filter", {.width = 192, .height = 192});
    std::set<Pixel> colors;
    for (int x = 40; x < 152; ++x) colors.insert(nearest.at(x, 96));
    EXPECT_LE(colors.size(), 14U);  // 12.8 texels across
}

TEST_F(Cases, WireframeDrawsEdgesOnly) {
    const std::string ball = "Background 0 0 0\nOrtho -1.2 1.2 -1.2 1.2\nLookAt 0 0 5 0 0 0 0 1 0\n";
    const int wires = draw(ball + "Wireframe on\nSphere 1 8 4\n", {.width = 256, .height = 256}).count(white);
    const int solid = draw(ball + "Sphere 1 8 4\n", {.width = 256, .height = 256}).count(white);
    EXPECT_LT(wires, solid / 5);
    EXPECT_GT(wires, solid / 50);
}

TEST_F(Cases, TheTimerSweeps) {
    for (double time : {1.0, 3.0}) {
        const Picture picture = picture_of("Timer", {.width = 120, .height = 120, .time = time});
        // The quad is the middle two thirds; a quarter of it each second.
        const int edge = 20 + static_cast<int>(80 * time / 4);
        EXPECT_FALSE(near(picture.at(edge - 2, 60), picture.at(edge + 2, 60), 20)) << time;
        EXPECT_TRUE(near(picture.at(22, 60), picture.at(edge - 2, 60))) << time;
    }
}

TEST_F(Cases, ClearLeavesOnlyWhatFollows) {
    const Picture cleared = picture_of("Clear");
    const Picture sphere = draw("Perspective 50\nLookAt 2.2 1.8 3.2  0 0 0  0 1 0\nVertex " SNELL_ROOT
                                "/tests/cases/shaders/lit.vert\nFragment " SNELL_ROOT
                                "/tests/cases/shaders/lit.frag\nProgram Lit\nColor .3 .6 .9\nSphere\n",
                                {.width = 128, .height = 128});
    EXPECT_TRUE(cleared == sphere);
}

TEST_F(Cases, DepthWriteOffLeavesNoTrace) {
    const Picture picture = picture_of("DepthWrite");
    const Pixel center = picture.center();
    EXPECT_GT(center[0], center[2]);  // the red sphere behind shows over the blue one
}

TEST_F(Cases, BlendOneOneAdds) {
    const Picture picture =
        draw("Ortho -1 1 -1 1\nBackground .1 .2 .3\nBlend one one\nColor .2 .2 .2\nQuadXY\nQuadXY .5\n");
    EXPECT_TRUE(near(picture.center(), {128, 153, 179, 255}));
}

TEST_F(Cases, CullFaceTakesFacesAway) {
    const std::string scene = "Ortho -1 1 -1 1\nBackground 0 0 0\n";
    EXPECT_EQ(draw(scene + "CullFace back\nQuadXY 0 .5\n").count(white), 32 * 32);
    EXPECT_EQ(draw(scene + "CullFace front\nQuadXY 0 .5\n").count(white), 0);
    EXPECT_EQ(draw(scene + "CullFace back\nRotate 180 0 1 0\nQuadXY 0 .5\n").count(white), 0);
}

}  // namespace
}  // namespace snell::test
