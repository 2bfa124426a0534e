// The bar of a load that takes long: on a terminal, and nowhere else.
#include <gtest/gtest.h>
#include <chrono>

#include "src/app/open/progress.h"
#include "tests/cli/run.h"
#include "tests/cli/terminal.h"
#include "tests/scratch.h"

namespace snell::test {
namespace {

using namespace std::chrono_literals;
using Stage = LoadProgress::Stage;

TEST(Progress, IsDueAfterHalfASecondAndThenAFewTimesASecond) {
    Patience patience;
    const Patience::Clock::time_point start{};
    EXPECT_FALSE(patience.due({Stage::programs, "", 0, 3}, start));
    EXPECT_FALSE(patience.due({Stage::files, "", 1, 3}, start + 499ms));
    EXPECT_TRUE(patience.due({Stage::files, "", 1, 3}, start + 501ms));
    EXPECT_FALSE(patience.due({Stage::files, "", 2, 3}, start + 520ms));
    EXPECT_TRUE(patience.due({Stage::draws, "", 0, 3}, start + 560ms));
    EXPECT_FALSE(patience.due({Stage::programs, "", 0, 3}, start + 2s)) << "another load";
    EXPECT_TRUE(patience.due({Stage::programs, "", 1, 3}, start + 2600ms));
}

TEST(Progress, ALineFitsItsTerminalInWholeCharacters) {
    const LoadProgress half{Stage::files, "w\xC3\xA4nde.png", 2, 4};
    EXPECT_EQ(progress_line(half, 80), "snell [##########..........] reading files: 2 of 4 (w\xC3\xA4nde.png)");
    for (std::size_t columns = 1; columns < 70; ++columns) {
        const std::string line = progress_line(half, columns);
        EXPECT_LT(line.size(), columns);
        EXPECT_TRUE(line.empty() || line.back() != '\xC3') << columns;
    }
    EXPECT_EQ(progress_line({Stage::files, "evil\x1b[2J", 0, 1}, 80).find('\x1b'), std::string::npos);
}

class ProgressLines : public testing::Test {
protected:
    void SetUp() override {
        folder.write("noise.vert", "void main() { gl_Position = ftransform(); }\n");
        folder.write("noise.frag",
                     "uniform sampler3D Noise3;\nvoid main() { gl_FragColor = texture3D(Noise3, vec3(.5)); }\n");
        folder.write("slow.glib", scene(384));
        folder.write("quick.glib", scene(16));
    }
    static std::string scene(int size) {
        return "Noise3D " + std::to_string(size) + "\nVertex noise.vert\nFragment noise.frag\nProgram N\nQuadXY -2\n";
    }
    std::string render(const std::string& stem) const {
        return "render " + folder.path(stem + ".glib") + " --size 16x16 --timeout 0 -o " + folder.path(stem + ".png");
    }
    Scratch folder;
};

TEST_F(ProgressLines, ASlowLoadHasABarOnATerminalThatIsGoneAfterwards) {
    const auto [text, seconds] = on_terminal(render("slow"));
    if (text.find("no graphics") != std::string::npos) GTEST_SKIP() << text;
    if (seconds < .8) GTEST_SKIP() << "this machine is too fast for the test: " << seconds << " s";
    EXPECT_NE(text.find("reading files: 0 of 1 (noise3d.384.tex)"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\r\x1b[K")) << text;
}

TEST_F(ProgressLines, TimingFramesHasABarToo) {
    const auto [text, seconds] =
        on_terminal("explain " + folder.path("quick.glib") + " --size 80x80 --reps 10000 --timeout 4");
    if (text.find("no graphics") != std::string::npos) GTEST_SKIP() << text;
    if (text.find("[timeout]") != std::string::npos) GTEST_SKIP() << "this machine is busy";
    EXPECT_NE(text.find("] timing frames: round "), std::string::npos) << text;
    EXPECT_LT(text.rfind("timing frames"), text.rfind("\r\x1b[K")) << "it is gone in the end";
    EXPECT_LT(text.rfind("\r\x1b[K"), text.find("PAYS FOR")) << text;
}

TEST_F(ProgressLines, MeasuringHasOneWhereTheTerminalCanClearIt) {
    const std::string accuracy = "accuracy " + folder.path("quick.glib") + " --size 64x64 --no-found --budget ";
    const auto [text, seconds] = on_terminal(accuracy + "2");
    if (text.find("no graphics") != std::string::npos) GTEST_SKIP() << text;
    EXPECT_NE(text.find(" s left"), std::string::npos) << text;
    EXPECT_EQ(text.find("\r\x1b[K"), text.find("snell [") - 4) << text;
    const auto [plain, again] = on_terminal(accuracy + "1", "dumb");
    EXPECT_EQ(plain.find(" s left"), std::string::npos) << plain;
    EXPECT_EQ(plain.find('\x1b'), std::string::npos) << plain;
}

TEST_F(ProgressLines, AQuickLoadHasNone) {
    const auto [text, seconds] = on_terminal(render("quick"));
    if (text.find("no graphics") != std::string::npos) GTEST_SKIP() << text;
    if (seconds > .5) GTEST_SKIP() << "this machine is busy";
    EXPECT_EQ(text, "");
}

TEST_F(ProgressLines, APipeGetsNone) {
    const Outcome outcome = snell(render("slow"));
    if (outcome.says("no graphics")) GTEST_SKIP() << outcome.output;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(outcome.status, 0);
}

}  // namespace
}  // namespace snell::test
