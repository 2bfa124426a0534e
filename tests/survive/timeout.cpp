// What does not end is ended: every command that draws or reads has --timeout, and status 4.
#include "tests/cli/command.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

class Timeout : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        const std::string loop = "  for (int i = 0; i < 60000; ++i) x = fract(sin(x + uOne) * 43758.5);\n";
        folder.write("s.frag", "uniform float uOne;\nvoid main() {\n  float x = gl_FragCoord.x;\n" + loop + loop +
                                   "  gl_FragColor = vec4(x);\n}\n");
        folder.write("s.glib",
                     "LookAt 0 0 4 0 0 0 0 1 0\nPerspective 90\nFragment s.frag\nProgram P uOne 1.\nQuadXY 0. 9.\n");
        folder.write("quick.glib", "Sphere\n");
    }

    // The frame would take minutes.
    void expect_ended(const std::string& arguments) const {
        const auto start = std::chrono::steady_clock::now();
        const Outcome ended = snell(arguments);
        EXPECT_EQ(ended.status, 4) << arguments << '\n' << ended.output;
        EXPECT_TRUE(ended.says("[timeout]")) << ended.output;
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30) * patience) << arguments;
    }

    std::string scene() const { return folder.path("s.glib"); }
    std::string quick() const { return folder.path("quick.glib"); }
};

TEST_F(Timeout, EndsFramesOfEveryCommandThatDraws) {
    expect_ended("explain --size 1024x1024 --timeout .6 " + scene());
    expect_ended("accuracy --knobs samples --size 1024x1024 --timeout .6 " + scene());
    expect_ended("sweep --over uOne=0,1 --size 1024x1024 --timeout .6 " + scene() + " -o " + folder.path("{uOne}.png"));
}

// No context is made within so little time.
TEST_F(Timeout, EndsReadingAndCompiling) {
    expect_ended("check --timeout .0001 " + scene());
    expect_ended("info --timeout .0001");
}

// Whenever it ends, nothing half-written stays.
TEST_F(Timeout, LeavesNoTemporaryFile) {
    int ended = 0;
    for (int n = 0; n < 24; ++n) {
        const std::string limit = std::to_string(.0001 + .0002 * n);
        ended += snell("save --timeout " + limit + " " + quick() + " -o " + folder.path("copy.glib")).status == 4;
        std::filesystem::remove(folder.path("copy.glib"));
        EXPECT_EQ(folder.entries(), 3U) << limit;
    }
    EXPECT_GT(ended, 0);
}

TEST_F(Timeout, LeavesAloneWhatEnds) {
    for (const std::string limit : {"", " --timeout 0", " --timeout 100"}) {
        EXPECT_EQ(snell("check" + limit + " " + quick()).status, 0) << limit;
        EXPECT_EQ(snell("info" + limit).status, 0) << limit;
        EXPECT_EQ(snell("explain --no-time --size 16x16" + limit + " " + quick()).status, 0) << limit;
    }
    EXPECT_EQ(snell("accuracy --knobs samples --no-time --size 16x16 --timeout 100 " + quick()).status, 0);
}

// The file that rows are written to is there from the beginning, and gone in the end.
TEST_F(Timeout, OfAPictureInPartsLeavesNothing) {
    const std::size_t before = folder.entries();
    expect_ended("render --tile 1024 --size 2048x2048 --timeout .6 " + scene() + " -o " + folder.path("o.png"));
    EXPECT_EQ(folder.entries(), before);
}

TEST_F(Timeout, TakesNumbersAlone) {
    for (const char* command : {"check", "explain", "accuracy"})
        for (const char* wrong : {"-1", "nan", "inf", "soon", ""})
            EXPECT_EQ(snell(std::string(command) + " --timeout '" + wrong + "' " + quick()).status, 2)
                << command << ' ' << wrong;
    for (const char* wrong : {"-1", "nan", "soon"}) EXPECT_EQ(snell("info --timeout " + std::string(wrong)).status, 2);
}

}  // namespace
}  // namespace snell::test
