// Sliders of other kinds, and of another program: boxes are checked, colours picked, sections opened.
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

class Kinds : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", R"(##OpenGL GLIB
Ortho -2 2 -2 2
Background 0 0 0
Vertex paint.vert
Fragment paint.frag
Program Left uOn <false> uColor {.2 .6 .4 1.}
QuadXY 0. 2.
Vertex paint.vert
Fragment other.frag
Program Right uBlue <0. .25 1.>
QuadXY .5 .5
)");
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag",
             "#version 330 compatibility\nuniform bool uOn;\nuniform vec4 uColor;\n"
             "void main() { gl_FragColor = uOn ? vec4(1. - uColor.rgb, 1.) : uColor; }\n");
        save("other.frag",
             "#version 330 compatibility\nuniform float uBlue;\nvoid main() { gl_FragColor = vec4(0., 0., uBlue, 1.); "
             "}\n");
        open("scene.glib", {"--no-specialise"});  // one test counts what is compiled
    }
    void click(std::array<int, 2> at) {
        user("mousemove " + std::to_string(at[0]) + " " + std::to_string(at[1]) + " sleep 0.1 click 1");
        settle();
    }
    std::vector<double> value(const std::string& name) const { return state()["controls"][name]; }
    // Below the other program's quad and the axes.
    Pixel left() const { return scene_pixel(-150, 150); }
    static int byte(double v) { return static_cast<int>(std::lround(255 * std::min(std::max(v, 0.), 1.))); }
};

TEST_F(Kinds, ABoxIsChecked) {
    EXPECT_NEAR(left().green, byte(.6), 1);
    click(on("Left.uOn", .05));
    EXPECT_EQ(value("Left.uOn"), std::vector<double>{1});
    EXPECT_NEAR(left().green, byte(.4), 1);
    click(on("Left.uOn", .05));
    EXPECT_EQ(value("Left.uOn"), std::vector<double>{0});
    EXPECT_NEAR(left().green, byte(.6), 1);
}

TEST_F(Kinds, AColorIsPicked) {
    const std::vector<double> before = value("Left.uColor");
    const std::array<int, 2> swatch = on("Left.uColor", .97);
    click(swatch);
    keep("color");
    // Into the square of saturation and brightness, which opens at the left, below.
    click({swatch[0] - 300, swatch[1] + 150});
    ASSERT_TRUE(wait([&](const json& s) { return s["controls"]["Left.uColor"] != json(before); }));
    const std::vector<double> picked = value("Left.uColor");
    EXPECT_EQ(picked[3], 1) << "alpha stays";
    for (const double part : picked)
        EXPECT_LE(json(part).dump().size(), 5u) << part << ": no more digits than a byte has";
    EXPECT_NEAR(left().red, byte(picked[0]), 1);
    EXPECT_NEAR(left().green, byte(picked[1]), 1);
    EXPECT_NEAR(left().blue, byte(picked[2]), 1);
}

TEST_F(Kinds, TheOtherProgramsSectionOpensAndItsSliderIsDragged) {
    if (!state()["widgets"].contains("Right.uBlue")) click(on("Right", .3));
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("Right.uBlue"); }));
    const std::vector<double> others = value("Left.uColor");
    const json compiled = state()["counters"]["programs_compiled"];
    drag(on("Right.uBlue", .25), on("Right.uBlue", .8));
    const double blue = value("Right.uBlue")[0];
    EXPECT_NEAR(blue, .8, .03);
    EXPECT_NEAR(scene_pixel(40, -30).blue, byte(blue), 1);
    EXPECT_EQ(value("Left.uColor"), others);
    EXPECT_EQ(state()["counters"]["programs_compiled"], compiled) << "a drag compiles nothing";
}

}  // namespace
}  // namespace snell::test
