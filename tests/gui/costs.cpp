// The costs panel of a real window follows the programs that are compiled for the values as they are.
#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

class CostsInTheWindow : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("plain.vert",
             "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
             "gl_Position = ftransform(); }\n");
        // Programs are compiled for values only where frames are expensive.
        save("slow.frag",
             "#version 330 compatibility\nuniform float uMix, uTint;\nin vec2 vST;\nvoid main() {\n    vec3 c = "
             "vec3(vST, .5);\n    for (int i = 0; i < 400; ++i) c = fract(sin(c * 1.7) + .1);\n    gl_FragColor = "
             "vec4(c + uMix * vec3(uTint), 1.);\n}\n");
        save("scene.glib",
             "Perspective 50\nLookAt 0 0 2  0 0 0  0 1 0\nVertex plain.vert\nFragment slow.frag\n"
             "Program Slow uMix <0. 0. 1.> uTint <0. .5 1.>\nQuadXY 0. 1.\n");
    }
};

TEST_F(CostsInTheWindow, SayWhatValuesSwitchOffWhileNothingIsTouched) {
    open("scene.glib");
    click("tools");
    click("costs");
    const auto tells = [](const json& s) { return s["widgets"].contains("costs.Switched off by values"); };
    EXPECT_TRUE(wait(tells, 20));
    settle();
    const json still = state();
    EXPECT_FALSE(wait([&](const json& s) { return s["presents"] != still["presents"]; }, .8))
        << "nothing is left to show";
    click("controls");
    click("Slow.uMix", .7);
    click("tools");
    EXPECT_TRUE(wait([&](const json& s) { return !tells(s); })) << "programs for any values draw now";
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

}  // namespace
}  // namespace snell::test
