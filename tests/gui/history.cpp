// What a window remembers: undo and redo, and each scene as it was last.
#include <cmath>

#include "tests/gui/desk.h"
#include "tests/gui/x11.h"

namespace snell::test {
namespace {

using nlohmann::json;

class Past : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        for (const char* name : {"one.glib", "two.glib"}) save(name, scene("uRed"));
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag", fragment("uRed"));
    }

    static std::string scene(const std::string& name, const std::string& end = "QuadXY 0. 1. 2 2\n") {
        return "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex paint.vert\nFragment paint.frag\n"
               "Ladder TINT <dark> light\nProgram Paint " +
               name + " <0. .2 1.> uGreen <0. .4 1.>\n" + end;
    }

    static std::string fragment(const std::string& name) {
        return "#version 330 compatibility\nuniform float " + name +
               ", uGreen;\n"
               "void main() { gl_FragColor = vec4(" +
               name + ", uGreen, float(TINT) * .5, 1.); }\n";
    }
    double red() const { return state()["controls"]["Paint.uRed"][0]; }
    std::string notice() const { return state()["notice"]; }
    std::string view() const { return state()["view"]["text"]; }
    void press(const std::string& key) const {
        user("key " + key);
        settle();
    }
    // By the menu of its name.
    void animate(const std::string& slider) const {
        click(slider + ".name", .5, 3);
        click(slider + ".animate", .1);
        user("key Escape");
    }
    void slide(double to) const { drag(on("Paint.uRed", .2), on("Paint.uRed", to)); }
    void turn() const { drag({200, 300}, {260, 320}); }
    void show(const std::string& name) {
        ASSERT_TRUE(drop_files(display_, {file(name)}));
        ASSERT_TRUE(wait([&](const json& s) { return s["file"] == file(name); }));
        settle();
    }
    std::string title() const {
        shell("DISPLAY=" + display_ + " xdotool search --onlyvisible --name snell getwindowname >title");
        return bytes("title");
    }
    // Waits until what is kept is written.
    bool kept() const {
        return wait([&](const json&) { return std::filesystem::exists(file("state/snell/scenes")); });
    }
};

TEST_F(Past, EveryChangeIsUndoneAndTheFirstPictureIsBackToTheBit) {
    open("one.glib");
    const Picture first = look();
    const std::string plain = title();
    EXPECT_EQ(plain.find("\u2022"), std::string::npos) << plain;
    slide(.75);
    const double slid = red();
    EXPECT_EQ(title(), "\u2022 " + plain);
    click("Paint.uGreen", .9);
    turn();
    const std::string turned = view();
    ASSERT_NE(turned, "");
    user("mousemove 200 300 click --repeat 5 --delay 30 4");
    settle();
    choose("view", "axes");
    press("r");
    EXPECT_EQ(view(), "");
    press("ctrl+z");
    EXPECT_NE(view(), "") << notice();
    press("ctrl+z");
    EXPECT_EQ(notice(), "undo: axes hidden \u2192 shown");
    press("ctrl+z");
    EXPECT_EQ(view(), turned) << "five steps of the wheel are one";
    press("ctrl+z");
    press("ctrl+z");
    EXPECT_EQ(red(), slid);
    press("ctrl+z");
    EXPECT_EQ(red(), .2);
    EXPECT_EQ(notice().find("undo: Paint.uRed "), 0U) << notice();
    EXPECT_EQ(title(), plain);
    press("ctrl+z");
    EXPECT_EQ(notice(), "nothing to undo");
    user("mousemove 1 1");
    press("Escape");  // the notice goes
    const Picture back = look();
    const std::array<double, 4> area = state()["scene"];
    int different = 0;
    for (int py = 0; py < static_cast<int>(area[3]); ++py)
        for (int px = 0; px < static_cast<int>(area[2]); ++px) different += !(back.at(px, py) == first.at(px, py));
    EXPECT_EQ(different, 0);
    press("ctrl+y");
    EXPECT_EQ(red(), slid);
    press("ctrl+shift+z");
    EXPECT_NE(state()["controls"]["Paint.uGreen"][0], .4);
}

TEST_F(Past, ARangeThatATypedValueWidenedIsUndoneWithIt) {
    open("one.glib");
    const std::string text = bytes("one.glib");
    type("Paint.uRed", "500", Field::number);
    ASSERT_EQ(red(), 500);
    press("ctrl+z");
    if (red() != .2) press("ctrl+z");  // the click that opened the field had moved the slider
    EXPECT_EQ(red(), .2);
    slide(.75);
    EXPECT_LT(red(), 1) << "the range is the scene's again";
    press("ctrl+s");
    EXPECT_NE(bytes("one.glib").find(" 1.> uGreen <0. .4 1.>"), std::string::npos) << bytes("one.glib");
    press("ctrl+y");
    EXPECT_EQ(notice(), "nothing to redo");
}

TEST_F(Past, ASliderThatMovesByItselfIsOneStep) {
    open("one.glib");
    animate("uRed");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .3; }));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .5; }));
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "this ends the motion, too";
    press("ctrl+z");
    EXPECT_EQ(notice(), "nothing to undo");
}

TEST_F(Past, OtherChangesAreStepsWhileASliderMoves) {
    open("one.glib");
    animate("uGreen");
    const auto green = [](const json& s) { return s["controls"]["Paint.uGreen"][0].get<double>(); };
    ASSERT_TRUE(wait([&](const json& s) { return green(s) > .5; }));
    slide(.75);
    const double slid = red();
    ASSERT_NE(slid, .2);
    EXPECT_EQ(state()["undo"], 1);
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] == .2; }));
    const double then = green(state());
    EXPECT_TRUE(wait([&](const json& s) { return green(s) != then; })) << "the motion continues";
    EXPECT_NE(then, .4);
    user("key ctrl+y");
    ASSERT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] == slid; }));
    end_window();
    open("one.glib");
    EXPECT_EQ(red(), slid);
    EXPECT_NE(green(state()), .4) << "the motion ended with the window";
}

TEST_F(Past, UndoWaitsForTheEndOfADrag) {
    open("one.glib");
    slide(.5);
    const double half = red();
    const auto [x, y] = on("Paint.uRed", half);
    const auto [to, same] = on("Paint.uRed", .9);
    const std::string at = " " + std::to_string(y);
    user("mousemove " + std::to_string(x) + at + " mousedown 1 sleep .1 mousemove " + std::to_string(to) + at +
         " sleep .1 key ctrl+z sleep .1 mousemove " + std::to_string(to + 1) + at + " sleep .1 mouseup 1");
    settle();
    EXPECT_EQ(state()["undo"], 2) << notice();
    press("ctrl+z");
    EXPECT_EQ(red(), half);
    press("ctrl+z");
    EXPECT_EQ(red(), .2);
}

TEST_F(Past, AValueThatIsGoneForAWhileOutlivesALoss) {
    open("one.glib", {"--lose-file", file("lose")});
    slide(.75);
    const double slid = red();
    save("paint.frag", fragment("uRose"));
    save("one.glib", scene("uRose"));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].contains("Paint.uRose") && s["errors"] == 0; }));
    settle();
    save("lose", "");
    turn();
    ASSERT_TRUE(
        wait([](const json& s) { return s["problems"].get<std::string>().find("context") != std::string::npos; }));
    settle();
    save("paint.frag", fragment("uRed"));
    save("one.glib", scene("uRed"));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].contains("Paint.uRed") && s["errors"] == 0; }, 20));
    settle();
    EXPECT_EQ(red(), slid);
}

TEST_F(Past, AUniformThatIsRenamedAndBackHasItsPosition) {
    open("one.glib");
    slide(.75);
    const double slid = red();
    save("paint.frag", fragment("uRose"));
    save("one.glib", scene("uRose"));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].contains("Paint.uRose") && s["errors"] == 0; }));
    settle();
    EXPECT_EQ(state()["controls"]["Paint.uRose"][0], .2);
    save("paint.frag", fragment("uRed"));
    save("one.glib", scene("uRed"));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].contains("Paint.uRed") && s["errors"] == 0; }));
    settle();
    EXPECT_EQ(red(), slid);
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "steps outlive edits";
    press("ctrl+y");
    press("F5");
    EXPECT_EQ(red(), slid);
}

TEST_F(Past, ALadderThatIsGoneAndBackHasItsRung) {
    open("one.glib");
    save("one.snapshots.json", R"({"1": {"values": {}, "ladders": {"TINT": "light"}}})");
    press("F5");
    press("1");
    ASSERT_TRUE(wait([](const json& s) { return s["rungs"]["TINT"] == "light"; }));
    std::string text = scene("uRed");
    save("paint.frag", "#define TINT 0\n" + fragment("uRed"));
    save("one.glib", text.replace(text.find("Ladder TINT"), 11, "Ladder OTHER"));
    ASSERT_TRUE(wait([](const json& s) { return s["rungs"].contains("OTHER"); }));
    save("one.glib", scene("uRed"));
    ASSERT_TRUE(wait([](const json& s) { return s["rungs"].contains("TINT"); }));
    settle();
    EXPECT_EQ(state()["rungs"]["TINT"], "light");
}

TEST_F(Past, WhatWasSetWhileAShaderIsBrokenOutlivesALossAndIsSaved) {
    open("one.glib", {"--lose-file", file("lose")});
    save("paint.frag", "void main() { broken }\n");
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == true; }));
    settle();
    slide(.75);
    const double slid = red();
    ASSERT_NE(slid, .2);
    save("lose", "");
    turn();
    ASSERT_TRUE(
        wait([](const json& s) { return s["problems"].get<std::string>().find("context") != std::string::npos; }));
    settle();
    EXPECT_EQ(red(), slid);
    save("paint.frag", fragment("uRed"));
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }, 20));
    settle();
    EXPECT_EQ(red(), slid);
    press("ctrl+z");
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "and so do the steps";
    press("ctrl+y");
    press("ctrl+s");
    EXPECT_NE(bytes("one.glib"), scene("uRed")) << notice();
}

TEST_F(Past, AnotherSceneAndBackIsAsItWas) {
    open("one.glib");
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

TEST_F(Past, AReplacedSnapshotComesBack) {
    open("one.glib");
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
    open("one.glib");
    slide(.75);
    turn();
    const double slid = red();
    const std::string turned = view(), text = bytes("one.glib");
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
    EXPECT_EQ(title().find("\u2022"), std::string::npos) << "everything is saved";
    EXPECT_EQ(state()["errors"], 0);
    press("ctrl+shift+s");
    std::filesystem::create_directory(file("other"));
    user("key ctrl+a");
    user("type --delay 8 other/three");
    press("Return");
    EXPECT_TRUE(state()["widgets"].contains("save as error")) << "its shaders are not there";
    type("save as file", ".", Field::text);
    EXPECT_TRUE(state()["widgets"].contains("save as error")) << "no name";
    EXPECT_FALSE(std::filesystem::exists(file("..glib")));
    EXPECT_FALSE(std::filesystem::exists(file("other/three.glib")));
    press("Escape");
    EXPECT_FALSE(state()["widgets"].contains("save as save"));
}

TEST_F(Past, SaveAsHandsOnAValueThatIsGoneForAWhile) {
    open("one.glib");
    slide(.75);
    const double slid = red();
    save("paint.frag", fragment("uRose"));
    save("one.glib", scene("uRose"));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"].contains("Paint.uRose") && s["errors"] == 0; }));
    settle();
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

}  // namespace
}  // namespace snell::test
