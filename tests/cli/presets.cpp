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
    // A reader that blocks ends with status 124.
    Outcome in_folder(const std::string& arguments) const {
        return run("cd " + at("k") + " && timeout 20 " SNELL_BIN "/snell " + arguments);
    }
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

// What was written is drawn by the program, and its error and time are those that its presets state.
TEST_F(Presets, OfACopyChooseFoundRungs) {
    folder.write("k/a.vert", "varying vec2 vP;\nvoid main() { vP = gl_Vertex.xy; gl_Position = vec4(vP, 0., 1.); }\n");
    const std::string fragment =
        "varying vec2 vP;\nvoid main() {\n    float s = .2;\n"
        "    for (int i = 0; i < 1500; ++i)\n        s += .0002 + .0001 * fract(float(i) * vP.x);\n"
        "    for (int k = 0; k < 500; ++k)\n        s += .00000001 * fract(float(k) * vP.y);\n"
        "    gl_FragColor = vec4(vec3(s), 1.);\n}\n";
    folder.write("k/a.frag", fragment);
    folder.write("k/a.glib", "Vertex a.vert\nFragment a.frag\nProgram A\nQuadXY 0 1\n");
    const Outcome none = in_folder("accuracy a.glib --save-quality --size 64x64 --reps 5 --budget 1");
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(none.says("snell accuracy a.glib --quality-copy FOLDER")) << none.output;
    using nlohmann::json;
    json presets;
    const auto ratio = [&](const char* name) {
        return std::strtod(presets[name]["ratio"].get<std::string>().c_str(), nullptr);
    };
    constexpr double fast = .7, others = .95;
    const auto cheaper = [&] { return ratio("fast") < fast && ratio("balanced") < others && ratio("exact") < others; };
    // Other processes may take the time of a measurement; it is done again, with more.
    for (const char* budget : {"12", "20", "90"}) {
        std::filesystem::remove_all(at("k/out"));
        const Outcome written =
            run("cd " + at("k") +
                " && " SNELL_BIN "/snell accuracy a.glib --quality-copy out --size 64x64 --reps 9 --budget " + budget);
        ASSERT_EQ(written.status, 0) << written.output;
        EXPECT_TRUE(written.says("wrote out/a.glib\n")) << written.output;
        EXPECT_EQ(bytes_of(at("k/a.frag")), fragment) << "the scene stays as it is";
        EXPECT_FALSE(std::filesystem::exists(at("k/a.quality.json")));
        presets = json::parse(bytes_of(at("k/out/a.quality.json")))["presets"];
        if (cheaper()) break;
    }
    EXPECT_TRUE(cheaper()) << "a quarter of the work has no visible effect";
    const auto render = [&](const std::string& arguments, const std::string& picture) {
        const Outcome outcome = snell("render " + at(arguments) + " -o " + at(picture));
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return content::decode_image(picture, bytes_of(at(picture))).image.value_or(content::Image{});
    };
    const auto light = [](std::byte value) {
        const double x = std::to_integer<int>(value) / 255.;
        return x <= .04045 ? x / 12.92 : std::pow((x + .055) / 1.055, 2.4);
    };
    const content::Image plain = render("k/a.glib --size 64x64", "plain.png");
    const double cost = cost_of("render " + at("k/a.glib --size 700x700 -o ") + at("plain.png"));
    for (const char* name : {"fast", "balanced", "exact"}) {
        SCOPED_TRACE(name + presets[name].dump());
        const std::string with = std::string("k/out/a.glib --quality ") + name;
        const content::Image drawn = render(with + " --size 64x64", "drawn.png");
        ASSERT_EQ(drawn.pixels.size(), plain.pixels.size());
        double sum = 0;
        for (std::size_t k = 0; k < drawn.pixels.size(); ++k)
            sum += std::pow(light(drawn.pixels[k]) - light(plain.pixels[k]), 2);
        const double error =
            std::sqrt(sum / static_cast<double>(drawn.pixels.size()) * (drawn.channels == 4 ? 4 / 3. : 1));
        EXPECT_NEAR(error, presets[name]["alone"].get<double>(), .003 + .05 * error);
        if (ratio(name) > fast) continue;
        EXPECT_LT(cost_of("render " + at(with + " --size 700x700 -o ") + at("drawn.png")), .95 * cost);
    }
    EXPECT_GT(presets["fast"]["alone"].get<double>(), 1 / 255.);
    EXPECT_LT(presets["exact"]["alone"].get<double>(), .01 / 255);
}

TEST_F(Presets, AFolderThatCannotBeMadeIsToldBeforeAnythingIsMeasured) {
    const Outcome refused = in_folder("accuracy k.glib --quality-copy k.glib/out");
    EXPECT_EQ(refused.status, 1);
    EXPECT_TRUE(refused.says("cannot make the folder 'k.glib/out'")) << refused.output;
    EXPECT_FALSE(refused.says("found rungs")) << refused.output;
}

TEST_F(Presets, ACopyNeedsFoundRungsOfOneScene) {
    for (const char* options : {"--no-found", "--ladders all", "--knobs samples", "--from lattice", "k.glib"}) {
        const Outcome refused = in_folder(std::string("accuracy k.glib --quality-copy out ") + options);
        EXPECT_EQ(refused.status, 2) << refused.output;
        EXPECT_TRUE(refused.says("--quality-copy looks for found rungs of one scene")) << refused.output;
    }
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
