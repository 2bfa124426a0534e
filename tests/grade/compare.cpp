// snell compare: its figures against values that are known, and what makes pictures different.
#include "tests/cli/command.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/accuracy/metrics.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Compare : public CommandTest {
protected:
    // A grey picture, in which the pixel at x, y has another value.
    void grey(const std::string& name, int value, int x = -1, int y = 0, int other = 0) const {
        std::vector<std::array<int, 3>> pixels(20 * 10, {value, value, value});
        if (x >= 0) pixels[static_cast<std::size_t>(y * 20 + x)] = {other, other, other};
        folder.write(name, bmp(20, 10, pixels));
    }
    Outcome compare(const std::string& arguments) const { return snell("compare " + arguments, "", folder.path()); }
    json figures(const std::string& arguments) const {
        return json::parse(compare(arguments + " --json").output, nullptr, false)["pairs"][0];
    }
};

TEST_F(Compare, FiguresAreThoseOfTheirDefinitions) {
    grey("a.bmp", 100);
    grey("b.bmp", 151);
    grey("c.bmp", 100, 7, 3, 255);
    const json all = figures("a.bmp b.bmp");
    EXPECT_NEAR(all["display"]["rmse"], .2, 1e-6);
    EXPECT_NEAR(all["display"]["psnr"], -20 * std::log10(.2), 1e-4);
    const auto light = [](double v) { return std::pow((v / 255 + .055) / 1.055, 2.4); };  // the curve of sRGB
    EXPECT_NEAR(all["light"]["rmse"], light(151) - light(100), 1e-6);
    EXPECT_EQ(all["pixels_percent"], 100);
    const json one = figures("a.bmp c.bmp");
    EXPECT_EQ(one["largest_at"], json::array({7, 3}));
    EXPECT_NEAR(one["display"]["max"], 155. / 255, 1e-6);
    EXPECT_NEAR(one["display"]["rmse"], 155. / 255 / std::sqrt(200.), 1e-6);
    EXPECT_NEAR(one["pixels_percent"], .5, 1e-9);
    EXPECT_EQ(one["coverage"], json::array({0., .005}));
    EXPECT_EQ(figures("a.bmp a.bmp")["flip"], 0);
    EXPECT_GT(one["flip"], 0);
    EXPECT_LT(one["flip"], all["flip"]);
    EXPECT_TRUE(figures("a.bmp a.bmp")["display"]["psnr"].is_null()) << "infinite";
}

TEST_F(Compare, NamesThatNoFileCanHaveAreSaid) {
    grey("a.bmp", 100);
    const std::string longer(300, 'a');  // than a file system allows
    for (const std::string& both : {longer + " a.bmp", "a.bmp " + longer}) {
        const Outcome refused = compare(both);
        EXPECT_EQ(refused.status, 2) << both;
        EXPECT_TRUE(refused.says("there is no '" + longer + "'")) << refused.output;
    }
}

TEST_F(Compare, LimitsMakeItATest) {
    grey("a.bmp", 100);
    grey("b.bmp", 102);
    EXPECT_EQ(compare("a.bmp b.bmp").status, 0);
    EXPECT_EQ(compare("a.bmp b.bmp --max-rmse .01").status, 0);
    EXPECT_EQ(compare("a.bmp b.bmp --max-rmse .007").status, 1);
    EXPECT_EQ(compare("a.bmp b.bmp --max-pixels 50").status, 1);
    EXPECT_EQ(compare("a.bmp b.bmp --max-pixels 50 --threshold .01").status, 0);
    for (const std::string any : {"8", "1.01", "8/", "/255", "8/0", "300/255", "1/2/3", "8/255x"}) {
        const Outcome refused = compare("a.bmp b.bmp --max-pixels 50 --threshold " + any);
        EXPECT_EQ(refused.status, 2) << any;
        EXPECT_TRUE(refused.says("is neither a number from 0 to 1 nor one of bytes, such as 8/255")) << refused.output;
    }
    EXPECT_EQ(compare("a.bmp b.bmp --max-pixels 50 --threshold 1.9/255").status, 1);
    EXPECT_EQ(compare("a.bmp b.bmp --max-pixels 50 --threshold 2.1/255").status, 0);
    // Exactly as many steps are not more, whatever the colour is.
    for (const auto& [from, to] : {std::pair(0, 8), {37, 54}, {100, 129}, {200, 255}}) {
        grey("c.bmp", from);
        grey("d.bmp", to);
        const auto most = [](int steps) { return "c.bmp d.bmp --max-pixels 0 --threshold " + std::to_string(steps); };
        EXPECT_EQ(compare(most(to - from) + "/255").status, 0) << from;
        EXPECT_EQ(compare(most(to - from - 1) + "/255").status, 1) << from;
    }
    EXPECT_EQ(compare("a.bmp b.bmp --max-flip 1e-5").status, 1);
    EXPECT_EQ(compare("a.bmp b.bmp --max-flip 2").status, 2);
    EXPECT_EQ(compare("a.bmp").status, 2);
    EXPECT_EQ(compare("a.bmp nothere.bmp").status, 2);
    EXPECT_EQ(compare("a.bmp b.bmp -o a.bmp").status, 2) << "what is read is not overwritten";
}

TEST_F(Compare, NumbersOfOptionsAreFinite) {
    grey("a.bmp", 100);
    for (const std::string option : {"max-rmse", "max-flip", "max-pixels", "threshold", "time", "timeout"})
        for (const std::string number : {"nan", "inf", "-inf", "-nan", "1e999", "x"}) {
            const Outcome refused = compare("a.bmp a.bmp --" + option + "=" + number);
            EXPECT_EQ(refused.status, 2) << option << " " << number;
            EXPECT_TRUE(refused.says("--" + option)) << refused.output;
        }
    for (const std::string option : {"max-rmse", "max-flip", "max-pixels", "threshold"})
        EXPECT_EQ(compare("a.bmp a.bmp --" + option + "=-0.1").status, 2) << option;
}

TEST_F(Compare, BlackAndWhiteHaveNoDecibels) {
    grey("black.bmp", 0);
    grey("white.bmp", 255);
    const Outcome outcome = compare("black.bmp white.bmp");
    EXPECT_TRUE(outcome.says("PSNR      0 dB of displayed values, 0 dB of light")) << outcome.output;
    EXPECT_FALSE(outcome.says("-0")) << outcome.output;
    // Light just above white: .0004 dB more than the peak.
    const auto grey_light = [&](const std::string& name, float value) {
        std::string bytes = "PF\n20 10\n-1.0\n";
        for (int i = 0; i < 20 * 10 * 3; ++i) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        folder.write(name, bytes);
    };
    grey_light("none.pfm", 0);
    grey_light("over.pfm", 1.00005F);
    const Outcome light = compare("none.pfm over.pfm");
    EXPECT_TRUE(light.says("dB of displayed values, 0 dB of light")) << light.output;
}

// What a display cannot show makes no difference between displayed values, but between lights.
TEST_F(Compare, DisplayedValuesAreTheBytesOfAPng) {
    const accuracy::Picture shown =
        accuracy::as_bytes({1, 1, {-1.f, .5f, 4.f, std::numeric_limits<float>::quiet_NaN()}});
    EXPECT_EQ(shown.rgba[0], 0);
    EXPECT_FLOAT_EQ(shown.rgba[1], 128.f / 255);
    EXPECT_EQ(shown.rgba[2], 1);
    EXPECT_TRUE(std::isnan(shown.rgba[3]));
    const std::string scene = "##OpenGL GLIB\nVertex h.vert\nFragment h.frag\nProgram H uMost <0. 4. 9.>\nSphere 9\n";
    folder.write("own.glib", scene);
    folder.write("light.glib", "Output srgb\n" + scene);
    folder.write("h.vert", "void main() { gl_Position = ftransform(); }\n");
    folder.write("h.frag",
                 "uniform float uMost;\nvoid main() { float x = floor(gl_FragCoord.x) / 31.;\n"
                 "  gl_FragColor = vec4(vec3(x < .5 ? uMost : x * x), 1.); }\n");
    for (const std::string name : {"own", "light"}) {
        const std::string displayed = name == "own" ? " --displayed" : "";
        for (const std::string& file : {name + ".png", name + ".exr", std::string("more.exr")})
            ASSERT_EQ(snell("render -q " + at(name + ".glib") + " --size 32x16 -o " + at(file) +
                            (file == "more.exr" ? " --set uMost=8" : ""))
                          .status,
                      0);
        const json all = figures(name + ".exr " + name + ".png --threshold 0.004" + displayed);  // one step
        EXPECT_EQ(all["pixels_percent"], 0) << name;
        EXPECT_LT(all["display"]["rmse"], .002) << name;
        EXPECT_GT(all["light"]["rmse"], 1) << name;
        EXPECT_LE(all["display"]["max"], 1. / 254) << name;
        const json more = figures(name + ".exr more.exr" + displayed);
        EXPECT_EQ(more["display"]["rmse"], 0) << name;
        EXPECT_EQ(more["flip"], 0) << name;
        EXPECT_GT(more["light"]["rmse"], 1) << name;
    }
}

TEST_F(Compare, TheNearestOfSeveralReferencesCounts) {
    grey("a.bmp", 100);
    grey("far.bmp", 200);
    grey("near.bmp", 101);
    const json all = figures("a.bmp far.bmp near.bmp");
    EXPECT_EQ(all["reference"], "near.bmp");
    EXPECT_EQ(compare("a.bmp near.bmp far.bmp --max-rmse .01").status, 0);
}

TEST_F(Compare, OtherSizesAreDifferent) {
    grey("a.bmp", 100);
    folder.write("b.bmp", bmp(2, 2, std::vector<std::array<int, 3>>(4, {1, 1, 1})));
    folder.write("t.txt", "no picture");
    const Outcome outcome = compare("a.bmp b.bmp");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("'a.bmp' has 20x10 pixels, but 'b.bmp' has 2x2")) << outcome.output;
    EXPECT_EQ(compare("a.bmp t.txt").status, 1);
}

TEST_F(Compare, ScenesAreDrawn) {
    const std::string scene = SNELL_ROOT "/tests/cases/Sphere.glib";
    ASSERT_EQ(snell("render -q " + scene + " -o " + at("p.png") + " --size 64x48").status, 0);
    EXPECT_EQ(figures(scene + " p.png")["display"]["max"], 0) << "in the size of the picture";
    EXPECT_EQ(figures("p.png " + scene)["display"]["max"], 0);
    EXPECT_EQ(figures(scene + " " + scene + " --size 32x32")["size"], json::array({32, 32}));
    EXPECT_GT(figures(scene + " " + SNELL_ROOT "/tests/cases/Torus.glib --size 32x32")["display"]["rmse"], 0);
    folder.write("broken.glib", "Sphre 1\n");
    EXPECT_EQ(compare("broken.glib p.png").status, 1);
}

TEST_F(Compare, TwoStatesOfASceneAreNamed) {
    folder.write("s.glib",
                 "Vertex s.vert\nFragment s.frag\nLadder TINT dark <light>\nProgram P uRed <0 .2 1> uMore [0 "
                 "0]\nQuadXY 0 1 2 2\n");
    folder.write("s.vert", "#version 330 compatibility\nvoid main() { gl_Position = vec4(gl_Vertex.xy, 0., 1.); }\n");
    folder.write("s.frag",
                 "#version 330 compatibility\nuniform float uRed;\nuniform vec2 uMore;\n"
                 "void main() { gl_FragColor = vec4(uRed + uMore.x, 0., float(TINT) * .4 + uMore.y, 1.); }\n");
    folder.write(
        "s.snapshots.json",
        R"({"1": {"options": "--ladder TINT=dark\n--set P.uRed=0.2"}, "3": {"options": ""}, "0": {"options": ""},)"
        R"( "72": {"options": ""}})");
    const auto rmse = [&](const std::string& a, const std::string& b) {
        const json pair = figures("s.glib --set '" + a + "' --set '" + b + "' --size 16x16");
        EXPECT_EQ(pair["picture"], "s.glib (" + a + ")");
        return pair["display"]["rmse"].get<double>();
    };
    // Of three channels, each off by so much.
    const double red = .4 / std::sqrt(3), blue = .4 / std::sqrt(3);
    EXPECT_NEAR(rmse("uRed=.6", "saved"), red, .003);
    EXPECT_NEAR(rmse("P.uRed=.6 TINT=dark", "reference"), std::hypot(red, blue), .003);
    EXPECT_NEAR(rmse("uMore=[.4 0] uRed=.2", "saved"), red, .003) << "blanks in brackets";
    EXPECT_NEAR(rmse("snapshot 1", "saved"), blue, .003);
    EXPECT_EQ(rmse("snapshot 1", "TINT=dark"), 0);
    EXPECT_EQ(figures("s.glib --set saved --set uRed=.2 --size 16x16")["display"]["max"], 0);
    EXPECT_NEAR(figures("s.glib --set saved --set uRed=.2 --ladder TINT=dark --size 16x16")["display"]["rmse"], blue,
                .003)
        << "what is saved has the file's rung";
    const std::vector<std::array<const char*, 2>> wrongs{
        {"", "--set twice"},
        {"--set saved", "--set twice"},
        {"--set saved --set nonsense", "names no state"},
        {"--set '' --set saved", "'' names no state"},
        {"--set saved --set ' '", "' ' names no state"},
        {"--set saved --set 'snapshot 2'", "there is no snapshot 2; the scene has snapshots 1, 3"},
        {"--set saved --set 'snapshot 0'", "there is no snapshot 0; the scene has snapshots 1, 3"},
        {"--set 'snapshot 72' --set saved", "there is no snapshot 72; the scene has snapshots 1, 3"},
        {"--set 'snapshot x' --set saved", "there is no snapshot x; the scene has snapshots 1, 3"},
        {"--set uRad=.6 --set saved", "there is no uniform 'uRad'"},
        {"--set saved --set uRed=red", "uRed"},
        {"--set saved --set TINT=drak", "'drak'"},
    };
    for (const auto& [arguments, said] : wrongs) {
        const Outcome outcome = compare(std::string("s.glib --size 16x16 ") + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(outcome.says(said)) << arguments << '\n' << outcome.output;
    }
}

TEST_F(Compare, TransparencyCounts) {
    const auto png = [&](const std::string& name, std::array<int, 4> left, std::array<int, 4> right) {
        content::Image image;
        image.width = 16;
        image.height = 8;
        for (int i = 0; i < 16 * 8; ++i)
            for (const int value : i % 16 < 4 ? left : right) image.pixels.push_back(static_cast<std::byte>(value));
        folder.write(name, content::encode_png(image));
    };
    png("opaque.png", {200, 100, 50, 255}, {200, 100, 50, 255});
    png("quarter.png", {200, 100, 50, 0}, {200, 100, 50, 255});
    png("red.png", {255, 0, 0, 0}, {255, 0, 0, 0});
    png("green.png", {0, 255, 0, 0}, {0, 255, 0, 0});
    png("black.png", {0, 0, 0, 255}, {0, 0, 0, 255});
    const json quarter = figures("quarter.png opaque.png");
    EXPECT_EQ(quarter["pixels_percent"], 25);
    EXPECT_NEAR(quarter["display"]["max"], 200. / 255, 1e-6);
    EXPECT_EQ(quarter["largest_at"], json::array({0, 0}));
    EXPECT_EQ(compare("quarter.png opaque.png --max-rmse 0").status, 1);
    EXPECT_EQ(compare("red.png green.png --max-rmse 0 --max-flip 0 --max-pixels 0").status, 0) << "both show nothing";
    EXPECT_EQ(figures("red.png black.png")["pixels_percent"], 100) << "one covers what is behind it";
}

TEST_F(Compare, NaNIsDifferentFromAllButNaN) {
    const auto quarter = [&](const std::string& name, float value, int width = 5) {
        std::string bytes = "PF\n20 10\n-1.0\n";
        for (int i = 0; i < 20 * 10 * 3; ++i) {
            const float held = i / 3 % 20 < width ? value : .5f;
            bytes.append(reinterpret_cast<const char*>(&held), sizeof held);
        }
        folder.write(name, bytes);
    };
    quarter("nan.pfm", std::nanf(""));
    quarter("none.pfm", .5f);
    folder.write("a.vert", "void main() { gl_Position = ftransform(); }\n");
    for (const auto& [name, left] : {std::pair("nan", "uZero / uZero"), std::pair("none", ".5")}) {
        const std::string n = name;
        folder.write(n + ".glib",
                     "##OpenGL GLIB\nVertex a.vert\nFragment " + n + ".frag\nProgram P uZero <0. 0. 1.>\nSphere 9\n");
        folder.write(n + ".frag",
                     "uniform float uZero;\nvoid main() { gl_FragColor = vec4(vec3(gl_FragCoord.x < 5. ? " +
                         std::string(left) + " : .5), 1.); }\n");
    }
    EXPECT_EQ(compare("nan.pfm none.pfm --max-rmse 1e9").status, 1);
    EXPECT_EQ(compare("nan.glib none.glib --size 20x10 --max-pixels 24").status, 1);
    EXPECT_EQ(compare("none.glib nan.glib --size 20x10 --max-flip 1e-3").status, 1);
    for (const std::string two : {"nan.glib nan.pfm", "nan.glib nan.glib --size 20x10"})
        EXPECT_TRUE(compare(two).says("NaN       in 50 pixels")) << two;
    EXPECT_EQ(compare("nan.glib nan.glib --size 20x10 --max-rmse 0 --max-pixels 0").status, 0);
    // Where nothing is known, there are neither figures nor a verdict, whatever the limit is.
    quarter("all.pfm", std::nanf(""), 20);
    for (const char* limit : {"", " --max-rmse 1", " --max-pixels 100", " --max-flip 1"}) {
        const Outcome none = compare(std::string("all.pfm all.pfm") + limit);
        EXPECT_EQ(none.status, 1) << limit;
        EXPECT_TRUE(none.says("'all.pfm' and 'all.pfm' cannot be compared: every pixel of both is NaN or infinite"));
        EXPECT_FALSE(none.says("different")) << none.output;
    }
    EXPECT_TRUE(compare("all.pfm none.pfm --max-rmse 1").says("all.pfm against none.pfm: 20x10, different"));
    EXPECT_TRUE(compare("all.pfm all.pfm none.pfm").says("all.pfm against none.pfm: 20x10\n")) << "the nearest known";
}

TEST_F(Compare, FoldersAreComparedByNames) {
    for (const std::string name : {"a/1.bmp", "a/deep/2.bmp", "b/1.bmp", "b/deep/2.bmp"}) {
        fs::create_directories(fs::path(at(name)).parent_path());
        grey(name, 100);
    }
    EXPECT_EQ(compare("a b --max-rmse 0 -o maps").status, 0);
    EXPECT_TRUE(fs::exists(at("maps/deep/2.png")));
    grey("b/deep/2.bmp", 110);
    EXPECT_EQ(compare("a b --max-rmse 0").status, 1);
    grey("b/deep/2.bmp", 100);
    grey("b/more.bmp", 100);
    const Outcome outcome = compare("a b --max-rmse 0");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("only in b: more.bmp")) << outcome.output;
    const json all = json::parse(compare("a b --json").output, nullptr, false);
    EXPECT_EQ(all["unpaired"], json::array({"b/more.bmp"})) << all.dump(1);
    EXPECT_EQ(all["alike"], false);
    EXPECT_EQ(compare("a b/1.bmp").status, 2);
}

TEST_F(Compare, MapsOfFoldersOverwriteNeitherPicturesNorEachOther) {
    const std::string grey_png = content::encode_png(content::checkerboard(8));
    for (const std::string side : {"a", "b"}) {
        fs::create_directories(at(side));
        for (const std::string name : {"/1.png", "/2.png"}) folder.write(side + name, grey_png);
        grey(side + "/1.bmp", side == "a" ? 100 : 200);
        folder.write(side + "/s.glib", "Texture2D 5 not.png\nSphere 1\n");
        folder.write(side + "/not.png", grey_png);
    }
    for (const char* into : {"-o a", "-o ./b", "--json=a/1.png", "--json=b/not.png"}) {
        const Outcome refused = compare(std::string("a b ") + into);
        EXPECT_EQ(refused.status, 2) << into << refused.output;
        EXPECT_TRUE(refused.says("is read, and would be overwritten")) << refused.output;
    }
    for (const char* name : {"a/1.png", "a/not.png", "b/1.png", "b/not.png"}) EXPECT_EQ(bytes_of(at(name)), grey_png);
    fs::remove(at("a/s.glib"));
    EXPECT_EQ(compare("a b -o maps").status, 1) << "a scene is missing";
    for (const char* map : {"maps/1.png.png", "maps/1.bmp.png", "maps/2.png"}) EXPECT_TRUE(fs::exists(at(map))) << map;
    EXPECT_NE(bytes_of(at("maps/1.png.png")), bytes_of(at("maps/1.bmp.png")));
    EXPECT_EQ(compare("b/s.glib b/1.bmp -o b/not.png").status, 2) << "the scene reads it";
}

TEST_F(Compare, StandardOutputHoldsTheMapAlone) {
    grey("a.bmp", 100);
    grey("b.bmp", 110);
    ASSERT_EQ(compare("a.bmp b.bmp -o map.png >text").status, 0);
    ASSERT_EQ(run("cd '" + folder.path() + "' && { " SNELL_BIN "/snell compare a.bmp b.bmp -o - >printed.png 2>told; }")
                  .status,
              0);
    EXPECT_EQ(bytes_of(at("printed.png")), bytes_of(at("map.png")));
    EXPECT_EQ(bytes_of(at("told")), bytes_of(at("text")));
    EXPECT_EQ(compare("a.bmp b.bmp -o - --json").status, 2) << "two outputs are not mixed";
}

TEST_F(Compare, CoverageLeavesTheBackgroundOut) {
    accuracy::Picture picture{10, 10, std::vector<float>(400, 1.f)};
    EXPECT_EQ(accuracy::coverage(picture), 0);
    EXPECT_TRUE(accuracy::uniform(picture));
    for (std::size_t i = 0; i < 25; ++i) picture.rgba[4 * (11 + i)] = 0;
    EXPECT_DOUBLE_EQ(accuracy::coverage(picture), .25);
    // With transparency, what is transparent is background, whatever its colour is.
    for (std::size_t i = 0; i < 50; ++i) picture.rgba[4 * i + 3] = 0;
    EXPECT_DOUBLE_EQ(accuracy::coverage(picture), .5);
    const accuracy::Picture turned = accuracy::mirrored(picture);
    EXPECT_EQ(turned.rgba[4 * 18], picture.rgba[4 * 11]);
    EXPECT_EQ(accuracy::mirrored(turned), picture);
}

}  // namespace

}  // namespace snell::test
