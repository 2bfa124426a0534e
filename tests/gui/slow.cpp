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
    // Pixels on the left alone take long. Coarse pictures, which tell what sharp ones take, are no wider; a sharp one
    // takes a third of what they tell, and so does the test.
    static constexpr const char* left_alone = "if (gl_FragCoord.x > 150.) break;";
    static std::string shader(const std::string& rounds, const std::string& moving = "uPhase") {
        return "uniform float uRounds, uPhase, uTime;\nvoid main() {\n    float x = gl_FragCoord.x + " + moving +
               ";\n    for (int i = 0; i < " + rounds + "; ++i) {\n        if (float(i) >= uRounds) break;\n        " +
               left_alone + "\n        x += sin(x);\n    }\n    gl_FragColor = vec4(0., 1., 1e-9 * x, 1.);\n}\n";
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
    // More of the marks than before is drawn, or all; the window has answered so often meanwhile.
    int marked() const {
        int answers = 0;
        double last = -1;
        EXPECT_TRUE(wait([&](const json& s) {
            const json pixels = s.value("pixels", json::object());
            if (const double now = pixels.value("drawn", -1.); now > 0 && now != last) {
                ++answers;
                last = now;
            }
            return pixels.contains("flags");
        }));
        return answers;
    }
    static constexpr const char* slow = "1800";
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
    for (int i = 1; i < 8; ++i) user("mousemove_relative 1 0");
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
    open("slow.glib", {"--no-specialise"});
    EXPECT_TRUE(wait([](const json& s) { return s["frames"] > 6; }));
    const auto [all, coarse] = drawn();
    EXPECT_EQ(all, coarse);
    user("key space");
    settle();
    EXPECT_EQ(state()["grain"], 0);
}

TEST_F(SlowPictures, AreMarkedInStripsOnceTheyAreSharp) {
    save("paint.frag", shader("int(uRounds)", "(gl_FragCoord.x < 150. ? sqrt(-1. - uPhase) : 0.)"));
    save("slow.glib", scene("2500"));  // so that many strips are seen
    open("slow.glib", {"--no-specialise"});
    user("key n");
    EXPECT_GT(marked(), 3) << "the window answers between two strips";
    settle();
    const json flags = state()["pixels"]["flags"];
    EXPECT_EQ(state()["frames"], 2) << "the scene is not drawn again";
    const auto [x, y] = on("Paint.uPhase", .2);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " mousedown 1 mousemove_relative 9 0");
    EXPECT_TRUE(wait([](const json& s) { return s["grain"] > 0 && !s["pixels"].contains("flags"); }))
        << "what is dragged has no marks of an older picture";
    user("mouseup 1");
}

TEST_F(SlowPictures, SideBySideAreAsCoarseAndComeInStripsTogether) {
    save("paint.frag",
         "uniform float uRounds, uPhase;\nvoid main() {\n    float x = gl_FragCoord.x;\n"
         "    for (int i = 0; i < int(uRounds); ++i) {\n        " +
             std::string(left_alone) +
             "\n        x += sin(x);\n    }\n"
             "    gl_FragColor = vec4(uPhase, 1., 1e-9 * x, 1.);\n}\n");
    open("quick.glib", {"--no-specialise"});
    user("key s");
    settle();
    click("accuracy.right");
    click("right.settings");
    drawn();
    user("type --delay 8 uPhase=0.6");
    user("key space");
    user(std::string("type --delay 8 uRounds=") + slow);
    user("key Return");
    settle();
    EXPECT_EQ(drawn(), coarse_then_sharp);
    EXPECT_EQ(scene_pixel(-30, 20), (Pixel{0, 255, 0}));
    EXPECT_EQ(scene_pixel(30, 20), (Pixel{153, 255, 0}));
    const int strips = state()["strips"];
    const auto [x, y] = on("Paint.uPhase", .2);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " mousedown 1 mousemove_relative 9 0");
    EXPECT_TRUE(coarse_since());
    EXPECT_EQ(scene_pixel(30, 20), (Pixel{153, 255, 0}));
    user("mouseup 1");
    settle();
    const auto [all, coarse] = drawn();
    EXPECT_EQ(all - coarse, 1) << "one sharp picture of both";
    EXPECT_GT(state()["strips"], strips + 1);
    user("key n");
    EXPECT_GT(marked(), 3) << "both halves' marks come in strips";
    settle();
    EXPECT_EQ(state()["pixels"]["flags"].size(), 2U) << state()["pixels"];
    EXPECT_EQ(drawn(), (std::array{0, 0})) << "the scene is not drawn again";
}

TEST_F(SlowPictures, KeepWhatWasMeasuredOfTheirRungs) {
    std::string laddered = shader("int(uRounds)");
    laddered.insert(0, "#if N == N_slow\n#define ROUNDS uRounds\n#else\n#define ROUNDS 1.\n#endif\n");
    const std::string_view rounds = "float(i) >= uRounds";
    laddered.replace(laddered.find(rounds), rounds.size(), "float(i) >= ROUNDS");
    save("paint.frag", laddered);
    save("slow.glib", "Ladder N <quick> slow exact\n" + scene("1100"));
    open("slow.glib", {"--no-specialise", "--size", "640x700"});
    user("key a");
    const auto measured = [](const json& s) {
        if (!s.contains("accuracy") || s["accuracy"]["measuring"] || s["accuracy"]["points"].size() != 3) return false;
        for (const json& point : s["accuracy"]["points"])
            if (!(point["milliseconds"] > 0)) return false;
        return true;
    };
    ASSERT_TRUE(wait(
        [](const json& s) { return s.contains("accuracy") && s["accuracy"]["samples"] == s["accuracy"]["wanted"]; }));
    click("accuracy.measure");
    ASSERT_TRUE(wait(measured, 90)) << state()["accuracy"];
    const bool reduced = state()["widgets"].contains("accuracy.reduced");
    for (const char* what : {"slow", "two states", "one state"}) {
        if (what == std::string("slow"))
            click("accuracy.rung.slow", .1);
        else
            user("key s");
        settle();
        EXPECT_TRUE(measured(state())) << what << ": " << state()["accuracy"];
        EXPECT_EQ(state()["widgets"].contains("accuracy.reduced"), reduced) << what;
    }
}

// Each strip is short, and all of them take longer than anyone waits.
TEST_F(SlowPictures, AreGivenUpWhereAllStripsTogetherTakeTooLong) {
    save(
        "paint.frag",
        "uniform float uStep;\nvoid main() {\n    float x = gl_FragCoord.x;\n"
        "    for (float t = 0.; t < 1.; t += uStep) x += sin(x);\n    gl_FragColor = vec4(0., 1., 1e-9 * x, 1.);\n}\n");
    save("slow.glib",
         "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uStep <0. 0. 1.>\nQuadXY 0. 9.\n");
    open("slow.glib", {"--no-specialise", "--timeout", "5"});
    const auto failure = [](const json& s) { return s["failure"].get<std::string>(); };
    ASSERT_TRUE(wait([&](const json& s) {
        return failure(s).find("slow.glib took longer than 5 s") != std::string::npos;
    })) << state();
    EXPECT_NE(failure(state()).find("a loop of 'Paint' may not end"), std::string::npos) << failure(state());
    EXPECT_TRUE(
        wait([](const json& s) { return s["problems"].get<std::string>().find("for ever") != std::string::npos; }));
    settle();
    const int strips = state()["strips"];
    EXPECT_GT(strips, 3);
    EXPECT_GT(state()["grain"], 0) << "the coarse one stays";
    click("Paint", .5);
    click("Paint", .5);
    settle();
    EXPECT_EQ(state()["strips"], strips) << "nobody tries again";
    type("Paint.uStep", "0.5", Field::number);
    settle();
    EXPECT_EQ(failure(state()), "");
    EXPECT_EQ(state()["grain"], 0);
    EXPECT_EQ(bytes("out/errors").find("started again"), std::string::npos);
}

// Strips share what is off-screen with pictures that are saved meanwhile, of other moments.
TEST_F(SlowPictures, AreOfOneMomentWhileASequenceIsSaved) {
    save("time.frag", "uniform float uTime;\nvoid main() { gl_FragColor = vec4(.2 + .02 * uTime, 0., 0., 1.); }\n");
    save("paint.frag",
         "uniform float uRounds;\nuniform sampler2D uMap;\nvoid main() {\n    float x = gl_FragCoord.x;\n"
         "    for (int i = 0; i < int(uRounds); ++i) {\n        " +
             std::string(left_alone) +
             "\n        x += sin(x);\n    }\n"
             "    gl_FragColor = vec4(texture2D(uMap, vec2(.5)).r, 1., 1e-9 * x, 1.);\n}\n");
    save("slow.glib",
         "Ortho -1 1 -1 1\nTexture2D 5 16 16\nRenderToTexture 5\nVertex paint.vert\nFragment time.frag\nProgram Time\n"
         "QuadXY 0. 9.\nRenderToTexture\nFragment paint.frag\nProgram Paint uMap 5 uRounds <1. " +
             std::string(slow) + ". 3000.>\nQuadXY 0. 9.\n");
    open("slow.glib", {"--no-specialise"});
    user("key space");
    settle();
    EXPECT_EQ(state()["grain"], 0);
    const Pixel color = scene_pixel(0, 60);
    choose("save", "picture");
    type("picture file", file("f.png"), Field::unconfirmed);
    type("picture width", "64", Field::number);
    type("picture height", "64", Field::number);
    click("picture sequence");
    type("picture from", "20", Field::number);
    type("picture to", "30", Field::number);
    type("picture rate", "1", Field::number);
    const auto [x, y] = on("picture save");
    const int strips = state()["strips"];
    user("search --onlyvisible --name slow windowsize 800 580 sleep .3 mousemove " + std::to_string(x) + " " +
         std::to_string(y - 10) + " click 1");
    EXPECT_TRUE(wait([&](const json& s) { return s["strips"] > strips + 1; }));
    EXPECT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().starts_with("saved "); })) << state();
    settle();
    const std::array<double, 4> scene = state()["scene"];
    const Picture picture = look();
    for (int row = 2; row < static_cast<int>(scene[3]) - 2; row += 4) {
        EXPECT_EQ(picture.at(30, row), color) << row;
        if (HasFailure()) break;
    }
}

// What frame cost plots is of sharp pictures; the coarse ones are counted apart.
TEST_F(SlowPictures, HaveCostsOfSharpOnesAlone) {
    open("slow.glib", {"--no-specialise"});
    click("tools");
    click("frame cost");
    settle();
    EXPECT_EQ(drawn(), coarse_then_sharp) << "no sharp one again, only for its time";
    const auto expect_sharp = [&](int pictures) {
        const json now = state(), cost = now["frame_cost"];
        EXPECT_EQ(cost["pictures"], pictures);
        EXPECT_EQ(cost["last"].get<float>(), now["ms"][0].get<float>()) << "the sharp one was last";
        EXPECT_EQ(cost["coarse"].get<int>(), now["coarse"].get<int>() - 1) << "since the panel is open";
        EXPECT_EQ(now["widgets"].contains("frame cost.coarse"), pictures > 1);
    };
    expect_sharp(1);
    click("controls");
    drag(on("Paint.uPhase", .1), on("Paint.uPhase", .8));
    settle();
    click("tools");
    settle();
    expect_sharp(2);
}

// Dozens of pictures of that size would keep the window from answering for minutes.
TEST_F(SlowPictures, AreMeasuredWithFewerPixels) {
    save("paint.vert", "varying float vAt;\nvoid main() { vAt = gl_Vertex.x; gl_Position = ftransform(); }\n");
    save("paint.frag",
         "uniform float uRounds, uPhase;\nvarying float vAt;\nvoid main() {\n    float x = gl_FragCoord.x;\n"
         "    for (int i = 0; i < int(uRounds); ++i) x += sin(x);\n"
         "#if RED == RED_none\n    float red = 0.;\n#else\n    float red = step(.5, fract(10. * vAt));\n#endif\n"
         "    gl_FragColor = vec4(red, 1., 1e-9 * x, 1.);\n}\n");
    save("slow.glib", "Ladder RED <none> all\n" + scene(slow));
    open("slow.glib", {"--no-specialise"});
    EXPECT_FALSE(state()["widgets"].contains("accuracy.reduced"));
    user("key a");
    ASSERT_TRUE(wait(
        [](const json& s) { return s.contains("accuracy") && s["accuracy"]["samples"] == s["accuracy"]["wanted"]; }));
    EXPECT_NEAR(state()["accuracy"]["error"].get<double>(), std::sqrt(.5 / 3), .04)
        << "stripes stay as wide as they are";
    EXPECT_TRUE(state()["widgets"].contains("accuracy.reduced")) << "and that is said";
    user("key a");
    click("tools");
    click("frame cost");
    click("frame cost.measure");
    ASSERT_TRUE(wait([](const json& s) { return s.contains("frame_cost") && !s["frame_cost"]["apart"].empty(); }));
    const json now = state();
    double all = 0;
    for (const json& cost : now["frame_cost"]["apart"]) all += cost["draw"] ? 0 : cost["milliseconds"].get<double>();
    EXPECT_LT(all, now["ms"][0].get<double>() / 4);
    EXPECT_TRUE(now["widgets"].contains("frame cost.reduced"));
    EXPECT_FALSE(now["widgets"].contains("frame cost.older"));
    // It goes with the times, and not with the picture.
    click("controls");
    type("Paint.uRounds", "9", Field::number);
    click("tools");
    settle();
    EXPECT_TRUE(state()["widgets"].contains("frame cost.reduced"));
    EXPECT_TRUE(state()["widgets"].contains("frame cost.older"));
}

TEST_F(SlowPictures, OfTheReferenceAloneHaveFewerPixelsThere) {
    save("paint.frag",
         "uniform float uRounds, uPhase;\nvoid main() {\n    float x = gl_FragCoord.x;\n"
         "#if RED == RED_none\n    float red = 0.;\n#else\n    float red = 1.;\n"
         "    for (int i = 0; i < int(uRounds); ++i) x += sin(x);\n#endif\n"
         "    gl_FragColor = vec4(red, 1., 1e-9 * x, 1.);\n}\n");
    save("slow.glib", "Ladder RED <none> all\n" + scene(slow));
    open("slow.glib", {"--no-specialise"});
    EXPECT_EQ(state()["coarse"], 0);
    user("key a");
    ASSERT_TRUE(wait(
        [](const json& s) { return s.contains("accuracy") && s["accuracy"]["samples"] == s["accuracy"]["wanted"]; }));
    EXPECT_TRUE(state()["widgets"].contains("accuracy.reduced"));
    EXPECT_NEAR(state()["accuracy"]["error"].get<double>(), std::sqrt(1 / 3.), 1e-3);
}

// The text shows no long loops: the picture before tells, from which one cannot know how much of it the compiler took.
TEST_F(SlowPictures, AreCoarseOnceOneTookLongWhateverTheTextSays) {
    const std::string dear = "x += sin(x + cos(x * 1.7)) + exp(-x * x) * pow(abs(x) + .1, 1.3);";
    save("paint.frag",
         "uniform float uPhase;\nvoid main() {\n    float x = gl_FragCoord.x + uPhase;\n"
         "    for (int i = 0; i < 450; ++i) { " +
             dear +
             " }\n"
             "    gl_FragColor = vec4(0., 1., 1e-9 * x, 1.);\n}\n");
    open("slow.glib", {"--no-specialise", "--size", "1000x700"});
    EXPECT_EQ(drawn(), (std::array{1, 0})) << "nobody could know";
    const auto [x, y] = on("Paint.uPhase", .2);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " mousedown 1 mousemove_relative 9 0");
    EXPECT_TRUE(coarse_since());
    EXPECT_EQ(state()["frames"].get<int>() - state()["coarse"].get<int>(), 1) << "the first change is coarse";
    user("mouseup 1");
    settle();
    EXPECT_GT(state()["strips"], 3);
}

// Neither a coarse picture nor a strip of it would be quicker.
TEST_F(SlowPictures, AreDrawnAtOnceWhereVerticesTakeLong) {
    save("paint.vert",
         "uniform float uPhase;\nvoid main() {\n    float x = gl_Vertex.x + uPhase;\n"
         "    for (int i = 0; i < 700; ++i) x += sin(x + cos(x * 1.7)) + exp(-x * x);\n"
         "    gl_Position = ftransform() + vec4(0., 0., 1e-9 * x, 0.);\n}\n");
    save("paint.frag", "void main() { gl_FragColor = vec4(0., 1., 0., 1.); }\n");
    save("slow.glib", "Vertex paint.vert\nFragment paint.frag\nProgram Paint uPhase <0. 0. 1.>\nSphere 1. 400 400\n");
    open("slow.glib", {"--no-specialise"});
    drawn();
    const auto [x, y] = on("Paint.uPhase");
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " keydown ctrl click 1 keyup ctrl");
    settle();
    user("key ctrl+a");
    user("type --delay 8 0.25");
    user("key Return");
    EXPECT_TRUE(wait([&](const json& s) { return s["widgets"].contains("status.grain"); })) << "it says that it draws";
    settle();
    EXPECT_FALSE(state()["widgets"].contains("status.grain"));
    EXPECT_EQ(drawn(), (std::array{1, 0}));
    EXPECT_EQ(state()["strips"], 0);
    EXPECT_GT(state()["ms"][0], 500) << "so that the test judges something";
    // The first click begins a picture of that length, in which the second one waits.
    user("mousemove " + std::to_string(x + 20) + " " + std::to_string(y) + " click --repeat 2 --delay 90 1");
    settle();
    EXPECT_EQ(state()["controls"]["Paint.uPhase"][0], .25) << "a double click changes nothing";
    user("key ctrl+a");
    user("type --delay 8 0.625");
    user("key Return");
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uPhase"][0] == .625; }));
}

// Strip by strip, a sharp picture is that which is drawn at once.
TEST_F(SlowPictures, AreSharpFromTheStartWhereNoneMayBeCoarse) {
    save("paint.vert", "varying vec3 vAt;\nvoid main() { vAt = gl_Vertex.xyz; gl_Position = ftransform(); }\n");
    save("paint.frag",
         "uniform float uRounds;\nvarying vec3 vAt;\nvoid main() {\n    float x = vAt.x + 3. * vAt.y;\n"
         "    for (int i = 0; i < 60000 && float(i) < uRounds; ++i) {\n        " +
             std::string(left_alone) +
             "\n        x += .1 * sin(x + vAt.z);\n    }\n"
             "    gl_FragColor = vec4(fract(3. * x), fract(9. * vAt.y), 20. * dFdx(vAt.z), 1.);\n}\n");
    save("slow.glib",
         "Perspective 50\nLookAt 0 0 3  0 0 0  0 1 0\nVertex paint.vert\nFragment paint.frag\n"
         "Program Paint uRounds <1. 1200. 9000.>\nSphere 1. 40 40\nTranslate .9 .4 .3\nSphere .5 40 40\n");
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
