// Mouse and keys on the panels, judged by what becomes of the values.
#include <cmath>
#include <limits>

#include "src/ui/kit/input.h"
#include "src/ui/kit/numbers.h"
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
    frame({button(false)});
    EXPECT_NE(controls_.items[1].value[1], .5);
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

TEST_F(UiTest, OnlyTheFirstProgramIsOpenAtFirst) {
    add_slider("uEta", 0, .5, 1);
    add_program("Walls");
    add_slider("uKa", 0, .5, 1);
    EXPECT_TRUE(has("Glass.uEta"));
    EXPECT_FALSE(has("Walls.uKa"));
    click(place("Walls"));
    EXPECT_TRUE(has("Walls.uKa"));
    click(place("Glass"));
    EXPECT_FALSE(has("Glass.uEta"));
}

TEST_F(UiTest, SectionsAreRememberedByTheirSceneAndName) {
    FileRow file;
    file.path = "/first.glib";
    facts_.files = {&file, 1};
    add_slider("uEta", 0, .5, 1);
    EXPECT_TRUE(has("Glass.uEta"));
    click(place("Glass"));
    EXPECT_FALSE(has("Glass.uEta"));
    FileRow other;
    other.path = "/second.glib";
    facts_.files = {&other, 1};
    EXPECT_TRUE(has("Glass.uEta")) << "another scene";
    facts_.files = {&file, 1};
    EXPECT_FALSE(has("Glass.uEta"));
    scene_.programs.insert(scene_.programs.begin(), scene_.programs[0]);
    scene_.programs[0].name = "Walls";
    linked_.push_back(1);
    controls_.items[0].program = 1;
    EXPECT_FALSE(has("Glass.uEta")) << "also behind a new program";
}

TEST_F(UiTest, TwoClicksDuringASlowFrameAreADoubleClick) {
    add_slider("uEta", .1, 1.1, 5);
    const Rect bar = place("Glass.uEta");
    frame({move(bar.x + bar.width * .9, bar.y + bar.height / 2)}, .5);
    frame({button(true)}, .5);
    frame({button(false), button(true)}, .5);
    frame({button(false)}, .5);
    EXPECT_EQ(controls_.items[0].value[0], 1.1);
    frame({key(Key::escape, true)}, .5);
    EXPECT_EQ(controls_.items[0].value[0], 1.1) << "nothing that the first click did remains";
}

TEST_F(UiTest, AProgramWithoutSlidersIsAFoldedLine) {
    add_program("Water");
    add_slider("uEta", 0, .5, 1);
    add_program("Air");
    add_slider("uKa", 0, .5, 1);
    EXPECT_TRUE(has("Water.uEta"));
    EXPECT_FALSE(has("Air.uKa"));
    click(place("Glass"));
    const double opened = place("Water").y;
    click(place("Glass"));
    EXPECT_LT(place("Water").y, opened) << "it was folded";
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
    memory_.failure = {"a.html is not saved: a.glib:3:1: error: browsers have no geometry shaders"};
    EXPECT_TRUE(has("failure.ok"));
    click(place("message.ok"));
    EXPECT_FALSE(has("message.ok"));
    EXPECT_TRUE(has("failure.ok"));
    click(place("failure.ok"));
    EXPECT_FALSE(has("failure.ok"));
    EXPECT_EQ(memory_.failure.text, "");
    EXPECT_FALSE(has("failure.remedy"));
    memory_.failure = {"not saved: a.glib has changed", Failure::Remedy::reload};
    const Rect remedy = place("failure.remedy");
    frame({move(remedy.x + remedy.width / 2, remedy.y + remedy.height / 2)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_TRUE(requests_.reload);
    EXPECT_FALSE(has("failure.ok")) << "it is answered";
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
