// Mouse and keys on the panels, judged by what becomes of the values.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "parser/text/words.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/widgets.h"
#include "tests/ui/screen.h"

namespace snell::ui {

std::size_t UiTest::batch_of(std::span<const Event> events) { return batch(events); }

namespace {

TEST_F(UiTest, DraggingASliderMovesItsValueToWhereTheMouseIs) {
    add_slider("uEta", .1, 1.1, 5);
    const Rect bar = place("Glass.uEta");
    frame({move(bar.x + bar.width / 2, bar.y + bar.height / 2), button(true)});
    EXPECT_NEAR(controls_.items[0].value[0], 2.55, .02);
    frame({move(bar.x + bar.width * 2, bar.y + 300)});  // a drag goes on beyond the bar
    EXPECT_EQ(controls_.items[0].value[0], 5);
    frame({move(-100, 0)});
    EXPECT_EQ(controls_.items[0].value[0], .1);
    frame({button(false), move(bar.x + bar.width, bar.y)});
    EXPECT_EQ(controls_.items[0].value[0], .1) << "released: the mouse moves nothing";
}

TEST_F(UiTest, APressAndAReleaseBetweenTwoFramesAreSeenWhereTheyHappened) {
    add_slider("uEta", 0, 0, 1);
    const Rect bar = place("Glass.uEta");
    const double y = bar.y + bar.height / 2;
    frame({move(bar.x + bar.width / 2, y), button(true), move(bar.x + bar.width, y), button(false), move(5, 5)});
    EXPECT_EQ(controls_.items[0].value[0], 1);
}

TEST_F(UiTest, AnIntegerSliderStopsAtIntegers) {
    add_slider("uSteps", 1, 8, 32, ValueType::int_);
    const Rect bar = place("Glass.uSteps");
    for (double at = 0; at <= 1; at += .013) {
        click(bar, MouseButton::left, at);
        const double value = controls_.items[0].value[0];
        EXPECT_EQ(value, std::round(value));
        EXPECT_NEAR(value, 1 + 31 * at, 1.6);
    }
}

TEST_F(UiTest, RightClickGivesTheScenesValueBack) {
    add_slider("uEta", .1, 1.1, 5);
    const Rect bar = place("Glass.uEta");
    click(bar, MouseButton::left, .9);
    ASSERT_GT(controls_.items[0].value[0], 4);
    click(bar, MouseButton::right);
    EXPECT_EQ(controls_.items[0].value[0], 1.1);
}

TEST_F(UiTest, CtrlClickTypesAValueExactly) {
    add_slider("uEta", .1, 1.1, 5);
    click(place("Glass.uEta"), MouseButton::left, .9, {.ctrl = true});
    EXPECT_EQ(controls_.items[0].value[0], 1.1) << "not moved by the click";
    type("1.3333333333333333");
    EXPECT_EQ(controls_.items[0].value[0], 1.3333333333333333);
}

TEST_F(UiTest, DoubleClickTypesToo) {
    add_slider("uEta", .1, 1.1, 5);
    const Rect bar = place("Glass.uEta");
    frame({move(bar.x + bar.width * .9, bar.y + bar.height / 2)});
    frame({button(true)});
    frame({button(false)});
    frame({button(true)});
    EXPECT_EQ(controls_.items[0].value[0], 1.1) << "what the first click moved is back";
    frame({button(false)});
    type("-2");
    EXPECT_EQ(controls_.items[0].value[0], -2);
    EXPECT_EQ(controls_.items[0].min, -2) << "the range has room for what was typed";
}

TEST_F(UiTest, NonsenseTypedChangesNothing) {
    add_slider("uEta", .1, 1.1, 5);
    for (const char* text : {"abc", "nan", "inf", "1e39", "--1", "1,5"}) {
        click(place("Glass.uEta"), MouseButton::left, .5, {.ctrl = true});
        type(text);
        EXPECT_TRUE(std::isfinite(controls_.items[0].value[0])) << text;
        EXPECT_LE(std::abs(controls_.items[0].value[0]), 5) << text;
        click(place("Glass.uEta"), MouseButton::right);
        EXPECT_EQ(controls_.items[0].value[0], 1.1) << text;
    }
}

TEST_F(UiTest, NoRangeAbortsTheProgram) {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
    const double most = std::numeric_limits<double>::max();
    const std::vector<std::array<double, 3>> ranges{
        {0, .5, infinity}, {-infinity, 0, infinity}, {-3e38, 0, 3e38}, {-most, 0, most},   {1, 1, 1},
        {5, 1, .1},        {nan, nan, nan},          {0, nan, 1},      {0, 1e-320, 1e-310}};
    for (std::size_t i = 0; i < ranges.size(); ++i)
        add_slider("u" + std::to_string(i), ranges[i][0], ranges[i][1], ranges[i][2],
                   i % 2 == 0 ? ValueType::float_ : ValueType::double_);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const Rect bar = place("Glass.u" + std::to_string(i));
        for (double at : {.1, .5, .9}) click(bar, MouseButton::left, at);
        const bool sound = std::isfinite(ranges[i][0]) && std::isfinite(ranges[i][2]) && ranges[i][0] < ranges[i][2];
        if (sound) {
            EXPECT_TRUE(std::isfinite(controls_.items[i].value[0])) << i;
            EXPECT_NEAR(controls_.items[i].value[0] / ranges[i][2], ranges[i][0] < 0 ? .8 : .9, .06) << i;
        }
    }
}

TEST_F(UiTest, CheckBoxesAndColors) {
    Control& box = add_slider("uOn", 0, 0, 1, ValueType::bool_);
    box.widget = Widget::check_box;
    Control& color = add_slider("uColor", 0, 0, 1);
    color.widget = Widget::color;
    color.components = 3;
    color.value = color.initial = {.123456789012, .5, 2};  // above 1 is allowed
    click(place("Glass.uOn"));
    EXPECT_EQ(controls_.items[0].value[0], 1);
    click(place("Glass.uOn"));
    EXPECT_EQ(controls_.items[0].value[0], 0);
    EXPECT_EQ(controls_.items[1].value, controls_.items[1].initial) << "shown and not rounded";
    const Rect row = place("Glass.uColor");
    frame({move(row.x + row.width * .45, row.y + row.height / 2), button(true)});  // drag the green field
    frame({move(row.x + row.width * .45 + 30, row.y + row.height / 2)});
    frame({move(row.x + row.width * .45 + 31, row.y + row.height / 2)});
    frame({button(false)});
    EXPECT_NEAR(controls_.items[1].value[1], .62, .02) << "from its own value, whatever is beside it";
    EXPECT_EQ(controls_.items[1].value[0], .123456789012) << "the others keep their bits";
    EXPECT_EQ(controls_.items[1].value[2], 2);
}

TEST_F(UiTest, AnInactiveUniformCanNotBeMoved) {
    add_slider("uDead", 0, .5, 1).active = false;
    click(place("Glass.uDead"), MouseButton::left, .9);
    EXPECT_EQ(controls_.items[0].value[0], .5);
}

TEST_F(UiTest, AnUnsignedSliderTakesNoNegativeNumber) {
    add_slider("uCount", 0, 3, 10, ValueType::uint_);
    click(place("Glass.uCount"), MouseButton::left, .5, {.ctrl = true});
    type("-4");
    EXPECT_EQ(controls_.items[0].value[0], 3);
    frame({key(Key::escape, true)});
    frame({key(Key::escape, false)});
    click(place("Glass.uCount"), MouseButton::left, .5, {.ctrl = true});
    type("3000000000");
    EXPECT_EQ(controls_.items[0].value[0], 3e9);
}

TEST_F(UiTest, ConstantsAreBehindAFoldUnlistedUniformsBelowARule) {
    add_slider("uEta", 0, .5, 1);
    Control& constant = add_slider("uLight", 0, 0, 1);
    constant.widget = Widget::none;
    constant.components = 3;
    constant.value = constant.initial = {5, 10, 0};
    add_slider("uExtra", 0, .5, 1).listed = false;
    EXPECT_FALSE(has("Glass.uLight[0]"));
    EXPECT_GT(place("Glass.uExtra").y, place("Glass.uEta").y);
    click(place("Glass.constants"));
    const Rect x = place("Glass.uLight[0]");
    click(x, MouseButton::left, .5, {.ctrl = true});
    type("7");
    EXPECT_EQ(controls_.items[1].value, (std::vector<double>{7, 10, 0}));
    click(x, MouseButton::right);
    EXPECT_EQ(controls_.items[1].value, controls_.items[1].initial);
}

TEST_F(UiTest, AllProgramsAreOpenAtFirstWhereTheyFitOtherwiseTheFirst) {
    add_slider("uEta", 0, .5, 1);
    add_program("Walls");
    for (int i = 0; i < 10; ++i) add_slider("uKa" + std::to_string(i), 0, .5, 1);
    Draw draw;
    draw.program = 1;
    scene_.draws = {draw};
    for (const float height : {800.F, 420.F}) {
        screen_.height = height;
        FileRow file;
        file.path = height > 600 ? "/high.glib" : "/low.glib";
        facts_.files = {&file, 1};
        EXPECT_TRUE(has("Glass.uEta")) << height;
        EXPECT_EQ(has("Walls.uKa0"), height > 600) << height;
        // An object that is picked unfolds its program, once.
        hold_object(memory_.hold, 0);
        EXPECT_TRUE(has("Walls.uKa0")) << height;
        click(place("Walls"));
        EXPECT_FALSE(has("Walls.uKa0")) << height;
        hold_object(memory_.hold, none);
        EXPECT_FALSE(has("Walls.uKa0")) << height;
    }
    click(place("Glass"));
    EXPECT_FALSE(has("Glass.uEta"));
}

// Room is left for "Reset all" only where it is.
TEST_F(UiTest, ATitleIsWholeInTheSmallestWindow) {
    scene_.programs[0].name = "Toon";
    Control& slider = add_slider("uEta", 0, .5, 1);
    screen_ = {420, 320, 1, fitting_scale(3, 420)};
    for (const double value : {.5, .7}) {
        slider.value = {value};
        const Rect at = place("Toon");
        frame({move(at.x + 1.5 * at.height, at.y + at.height / 2)});
        frame({}, 1);
        frame({}, 1);
        EXPECT_FALSE(kit().tip.shown) << kit().tip.text << ": no tooltip needs to say it, at " << value;
    }
}

TEST_F(UiTest, SectionsAreRememberedByTheirSceneAndName) {
    FileRow file;
    file.path = "/first.glib";
    facts_.files = {&file, 1};
    add_slider("uEta", 0, .5, 1);
    EXPECT_TRUE(has("Glass.uEta"));
    click(place("Glass"));
    EXPECT_FALSE(has("Glass.uEta"));
    EXPECT_EQ(memory_.folds, (Folds{{"Glass", false}}));
    FileRow other;
    other.path = "/second.glib";
    facts_.files = {&other, 1};
    const auto folds = std::exchange(memory_.folds, {});  // each scene has its own
    EXPECT_TRUE(has("Glass.uEta")) << "another scene";
    EXPECT_TRUE(memory_.folds.empty()) << "nobody folded it";
    memory_.folds = folds;
    facts_.files = {&file, 1};
    EXPECT_FALSE(has("Glass.uEta"));
    scene_.programs.insert(scene_.programs.begin(), scene_.programs[0]);
    scene_.programs[0].name = "Walls";
    linked_.push_back(1);
    controls_.items[0].program = 1;
    EXPECT_FALSE(has("Glass.uEta")) << "also behind a new program";
}

// While the text is read again, with the programs in another order.
TEST_F(UiTest, AControlInUseFollowsItsProgram) {
    add_slider("uEta", 0, .1, 1);
    add_program("Glass");
    add_slider("uEta", 0, .2, 1);
    memory_.numbers.carry({}, 2);
    const auto reread = [&](const std::vector<Index>& carried, std::size_t count) {
        scene_.programs.resize(count, scene_.programs[0]);
        linked_.assign(count, 1);
        std::erase_if(controls_.items, [&](const Control& control) { return carried[control.program] == none; });
        for (Control& control : controls_.items) control.program = carried[control.program];
        memory_.numbers.carry(carried, count);
    };
    const Rect top = place("Glass.uEta");
    click(top, MouseButton::left, .5, {.ctrl = true});
    reread({1, 0}, 2);
    type(".75");
    EXPECT_EQ(controls_.items[0].value[0], .75);
    EXPECT_EQ(controls_.items[1].value[0], .2) << "it is where the other was";

    frame({key(Key::right, true)});
    frame({key(Key::right, false)});
    EXPECT_NEAR(controls_.items[0].value[0], .76, 1e-9) << "the keyboard's focus is there, too";
    frame({move(top.x + top.width / 2, top.y + top.height / 2), button(true)});
    reread({2, 1}, 3);
    frame({move(top.x + 2 * top.width, top.y)});
    frame({button(false)});
    EXPECT_EQ(controls_.items[1].value[0], 1);
    EXPECT_NEAR(controls_.items[0].value[0], .76, 1e-9);

    click(place("Glass.uEta"), MouseButton::left, .5, {.ctrl = true});
    reread({none, none, 0}, 1);
    type(".25");
    ASSERT_EQ(controls_.items.size(), 1U);
    EXPECT_EQ(controls_.items[0].value[0], 1) << "that was for a program that is gone";
}

TEST_F(UiTest, TheMenuOfAProgramThatIsGoneIsClosed) {
    add_slider("uEta", 0, .1, 1);
    add_program("Glass");
    add_slider("uEta", 0, .2, 1);
    memory_.numbers.carry({}, 2);
    click(place("uEta.name"), MouseButton::right);
    ASSERT_TRUE(has("uEta.animate"));
    scene_.programs.pop_back();
    linked_.pop_back();
    controls_.items.erase(controls_.items.begin());
    controls_.items[0].program = 0;
    memory_.numbers.carry({none, 0}, 1);
    EXPECT_FALSE(has("uEta.animate"));
    for (const Key pressed : {Key::tab, Key::right}) {
        frame({key(pressed, true)});
        frame({key(pressed, false)});
    }
    EXPECT_GT(controls_.items[0].value[0], .2) << "keys are not the menu's";
}

// Frames that take a second: events are seen when the next one begins.
TEST_F(UiTest, ClicksAreCountedByTheirTimesNotByFrames) {
    struct Press {
        double since, seen;
    };
    struct Row {
        const char* what;
        Press first, second;
        bool twice;
    };
    add_slider("uEta", .1, 1.1, 5);
    const Rect bar = place("Glass.uEta");
    double& value = controls_.items[0].value[0];
    for (const Row& row : {Row{"the second one came during the frame of the first", {10, 10}, {10.01, 11}, true},
                           Row{"both came during one frame", {22, 23}, {22, 23}, true},
                           Row{"during one of a second and a half", {24, 25.5}, {24, 25.5}, false},
                           Row{"one in each of two frames of half a second", {27, 27.5}, {27.5, 28}, true},
                           Row{"the second one was seen at once", {30, 30}, {30.2, 30.21}, true},
                           Row{"one in each of two frames of a second", {32, 33}, {33, 34}, false},
                           Row{"for half a second there was none", {40, 40}, {40.5, 41.5}, false},
                           Row{"they are far apart", {50, 50}, {54, 54}, false},
                           Row{"during the first picture, which took half a minute", {60, 90}, {60, 90}, false},
                           Row{"during the frame of the first", {100, 100}, {100.001, 100.9}, true},
                           Row{"during a longer one", {110, 110}, {110.001, 112.5}, false}}) {
        SCOPED_TRACE(row.what);
        value = 1.1;
        const auto press = [&](const Press& at) {
            Event event = button(true);
            event.since = at.since;
            event.seen = at.seen;
            return event;
        };
        frame({move(bar.x + bar.width * .9, bar.y + bar.height / 2)}, 1);
        frame({press(row.first)}, 1);
        frame({button(false), press(row.second)}, 1);
        EXPECT_EQ(value == 1.1, row.twice) << "what the first click did is undone by a second one";
        EXPECT_EQ(kit().typing.id != 0, row.twice);
        frame({button(false)}, 1);
        frame({key(Key::escape, true), key(Key::escape, false)}, 1);
        EXPECT_EQ(value == 1.1, row.twice) << "nothing that the first click did remains";
        frame({}, 1);
    }
}

// All that came while one picture was drawn: the field that the second click opens has what was typed after it.
TEST_F(UiTest, DigitsAfterADoubleClickGoToTheFieldThatItOpens) {
    add_slider("uEta", .1, 1.1, 5);
    facts_.snapshots[2] = true;
    const Rect bar = place("Glass.uEta");
    frame({move(bar.x + bar.width * .9, bar.y + bar.height / 2)}, 1);
    frame({button(true)}, .02);
    std::vector<Event> rest{button(false),
                            button(true),
                            button(false),
                            key(static_cast<Key>(static_cast<int>(Key::one) + 1), true),
                            {.kind = Event::Kind::text, .text = '2'}};
    for (Event& event : rest) {
        event.since = clock_ + .001;
        event.seen = clock_ + .9;
    }
    frame(rest, .9);
    EXPECT_EQ(requests_.restore_snapshot, 0);
    frame({key(Key::enter, true)});
    EXPECT_EQ(controls_.items[0].value[0], 2);
}

TEST_F(UiTest, ProgramsOfOneNameAreToldApartByTheirFilesAndNumbers) {
    add_slider("uEta", .1, 1.1, 5);
    EXPECT_TRUE(has("title.Glass"));
    const auto stages = [&](std::size_t program, const std::string& fragment) {
        scene_.programs[program].stages[0] = FileName{"glass.vert", {}};
        scene_.programs[program].stages[4] = FileName{fragment, {}};
    };
    stages(0, "red.frag");
    EXPECT_TRUE(has("title.Glass")) << "no other has the name";
    for (const char* fragment : {"green.frag", "green.frag"}) {
        add_program("Glass");
        stages(scene_.programs.size() - 1, fragment);
    }
    for (const char* title : {"Glass, red.frag", "Glass#2, green.frag", "Glass#3, green.frag"})
        EXPECT_TRUE(has(std::string("title.") + title)) << title;
    // The first section is closed, and stays so where another program comes before it.
    memory_.numbers.carry({}, 3);
    click(place("title.Glass, red.frag"));
    EXPECT_FALSE(has("Glass.uEta"));
    memory_.numbers.carry({1, 2, 3}, 4);
    memory_.folds = {{"Glass#2", false}};
    scene_.programs.insert(scene_.programs.begin(), scene_.programs[1]);
    linked_.push_back(1);
    controls_.items[0].program = 1;
    EXPECT_TRUE(has("title.Glass#2, red.frag"));
    EXPECT_FALSE(has("Glass.uEta"));
}

TEST_F(UiTest, AProgramWithoutSlidersIsAFoldedLine) {
    add_program("Water");
    add_slider("uEta", 0, .5, 1);
    add_program("Air");
    add_slider("uKa", 0, .5, 1);
    EXPECT_TRUE(has("Water.uEta"));
    EXPECT_TRUE(has("Air.uKa"));
    click(place("Glass"));
    const double opened = place("Water").y;
    click(place("Glass"));
    EXPECT_LT(place("Water").y, opened) << "it was folded";
    // Also where no program has a slider.
    for (Control& control : controls_.items) control.widget = Widget::none;
    FileRow other;
    other.path = "/other.glib";
    facts_.files = {&other, 1};
    const double folded = place("Water").y;
    click(place("Glass"));
    EXPECT_GT(place("Water").y, folded);
}

TEST_F(UiTest, TheMouseTurnsScalesAndMovesTheScene) {
    const double x = 300, y = 300;
    frame();
    frame({move(x, y), button(true), move(x + 40, y + 20), button(false)});
    EXPECT_GT(view_.scene.rotate_y, 0) << "to the right: what is in front goes right";
    EXPECT_GT(view_.scene.rotate_x, 0) << "down: what is in front goes down";
    EXPECT_EQ(view_.scene.scale, 1);
    frame({wheel(1)});
    EXPECT_GT(view_.scene.scale, 1);
    frame({wheel(-1)});
    EXPECT_NEAR(view_.scene.scale, 1, 1e-12);
    frame({move(x, y), button(true, MouseButton::middle), move(x, y - 30), button(false, MouseButton::middle)});
    EXPECT_GT(view_.scene.scale, 1);
    frame({move(x, y), button(true, MouseButton::right), move(x + 10, y), button(false, MouseButton::right)});
    const double moved = view_.scene.x;
    EXPECT_GT(moved, 0);
    frame({move(x, y), button(true, MouseButton::left, {.shift = true}), move(x, y - 10), button(false)});
    EXPECT_NEAR(view_.scene.y, moved, 1e-9) << "the same length up as to the right";
    frame({key(Key::r, true)});
    EXPECT_EQ(view_.scene, Transformation{});
}

TEST_F(UiTest, ADragThatBeganInThePanelLeavesTheSceneAlone) {
    add_slider("uEta", 0, .5, 1);
    const Rect bar = place("Glass.uEta");
    frame({move(bar.x + bar.width / 2, bar.y + bar.height / 2), button(true), move(200, 300), move(100, 100)});
    frame({button(false)});
    EXPECT_EQ(view_.scene, Transformation{});
}

TEST_F(UiTest, KeysTypedIntoAFieldAreNoCommands) {
    add_slider("uEta", 0, .5, 1);
    view_.scene.rotate_x = 30;
    click(place("Glass.uEta"), MouseButton::left, .5, {.ctrl = true});
    frame({key(Key::r, true), key(Key::r, false), key(Key::h, true), key(Key::h, false)});
    EXPECT_EQ(view_.scene.rotate_x, 30);
    EXPECT_TRUE(memory_.panel);
}

TEST_F(UiTest, ThePanelDoesNotHideTheScene) {
    add_slider("uEta", 0, .5, 1);
    for (const auto& [width, height] : {std::pair(1280.F, 800.F), {1920.F, 1080.F}, {640.F, 480.F}, {320.F, 200.F}}) {
        screen_.width = width;
        screen_.height = height;
        const Rect bar = place("Glass.uEta");
        EXPECT_GE(bar.x, memory_.scene.x + memory_.scene.width);
        EXPECT_LE(bar.x + bar.width, width);
        EXPECT_GE(memory_.scene.width, .3 * width);
    }
    frame({key(Key::h, true)});
    EXPECT_EQ(memory_.scene.width, screen_.width);
}

TEST_F(UiTest, ErrorsAreOverThePictureWarningsWhenAsked) {
    const std::vector<Problem> problems{
        {{.file = "a.glib", .at = Position{1, 1}, .message = "no", .source = MarkedLine{"x"}}, {}},
        {{.severity = Severity::warning, .file = "a.glib", .at = Position{2, 1}, .message = "hm"}, {}}};
    facts_.problems = problems;
    facts_.revision = 1;
    EXPECT_TRUE(has("problems.hide"));
    click(place("problems.hide"));
    EXPECT_FALSE(has("problems.hide"));
    facts_.revision = 2;  // read again, still wrong
    EXPECT_TRUE(has("problems.hide"));
    facts_.problems = std::span(problems).subspan(1);
    EXPECT_FALSE(has("problems.hide")) << "warnings wait";
    click(place("problems"));
    EXPECT_TRUE(has("problems.hide"));
}

TEST_F(UiTest, AMessageStaysUntilItIsDismissed) {
    scene_.messages.push_back({"Move uEta slowly.", {}});
    click(place("message.ok"));
    EXPECT_FALSE(has("message.ok"));
}

TEST_F(UiTest, AFailureStaysUntilItIsDismissedAndLeavesTheMessages) {
    scene_.messages.push_back({"Move uEta slowly.", {}});
    memory_.failures.open = {{"a.html is not saved: a.glib:3:1: error: browsers have no geometry shaders"}};
    EXPECT_TRUE(has("failure.ok"));
    click(place("message.ok"));
    EXPECT_FALSE(has("message.ok"));
    EXPECT_TRUE(has("failure.ok"));
    click(place("failure.ok"));
    EXPECT_FALSE(has("failure.ok"));
    EXPECT_TRUE(memory_.failures.open.empty());
}

TEST_F(UiTest, ARemarkGoesWithTheNextActionAndEscapeClosesTheNewest) {
    using Remedy = Failure::Remedy;
    std::vector<Failure>& open = memory_.failures.open;
    const auto press = [&](Key which) {
        frame({key(which, true)});
        frame({key(which, false)});
    };
    for (const bool hidden : {false, true}) {
        memory_.panel = !hidden;
        facts_.full_screen = true;
        open = {{"a.html is not saved"}, {"there is no snapshot 1", Remedy::absent, {}, 1}};
        press(Key::tab);
        EXPECT_EQ(open.size(), 2U) << "on the way to its buttons";
        press(Key::h);
        ASSERT_EQ(open.size(), 1U);
        EXPECT_EQ(open[0].remedy, Remedy::none) << "a failure is no remark";
        press(Key::escape);
        EXPECT_TRUE(open.empty());
        EXPECT_FALSE(requests_.full_screen);
    }
    memory_.panel = true;
    open = {{"there is no snapshot 1", Remedy::absent, {}, 1}};
    const Rect at = place("failure.store");
    frame({move(at.x + at.width / 2, at.y + at.height / 2)}, 1);
    frame({button(true)});
    ASSERT_EQ(open.size(), 1U) << "a press on it answers it";
    frame({button(false)});
    EXPECT_EQ(requests_.store_snapshot, 1);
    open = {{"there is no snapshot 1", Remedy::absent, {}, 1}};
    place("failure.store");
    click({300, 200, 1, 1});
    EXPECT_TRUE(open.empty());
}

// And what went well is not.
TEST_F(UiTest, FailuresAreRedInEveryTheme) {
    // Of what is drawn within the box.
    const auto has_color = [](const Rect& box, const ImVec4& color) {
        const ImU32 wanted = ImGui::GetColorU32(color);
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            for (const ImDrawVert& v : data.CmdLists[i]->VtxBuffer)
                if (v.col == wanted && box.contains(v.pos.x, v.pos.y)) return true;
        return false;
    };
    for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
        screen_.theme = theme;
        memory_.failures.open = {{"not saved: no space left"}};
        memory_.notice = "saved as room.glib";
        const Rect ok = place("failure.ok"), box{memory_.scene.x, ok.y, ok.x - memory_.scene.x, ok.height};
        const ImVec4& red = palette().error_text;
        EXPECT_TRUE(has_color(box, red));
        EXPECT_GT(red.x, 1.4F * std::max(red.y, red.z));
        EXPECT_TRUE(has("notice"));
        EXPECT_FALSE(has_color(place("notice"), red));
    }
}

TEST_F(UiTest, FailuresOfferWhatHelpsAndGoWithTheirCause) {
    using Remedy = Failure::Remedy;
    struct Row {
        Remedy remedy;
        const char* button;
        bool Requests::*wants;
    };
    for (const Row& row :
         {Row{Remedy::reload, "failure.reload", &Requests::reload},
          Row{Remedy::reload, "failure.save as", &Requests::save_as},
          Row{Remedy::save, "failure.again", &Requests::save}, Row{Remedy::save, "failure.save as", &Requests::save_as},
          Row{Remedy::save_as, "failure.save as", &Requests::save_as},
          Row{Remedy::editor, "failure.editor", &Requests::set_editor}}) {
        facts_.changed = true;
        memory_.failures.open = {{"not saved: room.glib", row.remedy}};
        const Rect at = place(row.button);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        frame({button(true)});
        frame({button(false)});
        EXPECT_TRUE(requests_.*row.wants) << row.button;
        EXPECT_FALSE(has("failure.ok")) << row.button << " is an answer";
    }
    memory_.failures.open = {{"not saved: Glass.uHidden: it is not on the Program line", Remedy::add}};
    for (const char* useless : {"failure.again", "failure.save as"}) EXPECT_FALSE(has(useless)) << useless;
    EXPECT_TRUE(has("failure.ok"));
    facts_.changed = false;
    EXPECT_FALSE(has("failure.ok")) << "nothing is left to save";
    facts_.changed = true;
    memory_.failures.open = {{"xdg-open ended with status 4", Remedy::editor, {"/tmp/a.frag", 3, 1}}};
    const Rect again = place("failure.again");
    frame({move(again.x + 3, again.y + 3)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_EQ(requests_.edit.file, "/tmp/a.frag");
    const Listing listing{.folder = "/tmp"};
    facts_.listing = &listing;
    memory_.failures.open = {{"cannot read '/tmp/b.glib'", Remedy::open, {"/tmp/b.glib", 1, 1}}};
    click(place("failure.open"));
    EXPECT_TRUE(memory_.browser.open);
    EXPECT_STREQ(memory_.browser.typed.data(), "/tmp/b.glib") << "to be mended, not typed again";
    memory_.browser.open = false;
    EXPECT_FALSE(has("failure.ok"));
    // What is mended otherwise.
    memory_.failures.open = {{"not saved: room.glib has changed since it was read: reload it", Remedy::reload}};
    ++facts_.revision;
    EXPECT_TRUE(has("failure.again")) << "it was read, and nothing is saved yet";
    EXPECT_EQ(memory_.failures.open[0].text, "not saved: room.glib is read again now: try again");
    memory_.failures.open = {{"not saved: room.glib has changed", Remedy::reload}};
    EXPECT_TRUE(has("failure.ok"));
    facts_.changed = false;
    EXPECT_TRUE(has("failure.ok")) << "the files are still others";
    ++facts_.revision;
    EXPECT_FALSE(has("failure.ok")) << "they were read";
    facts_.changed = true;
    memory_.failures.open = {{"not saved: room.glib is gone", Remedy::save_as}};
    facts_.changed = false;
    EXPECT_TRUE(has("failure.ok")) << "it is gone, whatever the values are";
    facts_.stale = true;
    ++facts_.revision;
    EXPECT_TRUE(has("failure.ok")) << "reading it again did not find it";
    facts_.stale = false;
    ++facts_.revision;
    EXPECT_FALSE(has("failure.ok")) << "it is there again";
    facts_.changed = true;
    memory_.failures.open = {{"not saved: no space left", Remedy::save}};
    frame({key(Key::r, true)});
    frame({key(Key::r, false)});
    EXPECT_TRUE(has("failure.ok")) << "the next action leaves it";
    memory_.panel = false;
    EXPECT_TRUE(has("failure.ok")) << "also where all is hidden";
    memory_.panel = true;
    facts_.changed = false;
    EXPECT_FALSE(has("failure.ok")) << "nothing is left to save";
    no_scene_ = true;
    memory_.failures.open = {{"no .glib scene: a.png"}};
    EXPECT_TRUE(has("failure.ok")) << "also in an empty window";
}

TEST_F(UiTest, EveryFailureStaysUntilItIsAnswered) {
    using Remedy = Failure::Remedy;
    facts_.changed = true;
    Failures& failures = memory_.failures;
    failures.add({"snapshot 3 is not stored: no space left", Remedy::store, {}, 3, {{"--set Glass.uEta", ".62"}}});
    failures.add({"snapshot 4 cannot be read", Remedy::recall, {}, 4});
    failures.add({"not saved: no space left", Remedy::save});
    EXPECT_LT(place("failure 3.ok").y, place("failure 2.ok").y);
    EXPECT_LT(place("failure 2.ok").y, place("failure.ok").y) << "the latest is below the others";
    const auto pressed = [&](const char* name) {
        const Rect at = place(name);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        frame({button(true)});
        frame({button(false)});
        return requests_;
    };
    const Requests again = pressed("failure 3.again");
    EXPECT_EQ(again.store_snapshot, 3);
    EXPECT_EQ(again.values, (snell::Setup{{"--set Glass.uEta", ".62"}}))
        << "what was not stored, not the values of now";
    EXPECT_EQ(pressed("failure 2.again").restore_snapshot, 4);
    EXPECT_FALSE(has("failure 2.ok")) << "these are answered";
    EXPECT_TRUE(has("failure.again")) << "that one is not";
    failures.add({"not saved: room.glib has changed", Remedy::reload});
    EXPECT_FALSE(has("failure 2.ok")) << "the same values, tried again";
    EXPECT_TRUE(has("failure.reload"));
    failures.add({"false ended with status 1", Remedy::editor, {"/a.frag", 1, 1}});
    failures.add({"cannot read b.glib", Remedy::open, {"/b.glib", 1, 1}});
    failures.add({"b.html is not saved: a.glib:3:1: error", Remedy::page});
    failures.add({"a.html is not saved: a.glib:3:1: error", Remedy::page});
    EXPECT_TRUE(has("failure 3.ok"));
    EXPECT_FALSE(has("failure 4.ok")) << "it is only counted";
    click(place("failure.ok"));
    EXPECT_TRUE(has("failure 3.reload")) << "until there is room for it";
    failures.add({"a.html is not saved: a.glib:3:1: error", Remedy::page});
    failures.enter("/b.glib");
    ASSERT_EQ(failures.open.size(), 2U) << "another scene was opened";
    EXPECT_EQ(failures.open[0].remedy, Remedy::editor);
    failures.add({"saved twice", Remedy::page});
    ASSERT_EQ(failures.open.size(), 2U) << "one page at most is not saved";
    failures.done(Remedy::page);
    ASSERT_EQ(failures.open.size(), 1U);
    failures.add({"a.html is not saved: a.glib:3:1: error", Remedy::page});
    failures.done(Remedy::editor);
    ASSERT_EQ(failures.open.size(), 1U);
    // What would say the same is said once.
    for (int i = 5; i < 8; ++i) {
        failures.add({"there is no snapshot " + std::to_string(i), Remedy::absent, {}, i});
        failures.add({"false ended with status 1", Remedy::editor, {"/a.frag", i, 1}});
    }
    ASSERT_EQ(failures.open.size(), 3U);
    EXPECT_EQ(pressed("failure.again").edit.line, 7);
    EXPECT_EQ(pressed("failure.store").store_snapshot, 7);
    EXPECT_EQ(failures.open.size(), 1U);
}

TEST_F(UiTest, FailuresOfASceneComeBackWithIt) {
    using Remedy = Failure::Remedy;
    Failures& failures = memory_.failures;
    failures.scene = "/a.glib";
    facts_.changed = true;
    failures.add({"snapshot 3 is not stored: no space left", Remedy::store, {}, 3, {{"--set Glass.uEta", ".62"}}});
    failures.add({"not saved: no space left", Remedy::save});
    failures.add({"false ended with status 1", Remedy::editor});
    failures.add({"cannot read c.glib", Remedy::open, {"/c.glib", 1, 1}});
    const auto texts = [&] {
        std::string all;
        for (const Failure& failure : failures.open) all += failure.text.substr(0, failure.text.find(' ')) + ' ';
        return all;
    };
    const auto enter = [&](const char* scene, bool changed) {
        failures.enter(scene);
        ++facts_.revision;  // it is read
        facts_.changed = changed;
        frame();
        return texts();
    };
    EXPECT_EQ(enter("/b.glib", false), "false ") << "the others are of the first";
    failures.add({"there is no snapshot 5", Remedy::absent, {}, 5});
    EXPECT_EQ(enter("/a.glib", true), "snapshot not false ") << "not one of the second";
    EXPECT_EQ(failures.open[0].values.size(), 1U);
    EXPECT_EQ(enter("/a.glib", true), "snapshot not false ") << "opened again";
    EXPECT_EQ(enter("/b.glib", false), "there false ");
    EXPECT_EQ(enter("/a.glib", false), "snapshot false ") << "nothing is left to save";
    failures.open.clear();
    enter("/b.glib", false);
    EXPECT_EQ(enter("/a.glib", false), "") << "what was answered stays so";
}

TEST_F(UiTest, WhatIsNoLongerTrueIsNotSaidAndNothingIsSaidTwice) {
    using Remedy = Failure::Remedy;
    Failures& failures = memory_.failures;
    failures.add({"not undone: a.glib was changed meanwhile: it is left as it is"});
    failures.add({"not undone: a.snapshots.json was changed meanwhile: it is left as it is"});
    failures.exchanged("undo: Glass.uEta 1.5");
    failures.exchanged("undo: save to b.frag");
    failures.exchanged("nothing to undo");
    EXPECT_EQ(failures.open.size(), 2U) << "of other steps";
    failures.exchanged("undo: save to b.frag a.glib");
    ASSERT_EQ(failures.open.size(), 1U);
    EXPECT_EQ(failures.open[0].text.find("not undone: a.snap"), 0U);
    failures.exchanged("redo: snapshot 3");
    EXPECT_TRUE(failures.open.empty());
    // A path is shortened after it is said, by which time another may be.
    for (int i = 0; i < 3; ++i) {
        failures.add({"not undone: /scenes/a.glib is gone", i < 2 ? Remedy::none : Remedy::save_as});
        failures.rewrite([](const std::string& text) {
            const std::size_t at = text.find("/scenes/");
            return at == text.npos ? text : text.substr(0, at) + text.substr(at + 8);
        });
        ASSERT_EQ(failures.open.size(), 1U) << i;
    }
    EXPECT_EQ(failures.open[0].text, "not undone: a.glib is gone");
    EXPECT_EQ(failures.open[0].remedy, Remedy::save_as) << "the latest";
    failures.open = {{"there is no snapshot 5", Remedy::absent, {}, 5}};
    EXPECT_TRUE(has("failure.ok"));
    facts_.snapshots[5] = true;
    EXPECT_FALSE(has("failure.ok")) << "another window has stored it";
}

// The notice above slides under the mouse, and must be read before it is answered.
TEST_F(UiTest, ADoubleClickAnswersOneNotice) {
    using Remedy = Failure::Remedy;
    facts_.changed = true;
    // A picture takes that long: the second press was made while it was drawn, or the mouse waited.
    for (const double picture : {.02, .1, 2.5})
        for (const char* name : {"failure.ok", "failure.again"}) {
            memory_.failures.open = {{"not saved: no space left", Remedy::save},
                                     {"snapshot 4 cannot be read", Remedy::recall, {}, 4},
                                     {"snapshot 3 is not stored: no space left", Remedy::store, {}, 3}};
            const Rect at = place(name);
            frame({move(1, 1)});
            frame({move(at.x + at.width / 2, at.y + at.height / 2)}, 1);
            const auto press = [&](bool down, double seconds) {
                Event event = button(down);
                event.since = clock_;
                event.seen = clock_ + seconds;
                frame({event}, seconds);
                return requests_.restore_snapshot > 0 || requests_.save;
            };
            press(true, .02);
            press(false, .02);
            ASSERT_EQ(memory_.failures.open.size(), 2U) << name;
            for (int more = 0; more < 2; ++more) {
                press(true, picture);
                EXPECT_FALSE(press(false, .02)) << name << ' ' << picture;
                EXPECT_EQ(memory_.failures.open.size(), 2U) << name << ' ' << picture;
                if (picture > 1) break;
            }
            frame({}, 1);
            press(true, .02);
            press(false, .02);
            EXPECT_EQ(memory_.failures.open.size(), 1U) << "once it was there for a while";
        }
}

TEST_F(UiTest, EnterTwiceAnswersOneNotice) {
    using Remedy = Failure::Remedy;
    for (const double picture : {.02, .1, 2.5})
        for (const Key which : {Key::enter, Key::space})
            for (const char* name : {"failure.ok", "failure.again"}) {
                SCOPED_TRACE(picture);
                facts_.changed = true;
                memory_.failures.open = {{"not saved: no space left", Remedy::save},
                                         {"snapshot 4 cannot be read", Remedy::recall, {}, 4},
                                         {"snapshot 3 is not stored: no space left", Remedy::store, {}, 3}};
                const Rect at = place(name);
                kit().focus.at = 0;
                for (int i = 0; i < 99 && kit().focus.box != at; ++i)
                    frame({key(Key::tab, true), key(Key::tab, false)});
                ASSERT_EQ(kit().focus.box, at) << name;
                frame({}, 1);
                const auto press = [&](double seconds) {
                    Event down = key(which, true);
                    down.since = clock_;
                    down.seen = clock_ + seconds;
                    frame({down}, seconds);
                    const bool asked = requests_.restore_snapshot > 0 || requests_.save;
                    frame({key(which, false)});
                    return asked;
                };
                press(.02);
                ASSERT_EQ(memory_.failures.open.size(), 2U) << name;
                EXPECT_FALSE(press(picture)) << name;
                EXPECT_EQ(memory_.failures.open.size(), 2U) << name;
                frame({}, 1);
                press(.02);
                EXPECT_EQ(memory_.failures.open.size(), 1U) << "once it was there for a while";
            }
}

TEST_F(UiTest, EscapeDuringADragRestoresWhatWasBefore) {
    add_slider("uEta", .1, 1.1, 5);
    Control& field = add_slider("uField", 0, 3, 10);
    field.widget = Widget::none;
    const Rect track = place("Glass.uEta");
    click(place("Glass.constants"));
    struct Row {
        const char* what;
        Rect at;
        MouseButton button;
        std::function<double()> value;
    };
    const std::vector<Row> rows{
        {"slider", track, MouseButton::left, [&] { return controls_.items[0].value[0]; }},
        {"field", place("Glass.uField"), MouseButton::left, [&] { return controls_.items[1].value[0]; }},
        {"turn", {300, 300, 60, 60}, MouseButton::left, [&] { return view_.scene.rotate_y; }},
        {"move", {300, 300, 60, 60}, MouseButton::right, [&] { return view_.scene.x; }},
        {"scale", {300, 300, 60, 60}, MouseButton::middle, [&] { return view_.scene.scale; }},
    };
    memory_.hold.picking = true;
    for (const Row& row : rows) {
        const double before = row.value();
        const double y = row.at.y + row.at.height / 2;
        frame({move(row.at.x + row.at.width * .5, y)});
        frame({button(true, row.button)});
        frame({move(row.at.x + row.at.width * .9, y)});
        frame({move(row.at.x + row.at.width * .8, y)});
        EXPECT_NE(row.value(), before) << row.what;
        frame({key(Key::escape, true)});
        frame({key(Key::escape, false)});
        EXPECT_EQ(row.value(), before) << row.what;
        frame({move(row.at.x + row.at.width * .6, y)});
        EXPECT_EQ(row.value(), before) << row.what << " until the button is up";
        frame({button(false, row.button)});
        EXPECT_TRUE(memory_.hold.picking) << "Escape did nothing else";
    }
}

TEST_F(UiTest, EscapeDuringADragRestoresWhatAFileSaysThatWasSavedMeanwhile) {
    add_slider("uEta", 0, 1.1, 5);
    add_slider("uField", 0, 1.1, 10).widget = Widget::none;
    click(place("Glass.constants"));
    const Rect places[] = {place("Glass.uEta"), place("Glass.uField")};
    for (const std::size_t i : {0U, 1U})
        for (const double saved : {2., 1.1}) {
            double& value = controls_.items[i].value[0];
            double& initial = controls_.items[i].initial[0];
            value = 3;
            initial = 1.1;
            const double x = places[i].x, y = places[i].y + places[i].height / 2;
            frame({move(x + places[i].width * .5, y)}, 1);
            frame({button(true)});
            frame({move(x + places[i].width * .9, y)});
            if (saved != initial) value = initial = saved;  // as when the scene is read again
            frame({move(x + places[i].width * .8, y)});
            EXPECT_NE(value, saved) << "the drag continues";
            frame({key(Key::escape, true)});
            frame({key(Key::escape, false), button(false)});
            EXPECT_EQ(value, saved == 2 ? 2 : 3) << i;
        }
}

TEST_F(UiTest, APressBesideTheColourPickerOnlyClosesIt) {
    add_slider("uEta", .1, 1.1, 5);
    Control& color = add_slider("uColor", 0, 0, 1);
    color.widget = Widget::color;
    color.components = 3;
    color.value = color.initial = {.2, .5, 1};
    const Rect track = place("Glass.uEta"), row = place("Glass.uColor");
    for (const Rect& beside : {track, Rect{300, 300, 40, 40}}) {
        click({row.x + row.width - 8, row.y, 4, row.height});
        ASSERT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
        const View view = view_;
        frame({move(beside.x + beside.width * .9, beside.y + beside.height / 2)});
        frame({button(true)});
        frame({move(beside.x + beside.width * .2, beside.y + beside.height / 2 + 10)});
        frame({button(false)});
        EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
        EXPECT_EQ(controls_.items[0].value[0], 1.1);
        EXPECT_EQ(view_, view);
    }
}

TEST_F(UiTest, KeysThatAMenuShowsWorkWhileItIsOpen) {
    facts_.changed = true;
    struct Row {
        const char* menu;
        Key key;
        Modifiers modifiers;
        std::function<bool()> done;
    };
    for (const Row& row :
         {Row{"save", Key::s, {.ctrl = true}, [&] { return requests_.save; }},
          Row{"save", Key::s, {.shift = true, .ctrl = true}, [&] { return requests_.save_as; }},
          Row{"view", Key::r, {}, [&] { return view_.scene == Transformation{}; }},
          Row{"open", Key::o, {.ctrl = true}, [&] { return memory_.browser.open; }},
          Row{"view", Key::p, {}, [&] { return memory_.hold.picking; }},
          Row{"view", Key::s, {}, [&] { return memory_.accuracy.show != AccuracyMemory::Show::picture; }},
          Row{"view", Key::h, {}, [&] { return !std::exchange(memory_.panel, true); }},
          Row{"view", Key::f11, {}, [&] { return requests_.full_screen; }}}) {
        view_.scene.rotate_x = 30;
        click(place(std::string("menu.") + row.menu));
        const std::string menu = row.menu;
        ASSERT_TRUE(has(menu == "save" ? "save as" : menu == "open" ? "open" : "reset view"));
        frame({{.kind = Event::Kind::key, .key = row.key, .down = true, .modifiers = row.modifiers}});
        EXPECT_TRUE(row.done()) << row.menu;
        frame({{.kind = Event::Kind::key, .key = row.key, .down = false}});
        EXPECT_FALSE(has("save as") || has("open") || has("reset view")) << row.menu << " is closed";
        memory_.browser.open = false;
        memory_.accuracy.show = AccuracyMemory::Show::picture;
    }
    click(place("menu.view"));
    frame({key(Key::escape, true)});
    frame({key(Key::escape, false)});
    EXPECT_FALSE(has("reset view"));
    EXPECT_TRUE(memory_.hold.picking) << "Escape closes the menu, and nothing else";
}

TEST_F(UiTest, TheMenuOfASliderOpensLeftOfItsTrack) {
    add_slider("u", .1, 1.1, 5);
    add_slider("uALongerName", .1, 1.1, 5);
    const Rect track = place("Glass.u"), name = place("u.name");
    for (const double x : {name.x + 1., name.x + name.width + 20., track.x - 8., name.x - 6.}) {
        frame({move(x, track.y + track.height / 2)});
        frame({button(true, MouseButton::right)});
        frame({button(false, MouseButton::right)});
        EXPECT_TRUE(has("u.animate")) << x;
        frame({key(Key::escape, true)});
        frame({key(Key::escape, false)});
        ASSERT_FALSE(has("u.animate"));
    }
}

TEST_F(UiTest, EnterSavesThePicture) {
    memory_.picture.open = true;
    for (const char* after : {"", "picture file", "picture transparent"}) {
        memory_.picture.transparent = false;
        if (*after) click(place(after));
        place("picture save");
        frame({key(Key::enter, true)});
        EXPECT_EQ(requests_.picture, PictureRequest::save) << after;
        frame({key(Key::enter, false)});
    }
    click(place("picture samples"));
    frame({key(Key::enter, true)});
    EXPECT_EQ(requests_.picture, PictureRequest::none) << "it ends the typing of a number";
    frame({key(Key::enter, false)});
    EXPECT_LT(place("picture cancel").x, place("picture save").x);
    memory_.picture.open = false;
}

TEST_F(UiTest, NumbersAreNotBrokenAtTheirPoint) {
    frame();
    gui_.begin();
    const std::string text = "sum 12.3\u00A0ms; the same frame in one go 45.6\u00A0ms\nand 7.8 more";
    for (float width = 10; width < 600; width += 7) {
        const std::string lines = broken_at_blanks(text, width);
        std::string joined = lines;
        std::ranges::replace(joined, '\n', ' ');
        EXPECT_EQ(joined, "sum 12.3\u00A0ms; the same frame in one go 45.6\u00A0ms and 7.8 more");
        for (const std::string_view line : split(lines, '\n'))
            EXPECT_TRUE(width_of(line) <= width || line.find(' ') == line.npos) << width << ": " << line;
    }
    gui_.end();
}

TEST_F(UiTest, TheListOfErrorsIsAStripThatIsSized) {
    std::vector<Problem> problems(
        40, {{.file = "a.glib", .at = Position{1, 1}, .message = "no", .source = MarkedLine{"x"}}, {}});
    facts_.problems = problems;
    facts_.revision = 1;
    const Rect list = place("problems.panel"), grip = place("problems.grip");
    EXPECT_LE(list.height, .31F * memory_.scene.height);
    EXPECT_GE(grip.y, list.y + list.height) << "the last line is whole";
    EXPECT_EQ(gui_.fonts().mono->FontSize, gui_.fonts().text->FontSize) << "as large as all other letters";
    const double x = grip.x + grip.width / 2, y = grip.y + grip.height / 2;
    const View view = view_;
    frame({move(x, y)});
    frame({button(true)});
    frame({move(x, y + 150)});
    frame({button(false)});
    EXPECT_NEAR(place("problems.panel").height, list.height + 150, 20);
    // What the picture shows is told as it is.
    std::set<std::uint64_t> told;
    for (const auto& [stale, incomplete] : {std::pair(false, false), {true, false}, {true, true}}) {
        facts_.stale = stale;
        facts_.incomplete = incomplete;
        frame({move(5, 500)});
        frame();
        told.insert(picture_);
    }
    EXPECT_EQ(told.size(), 3U);
    EXPECT_EQ(view_, view);
    facts_.problems = std::span(problems).first(1);
    EXPECT_LT(place("problems.panel").height, list.height) << "no larger than what it holds";
}

TEST_F(UiTest, AnErrorsTooltipLeavesItsLinesInSight) {
    Problem problem{{.file = "a.glib", .at = Position{1, 1}, .message = "no", .source = MarkedLine{"x"}},
                    {"/a.glib", 1, 1}};
    facts_.problems = {&problem, 1};
    facts_.revision = 1;
    const Rect link = place("problem.0.place"), list = place("problems.panel");
    frame({move(link.x + 3, link.y - 3)});
    frame({}, 1);
    frame({}, 1);
    ASSERT_TRUE(kit().tip.shown);
    EXPECT_EQ(kit().tip.item.y, list.y);
    EXPECT_EQ(kit().tip.item.height, list.height) << "below the whole list";
}

TEST_F(UiTest, NothingNewIsTheSamePictureAndAHoverIsAnother) {
    add_slider("uEta", 0, .5, 1);
    const Rect bar = place("Glass.uEta");
    const std::uint64_t still = picture_;
    frame();
    EXPECT_EQ(picture_, still);
    frame({move(bar.x + bar.width / 2, bar.y + bar.height / 2)});
    EXPECT_NE(picture_, still);
}

TEST_F(UiTest, FortySlidersWithLongNamesAtTwiceTheScale) {
    screen_.scale = 2;
    for (int i = 0; i < 40; ++i)
        add_slider("uAVeryLongNameThatNoPanelIsWideEnoughToShowInOneLine" + std::to_string(i), 0, .5, 1);
    const Rect first = place("Glass." + controls_.items[0].name);
    EXPECT_LE(first.x + first.width, screen_.width);
    frame({move(first.x + 20, first.y + 20)});
    for (int i = 0; i < 200; ++i) frame({wheel(-5)});
    const Rect last = place("Glass." + controls_.items[39].name);
    EXPECT_LE(last.y + last.height, screen_.height);
}

}  // namespace
}  // namespace snell::ui
