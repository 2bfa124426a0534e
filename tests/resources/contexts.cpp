// The same scenes in the least and in other contexts: OpenGL 3.3, OpenGL ES, and one that draws no wide lines.
#include "parser/commands/commands.h"
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

class Context33 : public GlTest {
protected:
    Context33() { request.version = 33; }
};

class ContextEs : public GlTest {
protected:
    ContextEs() {
        request.version = 32;
        request.es = true;
    }
};

class NarrowLines : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        caps.max_line_width = 1;
    }
};

std::string case_file(std::string_view command) { return SNELL_ROOT "/tests/cases/" + std::string(command) + ".glib"; }

TEST_F(Context33, TheCasesLookTheSame) {
    std::string error;
    for (const Command& command : commands()) {
        SCOPED_TRACE(command.name);
        auto document = open_file(case_file(command.name));
        expect_clean(*document);
        const Picture here = draw(*document);
        EXPECT_LT(here.count(here.at(1, 1)), 64 * 64 - 10);
    }
}

// Where a point or a line ends is the driver's business; the rest of a picture is not.
TEST_F(ContextEs, TheCasesLookLikeThoseOfOpenGL) {
    std::vector<std::pair<std::string, Picture>> embedded;
    for (const Command& command : commands()) {
        SCOPED_TRACE(command.name);
        auto document = open_file(case_file(command.name));
        expect_clean(*document);
        if (has(*document, "wireframe-unsupported")) continue;
        embedded.emplace_back(command.name, draw(*document));
    }
    TearDown();
    context.reset();
    request = {};
    GlTest::SetUp();
    for (const auto& [name, picture] : embedded) {
        SCOPED_TRACE(name);
        const Picture desktop = draw(*open_file(case_file(name)));
        int far = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) far += !near(picture.at(x, y), desktop.at(x, y), 3);
        EXPECT_LE(far, 64 * 64 / 100);
    }
}

// The scene's size or the shader's: OpenGL ES cannot be told which.
TEST_F(ContextEs, PointsAreAsLargeAsTheirModeSays) {
    folder.write("p.vert",
                 "void main() { gl_PointSize = 5.; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("p.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    const std::string scene =
        "Ortho -1 1 -1 1\nBackground 0 0 0\nPointSize 9\nVertex p.vert\nFragment p.frag\nProgram P\n";
    const std::string point = "glBegin gl_points\nglVertex .01 .01 0\nglEnd\n";
    EXPECT_EQ(draw(scene + "PointSizeMode 1\n" + point).count(white), 25);
    EXPECT_EQ(draw(scene + "PointSizeMode 0\n" + point).count(white), 81);
    EXPECT_EQ(draw(scene + "PointSizeMode 0\n" + point + "PointSizeMode 1\n" + point).count(white), 81);
}

// OpenGL ES takes no initial values of uniforms: they are there all the same, unless the scene says otherwise.
TEST_F(ContextEs, UniformsHaveTheirInitialValues) {
    folder.write("u.frag",
                 "#version 330\nuniform vec3 uColor = vec3(0., 1., 0.);\nuniform float uScale[2] = float[2](.5, 1.);\n"
                 "uniform bool uOn = true;\nout vec4 c;\n"
                 "void main() { c = uOn ? vec4(uColor * uScale[1] + vec3(uScale[0], 0., 0.), 1.) : vec4(0.); }\n");
    const std::string scene = "Ortho -1 1 -1 1\nFragment u.frag\nProgram U";
    EXPECT_TRUE(near(draw(scene + "\nQuadXY\n").center(), {128, 255, 0, 255}));
    EXPECT_TRUE(near(draw(scene + " uColor {0. 0. 1.}\nQuadXY\n").center(), {128, 0, 255, 255}));
}

// No command fills a scene's own uniform blocks. They have a buffer all the same, because browsers draw nothing
// without.
TEST_F(ContextEs, BlocksOfUniformsReadZeros) {
    folder.write(
        "b.frag",
        "#version 300 es\nprecision highp float;\nlayout(std140) uniform Colors { vec4 uFirst[7]; vec4 uLast; };\n"
        "layout(std140) uniform More { float uMore; };\nout vec4 c;\n"
        "void main() { c = uFirst[3] + uLast + vec4(uMore, 1., 0., 1.); }\n");
    const std::string scene = "Ortho -1 1 -1 1\nFragment b.frag\nProgram B\nQuadXY\n";
    auto document = open(scene);
    EXPECT_TRUE(near(draw(*document).center(), {0, 255, 0, 255}));
    GLint buffer = 0, bytes = 0;
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &buffer);
    ASSERT_NE(buffer, 0);
    glBindBuffer(GL_UNIFORM_BUFFER, static_cast<GLuint>(buffer));
    glGetBufferParameteriv(GL_UNIFORM_BUFFER, GL_BUFFER_SIZE, &bytes);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    EXPECT_GE(bytes, 8 * 16);
}

// Bindings are words of OpenGL 4.2.
TEST_F(Context33, SamplersReadTheUnitsThatTheShaderNames) {
    folder.write("red.bmp", bmp(1, 1, {{255, 0, 0}}));
    folder.write("green.bmp", bmp(1, 1, {{0, 255, 0}}));
    folder.write("b.frag",
                 "#version 420\nlayout(binding = 6) uniform sampler2D uImage;\nout vec4 c;\n"
                 "void main() { c = texture(uImage, vec2(.5)); }\n");
    const std::string scene = "Ortho -1 1 -1 1\nTexture2D 5 red.bmp\nTexture2D 6 green.bmp\nFragment b.frag\nProgram B";
    EXPECT_TRUE(near(draw(scene + "\nQuadXY\n").center(), {0, 255, 0, 255}));
    EXPECT_TRUE(near(draw(scene + " uImage 5\nQuadXY\n").center(), {255, 0, 0, 255}));
}

// As OpenGL ES 3.0 and 3.1: nothing widens a line there, and that is said.
TEST_F(NarrowLines, WithoutGeometryShadersAreSaidToStayThin) {
    caps.geometry = false;
    const std::string line = "glBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 0\nglEnd\n";
    EXPECT_TRUE(has(*open("Ortho -1 1 -1 1\nLineWidth 9\n" + line), "thin-lines"));
    EXPECT_FALSE(has(*open("Ortho -1 1 -1 1\n" + line), "thin-lines"));
}

TEST_F(NarrowLines, AreNeitherCulledNorOutlined) {
    for (const char* state : {"CullFace front\n", "CullFace back\n", "Wireframe on\n"}) {
        const Picture picture = draw(std::string("Ortho -1 1 -1 1\nBackground 0 0 0\nLineWidth 9\n") + state +
                                         "glBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 0\nglEnd\n",
                                     {.width = 101, .height = 101});
        EXPECT_EQ(picture.count(white), 9 * 101) << state;
    }
}

TEST_F(NarrowLines, AreWidenedByOurselves) {
    auto document = open_file(case_file("LineWidth"));
    expect_clean(*document);
    const Picture picture = draw(*document, {.width = 300, .height = 300});
    const auto rows = [&](int from, int to) {
        int count = 0;
        for (int y = from; y < to; ++y) count += near(picture.at(150, y), white);
        return count;
    };
    // The lines rise by 1/3: measured down a column they are longer than across by sqrt(1 + 1/9).
    EXPECT_NEAR(rows(0, 100), 12 * 1.054, 1);
    EXPECT_NEAR(rows(100, 200), 5 * 1.054, 1);
    EXPECT_NEAR(rows(200, 300), 1, .5);
}

TEST_F(NarrowLines, PassEveryVaryingOn) {
    folder.write("v.vert",
                 "#version 330 compatibility\nout vec3 vColor;\nflat out int vWhich;\nvoid main() { vColor = "
                 "gl_Color.rgb; vWhich = 1; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write(
        "v.frag",
        "#version 330 compatibility\nin vec3 vColor;\nflat in int vWhich;\nvoid main() { gl_FragColor = vWhich "
        "== 1 ? vec4(vColor, 1.) : vec4(1.); }\n");
    const Picture picture = draw(
        "Ortho -1 1 -1 1\nBackground 0 0 0\nVertex v.vert\nFragment v.frag\nProgram V\nLineWidth 9\nglBegin gl_lines\n"
        "glColor 1 0 0\nglVertex -1 0 0\nglColor 0 1 0\nglVertex 1 0 0\nglEnd\n",
        {.width = 101, .height = 101});
    EXPECT_TRUE(near(picture.center(), {128, 128, 0, 255}, 4));
    EXPECT_TRUE(near(picture.at(10, 50), {229, 26, 0, 255}, 6));
    int rows = 0;
    for (int y = 0; y < 101; ++y) rows += picture.at(50, y)[0] > 0;
    EXPECT_EQ(rows, 9);
}

// Drivers warn of variables that are read before they are set, where they compile and don't take a program from a
// cache.
TEST_F(NarrowLines, HaveNothingThatDriversWarnOf) {
    folder.write("w.vert",
                 "#version 330 compatibility\nstruct Light { vec3 color; float parts[2]; };\nout Light vLight;\n"
                 "out float vParts[3];\nflat out ivec2 vWhole;\nout vec4 vUnset;\n"
                 "void main() { vLight = Light(vec3(0., 1., 0.), float[2](.5, 1.)); vWhole = ivec2(1);\n"
                 "for (int i = 0; i < 3; ++i) vParts[i] = 1.;\ngl_Position = gl_Vertex; }\n");
    folder.write("w.frag",
                 "#version 330 compatibility\nstruct Light { vec3 color; float parts[2]; };\nin Light vLight;\n"
                 "in float vParts[3];\nflat in ivec2 vWhole;\nin vec4 vUnset;\nvoid main() { gl_FragColor = "
                 "vec4(vLight.color * vLight.parts[1] * vParts[2], vWhole.x) + 0. * vUnset; }\n");
    auto document = open(
        "Ortho -1 1 -1 1\nVertex w.vert\nFragment w.frag\nProgram W\nLineWidth 9\n"
        "glBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 0\nglEnd\n");
    EXPECT_TRUE(near(draw(*document, {.width = 101, .height = 101}).center(), {0, 255, 0, 255}));
}

// A line from behind the eye to in front of it: what is behind is cut away.
TEST_F(NarrowLines, AreCutAtTheEye) {
    const Picture picture = draw(
        "Perspective 90\nBackground 0 0 0\nLineWidth 7\nglBegin gl_lines\nglVertex 0 0 -10\nglVertex 0 -1 5\nglEnd\n",
        {.width = 101, .height = 101});
    // From the centre straight down to the lower edge, nothing above.
    EXPECT_TRUE(near(picture.at(50, 80), white));
    EXPECT_TRUE(near(picture.at(50, 99), white));
    for (int y = 0; y < 45; ++y) EXPECT_FALSE(near(picture.at(50, y), white)) << y;
}

// A line that is cut has the colours of the driver's own wide lines, whichever end is behind the eye, and where it ends
// at the eye itself.
TEST_F(NarrowLines, AreColouredAsTheDriversWhereTheyAreCut) {
    folder.write(
        "w.vert",
        "out vec3 vColor;\nvoid main() { vColor = gl_Color.rgb; gl_Position = vec4(gl_Vertex.xy, .5, gl_Vertex.z); "
        "}\n");
    folder.write("w.frag", "in vec3 vColor;\nvoid main() { gl_FragColor = vec4(vColor, 1.); }\n");
    const std::string eye = "Perspective 90\n", own = "Vertex w.vert\nFragment w.frag\nProgram W\n";
    const std::string red = "glColor 1 0 0\nglVertex ", cyan = "glColor 0 1 1\nglVertex ";
    for (const auto& [view, from, to] : {std::array{eye, red + "0 0 -10\n", cyan + "0 -1 5\n"},
                                         {eye, red + "0 0 -10\n", cyan + "0 -1 0\n"},
                                         {own, red + "1 0 2\n", cyan + "-1 0 0\n"},
                                         {own, red + "1 0 2\n", cyan + "-1 0 -1\n"}})
        for (const std::string& ends : {from + to, to + from}) {
            const std::string scene = view + "Background 0 0 0\nLineWidth 7\nglBegin gl_lines\n" + ends + "glEnd\n";
            const Look look{.width = 101, .height = 101};
            caps.max_line_width = 1;
            const Picture widened = draw(scene, look);
            caps.max_line_width = 100;
            const Picture drivers = draw(scene, look);
            int far = 0;
            for (int y = 0; y < 101; ++y)
                for (int x = 0; x < 101; ++x) far += !near(widened.at(x, y), drivers.at(x, y), 3);
            EXPECT_LE(far, 7) << "where it begins: " << scene;
            EXPECT_GT(101 * 101 - drivers.count({0, 0, 0, 255}), 7 * 20) << scene;
        }
}

}  // namespace
}  // namespace snell::test
