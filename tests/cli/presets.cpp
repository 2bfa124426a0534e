// Files of presets and reports, which may come from strangers: what is read, kept, and shown of them.
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace snell::test {
namespace {

constexpr std::string_view escape = "\x1b";

class Presets : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        folder.write("k/k.glib", "WindowSize 16 16\nLadder METHOD <last> dark\nOrtho -1 1 -1 1\nQuadXY .2 .5\n");
    }
    // Presets that choose METHOD=last, measured on `renderer`, which is JSON's text of a string.
    static std::string presets(const std::string& renderer) {
        return R"({"schema": 1, "renderer": ")" + renderer +
               R"(", "presets": {"fast": {"ladders": ["METHOD=last"], "rmse": 0.1, "ratio": "1 [1, 1]",)"
               R"( "settled": true, "trusted": true}}})";
    }
    Outcome in_folder(const std::string& arguments) const { return snell(arguments, "", at("k")); }
    Outcome render(const std::string& more) const { return in_folder("render k.glib -o k.png --quality fast " + more); }
    std::string file() const { return at("k/k.quality.json"); }
};

TEST_F(Presets, AreReadOnlyWithinTheFolder) {
    folder.write("outside.json", presets("swordfish"));
    std::filesystem::create_symlink("../outside.json", file());
    EXPECT_EQ(render("").status, 0) << "without a limit, a link may lead anywhere";
    for (const char* limit : {"--grade", "--confine ."}) {
        const Outcome refused = render(limit);
        EXPECT_EQ(refused.status, 1) << limit << refused.output;
        EXPECT_TRUE(refused.says("outside of the folder")) << limit << refused.output;
        EXPECT_FALSE(refused.says("swordfish")) << limit << refused.output;
    }
}

TEST_F(Presets, PipesDevicesAndLargeFilesAreRefused) {
    ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
    const Outcome pipe = render("");
    EXPECT_EQ(pipe.status, 1) << pipe.output;
    EXPECT_TRUE(pipe.says("it is a pipe")) << pipe.output;
    std::filesystem::remove(file());
    std::filesystem::create_symlink("/dev/null", file());
    const Outcome device = render("");
    EXPECT_EQ(device.status, 1) << device.output;
    EXPECT_TRUE(device.says("it is a device")) << device.output;
    std::filesystem::remove(file());
    folder.write("k/k.quality.json", presets(std::string(10000, 'x')));
    EXPECT_EQ(render("--limit file-bytes=100000").status, 0);
    const Outcome large = render("--limit file-bytes=5000");
    EXPECT_EQ(large.status, 1) << large.output;
    EXPECT_TRUE(large.says("larger than 5000 bytes")) << large.output;
}

TEST_F(Presets, AreNotOverwrittenByTheCommandThatReadsThem) {
    folder.write("k/k.quality.json", presets("here"));
    for (const char* command : {"render k.glib -o k.png --json k.quality.json",
                                "sweep k.glib -o '{METHOD}.png' --over METHOD=last,dark "
                                "--stats ./k.quality.json"}) {
        const Outcome refused = in_folder(std::string(command) + " --quality fast");
        EXPECT_EQ(refused.status, 2) << command << refused.output;
        EXPECT_TRUE(refused.says("is read, and would be overwritten")) << command << refused.output;
        EXPECT_EQ(bytes_of(file()), presets("here")) << command;
    }
}

TEST_F(Presets, WhatIsDrawnIsPrinted) {
    folder.write("k/k.quality.json", presets("here"));
    const Outcome fast = render("");
    EXPECT_TRUE(fast.says("quality fast: METHOD=last (RMSE 0.1")) << fast.output;
    const Outcome typed = render("--ladder METHOD=dark");
    EXPECT_EQ(typed.status, 0) << typed.output;
    EXPECT_TRUE(typed.says("quality fast: METHOD=dark (measured with METHOD=last: RMSE 0.1")) << typed.output;
    const Outcome swept = in_folder("sweep k.glib -o '{METHOD}.png' --over METHOD=last,dark --quality fast");
    EXPECT_EQ(swept.status, 0) << swept.output;
    EXPECT_TRUE(swept.says("quality fast: METHOD varies (measured with METHOD=last")) << swept.output;
}

TEST_F(Presets, NoEscapeSequenceReachesTheTerminal) {
    folder.write("k/k.quality.json", presets("\\u001b[31mX"));
    const Outcome drawn = render("");
    EXPECT_EQ(drawn.status, 0) << drawn.output;
    EXPECT_TRUE(drawn.says("\\x1B[31mX")) << drawn.output;
    EXPECT_FALSE(drawn.says(escape)) << drawn.output;
    folder.write("k/a.json", "{}");
    for (const char* arguments : {"accuracy k.glib --within \x1b[31mX", "accuracy --merge a.json \x1b[31mX",
                                  "\x1b[31mX", "accuracy \x1b[31mX.glib", "render k.glib -o \x1b[31mX/k.png"}) {
        const Outcome refused = in_folder(arguments);
        EXPECT_NE(refused.status, 0) << refused.output;
        EXPECT_FALSE(refused.says(escape)) << refused.output;
        EXPECT_TRUE(refused.says("[31mX")) << refused.output;
    }
}

TEST_F(Presets, ASceneWithoutLaddersHasNone) {
    folder.write("k/a.vert", "void main() { gl_Position = gl_Vertex; }\n");
    folder.write("k/a.frag", "void main() { gl_FragColor = vec4(.5); }\n");
    folder.write("k/a.glib", "Vertex a.vert\nFragment a.frag\nProgram A\nQuadXY 0 1\n");
    const Outcome none = in_folder("accuracy a.glib --save-quality --size 16x16 --reps 3 --budget 1");
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(none.says("'a.glib' has no ladders, so no presets were written")) << none.output;
}

TEST_F(Presets, MergeReadsOnlyFilesWithinTheLimits) {
    folder.write("k/a.json", "{}");
    ASSERT_EQ(mkfifo(at("k/pipe").c_str(), 0600), 0);
    for (const char* other : {"pipe", "/dev/zero"}) {
        const Outcome refused = in_folder(std::string("accuracy --merge a.json ") + other);
        EXPECT_EQ(refused.status, 1) << refused.output;
        EXPECT_TRUE(refused.says("cannot read '" + std::string(other) + "': it is a ")) << refused.output;
    }
    const Outcome large = in_folder("accuracy --limit file-bytes=1 --merge a.json a.json");
    EXPECT_EQ(large.status, 1) << large.output;
    EXPECT_TRUE(large.says("larger than 1 bytes")) << large.output;
}

TEST_F(Presets, MergeTakesNoOptionsOfMeasurements) {
    folder.write("k/a.json", "{}");
    for (const char* option : {"-o x.html", "--json x.json", "--csv x.csv", "--markdown x.md", "--svg x.svg",
                               "--error .1", "--within 16ms", "--save-quality", "--size 8x8"}) {
        const Outcome refused = in_folder(std::string("accuracy --merge a.json a.json ") + option);
        EXPECT_EQ(refused.status, 2) << option << refused.output;
        EXPECT_TRUE(refused.says("--merge excludes")) << option << refused.output;
    }
}

}  // namespace
}  // namespace snell::test
