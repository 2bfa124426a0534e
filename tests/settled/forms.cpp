// In a window: programs for the values as they are, made while nothing changes, beside those for any values.
#include "tests/settled/settled.h"

namespace snell::test {
namespace {

class Forms : public SettledTest {
protected:
    static constexpr std::string_view scene =
        "Texture2D 5 a.bmp\nTexture2D 6 b.bmp\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment two.frag\n"
        "Program P uA 5 uB 6 uMix <0. 0. 1.> uGain <0. 1. 2.>\nQuadXY\n";
    void SetUp() override {
        SettledTest::SetUp();
        folder.write("a.bmp", bmp(1, 1, {{200, 0, 0}}));
        folder.write("b.bmp", bmp(1, 1, {{0, 200, 0}}));
        folder.write("two.frag",
                     "#version 330 compatibility\nuniform sampler2D uA, uB;\nuniform float uMix, uGain;\nin vec2 vST;\n"
                     "void main() { gl_FragColor = vec4((uGain > 0. ? uGain : .5) * mix(texture(uA, vST).rgb, "
                     "texture(uB, vST).rgb, uMix), "
                     "1.); }\n");
        target = gl::make_target(32, 32, 1);
    }
    // As the window does while nothing is touched. Returns the number of steps.
    int rest(Document& document) {
        int steps = 0;
        while (steps < 50 &&
               document.runtime->specialise({0, view, document.controls, true}, {target.framebuffer.get(), 32, 32}))
            ++steps;
        return steps;
    }
    static std::uint64_t by_constants(Document& document) { return document.runtime->counters().specialised_draws; }

    View view;
    gl::Target target;
};

TEST_F(Forms, TakeOverWhenReadyAndLeaveAtOnce) {
    auto document = open(scene), general = open(scene);
    expect_clean(*document);
    const Picture first = draw(*document);
    EXPECT_EQ(by_constants(*document), 0U);
    EXPECT_GT(rest(*document), 1);
    EXPECT_EQ(rest(*document), 0) << "nothing changed";
    EXPECT_EQ(by_constants(*document), 0U) << "what was drawn to compile does not count";
    EXPECT_EQ(draw(*document), first);
    EXPECT_EQ(by_constants(*document), 1U);
    const std::uint64_t compiled = document->runtime->counters().programs_compiled;
    EXPECT_EQ(draw(*document, {.sets = {"uMix=.5"}}), draw(*general, {.sets = {"uMix=.5"}}));
    EXPECT_EQ(by_constants(*document), 1U);
    EXPECT_EQ(document->runtime->counters().programs_compiled, compiled) << "the program for any values was kept";
    EXPECT_EQ(document->runtime->counters().images_decoded, 2U);
    EXPECT_EQ(draw(*document, {.sets = {"uMix=0"}}), first);
    EXPECT_EQ(by_constants(*document), 2U) << "the first values are back, and so is their program";
}

// Not with these values, but with others.
TEST_F(Forms, OfScenesThatReadTheTimeWithSomeValue) {
    const auto timed = [&](const std::string& value) {
        folder.write("one.frag",
                     "#version 330 compatibility\nuniform float Timer, uUsed;\nvoid main() { gl_FragColor = "
                     "vec4(" +
                         value + "); }\n");
        return open("Ortho -1 1 -1 1\nVertex plain.vert\nFragment one.frag\nProgram P uUsed <0 0 1>\nQuadXY\n")
            ->runtime->timed();
    };
    EXPECT_TRUE(timed("Timer"));
    EXPECT_TRUE(timed("uUsed > 0. ? Timer : 0."));
    EXPECT_FALSE(timed("uUsed")) << "the time is declared only";
}

// A window measures nothing while there is more to compile.
TEST_F(Forms, OfScenesWithoutValuesAreNotSoughtForEver) {
    folder.write("one.frag",
                 "#version 330 compatibility\nin vec2 vST;\nvoid main() { gl_FragColor = vec4(vST, 0., 1.); }\n");
    auto document = open("Ortho -1 1 -1 1\nVertex plain.vert\nFragment one.frag\nProgram P\nQuadXY\n");
    expect_clean(*document);
    const Picture first = draw(*document);
    rest(*document);
    EXPECT_EQ(rest(*document), 0);
    EXPECT_EQ(draw(*document), first);
    EXPECT_EQ(by_constants(*document), 0U);
}

TEST_F(Forms, AreFew) {
    auto document = open(scene);
    draw(*document);
    const auto at = [&](int i) { return "uGain=" + std::to_string(.1 * i); };
    for (int i = 1; i <= 8; ++i) {
        draw(*document, {.sets = {at(i)}});
        EXPECT_GT(rest(*document), 0);
    }
    const std::uint64_t before = by_constants(*document);
    draw(*document, {.sets = {at(8)}});
    draw(*document, {.sets = {at(7)}});
    EXPECT_EQ(by_constants(*document), before + 2);
    draw(*document, {.sets = {at(1)}});
    EXPECT_EQ(by_constants(*document), before + 2) << "it was dropped";
    EXPECT_GT(rest(*document), 0);
    draw(*document, {.sets = {at(1)}});
    EXPECT_EQ(by_constants(*document), before + 3);
}

TEST_F(Forms, FollowRungs) {
    folder.write(
        "rung.frag",
        "#version 330 compatibility\nuniform float uGain;\nvoid main() {\n#if KIND == KIND_red\n"
        "gl_FragColor = vec4(uGain, 0., 0., 1.);\n#else\ngl_FragColor = vec4(0., uGain, 0., 1.);\n#endif\n}\n");
    auto document = open(
        "Ladder KIND <red> green\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment rung.frag\n"
        "Program P uGain <0. 1. 2.>\nQuadXY\n");
    expect_clean(*document);
    draw(*document);
    rest(*document);
    EXPECT_EQ(draw(*document).center(), red);
    document->controls.rungs = {1};
    EXPECT_EQ(draw(*document).center(), green);
    rest(*document);
    EXPECT_EQ(draw(*document).center(), green);
    document->controls.rungs = {0};
    EXPECT_EQ(draw(*document).center(), red);
}

// Faces that were drawn before the change of programs are drawn again if they show other values.
TEST_F(Forms, ShareCubeMapsThatAreDrawn) {
    folder.write("cube.frag",
                 "#version 330 compatibility\nuniform samplerCube uCube;\nin vec2 vST;\n"
                 "void main() { gl_FragColor = texture(uCube, vec3(0., 0., -1.)); }\n");
    const std::string_view cube =
        "CubeMap 5 16\nVertex plain.vert\nFragment color.frag\nProgram Inner uColor {1 0 0 1}\nRenderToCube 5\n"
        "Sphere 5\nRenderToTexture\nOrtho -1 1 -1 1\nFragment cube.frag\nProgram Outer uCube 5\nQuadXY\n";
    auto document = open(cube), general = open(cube);
    expect_clean(*document);
    draw(*document);
    rest(*document);
    for (const char* color : {"Inner.uColor=1,0,0,1", "Inner.uColor=0,1,0,1", "Inner.uColor=1,0,0,1"}) {
        EXPECT_EQ(draw(*document, {.sets = {color}}), draw(*general, {.sets = {color}})) << color;
        rest(*document);
        EXPECT_EQ(draw(*document, {.sets = {color}}), draw(*general, {.sets = {color}})) << color;
    }
}

}  // namespace
}  // namespace snell::test
