// Pictures that take longer than anyone waits: a coarse one comes first, so that the window answers.
#include "tests/gui/desk.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

using nlohmann::json;

class SlowPictures : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        if (sanitized) GTEST_SKIP() << "sanitizers take their time";
        save("paint.vert", "void main() { gl_Position = ftransform(); }\n");
        save("paint.frag", shader("int(uRounds)"));
        save("quick.glib", scene("10"));
        save("slow.glib", scene(slow));
    }
    static std::string scene(const std::string& rounds) {
        return "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uRounds <1. " + rounds +
               ". 3000.> uPhase <0. 0. 1.>\nQuadXY 0. 9.\n";
    }
    static std::string shader(const std::string& rounds, const std::string& moving = "uPhase") {
        return "uniform float uRounds, uPhase, uTime;\nvoid main() {\n    float x = gl_FragCoord.x + " + moving +
               ";\n    for (int i = 0; i < " + rounds +
               "; ++i) {\n        if (float(i) >= uRounds) break;\n        x += sin(x);\n    }\n    gl_FragColor = "
               "vec4(0., 1., 1e-9 * x, 1.);\n}\n";
    }
    // Pictures since the last call, and those of them that were coarse.
    std::array<int, 2> drawn() {
        const json now = state();
        const std::array<int, 2> all{now["frames"], now["coarse"]};
        const std::array<int, 2> result{all[0] - before_[0], all[1] - before_[1]};
        before_ = all;
        return result;
    }
    bool coarse_since() const {
        return wait([&](const json& s) { return s["coarse"] > before_[1]; });
    }
    static constexpr const char* slow = "2500";
    static constexpr std::array<int, 2> coarse_then_sharp{2, 1};

private:
    std::array<int, 2> before_{};
};

TEST_F(SlowPictures, BeginCoarseWhereverTheyComeFrom) {
    open("slow.glib", {"--no-specialise"});
    EXPECT_EQ(drawn(), coarse_then_sharp) << "opened";
    EXPECT_GT(state()["strips"], 1) << "opened";
    EXPECT_EQ(scene_pixel(), (Pixel{0, 255, 0}));
    const auto [x, y] = on("Paint.uPhase", .2);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " mousedown 1");
    EXPECT_TRUE(coarse_since()) << "dragged before the cost of two sharp ones is known";
    for (int i = 1; i < 40; ++i) user("mousemove_relative 1 0");
    EXPECT_EQ(state()["frames"].get<int>() - state()["coarse"].get<int>(), 1) << "every move drops the sharp one";
    user("mouseup 1");
    settle();
    const auto [all, coarse] = drawn();
    EXPECT_EQ(all - coarse, 1) << "the release is sharp";
    // What is picked changes no pixel's colour, and still the picture is drawn again.
    const int strips = state()["strips"];
    const std::array<double, 4> scene = state()["scene"];
    user("key p mousemove " + std::to_string(static_cast<int>(scene[0] + scene[2] / 2)) + " " +
         std::to_string(static_cast<int>(scene[1] + scene[3] / 2)) + " click 1");
    EXPECT_TRUE(wait([&](const json& s) { return s["strips"] > strips + 1; })) << "picked";
    settle();
    EXPECT_EQ(state()["grain"], 0);
    drawn();
    save("paint.frag", shader("int(uRounds) - 1"));
    EXPECT_TRUE(coarse_since()) << "edited";
    EXPECT_EQ(drawn(), (std::array{1, 1}));
}

TEST_F(SlowPictures, OfATypedValueBeginCoarseAndQuickOnesDoNot) {
    save("paint.frag", shader("60000"));  // so that only a picture tells
    open("quick.glib", {"--no-specialise"});
    drawn();
    // A busy machine makes quick pictures slow, and then later ones of a drag are coarse; else only its last is sharp.
    for (int attempt = 0; attempt < 3; ++attempt) {
        drag(on("Paint.uPhase", .1 + attempt * .1), on("Paint.uPhase", .8));
        settle();
        const auto [all, coarse] = drawn();
        EXPECT_GT(all, 0);
        if (all > coarse + 1 || coarse == 0) break;
        EXPECT_LT(attempt, 2) << coarse << " of " << all;
    }
    type("Paint.uRounds", slow, Field::number);
    EXPECT_EQ(state()["grain"], 0);
    user("key ctrl+z");
    settle();
    drawn();
    user("key ctrl+y");
    EXPECT_TRUE(coarse_since()) << "undone, and done again";
    EXPECT_EQ(drawn(), (std::array{1, 1}));
}

TEST_F(SlowPictures, MoveCoarseAndAreSharpWhenTheyStand) {
    save("paint.frag", shader("int(uRounds)", "uPhase + uTime"));
    open("slow.glib", {"--no-specialise", "--exit-after", "60"});
    EXPECT_TRUE(wait([](const json& s) { return s["frames"] > 6; }));
    const auto [all, coarse] = drawn();
    EXPECT_EQ(all, coarse);
    user("key space");
    settle();
    EXPECT_EQ(state()["grain"], 0);
}

// Strip by strip, a sharp picture is that which is drawn at once.
TEST_F(SlowPictures, AreSharpFromTheStartWhereNoneMayBeCoarse) {
    save("paint.vert", "varying vec3 vAt;\nvoid main() { vAt = gl_Vertex.xyz; gl_Position = ftransform(); }\n");
    save("paint.frag",
         "uniform float uRounds;\nvarying vec3 vAt;\nvoid main() {\n    float x = vAt.x + 3. * vAt.y;\n"
         "    for (int i = 0; i < 60000 && float(i) < uRounds; ++i) x += .1 * sin(x + vAt.z);\n"
         "    gl_FragColor = vec4(fract(3. * x), fract(9. * vAt.y), 20. * dFdx(vAt.z), 1.);\n}\n");
    save("slow.glib",
         "Perspective 50\nLookAt 0 0 3  0 0 0  0 1 0\nVertex paint.vert\nFragment paint.frag\n"
         "Program Paint uRounds <1. 800. 9000.>\nSphere 1. 40 40\nTranslate .9 .4 .3\nSphere .5 40 40\n");
    open("slow.glib", {"--no-specialise"});
    EXPECT_EQ(drawn(), coarse_then_sharp);
    const Picture strips = look();
    const std::array<double, 4> scene = state()["scene"];
    end_window();
    std::filesystem::create_directories(file("state/snell"));
    save("state/snell/window.json", "{\"always_sharp\": true}");
    open("slow.glib", {"--no-specialise"});
    EXPECT_EQ(state()["frames"], 1);
    EXPECT_EQ(state()["coarse"], 0);
    const Picture whole = look();
    int differ = 0, seen = 0;
    for (int row = 0; row < static_cast<int>(scene[3]); ++row)
        for (int column = 0; column < static_cast<int>(scene[2]); ++column) {
            differ += strips.at(column, row) == whole.at(column, row) ? 0 : 1;
            seen += whole.at(column, row) == whole.at(2, 2) ? 0 : 1;
        }
    EXPECT_EQ(differ, 0);
    EXPECT_GT(seen, 30000);
}

}  // namespace
}  // namespace snell::test
