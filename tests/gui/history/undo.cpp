// Undo and redo, and values of what is gone for a while.
#include <cmath>

#include <fmt/format.h>

#include "tests/gui/history/past.h"

namespace snell::test {
namespace {

using nlohmann::json;

TEST_F(Past, EveryChangeIsUndoneAndTheFirstPictureIsBackToTheBit) {
    share("one.glib");
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

TEST_F(Past, ProgramsOfOneNameKeepTheirOwnValuesAndSnapshots) {
    const std::string begin = "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex paint.vert\n",
                      rest = " uRed <.1 .2 1.>\nQuadXY 0. 1. 2 2\n",
                      first = "Fragment paint.frag\nProgram Paint" + rest,
                      second = "Fragment other.frag\nProgram Paint" + rest;
    for (const char* name : {"paint.frag", "other.frag"})
        save(name,
             "#version 330 compatibility\nuniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, .4, 0., "
             "1.); }\n");
    save("one.glib", begin + first + second);
    share("one.glib");
    const auto value = [&](const char* name) { return state()["controls"][name][0].get<double>(); };
    type("Paint.uRed", ".75", Field::number);  // both have that name as widgets; this is the second
    ASSERT_EQ(value("Paint#2.uRed"), .75);
    press("ctrl+1");
    save("one.glib", begin + second);
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 1); }));
    settle();
    EXPECT_EQ(value("Paint.uRed"), .75);
    type("Paint.uRed", ".5", Field::number);
    press("1");
    EXPECT_EQ(value("Paint.uRed"), .75) << "the snapshot's of the second";
    EXPECT_EQ(notice(), "snapshot 1; 1 value left out: not in this scene");
    save("one.glib", begin + second + first);
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 2); }));
    settle();
    EXPECT_EQ(value("Paint.uRed"), .75);
    EXPECT_EQ(value("Paint#2.uRed"), .2);
    click("uRed.name", .5, 3);
    click("uRed.logarithmic");
    press("Escape");
    animate("uRed");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint#2.uRed"][0] > .3; }));
    save("one.glib", begin + first);
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 3); }));
    const double moving = value("Paint.uRed");
    EXPECT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] != moving; })) << "it moves still";
    click("Paint.uRed", .5);
    settle();
    EXPECT_NEAR(value("Paint.uRed"), std::sqrt(.1), .03) << "and is logarithmic";
}

TEST_F(Past, AValueThatAnEditReplacedComesBack) {
    share("one.glib");
    slide(.75);
    const double slid = red();
    std::string text = bytes("one.glib");
    save("one.glib", text.replace(text.find(".4 1.>"), 6, ".5 1.>"));
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 1); }));
    EXPECT_EQ(red(), slid) << "of another number";
    save("one.glib", text.replace(text.find(".2 1.>"), 6, ".3 1.>"));
    ASSERT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] == .3; }));
    settle();
    EXPECT_EQ(notice(), fmt::format("Paint.uRed {:.6g} was replaced by the file's 0.3; Ctrl+Z brings it back", slid));
    press("ctrl+z");
    EXPECT_EQ(red(), slid);
    EXPECT_EQ(notice(), fmt::format("undo: Paint.uRed 0.3 \u2192 {:.6g}", slid));
}

TEST_F(Past, ARangeThatATypedValueWidenedIsUndoneWithIt) {
    share("one.glib");
    const std::string text = bytes("one.glib");
    type("Paint.uRed", "500", Field::number);
    ASSERT_EQ(red(), 500);
    press("ctrl+z");
    EXPECT_EQ(red(), .2);
    slide(.75);
    EXPECT_LT(red(), 1) << "the range is the scene's again";
    press("ctrl+s");
    EXPECT_NE(bytes("one.glib").find(" 1.> uGreen <0. .4 1.>"), std::string::npos) << bytes("one.glib");
    press("ctrl+y");
    EXPECT_EQ(notice(), "nothing to redo");
}

TEST_F(Past, ASliderThatMovesByItselfIsOneStep) {
    share("one.glib");
    animate("uRed");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .3; }));
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .5; }));
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "this ends the motion, too";
    press("ctrl+z");
    EXPECT_EQ(notice(), "nothing to undo");
}

TEST_F(Past, ASaveWhileASliderMovesKeepsWhereItBegan) {
    share("one.glib");
    const std::string text = bytes("one.glib");
    type("Paint.uGreen", "0.7", Field::number);
    animate("uRed");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .4; }));
    for (const char* key : {"ctrl+s", "ctrl+z"}) {  // the undo of the save restores the file
        const auto revision = state()["revision"];
        user(std::string("key ") + key);
        ASSERT_TRUE(wait([&](const json& s) { return s["revision"] > revision; })) << key;
        const double then = red();
        EXPECT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] != then; })) << key;
    }
    EXPECT_EQ(bytes("one.glib"), text);
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << notice();
    EXPECT_EQ(state()["controls"]["Paint.uGreen"][0], .7);
}

TEST_F(Past, ASaveThatWasUndoneDuringAMotionIsRedoneAfterIt) {
    share("one.glib");
    type("Paint.uGreen", "0.7", Field::number);
    animate("uRed");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .4; }));
    std::string saved;
    for (const char* key : {"ctrl+s", "ctrl+z"}) {
        const auto revision = state()["revision"];
        user(std::string("key ") + key);
        ASSERT_TRUE(wait([&](const json& s) { return s["revision"] > revision; })) << key;
        if (saved.empty()) saved = bytes("one.glib");
    }
    EXPECT_EQ(bytes("one.glib"), scene("uRed"));
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << notice();
    press("ctrl+y");
    EXPECT_NE(red(), .2) << notice();
    press("ctrl+y");
    EXPECT_EQ(notice(), "redo: save to one.glib");
    EXPECT_EQ(bytes("one.glib"), saved);
}

TEST_F(Past, AChangeRightAfterASaveStays) {
    share("one.glib");
    slide(.75);
    const double saved = red();
    const auto [x, y] = on("Paint.uRed", .4);
    user("key ctrl+s mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1");
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 1); })) << "what was saved is read";
    settle();
    const double later = red();
    EXPECT_NEAR(later, .4, .05);
    EXPECT_NE(title().find("\u2022"), std::string::npos) << title();
    EXPECT_EQ(state()["undo"], 3) << "the slider, the save, the slider";
    press("ctrl+z");
    EXPECT_EQ(red(), saved) << notice();
    press("ctrl+y");
    EXPECT_EQ(red(), later) << notice();
    // The next edit of the text is followed.
    save("one.glib", scene("uRed").replace(scene("uRed").find("<0. .2"), 6, "<0. .3"));
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] == .3; }));
}

TEST_F(Past, ASaveRightAfterASaveSavesTheLaterValues) {
    share("one.glib");
    slide(.75);
    const auto [x, y] = on("Paint.uRed", .4);
    const std::string again = "mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1 key ctrl+s";
    user("key ctrl+s " + again);
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 2); })) << state()["failure"];
    settle();
    EXPECT_EQ(state()["failure"], "");
    EXPECT_NEAR(red(), .4, .05);
    EXPECT_EQ(title().find("\u2022"), std::string::npos) << "nothing is left to save";
    const std::string both = bytes("one.glib");
    press("ctrl+z");
    EXPECT_EQ(notice(), "undo: save to one.glib");
    EXPECT_NE(bytes("one.glib"), both);
    EXPECT_NE(bytes("one.glib"), scene("uRed")) << "the first save";
    EXPECT_NEAR(red(), .4, .05);
    press("ctrl+y");
    EXPECT_EQ(bytes("one.glib"), both);
}

TEST_F(Past, ASaveRightAfterASaveOverwritesNoOtherProgramsSave) {
    share("one.glib");
    slide(.75);
    save("other.sh", "cd " + file("") + "; sed 's/uGreen <0. .4/uGreen <0. .9/' one.glib >other; mv other one.glib");
    const auto [x, y] = on("Paint.uRed", .4);
    user("key ctrl+s exec --sync --terminator END sh " + file("other.sh") + " END mousemove " + std::to_string(x) +
         " " + std::to_string(y) + " click 1 key ctrl+s");
    settle();
    EXPECT_NE(bytes("one.glib").find("uGreen <0. .9"), std::string::npos) << bytes("one.glib") << state()["failure"];
    EXPECT_NEAR(red(), .4, .05);
}

// The window has not read its own save yet, and nobody has touched that number.
TEST_F(Past, WhatAnotherProgramSavesRightAfterASaveIsFollowed) {
    share("one.glib");
    slide(.75);
    save("other.sh", "cd " + file("") + "; sed 's/uGreen <0. .4/uGreen <0. .9/' one.glib >other; mv other one.glib");
    user("key ctrl+s exec --sync --terminator END sh " + file("other.sh") + " END");
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uGreen"][0] == .9; }));
    slide(.5);
    press("ctrl+s");
    settle();
    EXPECT_NE(bytes("one.glib").find("uGreen <0. .9"), std::string::npos) << bytes("one.glib");
}

// Reading it again does not save it.
TEST_F(Past, ASaveThatIsRefusedIsSaidUntilItIsDone) {
    share("one.glib");
    slide(.75);
    save("other.sh", "cd " + file("") + "; sed '1i # other' one.glib >other; mv other one.glib");
    user("exec --sync --terminator END sh " + file("other.sh") + " END key ctrl+s");
    ASSERT_TRUE(wait([&](const json& s) { return read(s, 1); }));
    settle();
    if (title().find("\u2022") == std::string::npos) return;  // the window was quick enough to read it first
    EXPECT_NE(state()["failure"].get<std::string>().find("not saved"), std::string::npos) << state()["failure"];
    press("ctrl+s");
    settle();
    EXPECT_EQ(state()["failure"], "");
    EXPECT_EQ(title().find("\u2022"), std::string::npos);
}

TEST_F(Past, UndoWaitsForTheEndOfADrag) {
    share("one.glib");
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

TEST_F(Past, ADoubleClickLeavesNoStep) {
    share("one.glib");
    click("Paint.uGreen", .9);
    double_click("Paint.uRed");
    settle();
    EXPECT_EQ(red(), .2);
    EXPECT_EQ(state()["undo"], 1);
    press("ctrl+z");
    EXPECT_EQ(state()["controls"]["Paint.uGreen"][0], .4) << notice();
    user("sleep .5");  // or these clicks are the third and the fourth of a row
    double_click("Paint.uRed");
    press("ctrl+y");
    EXPECT_NE(state()["controls"]["Paint.uGreen"][0], .4) << notice();
    type("Paint.uRed", "0.6", Field::number);
    EXPECT_EQ(state()["undo"], 2) << "a typed number is one step";
    press("ctrl+z");
    EXPECT_EQ(red(), .2);
}

TEST_F(Past, ADoubleClickEndsNoMotion) {
    share("one.glib");
    animate("uRed");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] > .3; }));
    double_click("Paint.uRed");
    const double then = red();
    EXPECT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] != then; }));
    EXPECT_EQ(state()["undo"], 0);
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "this ends the motion, too";
}

TEST_F(Past, AUniformThatIsRenamedAndBackHasItsPosition) {
    share("one.glib");
    slide(.75);
    const double slid = red();
    rename_to("uRose");
    EXPECT_EQ(state()["controls"]["Paint.uRose"][0], .2);
    rename_to("uRed");
    EXPECT_EQ(red(), slid);
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "steps outlive edits";
    press("ctrl+y");
    press("F5");
    EXPECT_EQ(red(), slid);
}

// The shader has the uniform all the time.
TEST_F(Past, AUniformThatItsLineDoesNotListForAWhileHasItsPosition) {
    const auto red_is = [&](double wanted) {
        return wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] == wanted; });
    };
    share("one.glib");
    slide(.75);
    const double slid = red();
    for (const char* instead : {"uRose <0. .2 1.>", "", "# uRed <0. .2 1.>"}) {
        std::string text = scene("uRed");
        const std::string_view listed = "uRed <0. .2 1.>";
        save("one.glib", text.replace(text.find(listed), listed.size(), instead));
        ASSERT_TRUE(red_is(0)) << "what the program begins with; " << instead;
        save("one.glib", scene("uRed"));
        EXPECT_TRUE(red_is(slid)) << instead;
    }
    settle();
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << notice();
    press("ctrl+y");
    EXPECT_EQ(red(), slid);
}

TEST_F(Past, ALadderThatIsGoneAndBackHasItsRung) {
    share("one.glib");
    save("one.snapshots.json", R"({"1": {"options": "--ladder TINT=light"}})");
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

TEST_F(Past, AChangeBetweenASaveAndTheEndIsThereNextTime) {
    open("one.glib");
    slide(.75);
    const auto [x, y] = on("Paint.uRed", .4);
    user("key ctrl+s mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1");
    ASSERT_TRUE(close_windows(display_));
    EXPECT_TRUE(wait([&](const json&) { return !alive(); }));
    EXPECT_NE(bytes("one.glib"), scene("uRed"));
    end_window();
    open("one.glib");
    EXPECT_NEAR(red(), .4, .05);
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

TEST_F(Past, AValueThatIsGoneForAWhileOutlivesALoss) {
    open("one.glib", {"--lose-file", file("lose")});
    slide(.75);
    const double slid = red();
    rename_to("uRose");
    save("lose", "");
    turn();
    ASSERT_TRUE(
        wait([](const json& s) { return s["problems"].get<std::string>().find("context") != std::string::npos; }));
    settle();
    rename_to("uRed");
    EXPECT_EQ(red(), slid);
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
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0; }));
    settle();
    EXPECT_EQ(red(), slid);
    press("ctrl+z");
    press("ctrl+z");
    EXPECT_EQ(red(), .2) << "and so do the steps";
    press("ctrl+y");
    press("ctrl+s");
    EXPECT_NE(bytes("one.glib"), scene("uRed")) << notice();
}

}  // namespace
}  // namespace snell::test
