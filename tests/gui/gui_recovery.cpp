// A window whose driver gave up: it goes on with what was last drawn well.
#include "tests/gui/desk.h"

namespace snell::test {
namespace {

class Recovery : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("paint.vert", "void main() { gl_Position = ftransform(); }\n");
        save("paint.frag", paint("uPaint"));
        save(
            "scene.glib",
            "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uPaint [1. 0. 0.]\nQuadXY 0. 9.\n");
    }
    static std::string paint(const std::string& color) {
        return "uniform vec3 uPaint;\nvoid main() { gl_FragColor = vec4(" + color + ", 1.); }\n";
    }
    // Beside the axes.
    bool shows(Pixel color, double seconds = 20) const {
        return wait([&](const nlohmann::json&) { return scene_pixel(90, 70) == color; }, seconds);
    }
    static constexpr Pixel red{255, 0, 0}, green{0, 255, 0};
};

TEST_F(Recovery, AfterALossTheLastGoodProgramIsShown) {
    open("scene.glib", {"--lose-file", file("lose")});
    ASSERT_TRUE(shows(red));
    settle();  // the next picture drawn is that of the edit
    save("lose", "");
    save("paint.frag", paint("uPaint.grb"));
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1 && state["stale"] == true; }, 20));
    EXPECT_TRUE(alive());
    EXPECT_TRUE(shows(red)) << "what was drawn before the edit that lost the context";
    // Another edit, or the same, is another try.
    save("paint.frag", paint("uPaint.grb "));
    EXPECT_TRUE(shows(green));
    EXPECT_EQ(state()["errors"], 0);
}

TEST_F(Recovery, AFrameThatDoesNotEndStartsTheWindowAgain) {
    open("scene.glib", {"--timeout", "2"});
    ASSERT_TRUE(shows(red));
    const std::string loop = "  for (int i = 0; i < 60000; ++i) x = fract(sin(x + uPaint.r) * 43758.5);\n";
    save("paint.frag", "uniform vec3 uPaint;\nvoid main() {\n  float x = gl_FragCoord.x;\n" + loop + loop +
                           "  gl_FragColor = vec4(x);\n}\n");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1; }, 40));
    EXPECT_TRUE(alive());
    save("paint.frag", paint("uPaint.grb"));
    save("scene.glib",
         "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uPaint [1. 0. 0.]\nQuadXY 0. 9.\n\n");
    EXPECT_TRUE(shows(green));
}

}  // namespace
}  // namespace snell::test
