// Scenes that are opened, files that lead to an editor, and looks that are kept.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/gui/desk.h"
#include "tests/gui/x11.h"
#include "tests/screens.h"

namespace snell::test {
namespace {

using nlohmann::json;

std::string scene(const std::string& green) {
    return "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex paint.vert\nFragment paint.frag\n"
           "Program Paint uRed <0. .2 1.> uGreen <0. " +
           green + " 1.>\nQuadXY 0. 1.\n";
}

constexpr const char* fragment =
    "#version 330 compatibility\nuniform float uRed, uGreen;\n"
    "void main() { gl_FragColor = vec4(uRed, uGreen, .2, 1.); }\n";

class FilesWindow : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("one.glib", scene(".4"));
        std::filesystem::create_directory(file("other"));
        save("other/two.glib", scene(".8"));
        for (const char* folder : {"", "other/"}) {
            save(std::string(folder) + "paint.vert",
                 "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
            save(std::string(folder) + "paint.frag", fragment);
        }
    }

    void expect_pixel(double red, double green) const {
        const Pixel pixel = scene_pixel(20, 20);
        EXPECT_NEAR(pixel.red, std::lround(255 * red), 1);
        EXPECT_NEAR(pixel.green, std::lround(255 * green), 1);
    }
    bool shows(const std::string& name) {
        const bool found = wait([&](const json& s) { return s["file"] == file(name); });
        settle();
        return found;
    }
    // A program that writes its arguments into "told".
    std::string editor(const std::string& name) {
        save(name, "#!/bin/sh\nprintf '%s\\n' \"$@\" >'" + file("told.new") + "'\nmv '" + file("told.new") + "' '" +
                       file("told") + "'\n");
        std::filesystem::permissions(file(name), std::filesystem::perms::owner_all);
        return file(name);
    }
    bool told() {
        return wait([&](const json&) { return std::filesystem::exists(file("told")); });
    }
};

TEST_F(FilesWindow, ADroppedSceneIsOpened) {
    open("one.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    drag({200, 300}, {260, 300});
    EXPECT_NE(state()["view"]["rotate_y"], 0);
    ASSERT_TRUE(drop_files(display_, {file("other/two.glib")}));
    ASSERT_TRUE(shows("other/two.glib"));
    expect_pixel(.2, .8);
    EXPECT_EQ(state()["view"]["rotate_y"], 0) << "as if the window had been opened on it";
    EXPECT_EQ(state()["errors"], 0);
    // Its files are the ones that are watched now.
    save("other/two.glib", scene(".6"));
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uGreen"][0] == .6; }));
    settle();
    expect_pixel(.2, .6);
    const auto revision = state()["revision"];
    save("one.glib", scene(".1"));
    EXPECT_FALSE(wait([&](const json& s) { return s["revision"] != revision; }, .5));
    ASSERT_TRUE(drop_files(display_, {file("other/paint.frag")}));
    EXPECT_TRUE(wait([](const json& s) { return s["failure"].get<std::string>().starts_with("no .glib"); }));
    EXPECT_EQ(state()["file"], file("other/two.glib"));
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(FilesWindow, TheBrowserOpensAnotherSceneAndTheLastOneIsRecent) {
    open("one.glib");
    user("key ctrl+o");
    click("browser.folders");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.entry.one.glib"); }));
    EXPECT_FALSE(state()["widgets"].contains("browser.entry.paint.frag")) << "scenes only";
    user("type --delay 30 oth");
    user("key Return");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.entry.two.glib"); }));
    const auto [x, y] = on("browser.entry.two.glib", .3);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " click --repeat 2 --delay 60 1");
    ASSERT_TRUE(shows("other/two.glib"));
    expect_pixel(.2, .8);
    user("key ctrl+o");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.recent.one.glib"); }));
    click("browser.recent.one.glib");
    ASSERT_TRUE(shows("one.glib"));
    expect_pixel(.2, .4);
    // What can't be opened leaves all as it is.
    user("key ctrl+o");
    settle();
    user("type --delay 20 ./none.glib");
    user("key Return");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.error"); })) << "what was typed stays";
    keep("browser-error");
    EXPECT_EQ(state()["failure"], "") << "the dialog says it";
    user("key End BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace");
    user("type --delay 20 one.glib");
    user("key Return");
    ASSERT_TRUE(wait([](const json& s) { return !s["widgets"].contains("browser.name"); }));
    settle();
    EXPECT_EQ(state()["file"], file("./one.glib")) << "as it was typed";
    expect_pixel(.2, .4);
}

TEST_F(FilesWindow, WithoutASceneItBeginsWithPicturesOfScenesAndWithNewOnes) {
    open("", {"--size", "1000x740"});
    settle();
    EXPECT_TRUE(state()["widgets"].contains("browser.new.noise"));
    // Its picture is made while nothing is done.
    const auto colourful = [&](const std::array<double, 4>& card) {
        const Picture picture = look();
        std::array<int, 2> range{255, 0};
        for (const double y : {.2, .6})  // above and below the words that an empty frame has in its middle
            for (double x = .2; x < .8; x += .05) {
                const int green = picture.at(card[0] + x * card[2], card[1] + y * card[2]).green;
                range = {std::min(range[0], green), std::max(range[1], green)};
            }
        return range[1] - range[0] > 20;
    };
    // For the guide's picture all that are whole.
    const json widgets = state()["widgets"];
    const double end = widgets["browser.name"][1];
    for (const auto& [name, card] : widgets.items()) {
        const bool whole = name.starts_with("browser.scene.") && card[1].get<double>() + card[3].get<double>() < end;
        if (name != "browser.scene.ambient.glib" && !(whole && !screens_folder().empty())) continue;
        EXPECT_TRUE(wait([&](const json&) { return colourful(card); }, 10)) << name;
    }
    user("mousemove 990 10");
    settle();
    keep("guide-start-window");
    click("browser.new.noise");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("new scene save"); }));
    type("new scene file", file("marble"), Field::text);
    ASSERT_TRUE(shows("marble/marble.glib"));
    settle();
    EXPECT_EQ(state()["errors"], 0);
    EXPECT_FALSE(state()["widgets"].contains("browser.cancel"));
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(FilesWindow, WithoutASceneTheBrowserIsOpenAndTheWindowWorks) {
    open("", {"--size", "900x700"});
    EXPECT_TRUE(state()["widgets"].contains("browser.cancel"));
    EXPECT_EQ(state()["file"], "");
    user("key Escape");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("open scene"); }));
    user("mousemove 30 30");
    user("key a key p key r key 1 key ctrl+s key F5 key n");
    user("search --sync --name snell windowsize 700 500");
    ASSERT_TRUE(wait([](const json& s) { return s["size"] == json::array({700, 500}); }));
    EXPECT_TRUE(idle());
    ASSERT_TRUE(alive());
    user("key ctrl+o");
    EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.cancel"); }));
    user("key Escape");
    settle();
    ASSERT_TRUE(drop_files(display_, {file("one.glib")}));
    ASSERT_TRUE(shows("one.glib"));
    expect_pixel(.2, .4);
    EXPECT_FALSE(state()["widgets"].contains("open scene"));
    EXPECT_EQ(state()["gl_errors"], json::array());
    EXPECT_EQ(run({"--exit-after", ".5"}, display_), 0);
    EXPECT_EQ(run({}, ""), 2) << "without a display";
    EXPECT_EQ(run({file("other")}, ""), 3);
    EXPECT_EQ(run({file("none")}, display_), 1);
}

TEST_F(FilesWindow, AFolderIsLookedIntoAndRecentScenesAreThereAsTheyWereLeft) {
    open("one.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .99));
    ASSERT_TRUE(close_windows(display_));
    EXPECT_TRUE(wait([&](const json&) { return !alive(); }));
    end_window();
    save("other/three.glib", "Background 0 0 0\n");
    open("other");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.entry.two.glib"); }));
    settle();
    EXPECT_TRUE(state()["widgets"].contains("browser.recent.one.glib"));
    const std::array<double, 4> row = state()["widgets"]["browser.recent.one.glib"];
    // It covers .27 of the shorter side from the middle of its picture.
    const Pixel middle = look().at(row[0] + row[2] / 2 + 4, row[1] + row[2] * .375);
    EXPECT_GT(middle.red, 240);
    EXPECT_NEAR(middle.green, 102, 4);
    keep("browser-of-a-folder");
    // The folder above has the one from which one comes.
    user("key BackSpace");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.entry.one.glib"); }));
    settle();
    user("key Return");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("browser.entry.two.glib"); }));
    click("browser.recent.one.glib");
    ASSERT_TRUE(shows("one.glib"));
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(FilesWindow, AFolderWithOneSceneOpensIt) {
    open("other");
    EXPECT_TRUE(shows("other/two.glib"));
    EXPECT_FALSE(state()["widgets"].contains("browser.cancel"));
}

TEST_F(FilesWindow, AnErrorLeadsToItsLineInTheEditor) {
    setenv("VISUAL", (editor("code") + " --wait").c_str(), 1);
    open("one.glib");
    save("paint.frag",
         "#version 330 compatibility\nuniform float uRed, uGreen;\n"
         "void main() { gl_FragColor = vec4(uRed, uGreen + nonsense, .2, 1.); }\n");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("problem.0"); })) << state()["problems"];
    settle();
    keep("guide-error");
    expect_pixel(.2, .4);
    click("problem.0", .3);
    ASSERT_TRUE(told());
    const std::string arguments = bytes("told");
    EXPECT_TRUE(arguments.starts_with("--wait\n--goto\n" + file("paint.frag") + ":3:")) << arguments;
    save("paint.frag", fragment);
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }));
    settle();
    EXPECT_FALSE(state()["widgets"].contains("problem.0"));

    std::filesystem::remove(file("told"));
    click("tools");
    click("files");
    click("file.paint.vert", .2);
    ASSERT_TRUE(told());
    EXPECT_EQ(bytes("told"), "--wait\n--goto\n" + file("paint.vert") + ":1:1\n");
    unsetenv("VISUAL");
}

TEST_F(FilesWindow, WhereNoEditorOpensOneIsSetAndTheLinkWorks) {
    setenv("VISUAL", "false", 1);
    open("one.glib");
    click("tools");
    click("files");
    click("file.paint.vert", .2);
    ASSERT_TRUE(wait([](const json& s) { return s["failure"] == "false ended with status 1"; })) << state()["failure"];
    settle();
    user("key r");
    settle();
    EXPECT_EQ(state()["failure"], "false ended with status 1") << "it stays";
    EXPECT_EQ(state()["notice"], "") << "nothing says that a file was opened";
    click("failure.editor");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("editor save"); }));
    type("editor file", editor("code"), Field::text);
    ASSERT_TRUE(wait([](const json& s) { return s["failure"] == ""; }));
    click("file.paint.vert", .2);
    ASSERT_TRUE(told());
    EXPECT_EQ(bytes("told"), "--goto\n" + file("paint.vert") + ":1:1\n");
    unsetenv("VISUAL");
}

TEST_F(FilesWindow, LooksAreKeptFromRunToRun) {
    open("one.glib", {"--size", "1000x700"});
    const std::array<double, 4> before = state()["widgets"]["reload"];
    const std::array<double, 4> area = state()["scene"];
    const auto panel = [&] { return look().at(area[2] + 8, 690); };
    EXPECT_GT(panel().red, 200);
    user("key ctrl+plus");
    user("key ctrl+plus");
    ASSERT_TRUE(wait([](const json& s) { return s["zoom"] == 1.25; }));
    click("tools");
    click("window");
    click("dark", .1);
    ASSERT_TRUE(wait([](const json& s) { return s["theme"] == "dark"; }));
    settle();
    EXPECT_LT(panel().red, 60);
    end_window();
    open("one.glib", {"--size", "1000x700"});
    EXPECT_EQ(state()["zoom"], 1.25);
    EXPECT_EQ(state()["theme"], "dark");
    EXPECT_TRUE(state()["widgets"].contains("dark")) << "the tab and its section";
    EXPECT_LT(panel().red, 60);
    const std::array<double, 4> after = state()["widgets"]["reload"];
    EXPECT_NEAR(after[3] / before[3], 1.25, .1);
    EXPECT_LT(state()["scene"][2], area[2]) << "the panel has more room";
    user("key ctrl+0");
    EXPECT_TRUE(wait([](const json& s) { return s["zoom"] == 1; }));
}

TEST_F(FilesWindow, OnAScreenOfManyDotsEverythingIsTwiceAsLarge) {
    ASSERT_TRUE(set_dots_per_inch(display_, 192));
    open("one.glib", {"--size", "1024x768"});
    const json now = state();
    const std::array<double, 4> reload = now["widgets"]["reload"];
    EXPECT_NEAR(reload[3], 2 * 24, 4);
    EXPECT_GT(now["scene"][2], 300) << "and there is a picture still";
    EXPECT_TRUE(now["widgets"].contains("Paint.uRed"));
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    EXPECT_NEAR(state()["controls"]["Paint.uRed"][0].get<double>(), .75, .03);
    expect_pixel(state()["controls"]["Paint.uRed"][0], .4);
    keep("window-at-192-dpi");
}

// A scene of ours for docs/guide.md, as a class sees it.
TEST_F(FilesWindow, TheGuidesPicture) {
    setenv("VISUAL", "code", 1);
    for (const char* folder : {"refraction-room", "environments"})
        std::filesystem::copy(std::string("scenes/") + folder, file(folder), std::filesystem::copy_options::recursive);
    open("refraction-room/refraction-room.glib", {"--size", "1024x720"});
    EXPECT_EQ(state()["errors"], 0) << state()["problems"];
    drag({300, 300}, {360, 320});
    user("mousemove 600 716");
    settle();
    keep("guide-window");
    choose("view", "labels");
    user("mousemove 600 716");
    settle();
    keep("guide-values-window");
    choose("view", "labels");
    user("key ctrl+plus");
    user("key ctrl+plus");
    user("key ctrl+plus");
    settle();
    click("tools");
    click("window");
    click("dark", .1);
    click("files");
    user("mousemove 300 716");
    settle();
    keep("guide-dark");
    EXPECT_EQ(state()["gl_errors"], json::array());
    unsetenv("VISUAL");
}

}  // namespace
}  // namespace snell::test
