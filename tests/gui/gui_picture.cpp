// Pictures that the window saves: larger than itself, many, and the same as the command's.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

class SavedPicture : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib",
             "Perspective 50\nLookAt 1 1 4  0 0 0  0 1 0\nBackground .1 .2 .4\nTimer 1\nVertex paint.vert\n"
             "Fragment paint.frag\nProgram Paint uRed <0. .2 1.>\nTeapot\nLineWidth 6\nWireSphere 1.3\n");
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag", still);
    }
    const std::string still =
        "uniform float uRed;\nuniform vec2 uResolution;\n"
        "void main() { gl_FragColor = vec4(uRed, gl_FragCoord.xy / uResolution, 1.); }\n";

    std::string bytes(const std::string& name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void click(const std::string& widget) {
        const auto [x, y] = on(widget);
        user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1");
        settle();
    }
    void type(const std::string& widget, const std::string& text, bool number) {
        const auto [x, y] = on(widget);
        const std::string at = "mousemove " + std::to_string(x) + " " + std::to_string(y);
        user(at + (number ? " click --repeat 2 --delay 60 1" : " click 1"));
        settle();
        user("key ctrl+a");
        user("type --delay 8 " + text);
        user("key Return");
        settle();
    }
    int run_command(const std::string& command) const {
        return std::system(("cd '" + file(".") + "' && PATH=" SNELL_BIN ":$PATH " + command).c_str());
    }
    Picture read_picture(const std::string& name) const {
        run_command("convert " + name + " -depth 8 read.ppm");
        const std::string ppm = bytes("read.ppm");
        Picture picture;
        int most = 0, begin = 0;
        std::sscanf(ppm.c_str(), "P6 %d %d %d%n", &picture.width, &picture.height, &most, &begin);
        picture.rgb.assign(ppm.begin() + std::min<std::ptrdiff_t>(begin + 1, std::ssize(ppm)), ppm.end());
        return picture;
    }
    // For people to look at.
    void keep_screen(const std::string& name, const std::string& area) const {
        std::filesystem::create_directories(SNELL_BIN "/../screens");
        run_command("import -display " + display_ + " -window root -crop " + area +
                    " +repage '" SNELL_BIN "/../screens/" + name + "'");
    }
};

TEST_F(SavedPicture, LargerThanTheWindowItIsWhatTheCommandDraws) {
    open("scene.glib", {"--size", "640x480"});
    drag(on("Paint.uRed", .2), on("Paint.uRed", .7));
    drag({150, 200}, {220, 230});
    click("picture");
    type("picture file", file("big.png"), false);
    type("picture width", "2200", true);
    type("picture height", "900", true);
    keep_screen("guide-picture.png", "640x480+0+0");
    click("picture command");
    const std::string copied = state()["notice"];
    ASSERT_EQ(copied.rfind("copied: ", 0), 0u) << copied;
    const std::string command = copied.substr(8);
    EXPECT_NE(command.find("--size 2200x900"), std::string::npos) << command;
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"] == "saved big.png, 2200x900"; }, 30)) << state();
    const Picture saved = read_picture("big.png");
    ASSERT_EQ(saved.width, 2200);
    ASSERT_EQ(saved.height, 900);
    run_command("rm big.png");
    ASSERT_EQ(run_command(command), 0) << command;
    const Picture drawn = read_picture("big.png");
    EXPECT_TRUE(drawn.rgb == saved.rgb) << command;
    EXPECT_FALSE(std::all_of(saved.rgb.begin(), saved.rgb.end(), [&](unsigned char c) { return c == saved.rgb[0]; }));
    EXPECT_EQ(state()["gl_errors"], json::array());
    // The window goes on as before.
    user("key 9");
    settle();
    EXPECT_TRUE(alive());
}

TEST_F(SavedPicture, WhatIsThereIsReplacedOnlyWhenAsked) {
    open("scene.glib", {"--size", "640x480"});
    save("there.png", "old");
    click("picture");
    type("picture file", file("there.png"), false);
    click("picture save");
    EXPECT_EQ(bytes("there.png"), "old");
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().rfind("saved there.png", 0) == 0; }));
    EXPECT_NE(bytes("there.png"), "old");
    click("picture");
    type("picture file", file("nowhere/x.png"), false);
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture error"); }));
    EXPECT_TRUE(alive());
}

TEST_F(SavedPicture, ASequenceIsThatOfTheCommand) {
    save("paint.frag",
         "uniform float uRed, Timer;\nvoid main() { gl_FragColor = vec4(Timer, uRed, gl_FragCoord.x / 400., 1.); }\n");
    open("scene.glib", {"--size", "640x480"});
    user("key space");  // the scene's own time stands
    click("picture");
    type("picture file", file("f.png"), false);
    click("picture sequence");
    type("picture from", ".125", true);
    type("picture to", ".5", true);
    type("picture rate", "8", true);
    click("picture command");
    const std::string command = state()["notice"].get<std::string>().substr(8);
    EXPECT_NE(command.find("--frames 3 --fps 8"), std::string::npos) << command;
    click("picture save");
    ASSERT_TRUE(
        wait([](const json& s) { return s["notice"].get<std::string>().rfind("saved 3 pictures", 0) == 0; }, 20))
        << state()["notice"];
    std::array<Picture, 3> saved;
    for (std::size_t k = 0; k < 3; ++k) saved[k] = read_picture("f-000" + std::to_string(k) + ".png");
    run_command("rm f-0000.png f-0001.png f-0002.png");
    ASSERT_EQ(run_command(command), 0) << command;
    for (std::size_t k = 0; k < 3; ++k) {
        const Picture drawn = read_picture("f-000" + std::to_string(k) + ".png");
        ASSERT_GT(drawn.rgb.size(), 0u);
        EXPECT_TRUE(drawn.rgb == saved[k].rgb) << k << ": " << command;
    }
    EXPECT_FALSE(saved[0].rgb == saved[2].rgb);
}

}  // namespace
}  // namespace snell::test
