// What varies between frames, and what it costs.
#include "src/runtime/resources/uniforms.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Frames : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("plain.vert", plain_vertex);
        folder.write("color.frag", color_fragment);
        folder.write("timer.frag",
                     "uniform float Timer;\nvoid main() { gl_FragColor = vec4(Timer, Timer, Timer, 1.); }\n");
        folder.write("slider.frag",
                     "uniform float uRed, uGreen;\nuniform int uCount;\nuniform bool uOn;\n"
                     "void main() { gl_FragColor = vec4(uRed, uGreen, uOn ? float(uCount) / 10. : 0., 1.); }\n");
    }
    static constexpr std::string_view sliders =
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment slider.frag\n"
        "Program S uRed <0. .25 1.> uGreen <0. .5 1.> uCount <0 5 10> uOn <true>\nQuadXY\n";
};

TEST_F(Frames, TheTimerIsASawtooth) {
    const std::string scene = "Timer 4\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment timer.frag\nProgram T\nQuadXY\n";
    auto document = open(scene);
    expect_clean(*document);
    EXPECT_TRUE(document->runtime->animated());
    EXPECT_TRUE(near(draw(*document, {.time = 1}).center(), {64, 64, 64, 255}));
    EXPECT_TRUE(near(draw(*document, {.time = 4 * 1e6 + 3}).center(), {191, 191, 191, 255}));
}

TEST_F(Frames, TheTimerNeverReachesOne) {
    for (double time : {9.9999999999, 10.0, 1e9 - 1e-9})
        EXPECT_LT(static_cast<float>(runtime::timer_value(time, 10)), 1.0F) << time;
    EXPECT_EQ(runtime::timer_value(5, 0), 0);
    EXPECT_EQ(runtime::timer_value(5, -1), 0);
    EXPECT_GE(runtime::timer_value(-1, 10), 0);
}

TEST_F(Frames, ValuesOfEveryKindReachTheProgram) {
    EXPECT_TRUE(near(draw(sliders).center(), {64, 128, 128, 255}));
    EXPECT_TRUE(near(draw(sliders, {.sets = {"uRed=1", "S.uGreen=0", "uCount=10"}}).center(), {255, 0, 255, 255}));
    EXPECT_TRUE(near(draw(sliders, {.sets = {"uOn=false"}}).center(), {64, 128, 0, 255}));
}

TEST_F(Frames, TheSceneTransformationTurnsThePictureAndLeavesEyeCoordinates) {
    folder.write("eye.vert",
                 "out vec3 vEye;\nvoid main() { vEye = (gl_ModelViewMatrix * gl_Vertex).xyz; gl_Position = "
                 "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("eye.frag", "in vec3 vEye;\nvoid main() { gl_FragColor = vec4(vEye.xy * .5 + .5, 0., 1.); }\n");
    const std::string scene =
        "Ortho -1 1 -1 1\nVertex eye.vert\nFragment eye.frag\nProgram E\nTranslate .5 0 0\nQuadXY 0 .2\n";
    const Picture still = draw(scene);
    EXPECT_TRUE(near(still.at(48, 32), {191, 128, 0, 255}, 4));
    Look look;
    look.view.scene.rotate_y = 180;
    const Picture turned = draw(scene, look);
    EXPECT_TRUE(near(turned.at(16, 32), {191, 128, 0, 255}, 4));
    look.view.scene = {};
    look.view.eye.rotate_y = 180;
    const Picture eye = draw(scene, look);
    EXPECT_TRUE(near(eye.at(16, 32), {64, 128, 0, 255}, 4));
}

TEST_F(Frames, OneMeshServesManyDraws) {
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::string scene = "Ortho -1 1 -1 1\n";
    for (int i = 0; i < 400; ++i) scene += "Translate .001 0 0\nObj t.obj\n";
    auto document = open(scene);
    expect_clean(*document);
    draw(*document);
    EXPECT_EQ(document->runtime->counters().buffers, 2U);
    EXPECT_EQ(document->runtime->counters().draws, 400U);
    EXPECT_EQ(document->runtime->counters().files_opened, 2U);  // the scene and the mesh
}

TEST_F(Frames, OddSizesAreDrawn) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 777), std::pair(4097, 1)}) {
        const Picture picture = draw("Background 0 1 0\n", {.width = width, .height = height});
        EXPECT_EQ(picture.count({0, 255, 0, 255}), width * height);
    }
}

}  // namespace
}  // namespace snell::test
