// Each scene is as it was last; snapshots, and scenes under another name.
#include <chrono>
#include <thread>

#include "tests/gui/history/past.h"

namespace snell::test {
namespace {

using nlohmann::json;

TEST_F(Past, AxesAreOffForAFlatPictureAndAsTheyWereLeft) {
    save("two.glib", scene("uRed", "QuadXY 0. 1.\n"));
    open("one.glib");
    EXPECT_EQ(state()["view"]["axes"], true);
    show("two.glib");
    EXPECT_EQ(state()["view"]["axes"], false);
    choose("view", "axes");
    show("one.glib");
    EXPECT_EQ(state()["view"]["axes"], true);
    choose("view", "axes");
    show("two.glib");
    EXPECT_EQ(state()["view"]["axes"], true);
    show("one.glib");
    EXPECT_EQ(state()["view"]["axes"], false);
}

// It is written while the window is open, which may end in any way.
TEST_F(Past, AFoldedProgramIsFoldedWhenTheSceneIsOpenedAgain) {
    open("one.glib");
    ASSERT_TRUE(state()["widgets"].contains("Paint.uRed"));
    click("Paint");
    EXPECT_FALSE(state()["widgets"].contains("Paint.uRed"));
    ASSERT_TRUE(
        wait([&](const json&) { return shell("grep -q -- '^--fold Paint=folded$' state/snell/scenes/*.txt") == 0; }));
    show("two.glib");
    EXPECT_TRUE(state()["widgets"].contains("Paint.uRed")) << "of another scene";
    end_window();
    open("one.glib");
    EXPECT_FALSE(state()["widgets"].contains("Paint.uRed"));
    EXPECT_EQ(notice(), "") << "nothing else is as it was last";
    click("Paint");
    EXPECT_TRUE(state()["widgets"].contains("Paint.uRed"));
}

// Whatever moves it in the text, while the window is open and while it is not.
TEST_F(Past, WhatIsInUseAndWhatIsFoldedFollowsItsProgram) {
    const auto text = [](std::initializer_list<const char*> reds) {
        std::string scene =
            "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nVertex paint.vert\nFragment paint.frag\n"
            "Ladder TINT <dark> light\n";
        for (const char* red : reds)
            scene += std::string("Program Paint uRed <0. ") + red + " 1.> uGreen <0. .4 1.>\nQuadXY 0. 1. 2 2\n";
        return scene;
    };
    const auto reds = [&] {
        std::vector<double> values;
        const json controls = state()["controls"];
        for (const char* name : {"Paint.uRed", "Paint#2.uRed", "Paint#3.uRed"})
            if (controls.contains(name)) values.push_back(controls[name][0]);
        return values;
    };
    // The space below a title tells whether its section is folded.
    const auto below = [&](const char* title, const char* next) {
        return on(std::string("title.") + next)[1] - on(std::string("title.") + title)[1];
    };
    const auto edit = [&](std::initializer_list<const char*> values, int times) {
        save("one.glib", text(values));
        ASSERT_TRUE(wait([&](const json& s) { return s["revision"] == times; }));
        settle();
    };
    save("one.glib", text({".1", ".2"}));
    open("one.glib");
    const int shown = state()["revision"];
    user("keydown ctrl");
    click("Paint.uRed");  // the second program's
    user("keyup ctrl key ctrl+a type --delay 8 .75");
    settle();
    edit({".05", ".1", ".2"}, shown + 1);
    press("Return");
    EXPECT_EQ(reds(), (std::vector<double>{.05, .1, .75}));
    click("title.Paint#2");
    settle();
    EXPECT_LT(below("Paint#2", "Paint#3"), below("Paint", "Paint#2"));
    edit({".1", ".05", ".2"}, shown + 2);
    EXPECT_LT(below("Paint", "Paint#2"), below("Paint#2", "Paint#3"));
    ASSERT_TRUE(
        wait([&](const json&) { return shell("grep -q -- '^--fold Paint=folded$' state/snell/scenes/*.txt") == 0; }));
    end_window();
    save("one.glib", text({".05", ".1", ".2"}));
    open("one.glib");
    EXPECT_LT(below("Paint#2", "Paint#3"), below("Paint", "Paint#2"));
    EXPECT_EQ(reds(), (std::vector<double>{.05, .1, .75}));
    end_window();
    save("one.glib", text({".05", ".1", ".3"}));
    open("one.glib");
    EXPECT_EQ(notice(), "Paint#3.uRed 0.75 was replaced by the file's 0.3");
}

TEST_F(Past, AClosedSceneIsAsItWasWhenItIsOpenedAgain) {
    open("one.glib");
    slide(.75);
    turn();
    choose("view", "axes");
    const json before = state();
    ASSERT_TRUE(kept());
    end_window();
    std::filesystem::create_symlink(file("one.glib"), file("link.glib"));
    open("link.glib");
    EXPECT_EQ(state()["controls"], before["controls"]);
    EXPECT_EQ(state()["view"], before["view"]);
    EXPECT_EQ(notice(), "values and view of last time; Ctrl+Z goes back to the scene as written");
    EXPECT_EQ(title().find("\u2022"), 0U);
    keep("values-of-last-time");
    press("ctrl+z");
    EXPECT_EQ(red(), .2);
    EXPECT_EQ(view(), "");
    EXPECT_EQ(shell("snell render one.glib -o plain.png --size 64x64"), 0);
    const std::string plain = bytes("plain.png");
    press("ctrl+y");
    end_window();
    EXPECT_EQ(shell("snell render one.glib -o again.png --size 64x64"), 0);
    EXPECT_TRUE(plain == bytes("again.png")) << "commands read nothing of it";
    // The text that was changed since wins.
    std::string text = scene("uRed");
    save("one.glib", text.replace(text.find("<0. .2 1.>"), 10, "<0. .3 1.>"));
    open("one.glib");
    EXPECT_EQ(red(), .3);
    end_window();
    for (const auto& entry : std::filesystem::directory_iterator(file("state/snell/scenes")))
        save("state/snell/scenes/" + entry.path().filename().string(), "{\"scene\": [[[");
    open("one.glib");
    EXPECT_EQ(state()["errors"], 0) << "damage is as nothing";
    EXPECT_EQ(notice(), "");
}

TEST_F(Past, RungsAreKeptAndTheCommandLineWins) {
    open("one.glib", {"--ladder", "TINT=light"});
    EXPECT_EQ(notice(), "");
    slide(.75);
    const json before = state();
    ASSERT_EQ(before["rungs"]["TINT"], "light");
    ASSERT_TRUE(kept());
    end_window();
    open("one.glib");
    EXPECT_EQ(state()["rungs"], before["rungs"]);
    press("ctrl+z");
    EXPECT_EQ(state()["rungs"]["TINT"], "dark");
    EXPECT_EQ(red(), .2);
    press("ctrl+y");
    EXPECT_EQ(state()["rungs"]["TINT"], "light");
    EXPECT_EQ(state()["controls"], before["controls"]);
    end_window();
    open("one.glib", {"--ladder", "TINT=dark"});
    EXPECT_EQ(state()["rungs"]["TINT"], "dark");
    EXPECT_EQ(state()["controls"], before["controls"]);
}

TEST_F(Past, ASizeIsRememberedIfTheUserChoseItInTheWindow) {
    const auto remembered = [&] {
        end_window();
        const json kept = json::parse(bytes("state/snell/window.json"));
        return std::pair<int, int>(kept["width"], kept["height"]);
    };
    const auto resize = [&](int width, int height) {
        user("search --sync --name snell windowsize " + std::to_string(width) + " " + std::to_string(height));
        ASSERT_TRUE(wait([&](const json& s) { return s["size"] == json::array({width, height}); }));
    };
    open("one.glib", {"--size", "640x480"});
    resize(660, 500);
    EXPECT_EQ(remembered(), std::pair(0, 0)) << "the command line chose it";
    save("small.glib", "WindowSize 300 250\n" + scene("uRed"));
    open("small.glib", {"--size", ""});
    const json small = state()["size"];
    show("two.glib");
    EXPECT_EQ(state()["size"], small);
    EXPECT_EQ(remembered(), std::pair(0, 0)) << "the scene chose it";
    open("small.glib", {"--size", ""});
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // it is placed by then
    resize(720, 510);
    ASSERT_TRUE(wait([&](const json&) {
        return json::parse(bytes("state/snell/window.json"), nullptr, false).value("width", 0) == 720;
    })) << "while it runs: a window that is killed says nothing";
    EXPECT_EQ(remembered(), std::pair(720, 510)) << "the user chose another one";
    open("small.glib", {"--size", ""});
    show("two.glib");
    resize(700, 500);
    EXPECT_EQ(remembered(), std::pair(700, 500));
    open("one.glib", {"--size", ""});
    EXPECT_EQ(state()["size"], json::array({700, 500}));
}

TEST_F(Past, NoticesAreOneLineWhateverAFileIsCalled) {
    save("two\nlines.glib", scene("uRed"));
    open("two\nlines.glib");
    slide(.75);
    press("ctrl+2");
    EXPECT_EQ(notice(), "snapshot 2 is in two\\x0Alines.snapshots.json");
    press("ctrl+s");
    EXPECT_EQ(notice(), "1 value saved to two\\x0Alines.glib");
    std::filesystem::remove(file("two\nlines.glib"));
    slide(.3);
    press("ctrl+s");
    const std::string said = state()["failure"];
    EXPECT_EQ(said.find("not saved: two\\x0Alines.glib is gone"), 0U) << said;
}

TEST_F(Past, AnotherSceneAndBackIsAsItWas) {
    share("one.glib");
    slide(.75);
    turn();
    choose("view", "axes");
    const json before = state();
    show("two.glib");
    EXPECT_EQ(red(), .2);
    EXPECT_EQ(view(), "");
    slide(.5);
    show("one.glib");
    EXPECT_EQ(state()["controls"], before["controls"]);
    EXPECT_EQ(state()["view"], before["view"]);
    EXPECT_EQ(notice(), "values and view of last time");
    press("ctrl+z");
    press("ctrl+z");
    EXPECT_EQ(view(), "") << "its own steps";
    EXPECT_EQ(red(), before["controls"]["Paint.uRed"][0]);
}

TEST_F(Past, WhatCouldNotBeStoredWaitsForItsScene) {
    share("one.glib");
    std::filesystem::create_directory(file("one.snapshots.json"));
    slide(.75);
    const double slid = red();
    press("ctrl+8");
    const std::string said = state()["failure"];
    EXPECT_EQ(said.find("snapshot 8 is not stored: "), 0U) << said;
    slide(.3);
    show("two.glib");
    EXPECT_EQ(state()["failure"], "") << "not of this one";
    show("one.glib");
    EXPECT_EQ(state()["failure"], said);
    press("ctrl+9");
    settle();
    const auto at = on("failure.ok", .5);
    user("mousemove " + std::to_string(at[0]) + " " + std::to_string(at[1]) + " click --repeat 3 --delay 90 1");
    settle();
    EXPECT_EQ(state()["failure"], said) << "a double click answers one notice";
    std::filesystem::remove(file("one.snapshots.json"));
    click("failure.again");
    ASSERT_TRUE(wait([](const json& s) { return s["failure"] == ""; }));
    EXPECT_NE(red(), slid);
    press("8");
    EXPECT_EQ(red(), slid) << "the values of then";
}

TEST_F(Past, AReplacedSnapshotComesBack) {
    share("one.glib");
    press("ctrl+1");
    const std::string old = bytes("one.snapshots.json");
    slide(.75);
    press("ctrl+1");
    EXPECT_NE(bytes("one.snapshots.json"), old);
    press("ctrl+z");
    EXPECT_EQ(notice(), "undo: snapshot 1");
    EXPECT_EQ(bytes("one.snapshots.json"), old);
    press("1");
    EXPECT_EQ(red(), .2);
    press("ctrl+z");
    EXPECT_NE(red(), .2) << "recalling it is a step, too";
    const auto button = [&] {
        const Picture picture = look();
        const std::array<double, 4> at = state()["widgets"]["snapshot 1"];
        std::vector<Pixel> pixels;
        for (int y = 0; y < static_cast<int>(at[3]); ++y)
            for (int x = 0; x < static_cast<int>(at[2]); ++x) pixels.push_back(picture.at(at[0] + x, at[1] + y));
        return pixels;
    };
    user("mousemove 1 1");
    settle();
    const auto lit = button();
    press("ctrl+z");
    ASSERT_EQ(notice().find("undo: Paint.uRed"), 0U);
    press("ctrl+z");
    EXPECT_EQ(notice(), "undo: snapshot 1");
    EXPECT_FALSE(std::filesystem::exists(file("one.snapshots.json")));
    EXPECT_FALSE(button() == lit) << "its button is as before it was stored";
    press("ctrl+y");
    EXPECT_TRUE(button() == lit);
}

TEST_F(Past, SaveAsWritesTheValuesUnderAnotherNameAndShowsIt) {
    share("one.glib");
    slide(.75);
    turn();
    const double slid = red();
    const std::string turned = view(), text = bytes("one.glib");
    press("ctrl+3");
    press("ctrl+shift+s");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    settle();
    keep("save-as");
    user("key ctrl+a");
    user("type --delay 8 two");
    press("Return");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    EXPECT_EQ(bytes("two.glib"), text) << "it is asked first";
    click("save as save");
    ASSERT_TRUE(wait([&](const json& s) { return s["file"] == file("two.glib"); }));
    settle();
    EXPECT_EQ(bytes("one.glib"), text);
    EXPECT_EQ(red(), slid);
    EXPECT_EQ(view(), turned);
    EXPECT_EQ(notice(), "saved as two.glib");
    press("7");
    EXPECT_EQ(notice(), "") << "there is no such snapshot, and nothing beside that looks like its outcome";
    EXPECT_EQ(title().find("\u2022"), std::string::npos) << "everything is saved";
    EXPECT_EQ(state()["errors"], 0);
    EXPECT_EQ(bytes("two.snapshots.json"), bytes("one.snapshots.json"));
    slide(.3);
    press("3");
    EXPECT_EQ(red(), slid) << "the snapshot came along";
    press("ctrl+4");
    press("ctrl+shift+s");
    user("key ctrl+a");
    user("type --delay 8 one");
    press("Return");
    keep("save-as-with-snapshots");
    EXPECT_NE(bytes("two.snapshots.json"), bytes("one.snapshots.json")) << "it is asked first";
    press("Escape");
    press("ctrl+shift+s");
    std::filesystem::create_directory(file("other"));
    user("key ctrl+a");
    user("type --delay 8 other/three");
    save("other/paint.frag", "another one\n");
    press("Return");
    EXPECT_TRUE(state()["widgets"].contains("save as error")) << "it would be replaced";
    EXPECT_EQ(notice(), "");
    type("save as file", ".", Field::text);
    EXPECT_TRUE(state()["widgets"].contains("save as error")) << "no name";
    EXPECT_FALSE(std::filesystem::exists(file("..glib")));
    EXPECT_FALSE(std::filesystem::exists(file("other/three.glib")));
    std::filesystem::remove(file("other/paint.frag"));
    type("save as file", "other/three", Field::text);
    ASSERT_TRUE(wait([&](const json& s) { return s["file"] == file("other/three.glib"); }));
    settle();
    std::string other = file("other");  // as the window shows it
    if (const char* home = getenv("HOME"); home && other.starts_with(std::string(home) + "/"))
        other.replace(0, std::string(home).size(), "~");
    EXPECT_EQ(notice(), "saved as three.glib in " + other + " with its 2 files");
    EXPECT_EQ(state()["errors"], 0);
    EXPECT_EQ(red(), slid);
    EXPECT_EQ(bytes("other/paint.frag"), bytes("paint.frag"));
    EXPECT_EQ(bytes("other/three.snapshots.json"), bytes("two.snapshots.json"));
}

TEST_F(Past, ARevertedSaveIsRememberedWhenAnotherSceneIsShown) {
    share("one.glib");
    slide(.75);
    const double slid = red();
    const std::string text = bytes("one.glib");
    press("ctrl+s");
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 1); }));
    settle();
    user("key ctrl+z");
    ASSERT_TRUE(wait([&](const json&) { return bytes("one.glib") == text; }));
    show("two.glib");  // before the window has noticed that the file is another one
    show("one.glib");
    EXPECT_EQ(red(), slid) << "it differed from the file";
    press("ctrl+y");
    EXPECT_NE(bytes("one.glib"), text) << "and can be saved again";
    show("two.glib");
    show("one.glib");
    EXPECT_EQ(red(), slid);
}

TEST_F(Past, ASaveIsUndoneAfterAnotherSceneWasShown) {
    share("./one.glib");  // later it is opened by another name
    slide(.75);
    const double slid = red();
    const std::string text = bytes("one.glib");
    press("ctrl+s");
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 1); }));
    settle();
    show("two.glib");
    show("one.glib");
    const auto revision = state()["revision"];
    press("ctrl+z");
    ASSERT_TRUE(wait([&](const json& s) { return s["revision"] > revision; }));
    settle();
    EXPECT_EQ(bytes("one.glib"), text);
    EXPECT_EQ(red(), slid) << "values stay as they are";
    EXPECT_TRUE(title().starts_with("\u2022")) << title() << "and differ from the file";
    press("ctrl+z");
    EXPECT_EQ(red(), .2);
}

TEST_F(Past, ASceneIsRescuedFromARenamedFolder) {
    namespace fs = std::filesystem;
    fs::create_directory(file("work"));
    for (const char* name : {"one.glib", "paint.vert", "paint.frag"}) save("work/" + std::string(name), bytes(name));
    share("work/one.glib");
    slide(.75);
    const double slid = red();
    fs::rename(file("work"), file("moved"));
    press("ctrl+s");
    EXPECT_NE(state()["failure"].get<std::string>().find("one.glib is gone"), std::string::npos) << state()["failure"];
    EXPECT_EQ(state()["failure"].get<std::string>().find(file("")), std::string::npos) << "the file, not its path";
    click("failure.ok");
    press("ctrl+z");
    press("ctrl+s");
    EXPECT_NE(state()["failure"].get<std::string>().find("one.glib is gone"), std::string::npos) << "nothing changed";
    press("ctrl+y");
    ASSERT_EQ(red(), slid);
    click("failure.save as");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    press("Return");
    EXPECT_TRUE(state()["widgets"].contains("save as error")) << "there is no such folder any more";
    type("save as file", file("moved") + "/two", Field::text);
    ASSERT_TRUE(wait([&](const json& s) { return s["file"] == file("moved/two.glib"); }));
    settle();
    EXPECT_EQ(state()["errors"], 0);
    EXPECT_EQ(red(), slid);
    EXPECT_EQ(state()["failure"], "");
}

TEST_F(Past, ADeletedSceneIsWrittenAgainUnderItsOwnName) {
    share("one.glib");
    const std::string text = bytes("one.glib");
    slide(.75);
    const double slid = red();
    std::filesystem::remove(file("one.glib"));
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == true; }));
    press("ctrl+s");
    EXPECT_EQ(state()["failure"].get<std::string>().find("not saved: one.glib is gone"), 0U) << state()["failure"];
    click("failure.save as");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    press("Return");
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0 && s["stale"] == false; }));
    settle();
    EXPECT_NE(bytes("one.glib"), "");
    EXPECT_NE(bytes("one.glib"), text) << "with the values as they are";
    EXPECT_EQ(red(), slid);
    EXPECT_EQ(state()["failure"], "");
    EXPECT_EQ(title().find("\u2022"), std::string::npos) << "everything is saved";
}

TEST_F(Past, SaveAsHandsOnAValueThatIsGoneForAWhile) {
    share("one.glib");
    slide(.75);
    const double slid = red();
    rename_to("uRose");
    press("ctrl+shift+s");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    user("key ctrl+a");
    user("type --delay 8 three");
    press("Return");
    ASSERT_TRUE(wait([&](const json& s) { return s["file"] == file("three.glib"); }));
    settle();
    save("paint.frag", fragment("uRed"));
    save("three.glib", scene("uRed"));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].contains("Paint.uRed") && s["errors"] == 0; }));
    settle();
    EXPECT_EQ(red(), slid);
}

}  // namespace
}  // namespace snell::test
