// Further sentences of the language, each as a picture.
#include "src/content/image/image.h"
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

class Language : public PlainTest {
protected:
    void SetUp() override {
        PlainTest::SetUp();
        folder.write("cube.vert",
                     "out vec3 d;\nvoid main() { d = gl_Vertex.xyz; gl_Position = gl_ModelViewProjectionMatrix * "
                     "gl_Vertex; }\n");
        folder.write("cube.frag",
                     "uniform samplerCube uCube;\nin vec3 d;\nvoid main() { gl_FragColor = texture(uCube, d); }\n");
    }
    static constexpr std::string_view square = "Ortho -1 1 -1 1\nBackground 0 0 0\n";
};

TEST_F(Language, AGeometryShaderThatTakesOtherPrimitivesIsAnError) {
    folder.write(
        "lines.geom",
        "#version 330 compatibility\nlayout(lines) in;\nlayout(line_strip, max_vertices = 2) out;\nvoid main() "
        "{ for (int i = 0; i < 2; i++) { gl_Position = gl_in[i].gl_Position; EmitVertex(); } EndPrimitive(); }\n");
    folder.write("one.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    auto document = open(
        "Vertex plain.vert\nGeometry lines.geom\nFragment one.frag\nProgram L\nSphere\nGeometry\nFragment one.frag\n"
        "Program M\nOrtho -1 1 -1 1\nQuadXY\n");
    EXPECT_TRUE(has(*document, "geometry-input"));
    EXPECT_TRUE(near(draw(*document).center(), white));  // the stage is unset: M draws
}

TEST_F(Language, PatchesNeedTessellation) {
    auto document =
        open("NumPatchVertices 3\nglBegin gl_patches\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 0 1 0\nglEnd\n");
    EXPECT_TRUE(has(*document, "patches-without-tessellation"));
    draw(*document);
}

TEST_F(Language, ASolidMayBeTessellated) {
    folder.write("p.vert", "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n");
    folder.write(
        "p.tcs",
        "#version 400 compatibility\nlayout(vertices = 3) out;\nvoid main() { gl_out[gl_InvocationID].gl_Position "
        "= gl_in[gl_InvocationID].gl_Position; gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = "
        "gl_TessLevelOuter[2] = gl_TessLevelInner[0] = 2.; }\n");
    folder.write("p.tes",
                 "#version 400 compatibility\nlayout(triangles) in;\nvoid main() { gl_Position = "
                 "gl_ModelViewProjectionMatrix * (gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * "
                 "gl_in[1].gl_Position + gl_TessCoord.z * gl_in[2].gl_Position); }\n");
    folder.write("one.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    const Picture picture =
        draw(std::string(square) +
             "Vertex p.vert\nTessControl p.tcs\nTessEvaluation p.tes\nFragment one.frag\nProgram T\nQuadXY 0 .5\n");
    EXPECT_EQ(picture.count(white), 32 * 32);
}

TEST_F(Language, TheUnitsOfSamplersMayBeWrittenInAnyWay) {
    folder.write("red.bmp", bmp(1, 1, {{255, 0, 0}}));
    folder.write("green.bmp", bmp(1, 1, {{0, 255, 0}}));
    folder.write(
        "two.frag",
        "#version 330 compatibility\nuniform sampler2D uTex[2];\nin vec2 vST;\nvoid main() { gl_FragColor = vST.s "
        "< .5 ? texture(uTex[0], vST) : texture(uTex[1], vST); }\n");
    const std::string start = std::string(square) + "Texture2D 5 red.bmp\nTexture2D 6 green.bmp\nVertex plain.vert\n";
    EXPECT_TRUE(near(draw(start + "Fragment texture.frag\nProgram T uUnit <0 6 9>\nQuadXY\n").center(), green));
    for (const char* units : {"uTex [5 6]", "uTex[0] 5 uTex[1] 6"}) {
        const Picture picture = draw(start + "Fragment two.frag\nProgram T " + units + "\nQuadXY\n");
        EXPECT_TRUE(near(picture.at(16, 32), red)) << units;
        EXPECT_TRUE(near(picture.at(48, 32), green)) << units;
    }
}

// Drivers say that an array ends with the last element that is read.
TEST_F(Language, AnArrayHasItsDeclaredSize) {
    const std::string scene = std::string(square) + "Vertex plain.vert\nFragment few.frag\nProgram T ";
    folder.write("few.frag",
                 "#version 330 compatibility\nuniform float uGain[4];\nuniform vec3 uColors[2];\nin vec2 vST;\n"
                 "void main() { gl_FragColor = vec4(uColors[0].r, uGain[0], uGain[1], 1.); }\n");
    for (const char* values : {"uGain [.2 1. 0. 0.] uColors [1. 0. 0. 0. 1. 0.]",
                               "uColors[0] {1. 0. 0.} uColors[1] {0. 1. 0.} uGain [.2 1. 0. 0.]",
                               "uGain[3] .1 uGain[0] .2 uGain[1] 1. uColors [1. 0. 0. 0. 1. 0.]"}) {
        auto document = open(scene + values + "\nQuadXY\n");
        EXPECT_TRUE(document->diagnostics.items().empty()) << render(document->diagnostics, document->sources);
        EXPECT_TRUE(near(draw(*document).center(), {255, 51, 255, 255})) << values;
    }
    auto document = open(scene + "uGain [.2 1. 0. 0.]\nQuadXY\n");
    EXPECT_TRUE(
        near(draw(*document, {.sets = {"uGain=.4 .6 1 1", "uColors=1 0 0 0 0 1"}}).center(), {255, 102, 153, 255}));
}

// As for glman, which asks OpenGL for the name "uGain[1]".
TEST_F(Language, ElementsOfArraysHaveSliders) {
    folder.write("few.frag",
                 "#version 330 compatibility\nuniform float uGain[4];\nin vec2 vST;\n"
                 "void main() { gl_FragColor = vec4(uGain[0], uGain[1], uGain[2], 1.); }\n");
    auto document = open(std::string(square) +
                         "Vertex plain.vert\nFragment few.frag\n"
                         "Program T uGain[0] <0. .2 1.> uGain[1] <0. .4 2.> uGain[3] <0. .1 1.>\nQuadXY\n");
    EXPECT_TRUE(document->diagnostics.items().empty()) << render(document->diagnostics, document->sources);
    const Control* second = document->controls.find(0, "uGain[1]");
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(second->widget, Widget::slider);
    EXPECT_EQ(second->max, 2);
    EXPECT_EQ(second->array_size, 1);
    EXPECT_TRUE(near(draw(*document).center(), {51, 102, 0, 255}));
    EXPECT_TRUE(near(draw(*document, {.sets = {"uGain[1]=.6", "uGain[2]=.8"}}).center(), {51, 153, 204, 255}));
    EXPECT_TRUE(near(draw(*document, {.sets = {"uGain=1 .8 .6 .4"}}).center(), {255, 204, 153, 255}));
    const std::string line = std::string(square) + "Vertex plain.vert\nFragment few.frag\nProgram T ";
    auto both = open(line + "uGain [.2 .4 0. 0.] uGain[1] <0. .6 1.>\nQuadXY\n");
    EXPECT_TRUE(has(*both, "element-without-slider"));
    EXPECT_TRUE(near(draw(*both).center(), {51, 153, 0, 255}));
    EXPECT_TRUE(near(draw(*both, {.sets = {"uGain[0]=1"}}).center(), {255, 153, 0, 255}));
    auto beyond = open(line + "uGain[4] <0. .6 1.>\nQuadXY\n");
    EXPECT_NE(render(beyond->diagnostics, beyond->sources).find("'uGain' is a float[4], which has no '[4]'"),
              std::string::npos);
}

TEST_F(Language, MembersOfArraysOfStructuresHaveValues) {
    folder.write("members.frag",
                 "#version 330 compatibility\nstruct Light { vec3 color; float gain; };\nuniform Light uLights[2];\n"
                 "in vec2 vST;\nvoid main() { gl_FragColor = vec4(uLights[0].color * uLights[1].gain, 1.); }\n");
    auto document = open(std::string(square) +
                         "Vertex plain.vert\nFragment members.frag\n"
                         "Program T uLights[0].color {1. .5 0.} uLights[1].gain <0. .4 1.>\nQuadXY\n");
    EXPECT_TRUE(document->diagnostics.items().empty()) << render(document->diagnostics, document->sources);
    EXPECT_TRUE(near(draw(*document).center(), {102, 51, 0, 255}));
    EXPECT_TRUE(near(draw(*document, {.sets = {"uLights[1].gain=.8"}}).center(), {204, 102, 0, 255}));
}

TEST_F(Language, AMissingImageIsACheckerboardAndAnError) {
    auto document = open(std::string(square) +
                         "Texture2D 6 none.bmp\nVertex plain.vert\nFragment texture.frag\nProgram T uUnit 6\nQuadXY\n");
    EXPECT_TRUE(has(*document, "file-not-found"));
    const Picture picture = draw(*document);
    EXPECT_GT(picture.count({255, 0, 255, 255}, 60), 64 * 64 / 4);
}

TEST_F(Language, APanoramaIsACubeMap) {
    // Columns: the left half of an equirectangular picture shows -X, the right half +X; its centre is -Z.
    std::vector<std::array<int, 3>> pixels;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            pixels.push_back(x < 32 ? std::array<int, 3>{255, 0, 0} : std::array<int, 3>{0, 255, 0});
    folder.write("pano.bmp", bmp(64, 32, pixels));
    const std::string scene =
        "CubeMap 6 pano.bmp\nVertex cube.vert\nFragment cube.frag\nProgram C uCube 6\nPerspective 60\nLookAt 0 0 0 ";
    EXPECT_TRUE(near(draw(scene + "-1 0 0 0 1 0\nBox 4 4 4\n").center(), red));
    EXPECT_TRUE(near(draw(scene + "1 0 0 0 1 0\nBox 4 4 4\n").center(), green));
}

TEST_F(Language, AnIncludedSceneStandsWhereItIsNamed) {
    folder.write("parts/red.glib", "Color 1 0 0\nInclude green.glib\nQuadXY .1 .5\n");
    folder.write("parts/green.glib", "Translate .5 0 0\n");
    const Picture picture = draw(std::string(square) + "Include parts/red.glib\n");
    EXPECT_TRUE(near(picture.at(48, 32), red));
    EXPECT_FALSE(near(picture.at(10, 32), red));
}

// Wherever the include stands, and whatever its file has on the same lines.
TEST_F(Language, ErrorsInIncludedFilesStandThere) {
    struct Case {
        const char *included, *error;
    };
    for (const Case& c :
         {Case{"// a\nfloat f(float x)\n{\n float y = x*undefd;\n return y; }\n", ":4:14: error: 'undefd' is not"},
          Case{"float f(float x)\n{\n return x*undefd; }\n", ":3:11: error: 'undefd' is not"},
          Case{"float f(float x) {\n vec3 y = vec2(x);\n return x; }\n", ":2:11: error: a 'vec2' cannot"},
          Case{"\nfloat f(float x) {\n if (x > .5) return normalise(x);\n return x; }\n",
               ":3:21: error: there is no function 'normalise'"},
          Case{"float f(float x)\n{ return vec2(x).z; }\n", ":2:18: error: '.z' asks"},
          Case{"float f(float x) { return x }\n", ":1:29: error: unexpected '}'"}})
        for (const char* before :
             {"", "// 1\n\nuniform float uA;\n", "uniform float uA; float g(float x) {\n return x; }\n"}) {
            SCOPED_TRACE(std::string(before) + c.included);
            folder.write("part.glsl", c.included);
            folder.write("whole.frag", std::string("#version 330 compatibility\n") + before +
                                           "#include \"part.glsl\"\nvoid main() { gl_FragColor = vec4(f(1.)); }\n");
            auto document = open("Vertex plain.vert\nFragment whole.frag\nProgram P\nQuadXY\n");
            draw(*document);
            const std::string all = render(document->diagnostics, document->sources);
            EXPECT_EQ(document->diagnostics.errors(), 1U) << all;
            EXPECT_TRUE(all.starts_with(folder.path("part.glsl") + c.error)) << all;
            complaints.clear();  // the driver's own words
        }
}

TEST_F(Language, ColoursOfVerticesAndOfDraws) {
    EXPECT_TRUE(near(draw(std::string(square) + "Color [0. 1. 0.]\nQuadXY\n").center(), green));
    const Picture picture = draw(
        std::string(square) +
        "Color 0 1 0\nglBegin gl_triangles\nglColor 1 0 0\nglVertex -3 -1 0\nglVertex 3 -1 0\nglVertex 0 5 0\nglEnd\n");
    EXPECT_TRUE(near(picture.center(), red));
}

TEST_F(Language, TheNoiseOfTheSceneIsItsFileWhereThereIsOne) {
    std::string tex("\x02\0\0\0\x02\0\0\0", 8);
    for (int i = 0; i < 4; ++i) tex += std::string("\0\0\xff\xff", 4);
    folder.write("noise2d.002.tex", tex);
    folder.write("noise.frag",
                 "uniform sampler2D Noise2;\nvoid main() { gl_FragColor = texture(Noise2, vec2(.3)); }\n");
    const std::string program = "Blend off\nVertex plain.vert\nFragment noise.frag\nProgram N\nQuadXY\n";
    EXPECT_TRUE(near(draw(std::string(square) + "Noise2D 2\n" + program).center(), blue));
    EXPECT_TRUE(near(draw(std::string(square) + program).center(), {127, 127, 127, 255}, 60));
    // A texture of the scene's own on that unit wins.
    folder.write("red.bmp", bmp(1, 1, {{255, 0, 0}}));
    EXPECT_TRUE(near(draw(std::string(square) + "Texture2D 2 red.bmp\n" + program).center(), red));
}

TEST_F(Language, TheSoccerballTellsItsFaces) {
    folder.write(
        "face.frag",
        "uniform int FaceIndex;\nvoid main() { gl_FragColor = FaceIndex < 12 ? vec4(0., 0., 1., 1.) : vec4(1.); }\n");
    auto document = open(
        "Background 0 0 0\nOrtho -1 1 -1 1\nLookAt 0 0 5 0 0 0 0 1 0\nVertex plain.vert\nFragment face.frag\nProgram "
        "F\nSoccerball\n");
    expect_clean(*document);
    const Picture picture = draw(*document, {.width = 256, .height = 256});
    EXPECT_EQ(document->runtime->counters().draws, 32U);
    const double covered = picture.count(white) + picture.count(blue);
    // Twelve pentagons cover 28.6 % of the ball; of a disc seen from one side somewhat more or less.
    EXPECT_NEAR(picture.count(blue) / covered, .286, .1);
}

TEST_F(Language, ScaleZeroAndMirrorsDrawNothingWrong) {
    folder.write("n.vert",
                 "out vec3 n;\nvoid main() { n = gl_NormalMatrix * gl_Normal; gl_Position = "
                 "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("n.frag",
                 "in vec3 n;\nvoid main() { gl_FragColor = vec4(normalize(n).z > .9 ? 1. : 0., any(isnan(n)) ? 1. : "
                 "0., gl_FrontFacing ? 1. : 0., 1.); }\n");
    const std::string scene =
        std::string(square) + "LookAt 0 0 5 0 0 0 0 1 0\nVertex n.vert\nFragment n.frag\nProgram N\n";
    EXPECT_TRUE(near(draw(scene + "Sphere\n").center(), {255, 0, 255, 255}));
    // Mirrored: normals stay outward.
    EXPECT_EQ(draw(scene + "Scale -1 1 1\nSphere\n").center()[0], 255);
    EXPECT_EQ(draw(scene + "Scale 1e-20\nScale 1e20\nSphere\n").center()[0], 255);
    for (const char* scale : {"Scale 0", "Scale 1 1 0", "Scale 1e-30", "Scale 1 0 1"}) {
        auto document = open(scene + scale + "\nSphere\n");
        EXPECT_EQ(draw(*document).count({0, 255, 0, 255}), 0) << scale;
    }
}

TEST_F(Language, AProgramWithoutAFragmentShaderShowsItsColour) {
    const Picture picture = draw(std::string(square) + "Color 0 1 0\nVertex plain.vert\nProgram V\nQuadXY\n");
    EXPECT_TRUE(near(picture.center(), green));
}

// The names of snell mean single values; an array of that name is the scene's mistake, and reads as zero.
TEST_F(Language, ArraysWhereSnellHasOneValueAreZero) {
    folder.write("array.frag",
                 "uniform float uTime[2];\nuniform mat4 uModelMatrix[2];\n"
                 "void main() { gl_FragColor = vec4(uTime[0], uModelMatrix[1][0][0] + uTime[1], 1., 1.); }\n");
    const std::string scene = std::string(square) + "Vertex plain.vert\nFragment array.frag\nProgram P\nQuadXY\n";
    EXPECT_EQ(draw(scene, {.time = 1}).center(), blue);
}

TEST_F(Language, MatricesOfEveryShapeGetTheirNumbersColumnByColumn) {
    for (int columns = 2; columns <= 4; ++columns)
        for (int rows = 2; rows <= 4; ++rows) {
            const std::string c = std::to_string(columns), r = std::to_string(rows);
            const std::string type = "mat" + c + (columns == rows ? "" : "x" + r);
            folder.write("m.frag",
                         "#version 330\nuniform " + type +
                             " uM;\nout vec4 color;\nvoid main() {\n    bool good = true;\n    for (int c = 0; c < " +
                             c + "; ++c) for (int r = 0; r < " + r + "; ++r) good = good && uM[c][r] == float(c * " +
                             r + " + r + 1);\n    color = good ? vec4(0., 1., 0., 1.) : vec4(1., 0., 0., 1.);\n}\n");
            std::string numbers;
            for (int i = 1; i <= columns * rows; ++i) numbers += std::to_string(i) + ". ";
            EXPECT_EQ(draw(std::string(square) + "Vertex plain.vert\nFragment m.frag\nProgram P uM [" + numbers +
                           "]\nQuadXY\n")
                          .center(),
                      green)
                << type;
        }
}

// Where they are not, the translator takes them for the built-in ones: GlslGstap.
TEST_F(Language, NamesOfGstapMayBeDeclared) {
    const std::string main = "void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n";
    folder.write("one.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    folder.write("bare.vert", main);
    folder.write("declared.vert", "uniform mat4 uModelViewProjectionMatrix;\nattribute vec4 aVertex;\n" + main);
    const auto seen = [&](const std::string& vertex) {
        return draw("Perspective 60\nLookAt 0 .5 4 0 0 0 0 1 0\nVertex " + vertex +
                    "\nFragment one.frag\nProgram P\nTeapot\n");
    };
    const Picture bare = seen("bare.vert");
    EXPECT_GT(bare.count(white), 60);
    EXPECT_TRUE(seen("declared.vert") == bare);
}

TEST_F(Language, ProgramWithoutArgumentsIsTheBuiltInOne) {
    const Picture picture =
        draw(std::string(square) +
             "Vertex plain.vert\nFragment color.frag\nProgram C uColor [1. 0. 0. 1.]\nColor 0 0 1\nProgram\nQuadXY\n");
    EXPECT_TRUE(near(picture.center(), blue));
}

TEST_F(Language, LoopsThatAUniformBoundsAreLongForLargeValues) {
    folder.write("rounds.frag",
                 "uniform int uN, uColor;\nvoid main() { float x = 0.; for (int i = 0; i < uN; ++i) x += .1; "
                 "gl_FragColor = vec4(x, float(uColor), 0., 1.); }\n");
    auto document = open("Vertex plain.vert\nFragment rounds.frag\nProgram P uN 5 uColor 100000\nQuadXY\n");
    ASSERT_TRUE(document->runtime);
    double& rounds = document->controls.find(0, "uN")->value[0];
    const auto with = [&](double value) {
        rounds = value;
        return document->runtime->long_loops(document->controls);
    };
    EXPECT_TRUE(document->runtime->may_have_long_loops());
    EXPECT_EQ(with(5), 0);
    EXPECT_EQ(with(256), 0);
    EXPECT_EQ(with(512), 2);
    EXPECT_EQ(with(-512), 2);
    EXPECT_EQ(with(std::nan("")), 1);
    with(5000);
    document->runtime->shorten_loops(document->controls, 3);
    EXPECT_EQ(rounds, 768);
    EXPECT_EQ(document->controls.find(0, "uColor")->value[0], 100000);
}

}  // namespace
}  // namespace snell::test
