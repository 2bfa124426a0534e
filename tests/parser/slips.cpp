// Slips of one kind each, and the one message that names them.
#include "tests/parser/support.h"
#include "tests/std.h"

namespace snell::test {
namespace {

std::string help_of(const std::string& statement) {
    const Read r = read(statement + "\n");
    return r.diagnostics().empty() ? "nothing is wrong" : r.diagnostics()[0].help;
}

// A '\' that is missing makes each line after it a statement, and is one mistake.
TEST(Slips, ALostBackslashIsOneError) {
    std::string text = "Program Glass uTexUnit 5\n";
    for (int i = 0; i < 10; ++i) text += "  u" + std::string(1, static_cast<char>('A' + i)) + " <0. .5 1.>\n";
    const Read r = read(text + "Sphere 1\n");
    ASSERT_EQ(r.codes(), Codes{"2:3 unknown-command"});
    EXPECT_EQ(r.diagnostics()[0].also.size(), 9U);
    EXPECT_EQ(r.diagnostics()[0].help, "'Program' on line 1 is not continued: end each line from 1 to 10 with '\\'");
    const std::string shown = render(r.diagnostics()[0], r.sources);
    EXPECT_NE(shown.find("also on lines 3, 4 and 7 others\n"), std::string::npos) << shown;
    ASSERT_EQ(r.scene().programs[0].uniforms.size(), 11U) << "all values are taken";
}

TEST(Slips, WhatFollowsALostBackslashMayBeginWithABareNumber) {
    const Read r = read("Program Glass\n  uTexUnit 6 \\\n  uEta <1. 1.5 2.>\n  uUnit 7\nSphere 1\n");
    ASSERT_EQ(r.codes(), Codes{"2:3 unknown-command"});
    EXPECT_EQ(r.scene().programs[0].uniforms.size(), 3U);
    const Read two = read("Program A\nuA <1>\nProgram B\nuB <1>\nuC <0>\n");
    EXPECT_EQ(two.codes(), (Codes{"2:1 unknown-command", "4:1 unknown-command"})) << "one for each program";
}

TEST(Slips, AFileNameOnALineOfItsOwn) {
    const Read r = read("CubeMap 6 a.bmp b.bmp c.bmp \\\nd.bmp\ne.bmp f.bmp\n");
    ASSERT_EQ(r.codes(), (Codes{"1:1 missing-argument", "3:1 unknown-command"}));
    EXPECT_NE(r.diagnostics()[1].help.find("end that line with '\\'"), std::string::npos);
}

TEST(Slips, AMisspeltCommandBehindAProgramIsNoUniform) {
    const Read r = read("Program Glass uEta 1.5\nSpher 1\n");
    ASSERT_EQ(r.codes(), Codes{"2:1 unknown-command"});
    EXPECT_EQ(r.diagnostics()[0].help, "did you mean 'Sphere'?");
    EXPECT_EQ(r.scene().programs[0].uniforms.size(), 1U);
    const Read scale = read("Program Glass uEta 1.5\nuScale 1\n");
    EXPECT_EQ(scale.scene().programs[0].uniforms.size(), 2U) << "as near to a command, and named like a uniform";
}

// What an OpenGL program says, and the command that does it here.
TEST(Slips, WordsOfOpenGLGetTheCommand) {
    for (const auto& [statement, help] : std::vector<std::pair<const char*, const char*>>{
             {"Enable GL_BLEND", "'Blend on' does it"},
             {"glDisable GL_DEPTH_TEST", "'DepthTest off' does it"},
             {"enable blend", "'Blend on' does it"},
             {"glEnable GL_CULL_FACE", "'CullFace back'"},
             {"glDisable GL_CULL_FACE", "'CullFace none' does it"},
             {"Enable GL_LIGHTING", "there are no lights"},
             {"Enable", "'Blend', 'DepthTest'"},
             {"BlendFunc GL_ONE GL_ZERO", "'Blend src dst'"},
             {"glBlendFunc GL_SRC_ALPHA GL_ONE_MINUS_SRC_ALPHA", "'Blend src dst'"},
             {"Light 0 1. 1. 1.", "there are no lights"},
             {"glLightfv GL_LIGHT0", "there are no lights"},
             {"ShadeModel GL_FLAT", "'Flat' or 'Smooth'"},
             {"Material GL_FRONT", "there are no materials"},
             {"glMaterialfv GL_FRONT", "there are no materials"},
             {"glTranslatef 0 0 -5", "'Translate x y=0 z=0' does it"},
             {"glRotatef 30 0 1 0", "'Rotate angle"},
             {"glScaled 2 2 2", "'Scale s"},
             {"glColor3f 1 0 0", "'glColor r=1"},
             {"glVertex3fv 0 0 0", "'glVertex x"},
             {"Color4f 1 0 0 1", "'Color r=1"},
             {"LoadIdentity", "'PushMatrix'"},
             {"glLoadIdentity", "'PushMatrix'"},
             {"glPushMatrix", "'PushMatrix' does it"},
             {"gluPerspective 60 1 .1 100", "'Perspective fov=50' does it"},
             {"gluLookAt 0 0 5 0 0 0 0 1 0", "'LookAt "},
             {"glutSolidTeapot 1", "'Teapot' does it"},
             {"glClearColor 0 0 0 1", "'Background r g b' does it"},
             {"glLineWidth 3", "'LineWidth w=1' does it"},
             {"TexParameteri GL_TEXTURE_2D", "'Filter linear'"},
         })
        EXPECT_NE(help_of(statement).find(help), std::string::npos) << statement << ": " << help_of(statement);
    for (const char* other : {"glfrobnicate", "Frobnicate 3f", "gl", "glu", "v", "3fv"})
        EXPECT_EQ(help_of(other).find("does it"), std::string::npos) << other;
}

// As glman's scanner had it: the default stands in for a word, and the numbers behind it keep their places.
TEST(Slips, AWordWhereANumberBelongsIsTheDefault) {
    const Read r =
        read("QuadXY z 1 1000 500\nSphere r 30\nTranslate x 2 3\nBox 1 y 4\nPerspective wide\nLookAt 0 0 z\n");
    EXPECT_EQ(r.codes(), (Codes{"1:8 not-a-number", "2:8 not-a-number", "3:11 not-a-number", "4:7 not-a-number",
                                "5:13 not-a-number", "6:12 not-a-number"}));
    EXPECT_EQ(r.diagnostics()[0].help, "the default, 0, is used");
    EXPECT_EQ(r.diagnostics()[1].help, "the default, 1, is used");
    ASSERT_EQ(r.scene().draws.size(), 3U);
    const auto& quad = std::get<Quad>(r.scene().draws[0].shape);
    EXPECT_EQ(quad.offset, 0);
    EXPECT_EQ(quad.size, 1);
    EXPECT_EQ(quad.n1, 1000);
    EXPECT_EQ(quad.n2, 500);
    EXPECT_EQ(std::get<Sphere>(r.scene().draws[1].shape).slices, 30);
    const auto& box = std::get<Box>(r.scene().draws[2].shape);
    EXPECT_EQ((Vec3{box.dx, box.dy, box.dz}), (Vec3{1, 2, 4}));
    EXPECT_EQ(r.matrix(2)[12], 0);
    EXPECT_EQ(r.matrix(2)[13], 2);
    EXPECT_EQ(r.matrix(2)[14], 3);
}

// Where 0 or the default would leave nothing to be seen, or would be another texture, the statement is left out.
TEST(Slips, AWordThatCannotBeGuessedTakesItsStatementDown) {
    const Read r =
        read("Scale big\nRotate 30 x 0 0\nTexture2D unit 64 64\nRenderToTexture five\nSphere\nScale 1e400\n");
    EXPECT_EQ(r.codes(), (Codes{"1:7 not-a-number", "2:11 not-a-number", "3:11 not-a-number", "4:17 not-a-number",
                                "6:7 number-too-large"}));
    EXPECT_TRUE(r.scene().textures.empty());
    EXPECT_EQ(r.matrix(0), (Mat4{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
}

// The reading stays: scenes may separate numbers by commas.
TEST(Slips, ADecimalCommaIsTwoNumbers) {
    const Read r = read("Sphere 1,5\n");
    ASSERT_EQ(r.codes(), Codes{"1:8 decimal-comma"});
    EXPECT_EQ(r.diagnostics()[0].message, "'1,5' is read as two numbers, 1 and 5");
    EXPECT_EQ(r.diagnostics()[0].help, "for one number write a point: 1.5; for two, a blank between them");
    EXPECT_EQ(read("Translate 1 -0,5\n").codes(), Codes{"1:13 decimal-comma"});
    EXPECT_EQ(read("Translate 1 0,5 // half\n").codes(), Codes{"1:13 decimal-comma"});
    for (const char* fine : {"Sphere 1, 5", "Sphere 1 ,5", "Sphere 1.,5", "LookAt 0,0,3 0,0,0 0,1,0", "Translate 1,-5",
                             "Program P uC <0,1,2> uD {1,0,0}", "MessageBox 1,5", "Ladder L 1,5", "Sphere 1 // 1,5"})
        EXPECT_EQ(read(std::string(fine) + "\n").codes(), Codes{}) << fine;
}

}  // namespace
}  // namespace snell::test
