// What docs/glman.md says of old scenes, by running them.
#include <gtest/gtest.h>

#include "tests/cli/run.h"

namespace snell::test {
namespace {

class Glman : public testing::Test {
protected:
    Glman() {
        folder.write("p.vert", "void main() { gl_Position = ftransform(); }\n");
        folder.write("p.frag",
                     "uniform float uA; uniform vec3 uC;\nvoid main() { gl_FragColor = vec4( uA, uC.rg, 1 ); }\n");
        folder.write("int.frag", "void main() { int i = 1.5; gl_FragColor = vec4( i ); }\n");
    }
    Outcome check(const std::string& text) const { return snell("check " + folder.write("s.glib", text)); }
    std::string program(const std::string& values) const {
        return "Ortho -1 1 -1 1\nVertex p.vert\nFragment p.frag\nProgram P " + values + "\nQuadXY 0 1\n";
    }
    Scratch folder;
};

TEST_F(Glman, WhatOldScenesSayIsReadAsThePageSays) {
    const std::string fine = program("uA <0. .5 1.> uC {1 0 0}");
    EXPECT_EQ(check(fine).output, "");
    const struct {
        std::string text, says, code;
        int status;
    } rows[] = {
        {program("uA 0.1. uC {1 0 0}"), "warning", "[second-point]", 0},
        {program("uA nan uC {1 0 0}"), "error", "[not-finite]", 1},
        {program("uA 1e400 uC {1 0 0}"), "error", "[number-too-large]", 1},
        {program("uA <2. .5 1.> uC {1 0 0}"), "warning", "[range-widened]", 0},
        {program("Height Blending uA 1 uC {1 0 0}"), "'P Height Blending'", "[name-of-several-words]", 0},
        {program("\n  uA 1\n  uC {1 0 0}"), "the values are taken for this program all the same", "[unknown-command]",
         1},
        {program("uC {1 0 0} uAa 2"), "did you mean 'uA'?", "[unknown-uniform]", 0},
        {fine + "Spere\n", "did you mean 'Sphere'?", "[unknown-command]", 1},
        {"Ortho -1 1 -1 1\nVertex P.VERT\nFragment p\nProgram P uA 1 uC {1 0 0}\nQuadXY 0 1\n", "p.frag' is used",
         "[file-inexact]", 0},
        {"Ortho -1 1 -1 1\nVertex p.vert\nFragment int.frag\nProgram P\nQuadXY 0 1\n", "warning", "[float-to-int]", 0},
    };
    for (const auto& row : rows) {
        const Outcome outcome = check(row.text);
        EXPECT_EQ(outcome.status, row.status) << row.text << outcome.output;
        EXPECT_TRUE(outcome.says(row.says)) << row.text << outcome.output;
        EXPECT_TRUE(outcome.says(row.code)) << row.text << outcome.output;
    }
}

TEST_F(Glman, WhatIsTheSameDrawsTheSame) {
    const auto drawn = [&](const std::string& text, const std::string& options = "") {
        const Outcome outcome = snell("render " + folder.write("s.glib", text) + " -o " + folder.path("s.png") +
                                      " --size 32x32 " + options);
        EXPECT_EQ(outcome.status, 0) << text << outcome.output;
        return bytes_of(folder.path("s.png"));
    };
    const std::string ball = "LookAt 0 0 5  0 0 0  0 1 0\nSphere\n";
    const std::string same[] = {
        "LookAt 1 2 3  0 0 0  0 1 0\n" + ball, "Persp\n" + ball,         "Background .0706 .1059 .1294\n" + ball,
        "lookat 0, 0, 5\nSPHERE 1 60 60\n",    "##OpenGL GLIB\n" + ball, ball + "TransformBegin\nTransformEnd\n"};
    const std::string picture = drawn(ball);
    for (const std::string& text : same) EXPECT_EQ(drawn(text), picture) << text;
    EXPECT_NE(drawn(ball, "--axes"), picture) << "no axes unless asked for";
    EXPECT_NE(drawn(ball, "--samples 4"), picture) << "one sample unless asked for";
    // Half of red over blue from both sides, unless blending is off.
    folder.write("p.frag", "void main() { gl_FragColor = vec4( 1., 0., 0., .5 ); }\n");
    const std::string quad =
        "Ortho -1 1 -1 1\nBackground 0 0 1\nVertex p.vert\nFragment p.frag\nProgram P\nQuadXY 0 2\n";
    EXPECT_EQ(drawn("Rotate 180 0 1 0\n" + quad), drawn(quad));
    EXPECT_EQ(drawn("Blend on\n" + quad), drawn(quad));
    EXPECT_NE(drawn("Blend off\n" + quad), drawn(quad));
    folder.write("p.frag", "uniform float Timer;\nvoid main() { gl_FragColor = vec4( vec3( Timer ), 1. ); }\n");
    EXPECT_EQ(drawn(quad, "--time 12.5"), drawn(quad, "--time 2.5")) << "10 seconds";
    EXPECT_NE(drawn(quad, "--time 5"), drawn(quad, "--time 2.5"));
}

}  // namespace
}  // namespace snell::test
