// The window around the panels: toolbar, tabs, what is hidden, the line below the picture, a window without a scene.
#include "src/ui/shell.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/ui/kit/kit.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class Shell : public UiTest {
protected:
    Shell() { facts_.file = "room.glib"; }
    void press(Key which, Modifiers modifiers = {}) {
        frame({{.kind = Event::Kind::key, .key = which, .down = true, .modifiers = modifiers}});
        pressed_ = requests_;
        frame({key(which, false)});
    }
    bool visible(const std::string& name) {
        for (int i = 0; i < 4; ++i) frame();
        return std::ranges::any_of(layout_.items(),
                                   [&](const Placed& placed) { return placed.name == name && placed.visible; });
    }
    void many_sliders() {
        for (int i = 0; i < 45; ++i) add_slider("uValue" + std::to_string(i), 0, .5, 1);
    }
    void ladder() {
        Ladder ladder;
        ladder.name = "FRESNEL";
        ladder.rungs = {"f0", "exact"};
        scene_.ladders.push_back(ladder);
        controls_.rungs = {0};
    }

    Requests pressed_;
};

TEST_F(Shell, TheToolbarStaysWhereItIsWhileThePanelScrolls) {
    many_sliders();
    facts_.animated = facts_.timed = true;
    for (const Screen& screen : {Screen{1280, 800, 1, 1}, {640, 480, 1, 1}, {1024, 768, 1, 2}}) {
        screen_ = screen;
        const Rect before = place("reload");
        EXPECT_FALSE(visible("Glass.uValue44"));
        frame({move(memory_.scene.width + 100, screen.height - 30)});
        for (int i = 0; i < 60; ++i) frame({wheel(-5)});
        EXPECT_TRUE(visible("Glass.uValue44")) << screen.height;
        for (const char* name : {"menu.open", "reload", "menu.save", "menu.view", "snapshot 1", "snapshot 9", "tools"})
            EXPECT_TRUE(visible(name)) << name << " at " << screen.width << " by " << screen.scale;
        EXPECT_EQ(place("reload"), before);
        for (int i = 0; i < 60; ++i) frame({wheel(5)});
    }
}

TEST_F(Shell, TheToolbarHasTwoRowsInAPanelOfItsUsualWidth) {
    EXPECT_EQ(place("menu.open").y, place("menu.view").y);
    EXPECT_EQ(place("snapshot 1").y, place("snapshot 9").y);
    screen_ = {640, 480, 1, 1};
    EXPECT_EQ(place("menu.open").y, place("menu.view").y);
    EXPECT_EQ(place("snapshot 1").y, place("snapshot 9").y);
}

TEST_F(Shell, AClickOnTheButtonOfAnOpenMenuClosesIt) {
    for (const auto& [menu, entry] : {std::pair("menu.open", "open"), {"menu.save", "save"}, {"menu.view", "hide"}}) {
        click(place(menu));
        EXPECT_TRUE(has(entry)) << menu;
        click(place(menu));
        EXPECT_FALSE(has(entry)) << menu;
        click(place(menu));
        EXPECT_TRUE(has(entry)) << menu;
        frame({key(Key::escape, true)});
        frame({key(Key::escape, false)});
        EXPECT_FALSE(has(entry)) << menu;
    }
    click(place("menu.open"));
    click(place("menu.view"));
    EXPECT_TRUE(has("hide")) << "the click beside one menu opens the other";
    EXPECT_FALSE(has("open"));
}

TEST_F(Shell, MenusOpenScenesAndChangeTheView) {
    const std::vector<SceneCard> recent{{"one.glib", "~", "/home/ann/one.glib"}, {"two.glib", "/x", "/x/two.glib"}};
    facts_.recent = recent;
    click(place("menu.open"));
    const Rect two = place("recent.two.glib");
    frame({move(two.x + 9, two.y + 9)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_EQ(requests_.open, "/x/two.glib");
    EXPECT_FALSE(has("recent.two.glib")) << "the menu is closed";
    view_.axes = true;
    choose("view", "axes");
    EXPECT_FALSE(view_.axes);
    choose("view", "labels");
    EXPECT_TRUE(memory_.labels);
    choose("view", "pick");
    EXPECT_TRUE(memory_.hold.picking);
    choose("view", "hide");
    EXPECT_FALSE(memory_.panel);
}

TEST_F(Shell, EscapeClosesAMenuAndNothingElse) {
    hold_object(memory_.hold, 0);
    click(place("menu.save"));
    EXPECT_TRUE(has("copy command"));
    press(Key::escape);
    EXPECT_FALSE(has("copy command"));
    EXPECT_EQ(memory_.hold.object, 0u);
    press(Key::escape);
    EXPECT_EQ(memory_.hold.object, none);
}

TEST_F(Shell, MenusStayOnTheScreen) {
    for (const Screen& screen : {Screen{1280, 800, 1, 1}, {640, 480, 1, 1}, {640, 480, 1, 2}}) {
        screen_ = screen;
        for (const auto& [menu, last] : {std::pair("menu.save", "copy command"), {"menu.view", "hide"}}) {
            click(place(menu));
            const Rect at = place(last);
            EXPECT_GE(at.x, 0) << menu;
            EXPECT_LE(at.x + at.width, screen.width) << menu;
            EXPECT_LE(at.y + at.height, screen.height) << menu;
            press(Key::escape);
        }
    }
}

// The frame that it is pressed in may stay for long: its contents are below it, so it is marked.
TEST_F(UiTest, ATabIsMarkedInTheFrameThatShowsItsContents) {
    for (const char* name : {"tools", "controls"}) {
        const Rect tab = place(name);
        frame({move(tab.x + tab.width / 2, tab.y + tab.height / 2)});
        frame({button(true)});
        frame({button(false)});
        const auto mark = std::find_if(layout_.items().begin(), layout_.items().end(),
                                       [](const Placed& placed) { return placed.name == "tab"; });
        ASSERT_NE(mark, layout_.items().end());
        EXPECT_EQ(mark->rect.x, tab.x) << name;
        EXPECT_EQ(mark->rect.width, tab.width) << name;
    }
}

TEST_F(Shell, ToolsAreInATabOfTheirOwn) {
    many_sliders();
    memory_.open = {"Costs", "Frame cost"};
    EXPECT_TRUE(has("Glass.uValue0"));
    EXPECT_FALSE(has("costs"));
    EXPECT_FALSE(memory_.costs) << "what is not in sight is not measured";
    click(place("tools"));
    EXPECT_EQ(memory_.tab, Tab::tools);
    for (const char* name : {"view", "pixels", "frame cost", "costs", "files", "window"}) EXPECT_TRUE(visible(name));
    EXPECT_FALSE(has("Glass.uValue0"));
    EXPECT_TRUE(memory_.costs);
    EXPECT_TRUE(memory_.frame_cost);
    click(place("controls"));
    EXPECT_TRUE(has("Glass.uValue0"));
    EXPECT_FALSE(memory_.costs);
    EXPECT_TRUE(memory_.frame_cost) << "it goes on while sliders are dragged";
}

TEST_F(Shell, TheLargestLettersLeaveAThirdForThePicture) {
    for (const float width : {320.F, 420.F, 640.F, 1280.F})
        for (const float wanted : {.5F, 1.F, 2.F, 3.F}) {
            screen_.width = width;
            screen_.scale = fitting_scale(wanted, width);
            frame();
            EXPECT_GE(memory_.scene.width, .32F * width) << width << ' ' << wanted;
            EXPECT_LE(screen_.scale, wanted);
            EXPECT_TRUE(screen_.scale == wanted || wanted > 1) << "usual letters are as they are";
        }
}

TEST_F(Shell, EverySectionSaysWhatItIsAbout) {
    memory_.tab = Tab::tools;
    std::set<std::string> said;
    for (const char* name : {"accuracy", "view", "pixels", "textures", "frame cost", "costs", "files", "window"}) {
        const Rect at = place(name);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        frame({}, 1);
        frame({}, 1);
        EXPECT_TRUE(kit().tip.shown && said.insert(kit().tip.text).second) << name;
    }
}

TEST_F(Shell, KeysWithCtrlAreOtherKeys) {
    view_.scene.scale = 2;
    for (const Key which : {Key::a, Key::p, Key::h, Key::r, Key::n}) press(which, {.ctrl = true});
    EXPECT_FALSE(memory_.accuracy.open);
    EXPECT_FALSE(memory_.hold.picking);
    EXPECT_TRUE(memory_.panel);
    EXPECT_EQ(view_.scene.scale, 2);
    EXPECT_FALSE(memory_.pixels.flags);
}

TEST_F(Shell, AShowsAccuracyAndThenClosesIt) {
    ladder();
    press(Key::a);
    EXPECT_TRUE(memory_.accuracy.open);
    EXPECT_EQ(memory_.tab, Tab::tools);
    click(place("controls"));
    EXPECT_TRUE(memory_.accuracy.open) << "it goes on beside the sliders";
    press(Key::a);
    EXPECT_TRUE(memory_.accuracy.open) << "out of sight it is shown first";
    EXPECT_EQ(memory_.tab, Tab::tools);
    press(Key::a);
    EXPECT_FALSE(memory_.accuracy.open);
}

TEST_F(Shell, ASectionThatIsOpenedIsScrolledIntoSight) {
    std::vector<FileRow> files;
    for (int i = 0; i < 12; ++i) files.push_back({"file" + std::to_string(i), "/file"});
    facts_.files = files;
    memory_.tab = Tab::tools;
    memory_.open = {"View"};
    screen_ = {1280, 520, 1, 1};
    ASSERT_TRUE(visible("files"));
    EXPECT_FALSE(visible("file.file11"));
    click(place("files"));
    EXPECT_TRUE(visible("file.file11")) << "its end";
    EXPECT_TRUE(visible("files")) << "its title";
    const Rect there = place("files");
    click(there);
    click(place("files"));
    EXPECT_TRUE(visible("file.file11"));
    // One that is higher than the panel begins at its top.
    click(place("files"));
    for (int i = 12; i < 60; ++i) files.push_back({"file" + std::to_string(i), "/file"});
    facts_.files = files;
    click(place("files"));
    EXPECT_TRUE(visible("files"));
    EXPECT_FALSE(visible("view"));
    // What is in sight already stays where it is.
    memory_.open.clear();
    for (int i = 0; i < 4; ++i) frame();
    const Rect pixels = place("pixels");
    click(pixels);
    EXPECT_EQ(place("pixels"), pixels);
}

TEST_F(Shell, HHidesAllButAHintThatFades) {
    scene_.messages.push_back({"a message", {}});
    memory_.labels = true;
    add_slider("uEta", 0, .5, 1);
    frame();
    const Rect before = memory_.scene;
    press(Key::h);
    EXPECT_EQ(memory_.scene, (Rect{0, 0, screen_.width, screen_.height}));
    for (const char* name : {"reload", "status.file", "message.ok"}) EXPECT_FALSE(has(name)) << name;
    EXPECT_TRUE(has("hint"));
    const std::uint64_t shown = picture_;
    frame({}, hint_seconds - .5);
    EXPECT_NE(picture_, shown) << "it fades";
    EXPECT_GT(memory_.hint, 0);
    frame({}, 1);
    EXPECT_FALSE(has("hint"));
    EXPECT_EQ(memory_.hint, 0) << "nothing changes from here on";
    EXPECT_EQ(ImGui::GetDrawData()->TotalVtxCount, 0) << "there is nothing but the picture";
    // Errors must be seen.
    const std::vector<Problem> problems{{{.message = "no"}, {}}};
    facts_.problems = problems;
    EXPECT_TRUE(has("problems.hide"));
    press(Key::h);
    EXPECT_EQ(memory_.scene, before);
    EXPECT_TRUE(has("reload"));
    EXPECT_FALSE(has("hint"));
}

TEST_F(Shell, F11AsksForFullScreenAndEscapeEndsItLast) {
    press(Key::f11);
    EXPECT_TRUE(pressed_.full_screen);
    press(Key::escape);
    EXPECT_FALSE(pressed_.full_screen) << "there is none to end";
    facts_.full_screen = true;
    memory_.hold.picking = true;
    memory_.keys = true;
    press(Key::escape);
    EXPECT_FALSE(memory_.keys);
    EXPECT_FALSE(pressed_.full_screen);
    press(Key::escape);
    EXPECT_FALSE(memory_.hold.picking);
    EXPECT_FALSE(pressed_.full_screen);
    press(Key::escape);
    EXPECT_TRUE(pressed_.full_screen);
}

TEST_F(Shell, PickingSaysSoAtOnce) {
    EXPECT_FALSE(has("status.pick"));
    press(Key::p);
    EXPECT_TRUE(visible("status.pick"));
    frame({move(300, 300)});
    EXPECT_EQ(gui_.cursor(), Cursor::hand);
    frame({move(screen_.width - 40, 300)});
    EXPECT_EQ(gui_.cursor(), Cursor::arrow) << "over the panel nothing is picked";
    press(Key::p);
    frame({move(300, 300)});
    EXPECT_EQ(gui_.cursor(), Cursor::arrow);
}

// The narrower the window, the fewer the parts; each goes alone, and never before one that is less important.
TEST_F(Shell, TheStatusLineGivesWayBitByBit) {
    ladder();
    facts_.animated = facts_.timed = true;
    facts_.object = "Sphere, line 3";
    memory_.hold.picking = true;
    const std::vector<Problem> problems{{{.severity = Severity::warning, .message = "no"}, {}}};
    facts_.problems = problems;
    const std::vector<std::string> by_importance{"problems",      "status.pick",  "status.cost", "status.file",
                                                 "status.object", "status.time",  "status.keys", "status.accuracy",
                                                 "status.drag",   "status.wheel", "status.move", "status.reset"};
    std::set<std::string> before;
    std::size_t changes = 0;
    for (float width = 1900; width > 400; width -= 1) {
        screen_.width = width;
        frame();
        std::set<std::string> now;
        for (const Placed& placed : layout_.items())
            if (placed.name == "problems" || placed.name.starts_with("status.")) {
                now.insert(placed.name);
                EXPECT_LE(placed.rect.x + placed.rect.width, memory_.scene.width) << placed.name << " at " << width;
            }
        const auto first_gone =
            std::ranges::find_if(by_importance, [&](const auto& name) { return !now.contains(name); });
        for (auto later = first_gone; later != by_importance.end(); ++later)
            EXPECT_FALSE(now.contains(*later))
                << *later << " is there at " << width << ", " << *first_gone << " is not";
        if (!before.empty() && now != before) {
            ++changes;
            EXPECT_LE(before.size() - now.size(), 1u) << width;
        }
        if (width == 1900) {
            EXPECT_EQ(now.size(), by_importance.size());
        }
        before = now;
    }
    EXPECT_GT(changes, 6u);
    EXPECT_TRUE(before.contains("problems"));
}

TEST_F(Shell, AnOutcomeTakesThePlaceOfTheKeysAndIsShortened) {
    memory_.notice = "42 values saved to a-scene-with-quite-a-long-name.glib\nnot uThis: it is computed";
    screen_.width = 900;
    EXPECT_TRUE(visible("notice"));
    EXPECT_FALSE(has("status.drag"));
    screen_.width = 700;
    EXPECT_TRUE(visible("notice"));
    EXPECT_TRUE(visible("status.cost"));
}

// The next press ends an outcome, and what it hid is there again.
TEST_F(Shell, InTheNarrowestLineAnOutcomeIsInPlaceOfTheWarnings) {
    const std::vector<Problem> problems{{{.severity = Severity::warning, .message = "no"}, {}}};
    facts_.problems = problems;
    screen_.width = 420;
    screen_.height = 320;
    EXPECT_TRUE(visible("problems"));
    memory_.notice = "snapshot 3 is in a-scene-with-quite-a-long-name.snapshots.json";
    EXPECT_TRUE(visible("notice"));
    memory_.notice.clear();
    EXPECT_TRUE(visible("problems"));
}

TEST_F(Shell, APictureThatNeverWasGoodIsNotCalledSo) {
    facts_.stale = true;
    frame();
    EXPECT_EQ(place("status.stale").width, ImGui::CalcTextSize("last good picture").x);
    facts_.incomplete = true;
    EXPECT_EQ(place("status.stale").width, ImGui::CalcTextSize("incomplete picture").x);
}

TEST_F(Shell, AWindowWithoutASceneSaysHowToOpenOne) {
    no_scene_ = true;
    facts_.file = "";
    Listing listing;
    listing.folder = "/home/ann/scenes";
    facts_.listing = &listing;
    for (const Screen& screen : {Screen{1280, 800, 1, 1}, {640, 480, 1, 2}, {320, 240, 1, 1}}) {
        screen_ = screen;
        EXPECT_TRUE(visible("open scene"));
    }
    screen_ = {1280, 800, 1, 1};
    press(Key::o, {.ctrl = true});
    EXPECT_TRUE(has("browser.cancel"));
    EXPECT_FALSE(has("open scene"));
    press(Key::escape);
    EXPECT_FALSE(has("browser.cancel"));
    click(place("open scene"));
    EXPECT_TRUE(has("browser.cancel"));
    press(Key::escape);
    // Keys that need a scene do nothing.
    for (const Key which : {Key::p, Key::r, Key::a, Key::n, Key::space, Key::one}) press(which);
    press(Key::s, {.ctrl = true});
    EXPECT_FALSE(pressed_.save);
    EXPECT_TRUE(visible("open scene"));
}

TEST_F(Shell, F1ListsAllWithoutAScrollBarWhereverItFits) {
    press(Key::f1);
    for (const Screen& screen :
         {Screen{800, 600, 1, 1}, {1024, 768, 1, 1}, {1280, 800, 1, 1}, {1440, 900, 1, 1}, {1920, 1080, 1, 2}}) {
        screen_ = screen;
        const Rect at = place("keys");
        EXPECT_FALSE(has("keys.scrolls")) << screen.width << " by " << screen.scale;
        EXPECT_LE(at.x + at.width, screen.width);
        EXPECT_GE(at.x, 0);
    }
    screen_ = {320, 240, 1, 1};
    EXPECT_TRUE(visible("close keys"));
    press(Key::f1);
    EXPECT_FALSE(has("keys"));
}

}  // namespace
}  // namespace snell::ui
