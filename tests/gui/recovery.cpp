// A window whose driver gave up: it goes on with what was last drawn well.
#include "tests/gui/desk.h"
#include "tests/gui/x11.h"
#include "tests/sanitized.h"

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
    // Of more rounds than even a coarse picture has time for, together.
    static std::string loops(const std::string& rounds, const std::string& number) {
        const std::string step = " x = fract(sin(x + " + number + ") * 43758.5);";
        std::string steps;
        for (int i = 0; i < 48; ++i) steps += step;  // long in a sixteenth of the size, too
        return "  for (int i = 0; i < " + rounds + "; ++i) {" + steps + " }\n";
    }
    std::size_t restarts() const {
        const std::string said = bytes("out/errors"), what = "the window is started again";
        std::size_t count = 0;
        for (std::size_t at = said.find(what); at != said.npos; at = said.find(what, at + 1)) ++count;
        return count;
    }
    bool says(const std::string& words) const {
        return wait([&](const nlohmann::json& state) {
            return state["problems"].get<std::string>().find(words) != std::string::npos;
        });
    }
    // Skips the test if the memory that ran out is OpenGL's.
    void await_memory() const {
        if (wait([](const nlohmann::json& state) { return !state.contains("controls"); })) return;
        if (state()["problems"].get<std::string>().find("[out-of-graphics-memory]") != std::string::npos)
            GTEST_SKIP() << "the memory that ran out is OpenGL's";
        FAIL() << bytes("out/errors");
    }
    static constexpr Pixel red{255, 0, 0}, green{0, 255, 0};
};

TEST_F(Recovery, AfterALossTheLastGoodProgramIsShown) {
    open("scene.glib", {"--lose-file", file("lose")});
    ASSERT_TRUE(shows(red));
    settle();  // the next picture drawn is that of the edit
    save("lose", "");
    save("paint.frag", paint("uPaint.grb"));
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1 && state["stale"] == true; }));
    EXPECT_TRUE(alive());
    EXPECT_TRUE(shows(red)) << "what was drawn before the edit that lost the context";
    // Another edit, or the same, is another try.
    save("paint.frag", paint("uPaint.grb "));
    EXPECT_TRUE(shows(green));
    EXPECT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 0; }));
}

TEST_F(Recovery, AnotherRungDoesNotReadWhatHasEndedTheWindow) {
    save("scene.glib",
         "Ortho -1 1 -1 1\nLadder SWAP <no> yes\nVertex paint.vert\nFragment paint.frag\n"
         "Program Paint uPaint [1. 0. 0.]\nQuadXY 0. 9.\n");
    save("paint.frag", paint("SWAP == SWAP_no ? uPaint : uPaint.grb"));
    open("scene.glib", {"--lose-file", file("lose")});
    ASSERT_TRUE(shows(red));
    settle();
    save("lose", "");
    save("paint.frag", paint("uPaint.bgr"));
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1 && state["stale"] == true; }));
    click("SWAP");
    click("SWAP.yes");
    EXPECT_TRUE(shows(green));
    settle();
    EXPECT_EQ(state()["stale"], true);
}

TEST_F(Recovery, WhatWasNotDoneIsSaidAfterALoss) {
    open("scene.glib", {"--lose-file", file("lose")});
    ASSERT_TRUE(shows(red));
    user("key 5");
    settle();
    const std::string said = state()["failure"];
    ASSERT_NE(said, "");
    save("lose", "");
    save("paint.frag", paint("uPaint.grb"));
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1; }));
    settle();
    EXPECT_EQ(state()["failure"], said);
    click("failure.ok");
    settle();
    EXPECT_EQ(state()["failure"], "");
}

TEST_F(Recovery, WhatIsOnTheRightOfTwoStatesWasDrawnWell) {
    open("scene.glib", {"--lose-file", file("lose")});
    ASSERT_TRUE(shows(red));
    user("key s");
    settle();
    click("accuracy.left");
    click("left.saved");
    settle();
    click("accuracy.right");
    click("right.now");
    settle();
    save("paint.frag", paint("uPaint.grb"));
    ASSERT_TRUE(shows(green));
    settle();
    save("lose", "");
    save("paint.frag", paint("uPaint.bgr"));
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1 && state["stale"] == true; }));
    EXPECT_TRUE(shows(green)) << "the scene's picture, which was at the right";
}

// An editor's text holds until its file is saved, whatever happens to the context, and to the window, afterwards.
TEST_F(Recovery, ATextThatWasSavedDoesNotComeBack) {
    const std::string path = file("paint.frag");
    save("texts", nlohmann::json{{path, paint("uPaint.bgr")}}.dump());
    const std::vector<std::string> given{"--instead", file("texts"), "--lose-file", file("lose")};
    open("scene.glib", given);
    ASSERT_TRUE(shows({0, 0, 255})) << "the editor's text";
    save("paint.frag", paint("uPaint.grb"));
    ASSERT_TRUE(shows(green));
    settle();
    save("lose", "");
    save("scene.glib", bytes("scene.glib") + "# an edit\n");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1; }));
    save("scene.glib", bytes("scene.glib") + "# another\n");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 0; }));
    EXPECT_TRUE(shows(green)) << "after the loss";
    end_window();
    open("scene.glib", given);
    EXPECT_TRUE(shows(green)) << "a window that is started again gets the same arguments";
}

TEST_F(Recovery, AFrameThatDoesNotEndStartsTheWindowAgain) {
    open("scene.glib", {"--timeout", "2"});
    ASSERT_TRUE(shows(red));
    save("paint.frag", "uniform vec3 uPaint;\nvoid main() {\n  float x = gl_FragCoord.x;\n" +
                           loops("60000", "uPaint.r") + "  gl_FragColor = vec4(x);\n}\n");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1; }));
    EXPECT_TRUE(alive());
    EXPECT_TRUE(says("a frame of scene.glib took too long and was stopped;"));
    EXPECT_TRUE(state()["widgets"].contains("not drawn.scene.glib")) << state()["widgets"];
    user("key F5");
    EXPECT_TRUE(says("a frame of scene.glib took too long in try 2 and was stopped;"));
    EXPECT_EQ(restarts(), 2U);
    save("paint.frag", paint("uPaint.grb"));
    EXPECT_TRUE(shows(green)) << "an edit of the shader alone is another try";
}

// A smaller picture has as many vertices, so that none can be drawn before, and nothing interrupts it: what is seen
// says for how long.
TEST_F(Recovery, AVertexShaderThatDoesNotEndIsGivenUp) {
    save("paint.vert", "uniform vec3 uPaint;\nvoid main() {\n  float x = gl_Vertex.x;\n" + loops("60000", "uPaint.r") +
                           "  gl_Position = ftransform() + vec4(1e-9 * x, 0., 0., 0.);\n}\n");
    save("scene.glib", "Vertex paint.vert\nFragment paint.frag\nProgram Paint uPaint [1. 0. 0.]\nSphere 1. 300 300\n");
    open("", {"--timeout", "2"});
    const Picture empty = look();
    ASSERT_TRUE(drop_files(display_, {file("scene.glib")}));
    const auto words = [&] {  // columns of the box that says so
        const Picture now = look();
        int columns = 0;
        for (int x = 0; x < 560; ++x) columns += now.at(x, 277).blue < 100 && !(now.at(x, 277) == empty.at(x, 277));
        return columns;
    };
    int widest = 0;
    for (int looks = 0; looks < 60 && restarts() == 0; ++looks) widest = std::max(widest, words());
    EXPECT_GT(widest, 360) << "with the time";
    EXPECT_TRUE(says("a frame of scene.glib took too long and was stopped; the window was started again"));
    settle();
    save("paint.vert", "void main() { gl_Position = ftransform(); }\n");
    EXPECT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 0 && state["frames"] > 0; }));
    EXPECT_EQ(restarts(), 1U);
}

// The scene that hung is blamed, and tried again; the one before stays as it was.
TEST_F(Recovery, AFirstPictureThatDoesNotEndIsThatOfItsOwnScene) {
    save("scene.glib",
         "Ortho -1 1 -1 1\nVertex paint.vert\nFragment blue.frag\nProgram Paint uBlue <0. .2 1.>\nQuadXY 0. 9.\n");
    save("blue.frag", "uniform float uBlue;\nvoid main() { gl_FragColor = vec4(0., 0., uBlue, 1.); }\n");
    save("slow.frag", "uniform vec3 uPaint;\nvoid main() {\n  float x = gl_FragCoord.x;\n" +
                          loops("60000", "uPaint.r") + "  gl_FragColor = vec4(x);\n}\n");
    save("slow.glib",
         "Ortho -1 1 -1 1\nVertex paint.vert\nFragment slow.frag\nProgram Paint uPaint [1. 0. 0.]\nQuadXY 0. 9.\n");
    open("scene.glib", {"--timeout", "2"});
    drag(on("Paint.uBlue", .2), on("Paint.uBlue", .7));
    settle();
    const nlohmann::json before = state();
    const Pixel scene_blue = scene_pixel(90, 70);
    ASSERT_GT(scene_blue.blue, 120);
    user("key ctrl+o");
    settle();
    user("type --delay 20 ./slow.glib");
    settle();
    user("key Return");
    const std::array<double, 4> scene = before["scene"];
    const double x = scene[0] + scene[2] / 2, y = scene[1] + scene[3] / 2;
    bool said = false;  // over the picture that was there, without the dialog
    for (int looks = 0; looks < 60 && !said && restarts() == 0; ++looks) {
        const Picture picture = look();
        said = picture.at(x + 90, y + 70) == scene_blue && picture.at(x, y - 12).blue < 60;
    }
    EXPECT_TRUE(said);
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1; }));
    settle();
    EXPECT_EQ(state()["file"], file("./slow.glib"));
    const std::string problems = state()["problems"];
    EXPECT_NE(problems.find("a frame of slow.glib took too long and was stopped"), std::string::npos) << problems;
    EXPECT_NE(bytes("out/errors").find("drawing a frame of slow.glib takes longer"), std::string::npos);
    EXPECT_FALSE(state()["widgets"].contains("browser.cancel"));
    save("slow.frag", paint("uPaint.grb"));
    EXPECT_TRUE(shows(green)) << "an edit of its shader is another try";
    ASSERT_TRUE(drop_files(display_, {file("scene.glib")}));
    ASSERT_TRUE(wait([&](const nlohmann::json& state) { return state["file"] == file("scene.glib"); }));
    settle();
    EXPECT_EQ(state()["controls"], before["controls"]);
}

TEST_F(Recovery, WhatWasSetByHandOutlivesTheMoveThatHung) {
    save("scene.glib",
         "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uBlue <0. 0. 1.> uHang <0. .1 1.>\n"
         "QuadXY 0. 9.\n");
    save(
        "paint.frag",
        "uniform float uBlue, uHang;\nvoid main() {\n  float x = gl_FragCoord.x;\n  int n = uHang > .5 ? 60000 : 0;\n" +
            loops("n", "uHang") + "  gl_FragColor = vec4(0., x < 0. ? 1. : 0., uBlue, 1.);\n}\n");
    open("scene.glib", {"--timeout", "2"});
    drag(on("Paint.uBlue", .05), on("Paint.uBlue", .7));
    drag(on("Paint.uHang", .1), on("Paint.uHang", .3));
    drag({200, 300}, {230, 310});
    const nlohmann::json before = state();
    const double blue = before["controls"]["Paint.uBlue"][0], hang = before["controls"]["Paint.uHang"][0];
    ASSERT_GT(blue, .5);
    ASSERT_TRUE(hang > .1 && hang < .5) << hang;
    ASSERT_NE(before["view"]["text"], "");
    click("Paint.uHang", .9);
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return !state.contains("controls"); }));
    settle();
    const std::string problems = state()["problems"];
    EXPECT_NE(problems.find("[frame-too-long]"), std::string::npos) << problems;
    EXPECT_NE(problems.find("set manually"), std::string::npos) << problems;
    keep("recovery-after-a-hang");
    user("key F5");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 0 && state["frames"] > 0; }));
    settle();
    const nlohmann::json after = state();
    EXPECT_EQ(after["controls"], before["controls"]) << "and the move that hung is not among it";
    EXPECT_EQ(after["view"]["text"], before["view"]["text"]);
    EXPECT_EQ(after["view"]["axes"], before["view"]["axes"]);
    EXPECT_NEAR(scene_pixel(90, 70).blue, 255 * blue, 1);
    EXPECT_TRUE(alive());
}

// An edit that asks for more than there is takes the window's memory, and not what was set by hand.
TEST_F(Recovery, MemoryThatRunsOutStartsTheWindowAgain) {
    if (sanitized) GTEST_SKIP() << "sanitizers need all addresses";
    const std::string fine =
        "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uRed <0. .2 1.>\nQuadXY 0. 9.\n";
    save("scene.glib", fine);
    save("paint.frag", "uniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, 0., 0., 1.); }\n");
    open("scene.glib");
    limit_memory(std::size_t{350} << 20);
    drag(on("Paint.uRed", .2), on("Paint.uRed", .7));
    const nlohmann::json before = state();
    const std::string much = fine + "Sphere 1 3000 3000\nSphere 2 3000 3000\nTorus .2 1 3000 3000\n";
    save("scene.glib", much);
    await_memory();
    if (IsSkipped() || HasFatalFailure()) return;
    settle();
    EXPECT_TRUE(says("memory ran out while reading scene.glib, and"));
    // F5 without an edit: the same again, and nothing is lost by it.
    std::filesystem::remove(file("out/state.json"));
    user("key F5");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 1; })) << bytes("out/errors");
    EXPECT_EQ(restarts(), 2U) << bytes("out/errors");
    EXPECT_TRUE(says("memory ran out in try 2 while reading scene.glib, and"));
    save("scene.glib", fine);
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 0 && state["frames"] > 0; }));
    settle();
    EXPECT_EQ(state()["controls"], before["controls"]);
    // Another scene that is too much is named, and leaves this one as it was.
    save("much.glib", much);
    ASSERT_TRUE(drop_files(display_, {file("much.glib")}));
    await_memory();
    if (IsSkipped() || HasFatalFailure()) return;
    settle();
    EXPECT_TRUE(says("memory ran out while reading much.glib, and"));
    EXPECT_TRUE(says("F5 or another edit shows scene.glib again, with the values"));
    user("mousemove 200 300 key F5");
    ASSERT_TRUE(wait([](const nlohmann::json& state) { return state["errors"] == 0 && state["frames"] > 0; }));
    settle();
    EXPECT_EQ(state()["file"], file("scene.glib"));
    EXPECT_EQ(state()["controls"], before["controls"]);
}

}  // namespace
}  // namespace snell::test
