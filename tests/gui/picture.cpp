// Pictures that the window saves: larger than itself, many, and the same as the command's.
#include <fmt/format.h>

#include <algorithm>

#include "tests/gui/desk.h"
#include "tests/screens.h"

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

    // A scene that moves, and whose pictures take little: the window draws them until its time is held.
    void save_moving(const std::string& seconds) {
        save("scene.glib", "Timer " + seconds + "\nVertex paint.vert\nFragment paint.frag\n" +
                               "Program Paint uRed <0. .2 1.>\nQuadXY\n");
        save("paint.frag", "uniform float uRed, Timer;\nvoid main() { gl_FragColor = vec4(Timer, uRed, 0., 1.); }\n");
    }

    // For people to look at.
    void keep_screen(const std::string& name, const std::string& area) const {
        const std::string folder = screens_folder();
        if (folder.empty()) return;
        shell("import -display " + display_ + " -window root -crop " + area + " +repage '" + folder + "/" + name + "'");
    }
};

TEST_F(SavedPicture, LargerThanTheWindowItIsWhatTheCommandDraws) {
    open("scene.glib", {"--size", "640x480"});
    drag(on("Paint.uRed", .2), on("Paint.uRed", .7));
    drag({150, 200}, {220, 230});
    choose("save", "picture");
    type("picture file", file("big.png"), Field::unconfirmed);
    type("picture width", "2200", Field::number);
    type("picture height", "900", Field::number);
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
    shell("rm big.png");
    ASSERT_EQ(shell(command), 0) << command;
    const Picture drawn = read_picture("big.png");
    EXPECT_TRUE(drawn.rgb == saved.rgb) << command;
    EXPECT_FALSE(std::all_of(saved.rgb.begin(), saved.rgb.end(), [&](unsigned char c) { return c == saved.rgb[0]; }));
    EXPECT_EQ(state()["gl_errors"], json::array());
    // The window goes on as before.
    user("key 9");
    settle();
    EXPECT_TRUE(alive());
}

// The saved picture is that of the time that the dialog says, however long it is open.
TEST_F(SavedPicture, TimeStandsWhileTheDialogIsOpen) {
    save("paint.frag",
         "uniform float uRed, Timer;\nvoid main() { gl_FragColor = vec4(fract(8. * Timer), uRed, .5, 1.); }\n");
    open("scene.glib", {"--size", "640x480"});
    choose("save", "picture");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture time"); }));
    const double stands = state()["time"];
    ASSERT_TRUE(idle());
    EXPECT_EQ(state()["time"], stands);
    type("picture file", file("moment.png"), Field::unconfirmed);
    click("picture command");
    const std::string command = state()["notice"].get<std::string>().substr(8);
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().rfind("saved moment.png", 0) == 0; }));
    const Picture saved = read_picture("moment.png");
    ASSERT_EQ(shell(command), 0) << command;
    EXPECT_TRUE(read_picture("moment.png").rgb == saved.rgb) << command;
    EXPECT_TRUE(wait([&](const json& s) { return s["time"] > stands; })) << "time goes on";
    // From where it stood, and not from where it would be now.
    choose("save", "picture");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture time"); }));
    const double again = state()["time"];
    user("sleep 2");
    const auto closed = std::chrono::steady_clock::now();
    user("key Escape");
    ASSERT_TRUE(wait([&](const json& s) { return s["time"] > again; }));
    const double passed = state()["time"].get<double>() - again;
    EXPECT_LT(passed, std::chrono::duration<double>(std::chrono::steady_clock::now() - closed).count() + .1);
}

TEST_F(SavedPicture, WhatIsThereIsReplacedOnlyWhenAsked) {
    open("scene.glib", {"--size", "640x480"});
    save("there.png", "old");
    choose("save", "picture");
    type("picture file", file("there.png"), Field::unconfirmed);
    click("picture save");
    EXPECT_EQ(bytes("there.png"), "old");
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().rfind("saved there.png", 0) == 0; }));
    EXPECT_NE(bytes("there.png"), "old");
    choose("save", "picture");
    type("picture file", file("nowhere/x.png"), Field::unconfirmed);
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture error"); }));
    EXPECT_TRUE(alive());
}

TEST_F(SavedPicture, WhatTheSceneReadsIsNotReplaced) {
    const std::string shader = bytes("paint.frag");
    std::string scene = bytes("scene.glib");
    save("paint.png", shader);
    scene.replace(scene.find("paint.frag"), 10, "paint.png");
    save("scene.glib", scene);
    open("scene.glib", {"--size", "640x480"});
    choose("save", "picture");
    type("picture file", file("paint.png"), Field::unconfirmed);
    for (int again = 0; again < 2; ++again) click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture error"); }));
    EXPECT_EQ(bytes("paint.png"), shader);
}

TEST_F(SavedPicture, ASequenceIsThatOfTheCommand) {
    save("paint.frag",
         "uniform float uRed, Timer;\nvoid main() { gl_FragColor = vec4(Timer, uRed, gl_FragCoord.x / 400., 1.); }\n");
    open("scene.glib", {"--size", "640x480"});
    user("key space");  // the scene's own time stands
    choose("save", "picture");
    type("picture file", file("f.png"), Field::unconfirmed);
    click("picture sequence");
    type("picture from", ".125", Field::number);
    type("picture to", ".5", Field::number);
    type("picture rate", "8", Field::number);
    click("picture command");
    const std::string command = state()["notice"].get<std::string>().substr(8);
    EXPECT_NE(command.find("--frames 3 --fps 8"), std::string::npos) << command;
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().rfind("saved 3 pictures", 0) == 0; }))
        << state()["notice"];
    std::array<Picture, 3> saved;
    for (std::size_t k = 0; k < 3; ++k) saved[k] = read_picture("f-000" + std::to_string(k) + ".png");
    shell("rm f-0000.png f-0001.png f-0002.png");
    ASSERT_EQ(shell(command), 0) << command;
    for (std::size_t k = 0; k < 3; ++k) {
        const Picture drawn = read_picture("f-000" + std::to_string(k) + ".png");
        ASSERT_GT(drawn.rgb.size(), 0u);
        EXPECT_TRUE(drawn.rgb == saved[k].rgb) << k << ": " << command;
    }
    EXPECT_FALSE(saved[0].rgb == saved[2].rgb);
}

TEST_F(SavedPicture, OfASequenceThatIsStoppedIsSaidHowManyArePresent) {
    save_moving("1");
    open("scene.glib", {"--size", "640x480"});
    user("key space");
    choose("save", "sequence");
    type("picture to", "1000", Field::number);
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture names"); }));
    keep("sequence");
    click("picture save");
    ASSERT_TRUE(wait([&](const json&) { return std::filesystem::exists(file("scene-0002.png")); }));
    click("picture stop");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture error"); }));
    std::size_t there = 0;
    while (std::filesystem::exists(file(fmt::format("scene-{:04}.png", there)))) ++there;
    EXPECT_EQ(state()["picture_error"], fmt::format("stopped after {} of 25000 pictures", there));
    keep("sequence-stopped");
}

// What the dialog of a scene begins with, it begins with again when the scene was left.
TEST_F(SavedPicture, ASequenceBeginsWithTheScenesTimeAndTheWindowsSize) {
    save("other.glib", "Sphere 1.\n");
    save_moving("3");
    open("scene.glib", {"--size", "640x480"});
    user("key space");
    const auto command = [this](const std::string& item) {
        choose("save", item);
        click("picture command");
        const std::string text = state()["notice"];
        user("key Escape");
        settle();
        return text;
    };
    const auto show = [this](const std::string& name) {
        user("key ctrl+o");
        settle();
        user("type --delay 8 " + name);
        user("key Return");
        EXPECT_TRUE(wait([&](const json& s) { return s["file"].get<std::string>().ends_with(name); }));
        settle();
    };
    const std::string first = command("sequence");
    EXPECT_NE(first.find("--frames 75 --fps 25"), std::string::npos) << first;
    EXPECT_NE(first.find("scene.png"), std::string::npos) << first;
    show("other.glib");
    choose("save", "picture");
    type("picture width", "300", Field::number);
    user("key Escape");
    const std::string again = command("picture");
    EXPECT_NE(again.find("--size 300x"), std::string::npos) << "what was typed stays as long as the scene: " << again;
    show("scene.glib");
    EXPECT_EQ(command("sequence"), first);
}

// Half a period later the slider is at the mirrored place of its range.
TEST_F(SavedPicture, ASequenceShowsOnePeriodOfAnAnimatedSlider) {
    save("paint.frag", "uniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, 0., 0., 1.); }\n");
    save("scene.glib",
         "Ortho -1 1 -1 1\nVertex paint.vert\nFragment paint.frag\nProgram Paint uRed <0. .2 1.>\nQuadXY 0. 5.\n");
    open("scene.glib", {"--size", "640x480"});
    click("uRed.name", .5, 3);
    click("uRed.animate", .1);
    user("key Escape");
    const json before = state();
    ASSERT_TRUE(wait([&](const json& s) { return s["frames"] > before["frames"].get<int>() + 5; })) << "it moves";
    EXPECT_NE(state()["controls"]["Paint.uRed"], before["controls"]["Paint.uRed"]);
    user("key space");
    settle();
    const json paused = state();
    EXPECT_FALSE(wait([&](const json& s) { return s["frames"] != paused["frames"]; }, .3));
    click("uRed.name", .5, 3);
    type("uRed.period", "2", Field::number);
    user("key Escape");
    choose("save", "picture");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("picture save"); }));
    EXPECT_FALSE(state()["widgets"].contains("picture from")) << "one picture was asked for";
    user("key Escape");
    choose("save", "sequence");
    type("picture file", file("f.png"), Field::unconfirmed);
    type("picture rate", "4", Field::number);
    click("picture save");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"].get<std::string>().rfind("saved 8 pictures", 0) == 0; }))
        << state()["notice"];
    std::array<int, 8> reds{};
    for (std::size_t k = 0; k < 8; ++k) reds[k] = read_picture("f-000" + std::to_string(k) + ".png").at(20, 20).red;
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(reds[k] + reds[k + 4], 255, 1) << k;
    EXPECT_GE(*std::ranges::max_element(reds) - *std::ranges::min_element(reds), 255 * 3 / 4);
    click("uRed.dot");
    const json stopped = state();
    EXPECT_FALSE(wait([&](const json& s) { return s["frames"] != stopped["frames"]; }, .3));
}

}  // namespace
}  // namespace snell::test
