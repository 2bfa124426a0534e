// Many pictures by one process, as a shell asks for them.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;

class CliSweep : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        folder.write("mix.frag",
                     "uniform float uEta, uMix;\nuniform vec3 uColor;\nuniform float Timer;\nvoid main() {\n"
                     "#if KIND == KIND_red\ngl_FragColor = vec4(uMix, uEta / 10., Timer, 1.);\n"
                     "#elif KIND == KIND_plain\ngl_FragColor = vec4(uColor * uMix, 1.);\n"
                     "#else\nthis is no GLSL\n#endif\n}\n");
        scene("good", "uEta <.1 1.1 5.> uMix <0. 0. 1.> uColor [1. 1. 1.]");
        for (const char* name : {"out", "a", "b"}) fs::create_directory(folder.path(name));
    }
    void scene(const std::string& name, const std::string& values) const {
        folder.write(name + ".glib",
                     "Timer 10\nLadder KIND <red> plain broken\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment "
                     "mix.frag\nProgram Mix " +
                         values + "\nQuadXY\n");
    }
    // "sweep GOOD ARGUMENTS --size 8x8", with {} for the folder.
    Outcome sweep(const std::string& arguments) const {
        return snell("sweep " + at("good.glib") + " --size 8x8 " + arguments);
    }
    // What lies in a folder, by name.
    std::map<std::string, std::string> files(const std::string& name) const {
        std::map<std::string, std::string> found;
        for (const auto& entry : fs::directory_iterator(at(name)))
            found[entry.path().filename().string()] = bytes_of(entry.path().string());
        return found;
    }
    nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(bytes_of(at(name))); }
};

TEST_F(CliSweep, EveryPictureIsThatOfRenderWithItsValues) {
    const Outcome outcome = sweep("--over uEta=1:2.5:4 --over uMix=0,.5,1 -o '" + at("out") +
                                  "/{uEta}_{uMix}.png' --json " + at("all.json"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "");
    const auto told = json("all.json");
    ASSERT_EQ(told["pictures"].size(), 12U);
    EXPECT_EQ(files("out").size(), 12U);
    std::set<std::string> hashes;
    for (const auto& picture : told["pictures"]) {
        hashes.insert(picture["sha256"]);
        const std::string name = picture["file"];
        EXPECT_EQ(picture["bytes"], bytes_of(name).size());
        const std::string sum = run("sha256sum " + name).output;
        EXPECT_EQ(sum.substr(0, 64), picture["sha256"]);
    }
    EXPECT_EQ(hashes.size(), 12U) << "all differ";
    for (const std::size_t index : {0U, 5U, 11U}) {
        const auto& picture = told["pictures"][index];
        snell("render " + at("good.glib") + " --size 8x8 --set uEta=" + picture["values"]["uEta"].dump() +
              " --set uMix=" + picture["values"]["uMix"].dump() + " -o " + at("one.png"));
        EXPECT_EQ(bytes_of(at("one.png")), bytes_of(picture["file"])) << picture["file"];
    }
    const auto pixel = picture("out/2_0.5.png");
    EXPECT_NEAR(std::to_integer<int>(pixel.pixels.at(0)), 128, 1);
    EXPECT_NEAR(std::to_integer<int>(pixel.pixels.at(1)), 51, 1);
}

TEST_F(CliSweep, TimeAndRungsVaryToo) {
    const Outcome outcome = sweep("--over KIND=red,plain --over time=0:5:3 --set uMix=1 -o '" + at("out") +
                                  "/{KIND}-{time}.png' --json " + at("all.json"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    const nlohmann::json all = json("all.json");
    for (const auto& picture : all["pictures"]) {
        snell("render " + at("good.glib") +
              " --size 8x8 --set uMix=1 --ladder KIND=" + picture["values"]["KIND"].get<std::string>() + " --time " +
              picture["time"].dump() + " -o " + at("one.png"));
        EXPECT_EQ(bytes_of(at("one.png")), bytes_of(picture["file"])) << picture["file"];
    }
    EXPECT_NE(files("out")["red-2.5.png"], files("out")["red-5.png"]);
}

TEST_F(CliSweep, ComponentsOfVectorsVary) {
    EXPECT_EQ(sweep("--over uColor.g=0,1 --ladder KIND=plain --set uMix=1 -o '" + at("out") + "/{index}.png'").status,
              0);
    const auto image = picture("out/0.png");
    ASSERT_FALSE(image.pixels.empty());
    EXPECT_EQ(std::to_integer<int>(image.pixels[0]), 255);
    EXPECT_EQ(std::to_integer<int>(image.pixels[1]), 0);
    EXPECT_EQ(sweep("--over uColor.w=0,1 -o '" + at("out") + "/{index}.png'").status, 1);
}

// A rung that does not compile gives what it gives alone, wherever in the sweep it stands.
TEST_F(CliSweep, ABrokenRungSpoilsNoOther) {
    const std::string over = "--over KIND=plain,broken,red --set uMix=1 -o '";
    EXPECT_EQ(sweep(over + at("out") + "/{KIND}.png'").status, 1);
    EXPECT_EQ(files("out").size(), 3U);
    for (const char* rung : {"plain", "broken", "red"}) {
        snell("render " + at("good.glib") + " --size 8x8 --set uMix=1 --ladder KIND=" + rung + " -o " + at("one.png"));
        EXPECT_EQ(bytes_of(at("one.png")), files("out")[std::string(rung) + ".png"]) << rung;
    }
}

TEST_F(CliSweep, TheUnionOfTheShardsIsTheWhole) {
    const std::string over = "--over KIND=red,plain --over uMix=0:1:5 -o '";
    ASSERT_EQ(sweep(over + at("out") + "/{KIND}{uMix}.png'").status, 0);
    std::size_t drawn = 0;
    for (int shard = 0; shard < 3; ++shard) {
        const Outcome outcome =
            sweep(over + at("a") + "/{KIND}{uMix}.png' --shard " + std::to_string(shard) + "/3 --json " + at("s.json"));
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        drawn += json("s.json")["pictures"].size();
        EXPECT_EQ(files("a").size(), drawn) << "no picture twice";
    }
    EXPECT_EQ(files("a"), files("out"));
}

TEST_F(CliSweep, WhatIsThereIsNotDrawnAgain) {
    const std::string command = "--over uMix=0,.5,1 -o '" + at("out") + "/{uMix}.png' --json " + at("s.json");
    ASSERT_EQ(sweep(command).status, 0);
    const auto whole = files("out");
    fs::remove(at("out/0.5.png"));
    folder.write("out/1.png", whole.at("0.png"));
    ASSERT_EQ(sweep(command + " --skip-existing").status, 0);
    EXPECT_EQ(files("out")["0.5.png"], whole.at("0.5.png"));
    EXPECT_EQ(files("out")["1.png"], whole.at("0.png")) << "kept as it is";
    const auto told = json("s.json")["pictures"];
    ASSERT_EQ(told.size(), 3U);
    EXPECT_TRUE(told[0].contains("skipped"));
    EXPECT_FALSE(told[1].contains("skipped"));
}

// Of every format and cut: tests/image/whole.cpp.
TEST_F(CliSweep, WhatIsNoWholePictureIsDrawnAgain) {
    for (const std::string name : {"out/o.png", "out/o.exr"}) {
        const std::string command =
            "render " + at("good.glib") + " --size 40x30 -o " + at(name) + " --json " + at("s.json");
        ASSERT_EQ(snell(command).status, 0) << name;
        const std::string whole = bytes_of(at(name));
        const auto draws = [&](const std::string& bytes) {
            folder.write(name, bytes);
            EXPECT_EQ(snell(command + " --skip-existing").status, 0) << name;
            EXPECT_EQ(bytes_of(at(name)).size(), whole.size()) << name;  // an EXR holds the date
            return !json("s.json")["pictures"][0].contains("skipped");
        };
        EXPECT_FALSE(draws(whole)) << name;
        EXPECT_TRUE(draws(whole.substr(0, whole.size() - 1)));
    }
    fs::create_directory(at("out/folder.png"));
    EXPECT_EQ(snell("render " + at("good.glib") + " --size 8x8 --skip-existing -o " + at("out/folder.png")).status, 1);
}

// Of a driver that crashes, say.
TEST_F(CliSweep, APictureThatKillsTheProcessCostsNoOther) {
    const std::string command = "sweep " + at("good.glib") + " --size 128x128 --over uMix=0:1:150 --json " +
                                at("s.json") + " -o '" + at("out") + "/{index:03}.png'";
    ASSERT_EQ(snell(command).status, 0);
    const auto whole = files("out");
    ASSERT_EQ(whole.size(), 150U);
    std::size_t left = 0;
    for (int attempt = 0; attempt < 5 && (left == 0 || left == whole.size()); ++attempt) {
        fs::remove_all(at("out"));
        fs::create_directory(at("out"));
        const pid_t child = fork();
        if (child == 0) {
            const rlimit no_core{0, 0};
            setrlimit(RLIMIT_CORE, &no_core);
            execl("/bin/sh", "sh", "-c", ("exec " SNELL_BIN "/snell " + command + " 2>/dev/null").c_str(), nullptr);
            _exit(127);
        }
        for (int i = 0; i < 20'000 && !fs::exists(at("out/020.png")); ++i) usleep(500);
        kill(child, SIGSEGV);
        int status = 0;
        waitpid(child, &status, 0);
        left = 0;
        for (const auto& [name, bytes] : files("out")) {
            if (!name.ends_with(".png")) continue;
            EXPECT_EQ(bytes, whole.at(name)) << name;
            ++left;
        }
    }
    ASSERT_TRUE(left > 0 && left < whole.size()) << left;
    ASSERT_EQ(snell(command + " --skip-existing").status, 0);
    std::size_t skipped = 0;
    const auto told = json("s.json");
    for (const auto& picture : told["pictures"]) skipped += picture.contains("skipped") ? 1 : 0;
    EXPECT_EQ(skipped, left);
    for (const auto& [name, bytes] : whole) EXPECT_EQ(bytes_of(at("out/" + name)), bytes) << name;
}

TEST_F(CliSweep, TheSheetOfLightIsEncodedWhateverTheFormat) {
    std::ofstream(at("light.frag")) << "uniform float uA;\nvoid main() { gl_FragColor = vec4(uA, uA, uA, 1.); }\n";
    std::ofstream(at("light.glib"))
        << "Output srgb\nOrtho -1 1 -1 1\nFragment light.frag\nProgram P uA <0. .5 1.>\nQuadXY\n";
    for (const std::string format : {"exr", "png"}) {
        const Outcome outcome = snell("sweep " + at("light.glib") + " --size 8x8 --over uA=.2,.5 -o '" + at("out") +
                                      "/{index}." + format + "' --no-labels --sheet " + at("sheet.png"));
        ASSERT_EQ(outcome.status, 0) << outcome.output;
        const auto sheet = picture("sheet.png");
        const auto red = [&](int x) {
            return std::to_integer<int>(sheet.pixels[static_cast<std::size_t>(8 * sheet.width + x) * 3]);
        };
        EXPECT_NEAR(red(8), 124, 1) << format;
        EXPECT_NEAR(red(20), 188, 1) << format;
    }
}

TEST_F(CliSweep, TheSheetHasEveryPicture) {
    const Outcome outcome = sweep("--over uEta=0:5:3 --over uMix=0,1 -o '" + at("out") +
                                  "/{index}.png' --no-labels --sheet " + at("sheet.png"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    const auto sheet = picture("sheet.png");
    // Two columns, for the axis that varies fastest; tiles of 8 pixels, 4 apart.
    ASSERT_EQ(sheet.width, 2 * 12 + 4);
    ASSERT_EQ(sheet.height, 3 * 12 + 4);
    const auto red = [&](int column, int row) {
        const int x = 4 + 12 * column + 4, y = 4 + 12 * row + 4;
        return std::to_integer<int>(sheet.pixels[static_cast<std::size_t>(y * sheet.width + x) * 3]);
    };
    for (int row = 0; row < 3; ++row) {
        EXPECT_EQ(red(0, row), 0);
        EXPECT_EQ(red(1, row), 255);
    }
    EXPECT_EQ(sweep("--over uMix=0:1:5000 -o '" + at("out") + "/x{index}.png' --sheet " + at("s.png")).status, 2);
}

TEST_F(CliSweep, WhatIsWrongIsSaidBeforeAnythingIsDrawn) {
    const std::string out = " -o '" + at("a") + "/{index}.png'";
    const Outcome typo = sweep("--over uMxi=0,1" + out);
    EXPECT_EQ(typo.status, 1);
    EXPECT_TRUE(typo.says("did you mean 'uMix'?")) << typo.output;
    for (const char* over : {"KIND=red,plian", "uMix=0,1,high", "time=0,soon", "uMix=[0,1],[1,0]"})
        EXPECT_EQ(sweep("--over '" + std::string(over) + "'" + out).status, 1) << over;
    for (const char* over : {"uMix=0:1", "uMix=", "uMix=nan", "uMix=0:1:2000000", "uMix"})
        EXPECT_EQ(sweep("--over " + std::string(over) + out).status, 2) << over;
    EXPECT_EQ(sweep("--over uMix=0,1 -o " + at("a") + "/same.png").status, 2);
    EXPECT_EQ(sweep("--over uMix=0,1 --shard 3/3" + out).status, 2);
    EXPECT_EQ(sweep(out).status, 2) << "over nothing";
    EXPECT_EQ(sweep("--over uMix=0,1 -o '" + at("none") + "/{uMix}.png'").status, 1) << "no folder";
    EXPECT_TRUE(files("a").empty());
    EXPECT_EQ(sweep("--over uMix=0,1 -o '" + at("a") + "/{uMix}/o.png'").status, 0) << "folders by value are made";
    EXPECT_TRUE(fs::exists(at("a/1/o.png")));
}

// Case 54: frame k of an animation is at exactly k/fps, in every shard.
TEST_F(CliSweep, FramesAreAtTheirTimesInEveryShard) {
    const std::string command =
        "render " + at("good.glib") + " --size 8x8 --frames 10 --fps 29.97 --json " + at("s.json");
    ASSERT_EQ(snell(command + " -o " + at("out/f.png")).status, 0);
    const auto told = json("s.json")["pictures"];
    ASSERT_EQ(told.size(), 10U);
    for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(told[k]["time"], static_cast<double>(k) / 29.97);
    for (const char* shard : {"0/2", "1/2"})
        EXPECT_EQ(snell(command + " --shard " + shard + " -o '" + at("a") + "/f-{frame:04}.png'").status, 0);
    EXPECT_EQ(files("a"), files("out"));
}

TEST_F(CliSweep, ManyScenesInOneProcess) {
    std::string names;
    for (int i = 0; i < 5; ++i) {
        scene("s" + std::to_string(i), "uEta <.1 1. 5.> uMix <0. ." + std::to_string(i) + " 1.>");
        names += " " + at("s" + std::to_string(i) + ".glib");
    }
    folder.write("bad.glib", "Ortho -1 1 -1 1\nSphree 1\nColor 1 0 0\nQuadXY\n");
    const Outcome outcome = snell("render" + names + " " + at("bad.glib") + " " + at("none.glib") + " --size 8x8 -o '" +
                                  at("out") + "/{stem}.png'");
    EXPECT_EQ(outcome.status, 1) << "one has an error, one is not there";
    EXPECT_EQ(files("out").size(), 6U) << outcome.output;
    EXPECT_TRUE(outcome.says("bad.glib:2:1: error:")) << outcome.output;
    EXPECT_TRUE(outcome.says("none.glib")) << outcome.output;
    for (int i = 0; i < 5; ++i) {
        snell("render " + at("s" + std::to_string(i) + ".glib") + " --size 8x8 -o " + at("one.png"));
        EXPECT_EQ(files("out")["s" + std::to_string(i) + ".png"], bytes_of(at("one.png")));
    }
    fs::create_directory(at("more"));
    folder.write("more/s1.glib", "Sphere\n");
    const Outcome same = snell("render" + names + " " + at("more/s1.glib") + " -o '" + at("a") + "/{stem}.png'");
    EXPECT_EQ(same.status, 2);
    EXPECT_TRUE(same.says("would both be")) << same.output;
    EXPECT_TRUE(same.says("\n   help: {path} in the name")) << "a line of its own: " << same.output;
    EXPECT_TRUE(files("a").empty());
    EXPECT_EQ(snell("render" + names + " -o '" + at("a") + "/{stem}.png' --size 8x8").status, 0);
}

// In a process of its own each would cost as much as one alone.
TEST_F(CliSweep, AHundredScenesAreQuick) {
    std::string names;
    for (int i = 0; i < 100; ++i) {
        folder.write("t" + std::to_string(i) + ".glib", "Color 1 .5 ." + std::to_string(i) + "\nSphere .5\n");
        names += " " + at("t" + std::to_string(i) + ".glib");
    }
    const double one = cost_of("render " + at("t0.glib") + " --size 64x64 -o " + at("one.png"));
    EXPECT_LE(cost_of("render" + names + " --size 64x64 -o '" + at("out") + "/{stem}.png'"), 10 * one);
    EXPECT_EQ(files("out").size(), 100U);
}

}  // namespace

}  // namespace snell::test
