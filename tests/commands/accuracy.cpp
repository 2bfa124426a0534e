// `snell accuracy` as a user runs it.
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/command.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

class Accuracy : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        folder.write("lit.vert",
                     "#version 330 compatibility\nout vec3 vN;\nvoid main() { vN = gl_Normal; gl_Position = "
                     "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write("lit.frag",
                     "#version 330 compatibility\nin vec3 vN;\nvoid main() {\n float c = abs(vN.z);\n#if SHADE == "
                     "SHADE_cheap\n c = .9 * c;\n#endif\n gl_FragColor = vec4(vec3(c), 1.);\n}\n");
        scene = folder.write("scene.glib",
                             "Ladder SHADE <cheap> exact\nVertex lit.vert\nFragment lit.frag\nProgram Lit\n"
                             "Ortho -1.5 1.5 -1.5 1.5\nLookAt 0 0 3 0 0 0 0 1 0\nSphere 1 12 12\n");
    }

    int run(const std::string& arguments) const {
        return snell("accuracy " + scene + " " + arguments + " >out.txt 2>err.txt", "", folder.path()).status;
    }
    std::string text(const std::string& name) const { return bytes_of(folder.path(name)); }

    std::string scene;
};

TEST_F(Accuracy, WritesEveryFormat) {
    folder.write("scene.glib", text("scene.glib").replace(text("scene.glib").find("12 12"), 5, "30 30"));
    ASSERT_EQ(
        run("--size 64x64 --reps 3 --budget 4 --ladders SHADE --knobs samples -o " + folder.path("r.html") + " --svg " +
            folder.path("p.svg") + " --json " + folder.path("r.json") + " --csv " + folder.path("r.csv")),
        0)
        << text("err.txt");
    const auto json = nlohmann::json::parse(text("r.json"));
    ASSERT_EQ(json["ladders"].size(), 2U);
    const auto& shade = json["ladders"][0];
    EXPECT_EQ(shade["ladder"], "SHADE");
    EXPECT_EQ(shade["rungs"][0]["is_current"], true);
    EXPECT_EQ(shade["rungs"][1]["alone"]["rmse"], 0);
    EXPECT_GT(shade["rungs"][0]["own"]["light"]["rmse"], .01);
    EXPECT_LE(shade["rungs"][0]["n_rounds"], 3);
    EXPECT_GE(shade["rungs"][0]["n_rounds"], 1);
    EXPECT_FALSE(json["gl"]["renderer"].get<std::string>().empty());
    EXPECT_EQ(json["scene"]["size"], (std::vector<int>{64, 64}));
    // The shader's brightness is a tenth off, over the ball; its square's mean over a disc is 1/2.
    EXPECT_NEAR(shade["rungs"][0]["own"]["display"]["rmse"].get<double>(), .1 * std::sqrt(.5), .01);

    std::istringstream csv(text("r.csv"));
    std::string line;
    std::getline(csv, line);
    const auto columns = std::count(line.begin(), line.end(), ',');
    for (const char* name : {"cpu_ms_median", "aa_control_ratio", "wall_cv", "cliff", "ref_residual", "renderer",
                             "width", "reps", "date", "load_before", "machine", "tuple", "from"})
        EXPECT_NE(("," + line + ",").find(std::string(",") + name + ","), std::string::npos) << name;
    int rows = 0;
    for (; std::getline(csv, line); ++rows) {
        bool quoted = false;
        EXPECT_EQ(std::count_if(line.begin(), line.end(),
                                [&](char c) {
                                    quoted = quoted != (c == '"');
                                    return c == ',' && !quoted;
                                }),
                  columns);
    }
    EXPECT_EQ(rows, 2 + 6);

    const std::string html = text("r.html");
    EXPECT_NE(html.find("<svg"), std::string::npos);
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("src=\"http"), std::string::npos) << "nothing comes over a network";
    EXPECT_NE(html.find("data:image/png;base64,iVBOR"), std::string::npos);
    EXPECT_TRUE(text("p.svg").starts_with("<svg"));
    EXPECT_TRUE(text("p-2.svg").starts_with("<svg"));
}

TEST_F(Accuracy, InterruptedItWritesWhatItHas) {
    const int seconds = static_cast<int>(2 * patience);
    // In the foreground: else it comes twice, and the second ends it.
    const Outcome ended = test::run("timeout --foreground -s INT " + std::to_string(seconds) +
                                    " " SNELL_BIN "/snell accuracy " + scene + " --size 100x100 --reps 5000 --budget " +
                                    std::to_string(3 * seconds) + " --ladders SHADE --json " + folder.path("r.json"));
    EXPECT_EQ(ended.status, 124) << "of `timeout`, which waited for the end: " << ended.output;
    const auto json = nlohmann::json::parse(text("r.json"));
    EXPECT_EQ(json["ladders"][0]["interrupted"], true);
    EXPECT_EQ(json["ladders"][0]["rungs"][0]["drawn"], true);
}

// A second Ctrl-C does not wait for what was measured: each file is the old one, or whole.
TEST_F(Accuracy, InterruptedTwiceItLeavesNothingHalf) {
    int killed = 0;
    for (const char* between : {"0", ".05"}) {
        folder.write("r.html", "old");
        folder.write("r.json", "old");
        const std::string measure = std::string(SNELL_BIN "/snell accuracy ") + scene +
                                    " --size 900x900 --reps 5000 --budget 4 --ladders SHADE -o " +
                                    folder.path("r.html") + " --json " + folder.path("r.json") + " > " +
                                    folder.path("out.txt") + " 2> " + folder.path("err.txt");
        const std::string interrupt =
            " & p=$!; sleep .8; kill -INT $p; sleep " + std::string(between) + "; kill -INT $p 2>/dev/null; wait $p";
        const int status = std::system((measure + interrupt).c_str());
        killed += WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT ? 1 : 0;
        const std::string html = text("r.html"), json = text("r.json");
        EXPECT_TRUE(html == "old" || html.find("</html>") != std::string::npos) << html.size() << " bytes";
        EXPECT_TRUE(json == "old" || nlohmann::json::accept(json)) << json.size() << " bytes";
    }
    EXPECT_GT(killed, 0) << "the second one ends the program";
}

// An error that the second rung meets and the first does not, whatever the reference is good for on this machine.
TEST_F(Accuracy, AdvisesACombinationAndSaysHowToDrawIt) {
    const std::string quick = "--size 32x32 --reps 7 --budget 2 --no-found ";
    ASSERT_EQ(run(quick + "--ladders SHADE --no-time --json " + folder.path("r.json")), 0) << text("err.txt");
    const auto shade = nlohmann::json::parse(text("r.json"))["ladders"][0];
    const auto error = [&](std::size_t rung) { return shade["rungs"][rung]["own"]["light"]["rmse"].get<double>(); };
    ASSERT_GT(error(0), 1.2 * error(1));
    const double between = (error(0) + error(1)) / 2 + shade["reference"]["residual"].get<double>();
    ASSERT_EQ(run(quick + "--error " + std::to_string(between)), 0) << text("out.txt");
    EXPECT_NE(text("out.txt").find("--ladder SHADE=exact\n"), std::string::npos) << text("out.txt");
    for (const char* unmet : {"--within 0.0001ms", "--error 1e-9"}) {
        EXPECT_EQ(run(quick + "--time 1.5 " + unmet), 1) << unmet;
        EXPECT_NE(text("out.txt").find("nothing that was measured is; the nearest is SHADE="), std::string::npos);
        EXPECT_NE(text("out.txt").find(".glib -o picture.png --size 32x32 --time 1.5 --ladder SHADE="),
                  std::string::npos)
            << "the picture that was measured: " << text("out.txt");
    }
    // Three rounds have no interval; what they say is not denied either.
    EXPECT_EQ(run("--size 32x32 --reps 3 --budget 2 --no-found --within 100s"), 1);
    EXPECT_NE(text("out.txt").find("nothing that was measured surely is; the nearest is SHADE="), std::string::npos)
        << text("out.txt");
    EXPECT_EQ(run("--within soon"), 2);
    for (const char* odd : {"--error nan", "--error inf", "--error -1", "--budget nan"}) EXPECT_EQ(run(odd), 2) << odd;
    EXPECT_EQ(run("--within 5ms --no-time"), 2) << "what is not timed has no cost";
}

TEST_F(Accuracy, ReferenceThatIsNotFiniteIsAnErrorAtItsRung) {
    folder.write("lit.frag",
                 "#version 330 compatibility\nin vec3 vN;\nuniform float uZero;\nvoid main() {\n float c = .5;\n#if "
                 "SHADE == SHADE_exact\n c /= uZero;\n#endif\n gl_FragColor = vec4(vec3(c), 1.);\n}\n");
    for (const char* what : {"--ladders SHADE --no-time", "--error 0.1", "--save-quality"}) {
        EXPECT_EQ(run(std::string("--size 16x16 --reps 7 --budget 1 --no-found ") + what), 1) << what;
        EXPECT_NE(text("err.txt").find("scene.glib:1:22: error: SHADE: the reference is NaN or infinite in "),
                  std::string::npos)
            << text("err.txt");
    }
    EXPECT_TRUE(text("scene.quality.json").empty()) << "nothing is stored of which nothing is known";
}

TEST_F(Accuracy, BudgetThatDrawsNothingIsAnError) {
    folder.write("lit.frag",
                 "#version 330 compatibility\nin vec3 vN;\nvoid main() {\n float c = vN.z;\n#if SHADE == SHADE_exact\n"
                 " for (int i = 0; i < 60000; ++i) c = sin(c + sin(c + 1.));\n#endif\n"
                 " gl_FragColor = vec4(vec3(c), 1.);\n}\n");
    EXPECT_EQ(run("--size 64x64 --budget 1 --ladders SHADE"), 1) << text("out.txt");
    EXPECT_NE(text("err.txt").find("no rung was drawn: the time was up"), std::string::npos) << text("err.txt");
}

// The whole command with every knob; what starts and ends it is no part of the budget.
TEST_F(Accuracy, BudgetHolds) {
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run("--size 256x256 --budget 2 --json " + folder.path("r.json")), 0) << text("err.txt");
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_LT(took, 4 * patience) << text("out.txt");
    EXPECT_EQ(nlohmann::json::parse(text("r.json"))["ladders"].size(), 3U);
}

TEST_F(Accuracy, ReportsOfTwoMachinesAreMerged) {
    ASSERT_EQ(run("--size 16x16 --reps 9 --budget 4 --no-found --ladders SHADE --json " + folder.path("a.json")), 0);
    ASSERT_EQ(std::system(("cp " + folder.path("a.json") + " " + folder.path("b.json")).c_str()), 0);
    scene = "--merge " + folder.path("a.json") + " " + folder.path("b.json");
    EXPECT_EQ(run(""), 0) << text("err.txt");
    EXPECT_EQ(text("out.txt").find("not portable"), std::string::npos) << "one machine agrees with itself";
    EXPECT_NE(text("out.txt").find("SHADE\n"), std::string::npos) << text("out.txt");
    folder.write("b.json", "{}");
    EXPECT_EQ(run(""), 1);
    EXPECT_NE(text("err.txt").find("b.json' is not a report"), std::string::npos) << text("err.txt");
    scene = "";
    EXPECT_EQ(run(""), 2);
}

// Presets are found by measurement, kept beside the scene, and said when they are used; what is typed wins.
TEST_F(Accuracy, PresetsAreMeasuredKeptAndSaid) {
    const auto render = [&](const std::string& arguments, const std::string& picture) {
        return snell("render scene.glib --size 64x64 -o " + picture + " " + arguments + " 2>err.txt", "", folder.path())
            .status;
    };
    EXPECT_EQ(render("--quality exact", "none.png"), 1) << "nothing was measured yet";
    EXPECT_NE(text("err.txt").find("--save-quality"), std::string::npos) << text("err.txt");
    ASSERT_EQ(run("--size 64x64 --reps 7 --budget 2 --no-found --save-quality"), 0) << text("err.txt");
    ASSERT_EQ(render("--quality exact", "exact.png"), 0) << text("err.txt");
    EXPECT_NE(text("err.txt").find("quality exact: SHADE=exact"), std::string::npos) << text("err.txt");
    ASSERT_EQ(render("", "plain.png") + render("--ladder SHADE=exact", "typed.png") +
                  render("--quality exact --ladder SHADE=cheap", "cheap.png"),
              0);
    EXPECT_EQ(text("exact.png"), text("typed.png"));
    EXPECT_EQ(text("cheap.png"), text("plain.png"));
    EXPECT_NE(text("exact.png"), text("plain.png"));
    folder.write("scene.glib", text("scene.glib").replace(text("scene.glib").find("exact"), 5, "right"));
    EXPECT_EQ(render("--quality exact", "stale.png"), 1);
    EXPECT_NE(text("err.txt").find("stale-quality"), std::string::npos) << text("err.txt");
}

TEST_F(Accuracy, ValuesThatAreNoneAreErrors) {
    for (const char* const set : {"uK=nan", "nosuch=1"}) {
        EXPECT_EQ(run("--no-time --size 64x64 --set " + std::string(set)), 1) << set;
        EXPECT_NE(text("err.txt").find("error: "), std::string::npos) << text("err.txt");
        EXPECT_EQ(text("out.txt").find("RMSE"), std::string::npos) << "nothing is measured with other values";
    }
}

TEST_F(Accuracy, LimitsOfValuesAreShort) {
    for (const char* const option : {"--error -1", "--within -1", "--budget -1", "--reps -1"}) {
        EXPECT_EQ(run(option), 2) << option;
        const std::string said = text("err.txt");
        EXPECT_NE(said.find("-1"), std::string::npos) << said;
        EXPECT_LT(said.size(), 200U) << said;
    }
}

TEST_F(Accuracy, AShaderThatDoesNotCompileEndsItAtOnce) {
    folder.write("lit.frag", "void main() { gl_FragColor = vec4(oops); }");
    const auto begun = std::chrono::steady_clock::now();
    EXPECT_EQ(run("--size 64x64 --csv " + folder.path("none.csv")), 1);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), 10 * patience);
    EXPECT_NE(text("err.txt").find("lit.frag:1:35: error: "), std::string::npos) << text("err.txt");
    EXPECT_EQ(text("out.txt"), "") << "nothing is measured";
    EXPECT_FALSE(std::filesystem::exists(folder.path("none.csv")));
}

TEST_F(Accuracy, FoundRungsArePlottedToo) {
    folder.write("lit.frag",
                 "#version 330 compatibility\nin vec3 vN;\nvoid main() {\n float c = 0.;\n for (int i = 0; i < 20; "
                 "i++) c += abs(sin(vN.z + float(i))) / 20.;\n gl_FragColor = vec4(vec3(c), 1.);\n}\n");
    ASSERT_EQ(run("--size 16x16 --reps 7 --budget 1 --knobs samples --no-found --svg " + folder.path("k.svg")), 0);
    EXPECT_NE(
        run("--size 16x16 --reps 7 --budget 2 --svg " + folder.path("p.svg") + " --markdown " + folder.path("p.md")), 2)
        << text("err.txt");
    const std::string page = text("p.md");
    const std::size_t plot = page.find("![found rungs: error over time](p");
    ASSERT_NE(plot, std::string::npos) << page;
    const std::size_t from = page.find('(', plot) + 1;
    EXPECT_TRUE(text(page.substr(from, page.find(')', from) - from)).starts_with("<svg"));
}

TEST_F(Accuracy, UnknownNamesAreErrors) {
    EXPECT_EQ(run("--ladders SHAD --no-time"), 1);
    EXPECT_NE(text("err.txt").find("did you mean 'SHADE'?"), std::string::npos) << text("err.txt");
    EXPECT_EQ(run("--knobs sample --no-time"), 1);
    EXPECT_NE(text("err.txt").find("tessellation"), std::string::npos);
    EXPECT_EQ(run("--from here"), 2);
}

}  // namespace
}  // namespace snell::test
