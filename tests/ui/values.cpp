// Values that are typed, stepped, filtered: fields, the keyboard's focus, and what a row shows.
#include <cmath>

#include "src/plan/values/numbers.h"
#include "src/ui/kit/kit.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class Values : public UiTest {
protected:
    void press(Key which, Modifiers modifiers = {}) {
        frame({{.kind = Event::Kind::key, .key = which, .down = true, .modifiers = modifiers}});
        frame({key(which, false)});
        frame();
    }
    void write(const std::string& text) {
        std::vector<Event> events;
        for (const char c : text) events.push_back({.kind = Event::Kind::text, .text = static_cast<char32_t>(c)});
        frame(events);
        frame();
    }
    void open(const std::string& widget) { click(place(widget), MouseButton::left, .5, {.ctrl = true}); }
    double value(std::size_t control = 0, std::size_t component = 0) const {
        return controls_.items[control].value[component];
    }
    Control& array(const std::string& name, std::vector<double> values) {
        Control& control = add_slider(name, 0, 0, 1);
        control.widget = Widget::none;
        control.listed = false;
        control.components = static_cast<int>(values.size());
        control.value = control.initial = std::move(values);
        return control;
    }
    Control& color(const std::string& name, std::vector<double> values) {
        Control& control = array(name, std::move(values));
        control.widget = Widget::color;
        control.listed = true;
        return control;
    }
};

TEST_F(Values, ARangeIsWidenedWhenTheNumberIsEnteredAndNotBefore) {
    add_slider("uKa", 0, .3, 1);
    open("Glass.uKa");
    write("500");
    EXPECT_EQ(value(), .3) << "nothing is applied while typing";
    press(Key::escape);
    EXPECT_EQ(value(), .3);
    EXPECT_EQ(controls_.items[0].max, 1);
    open("Glass.uKa");
    type("500");
    EXPECT_EQ(value(), 500);
    EXPECT_EQ(controls_.items[0].max, 500);
    click(place("Glass.uKa"), MouseButton::right);
    EXPECT_EQ(value(), .3);
    EXPECT_EQ(controls_.items[0].max, 1) << "a reset restores the range";
    for (const char* widget : {"uKa.dot", "Glass.reset"}) {
        open("Glass.uKa");
        type("-7");
        ASSERT_EQ(controls_.items[0].min, -7);
        click(place(widget));
        EXPECT_EQ(value(), .3) << widget;
        EXPECT_EQ(controls_.items[0].min, 0) << widget;
        EXPECT_FALSE(has(widget)) << "there is nothing left to reset";
    }
}

// The next frame may come a second later, after a slow picture.
TEST_F(Values, KnobAndNumberOfADragSayTheSameInEachFrame) {
    add_slider("uEta", 0, .5, 10);
    const Rect at = place("Glass.uEta");
    const float y = at.y + at.height / 2;
    frame({move(at.x + 10, y)});
    frame({button(true)});
    for (const float x : {30.F, 60.F, 90.F}) {
        frame({move(at.x + x, y)});
        const std::uint64_t moved = picture_;
        if (x == 30) continue;  // a dot is there from now on
        frame();
        EXPECT_EQ(picture_, moved) << x;
    }
    frame({button(false)});
}

TEST_F(Values, ACommaAndArithmeticAreEvaluatedOnEnter) {
    add_slider("uEta", 0, .5, 10);
    for (const auto& [text, wanted] : {std::pair("0,7", .7), {"1/3", 1. / 3}, {"2*pi", 2 * M_PI}, {"-(1-3)", 2.}}) {
        open("Glass.uEta");
        type(text);
        EXPECT_EQ(value(), wanted) << text;
    }
}

TEST_F(Values, WhatIsNoNumberKeepsTheTextAndChangesNothing) {
    add_slider("uEta", 0, .5, 10);
    for (const char* text : {"abc", "1/0", "nan", "1 2", "0x10"}) {
        open("Glass.uEta");
        type(text);
        EXPECT_TRUE(kit().remark.shown) << text;
        EXPECT_EQ(kit().remark.text, "not a number");
        EXPECT_STREQ(kit().typing.text.data(), text) << "the text stays";
        EXPECT_EQ(value(), .5) << text;
        frame();
        EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "and so does the focus";
        // What is typed next is added, not a new beginning.
        write("!");
        EXPECT_EQ(std::string(kit().typing.text.data()), std::string(text) + "!");
        EXPECT_FALSE(kit().remark.shown) << "until it is entered again";
        press(Key::escape);
        EXPECT_EQ(value(), .5);
        EXPECT_EQ(kit().typing.id, 0u);
    }
}

TEST_F(Values, AnEmptyTextIsNoNumber) {
    add_slider("uEta", 0, .5, 10);
    open("Glass.uEta");
    frame({key(Key::delete_, true)});
    type("");
    EXPECT_TRUE(kit().remark.shown);
    EXPECT_EQ(value(), .5);
}

TEST_F(Values, LeavingAFieldAppliesItsNumberOrRestoresTheOldOne) {
    add_slider("uEta", 0, .5, 10);
    add_slider("uMix", 0, .25, 1);
    open("Glass.uEta");
    write("3");
    click({300, 300, 1, 1});
    EXPECT_EQ(value(), 3);
    open("Glass.uEta");
    write("three");
    const Rect other = place("Glass.uMix");
    frame({move(other.x + other.width * .75, other.y + other.height / 2)});
    frame({button(true)});
    EXPECT_EQ(value(), 3);
    EXPECT_TRUE(kit().remark.shown);
    EXPECT_EQ(kit().remark.text, "'three' is not a number");
    EXPECT_NEAR(value(1), .75, .05) << "the press is not lost";
    frame({button(false)});
    frame({button(true), button(false)});
    EXPECT_FALSE(kit().remark.shown) << "until the next press";
}

// What is above the field is drawn, and pressed, before the field knows that it is left.
TEST_F(Values, APressOnAnotherNumberLeavesTheFieldFirst) {
    for (const char* name : {"uUp", "uMid", "uDown"}) add_slider(name, 0, 3, 9, ValueType::int_);
    for (const char* other : {"Glass.uUp", "Glass.uDown"})
        for (const auto& [text, taken] : {std::pair("4", 4.), {"99999999999", 3.}, {"two", 3.}})
            for (const bool entered : {false, true}) {
                const Rect at = place("Glass.uMid"), track = place(other);
                click({at.x + at.width + 8, at.y, 8, at.height});
                write(text);
                if (entered) press(Key::enter);
                click({track.x + track.width + 8, track.y, 8, track.height});
                EXPECT_EQ(value(1), taken) << text << " before " << other;
                EXPECT_EQ(controls_.items[1].max, 9);
                EXPECT_EQ(kit().remark.shown, taken == 3) << text;
                type("5");
                EXPECT_EQ(value(other == std::string("Glass.uUp") ? 0 : 2), 5) << "the press is not lost";
                for (const std::size_t i : {0, 1, 2}) controls_.items[i].value[0] = 3;
            }
}

TEST_F(Values, ARefusalSaysWhatIsWrong) {
    add_slider("uInt", 0, 3, 9, ValueType::int_);
    add_slider("uUint", 0, 3, 9, ValueType::uint_);
    add_slider("uFloat", 0, 3, 9);
    struct Row {
        const char *widget, *text, *wrong;
    };
    for (const Row& row : {Row{"Glass.uInt", "7.2", "not a whole number"},
                           {"Glass.uInt", "7/2", "not a whole number"},
                           {"Glass.uInt", "99999999999", "out of the type's range"},
                           {"Glass.uInt", "9999999999.5", "out of the type's range"},
                           {"Glass.uInt", "1e999", "out of the type's range"},
                           {"Glass.uInt", "x", "not a number"},
                           {"Glass.uUint", ".5", "not a whole number"},
                           {"Glass.uUint", "-5", "out of the type's range"},
                           {"Glass.uFloat", "1e39", "out of the type's range"}}) {
        open(row.widget);
        type(row.text);
        EXPECT_EQ(kit().remark.text, row.wrong) << row.text;
        press(Key::escape);
    }
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(value(i), 3);
}

TEST_F(Values, CommandsTakeTheNumberThatIsTyped) {
    add_slider("uUp", 0, 3, 9);
    for (const Key command : {Key::s, Key::o}) {
        open("Glass.uUp");
        write("x");
        frame({{.kind = Event::Kind::key, .key = command, .down = true, .modifiers = {.ctrl = true}}});
        EXPECT_FALSE(requests_.save || memory_.browser.open) << "of what is no number nothing is saved";
        EXPECT_EQ(kit().remark.text, "'x' is not a number");
        press(command);
        open("Glass.uUp");
        write(command == Key::s ? "4" : "5");
        frame({{.kind = Event::Kind::key, .key = command, .down = true, .modifiers = {.ctrl = true}}});
        EXPECT_EQ(value(), command == Key::s ? 4 : 5);
        EXPECT_TRUE(requests_.save || memory_.browser.open);
        press(command);
    }
}

TEST_F(Values, AClickOnTheNumberBesideASliderEditsIt) {
    add_slider("uEta", 0, .5, 10);
    const Rect track = place("Glass.uEta");
    click({track.x + track.width + 20, track.y, 10, track.height});
    EXPECT_EQ(value(), .5);
    type("4");
    EXPECT_EQ(value(), 4);
}

TEST_F(Values, TabGoesThroughTheValuesInTheOrderOnScreen) {
    add_slider("uA", 0, .1, 9);
    add_slider("uB", 0, .2, 9);
    color("uC", {.3, .4, .5});
    array("uD", {1, 2});
    add_program("Walls");
    add_slider("uE", 0, .6, 9);
    open("Glass.uA");
    const std::vector<std::pair<std::size_t, std::size_t>> order{{0, 0}, {1, 0}, {2, 0}, {2, 1},
                                                                 {2, 2}, {3, 0}, {3, 1}, {4, 0}};
    for (std::size_t i = 0; i < order.size(); ++i) {
        write(std::to_string(i + 1));
        press(Key::tab);
        EXPECT_EQ(value(order[i].first, order[i].second), static_cast<double>(i + 1)) << i;
    }
    write("8.5");
    press(Key::tab, {.shift = true});
    EXPECT_EQ(value(0), 8.5) << "after the last value comes the first one";
    write("7.5");
    press(Key::enter);
    EXPECT_EQ(value(4), 7.5) << "and back";
}

TEST_F(Values, TabReachesCheckBoxesWhichEnterSwitches) {
    add_slider("uA", 0, .1, 9);
    add_slider("uOn", 0, 0, 1, ValueType::bool_).widget = Widget::check_box;
    add_slider("uB", 0, .2, 9);
    open("Glass.uA");
    press(Key::tab);
    press(Key::enter);
    EXPECT_EQ(value(1), 1);
    press(Key::enter);
    EXPECT_EQ(value(1), 0);
    press(Key::enter);
    press(Key::tab);
    press(Key::right);
    EXPECT_EQ(value(1), 1);
    EXPECT_GT(value(2), .2) << "the next one has the focus";
}

// Ladders, menus, sections and buttons, from the value that Tab reaches first.
TEST_F(Values, TabReachesEverythingThatTheMouseDoes) {
    scene_.ladders.push_back({.name = "Roughness", .rungs = {"smooth", "rough", "exact"}});
    controls_.rungs = {0};
    add_slider("uA", 0, .1, 9);
    frame();
    press(Key::tab);
    press(Key::enter);
    type("3");
    ASSERT_EQ(value(), 3) << "values first";
    facts_.animated = facts_.timed = true;  // the space bar pauses the time
    const auto go_to = [&](auto&& reached, Modifiers modifiers) {
        for (int i = 0; i < 30; ++i) {
            if (reached()) return true;
            press(Key::tab, modifiers);
        }
        return false;
    };
    const auto at_ladder = [&] {
        press(Key::down);
        return controls_.rungs[0] == 1;
    };
    const Modifiers shift{.shift = true};
    ASSERT_TRUE(go_to(at_ladder, shift)) << "the ladder is above the section";
    press(Key::down);
    press(Key::down);
    EXPECT_EQ(controls_.rungs[0], 2u) << "the last rung";
    press(Key::up);
    EXPECT_EQ(controls_.rungs[0], 1u);
    press(Key::enter);
    EXPECT_TRUE(has("Roughness.exact")) << "Enter opens the list";
    press(Key::down);
    EXPECT_EQ(controls_.rungs[0], 2u);
    press(Key::enter);
    EXPECT_FALSE(has("Roughness.exact")) << "and closes it";
    const auto at_reset = [&] {
        press(Key::space);
        return value() == .1;
    };
    const bool paused = memory_.clock.paused;
    ASSERT_TRUE(go_to(at_reset, {})) << "Reset all";
    EXPECT_EQ(memory_.clock.paused, paused) << "the space bar presses the button, and does nothing else";
}

TEST_F(Values, KeysChooseInAListThatTheMouseOpened) {
    scene_.ladders.push_back({.name = "Roughness", .rungs = {"smooth", "rough", "exact"}});
    controls_.rungs = {0};
    add_slider("uA", 0, 2, 9);
    for (const bool of_slider : {false, true}) {
        if (of_slider) click(place("Glass.uA"));
        const double before = value();
        controls_.rungs = {0};
        click(place("Roughness"));
        ASSERT_TRUE(has("Roughness.exact"));
        press(Key::down);
        EXPECT_EQ(controls_.rungs[0], 1U);
        press(Key::enter);
        EXPECT_FALSE(has("Roughness.exact"));
        press(Key::down);
        EXPECT_EQ(controls_.rungs[0], 2U) << "the button has the focus";
        EXPECT_EQ(value(), before);
    }
}

TEST_F(Values, TabGoesThroughAMenu) {
    add_slider("uA", 0, .1, 9);
    frame();
    press(Key::tab);
    for (int i = 0; i < 30 && !has("axes"); ++i) {
        press(Key::tab, {.shift = true});
        press(Key::enter);
    }
    ASSERT_TRUE(has("axes")) << "Enter opens a menu";
    const bool axes = view_.axes;
    press(Key::tab);
    press(Key::tab);
    EXPECT_TRUE(has("axes"));
    press(Key::enter);
    EXPECT_EQ(view_.axes, !axes) << "its second entry";
    EXPECT_FALSE(has("axes")) << "a choice closes the menu";
}

// As in other programs: arrow keys lead from entry to entry, Escape back to the button.
TEST_F(Values, ArrowKeysGoThroughAMenu) {
    add_slider("uA", 0, .1, 9);
    frame();
    press(Key::tab);
    for (int i = 0; i < 30 && !has("axes"); ++i) {
        press(Key::tab, {.shift = true});
        press(Key::enter);
    }
    ASSERT_TRUE(has("axes"));
    press(Key::escape);
    ASSERT_FALSE(has("axes"));
    press(Key::enter);
    ASSERT_TRUE(has("axes")) << "the button has the focus again";
    const bool axes = view_.axes;
    press(Key::down);
    press(Key::down);
    EXPECT_TRUE(has("axes"));
    EXPECT_EQ(value(), .1) << "the slider does not hear them";
    press(Key::enter);
    EXPECT_EQ(view_.axes, !axes) << "its second entry";
    press(Key::enter);
    ASSERT_TRUE(has("axes")) << "the button has the focus again";
    press(Key::up);
    press(Key::enter);
    EXPECT_FALSE(memory_.panel) << "its last entry";
}

TEST_F(Values, TheMenuOfASliderIsOpenedByKeys) {
    add_slider("uA", 1, 2, 9);
    for (const auto& [which, modifiers] : {std::pair(Key::menu, Modifiers{}), {Key::f10, Modifiers{.shift = true}}}) {
        frame();
        press(Key::escape);
        press(Key::tab);
        press(which, modifiers);
        ASSERT_TRUE(has("uA.animate"));
        EXPECT_GE(place("uA.animate").y, place("uA.name").y + place("uA.name").height);
        press(Key::down);
        press(Key::down);
        EXPECT_EQ(value(), 2);
        press(Key::enter);
        EXPECT_FALSE(has("uA.animate"));
        EXPECT_EQ(memory_.logarithmic.empty(), which == Key::f10) << "its second entry, there and back";
        press(Key::right);
        EXPECT_GT(value(), 2) << "the slider has the focus again";
        controls_.items[0].value[0] = 2;
    }
}

// Of every component, whatever changes it; a right click on its name, or on that of all, does the same.
TEST_F(Values, EveryComponentHasAMenu) {
    Control& sliders = add_slider("uSlid", 0, .2, 9);
    sliders.value = sliders.initial = {.2, .3, .4};
    color("uColor", {.3, .4, .5});
    add_slider("uOn", 0, 0, 1, ValueType::bool_).widget = Widget::check_box;
    array("uTyped", {1, 2, 3});
    const auto change = [&] {
        for (Control& control : controls_.items)
            for (double& value : control.value) value = 1 - value / 3;
    };
    frame();
    std::size_t menus = 0;
    for (std::size_t at = 0; at < controls_.items.size(); ++at) {
        for (std::size_t i = 0; i < controls_.items[at].value.size(); ++i) {
            const Control& control = controls_.items[at];
            SCOPED_TRACE(control.name + " " + std::to_string(i));
            change();
            const std::vector<double> before = control.value;
            press(Key::tab);
            ++menus;
            press(Key::f10, {.shift = true});
            ASSERT_TRUE(has(control.name + ".reset"));
            press(Key::down);
            press(Key::enter);
            EXPECT_FALSE(has(control.name + ".reset"));
            for (std::size_t k = 0; k < before.size(); ++k)
                EXPECT_EQ(control.value[k], k == i ? control.initial[k] : before[k]) << k;
        }
    }
    EXPECT_EQ(menus, 10U);
    for (const std::size_t at : {1U, 3U}) {
        const Control& control = controls_.items[at];
        change();
        click(place(control.name + ".name"), MouseButton::right);
        click(place(control.name + ".reset all"));
        EXPECT_EQ(control.value, control.initial) << control.name;
    }
    change();
    const Rect name = place("uSlid.name");
    click({name.x, name.y + 3, name.width, 2}, MouseButton::right);
    EXPECT_TRUE(has("uSlid.animate"));
}

TEST_F(Values, TabStaysWithWhatIsNoNumber) {
    add_slider("uA", 0, .1, 9);
    add_slider("uB", 0, .2, 9);
    open("Glass.uA");
    write("x");
    press(Key::tab);
    EXPECT_TRUE(kit().remark.shown);
    EXPECT_STREQ(kit().typing.text.data(), "x");
    EXPECT_EQ(value(0), .1);
    press(Key::escape);
    press(Key::tab);
    write("3");
    EXPECT_EQ(value(1), .2) << "a focus without a field moves by Tab, too";
    press(Key::enter);
    write("3");
    press(Key::enter);
    EXPECT_EQ(value(1), 3) << "and Enter opens its field";
}

TEST_F(Values, TabBringsAValueIntoSight) {
    for (int i = 0; i < 60; ++i) add_slider("uValue" + std::to_string(i), 0, .5, 1);
    place("Glass.uValue0");
    press(Key::tab, {.shift = true});
    for (int i = 0; i < 3; ++i) frame();
    const Rect last = place("Glass.uValue59");
    EXPECT_LT(last.y + last.height, screen_.height);
    press(Key::enter);
    write(".7");
    press(Key::enter);
    EXPECT_EQ(value(59), .7);
}

TEST_F(Values, KeysMoveTheSliderThatHasTheFocus) {
    add_slider("uMix", 0, .5, 2);
    add_slider("uSteps", 0, 5, 40, ValueType::int_);
    frame();
    press(Key::right);
    EXPECT_EQ(value(), .5) << "without a focus nothing moves";
    press(Key::tab);
    const auto expect_step = [&](Key which, Modifiers modifiers, double step) {
        const double before = value();
        press(which, modifiers);
        EXPECT_NEAR(value() - before, step, 1e-9);
    };
    expect_step(Key::right, {}, .02);
    expect_step(Key::left, {}, -.02);
    expect_step(Key::up, {.shift = true}, .002);
    expect_step(Key::down, {.shift = true}, -.002);
    expect_step(Key::page_up, {}, .2);
    expect_step(Key::page_down, {}, -.2);
    for (int i = 0; i < 20; ++i) press(Key::page_up);
    EXPECT_EQ(value(), 2) << "not beyond the end";
    press(Key::tab);
    press(Key::right);
    EXPECT_EQ(value(1), 6);
    press(Key::left, {.shift = true});
    EXPECT_EQ(value(1), 5) << "a whole number has no finer step";
    press(Key::page_up);
    EXPECT_EQ(value(1), 9);
    press(Key::escape);
    press(Key::right);
    EXPECT_EQ(value(1), 9) << "Esc ends the focus";
}

TEST_F(Values, TheFocusIsVisible) {
    add_slider("uMix", 0, .5, 2);
    place("Glass.uMix");
    const std::uint64_t without = picture_;
    press(Key::tab);
    EXPECT_NE(picture_, without);
    press(Key::escape);
    EXPECT_EQ(picture_, without);
}

TEST_F(Values, ManySlidersHaveAFilter) {
    for (int i = 1; i <= 12; ++i) add_slider("uValue" + std::to_string(i), 0, .5, 1);
    EXPECT_FALSE(has("filter"));
    add_program("Walls");
    add_slider("uKa", 0, .5, 1);
    click(place("Walls"));
    click(place("filter"));
    write("KA");
    EXPECT_TRUE(has("Walls.uKa")) << "any case, and the section is open";
    EXPECT_FALSE(has("Glass.uValue1"));
    press(Key::escape);
    EXPECT_TRUE(has("Glass.uValue1"));
    EXPECT_FALSE(has("Walls.uKa")) << "sections are as they were";
    click(place("filter"));
    write("e12");
    click(place("Glass.uValue12"), MouseButton::left, .9);
    EXPECT_GT(value(11), .8);
    click(place("filter.clear"));
    EXPECT_TRUE(has("Glass.uValue1"));
}

TEST_F(Values, RowsHaveTheHeightOfOneLine) {
    add_slider("uA", 0, .1, 9);
    Control& vector = add_slider("uB", 0, .2, 9);
    vector.value = vector.initial = {.2, .3, .4};
    add_slider("uC", 0, .2, 9);
    const float step = place("Glass.uB[0]").y - place("Glass.uA").y;
    EXPECT_NEAR(step, 28, 1);
    EXPECT_EQ(place("Glass.uB[2]").y - place("Glass.uB[1]").y, step) << "a row for each component";
    EXPECT_EQ(place("Glass.uC").y - place("Glass.uA").y, 4 * step);
    EXPECT_EQ(place("Glass.uC").x, place("Glass.uA").x);
}

TEST_F(Values, ALongNameLeavesTheTracksRoom) {
    add_slider("uKa", 0, .5, 1);
    add_slider("uAVeryLongUniformNameForAFramework", 0, .5, 1);
    EXPECT_GT(place("Glass.uKa").width, 120);
}

TEST_F(Values, MatricesAreShownByRowsAndVectorsInALine) {
    add_slider("uA", 0, .1, 9);  // which opens the section
    array("uMat4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, .1, .2, .3, 1}).type = ValueType::matrix;
    array("uMat2", {1, 2, 3, 4}).type = ValueType::matrix;
    array("uVec3", {.1, .2, .3});
    for (const auto& [name, rows] : {std::pair("Glass.uMat4", 4), {"Glass.uMat2", 2}})
        for (int i = 1; i < rows; ++i) {
            const auto at = [&](int k) { return place(std::string(name) + "[" + std::to_string(k) + "]"); };
            EXPECT_EQ(at(rows * i).y, at(0).y) << name << ": the first row";
            EXPECT_GT(at(rows * i).x, at(rows * i - rows).x);
            EXPECT_EQ(at(i).x, at(0).x) << name << ": the first column";
            EXPECT_GT(at(i).y, at(i - 1).y);
        }
    EXPECT_EQ(place("Glass.uVec3[2]").y, place("Glass.uVec3[0]").y);
}

TEST_F(Values, BooleansOfAVectorAreCheckBoxes) {
    add_slider("uA", 0, .1, 9);
    array("uOn", {1, 0, 1}).type = ValueType::bool_;
    click(place("Glass.uOn[1]"));
    EXPECT_EQ(controls_.items[1].value, (std::vector<double>{1, 1, 1}));
    press(Key::enter);
    EXPECT_EQ(controls_.items[1].value, (std::vector<double>{1, 0, 1})) << "Enter switches the one with the focus";
}

TEST_F(Values, ADotResetsOneComponent) {
    Control& vector = add_slider("uB", 0, .2, 9);
    vector.value = vector.initial = {.2, .3, .4};
    controls_.items[0].value = {1, .3, 3};
    click(place("uB.dot"));
    EXPECT_EQ(controls_.items[0].value, (std::vector<double>{.2, .3, 3}));
    EXPECT_TRUE(has("uB.dot"));
    click(place("uB.dot"));
    EXPECT_EQ(controls_.items[0].value, controls_.items[0].initial);
}

TEST_F(Values, ResetAllMovesNothing) {
    add_slider("uA", 0, .1, 9);
    color("uB", {.1, .2, .3});
    const Rect before = place("Glass.uB");
    click(place("Glass.uA"), MouseButton::left, .7);
    EXPECT_TRUE(has("Glass.reset"));
    EXPECT_EQ(place("Glass.uB"), before);
}

TEST_F(Values, NamesThatWouldBeCutToTheSameTextAreWhole) {
    add_slider("uParameterNumber1Amount", 0, .5, 1);
    add_slider("uParameterNumber2Amount", 0, .5, 1);
    EXPECT_GT(place("uParameterNumber1Amount.name").width, 8 * 16) << "above its track";
    const Rect track = place("Glass.uParameterNumber1Amount");
    EXPECT_GT(track.y, place("uParameterNumber1Amount.name").y + 10);
    controls_.items[1].name = "uAnotherLongNameThatIsCut";
    EXPECT_LT(place("uParameterNumber1Amount.name").width, 8.5 * 16) << "beside its track";
    EXPECT_NEAR(place("Glass.uParameterNumber1Amount").y, place("uParameterNumber1Amount.name").y, 6);
}

TEST_F(Values, NamesAreCutInTheMiddle) {
    frame();
    const std::string name = "uRefractiveIndexOfTheSphere";
    const float width = width_of("uRefractiveIndex");
    const Text a = shortened(name + "Amount", width), b = shortened(name + "Offset", width);
    EXPECT_FALSE(a == b.view()) << "what differs at the end differs on the screen";
    EXPECT_LE(width_of(a.view()), width);
    EXPECT_TRUE(a.view().starts_with("uRef"));
    EXPECT_TRUE(a.view().ends_with("ount"));
    EXPECT_TRUE(shortened(name, 1000) == name);
    EXPECT_FALSE(shortened(name, 0).empty());
    EXPECT_TRUE(shortened("2 errors in this scene", width_of("2 errors in\u2026")) == "2 errors in\u2026")
        << "a sentence";
    const Text greek =
        shortened("\u03b1\u03b2\u03b3\u03b4\u03b5\u03b6\u03b7\u03b8", width_of("\u03b1\u03b2\u03b3\u03b4"));
    EXPECT_TRUE(greek.view().starts_with("\u03b1") && greek.view().ends_with("\u03b8")) << greek.view();
}

TEST_F(Values, ATooltipWaitsAndCoversNoNeighbour) {
    add_slider("uA", 0, .1, 9);
    add_slider("uB", 0, .1, 9);
    const Rect name = place("uA.name");
    frame({move(name.x + 3, name.y + 3)});
    frame({}, .3);
    EXPECT_FALSE(kit().tip.shown);
    frame({move(name.x + 5, name.y + 3)}, .1);
    frame({}, .3);
    EXPECT_FALSE(kit().tip.shown) << "the pointer moved";
    EXPECT_NEAR(gui_.due(), .2, .01);
    frame({}, .3);
    EXPECT_TRUE(kit().tip.shown);
    EXPECT_FALSE(std::isfinite(gui_.due())) << "nothing more will change";
    EXPECT_NE(kit().tip.text.find("0 \u2026 9"), std::string::npos) << kit().tip.text;
    frame({move(name.x + 3, name.y + 30)});
    EXPECT_FALSE(kit().tip.shown) << "the neighbour has its own";
}

TEST_F(Values, EscapeInAFieldOfADialogLeavesTheDialogOpen) {
    add_slider("uA", 0, .5, 1);
    memory_.picture.open = true;
    memory_.picture.width = memory_.picture.height = 100;
    open("picture width");
    write("300");
    press(Key::escape);
    EXPECT_TRUE(memory_.picture.open);
    EXPECT_EQ(memory_.picture.width, 100);
    press(Key::enter);
    write("7");
    press(Key::tab);
    write("8");
    press(Key::tab, {.shift = true});
    EXPECT_EQ(memory_.picture.width, 7);
    EXPECT_EQ(memory_.picture.height, 8) << "Tab stays in the dialog";
    press(Key::escape);
    press(Key::escape);
    EXPECT_FALSE(memory_.picture.open);
    EXPECT_EQ(value(), .5);
}

TEST_F(Values, EscapeClosesThePickerAndNothingElse) {
    color("uC", {.3, .4, .5});
    memory_.keys = true;
    const Rect row = place("Glass.uC");
    const auto open = [] {
        return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    };
    click({row.x + row.width - 12, row.y, 4, row.height});
    EXPECT_TRUE(open());
    press(Key::escape);
    EXPECT_FALSE(open());
    EXPECT_TRUE(memory_.keys) << "the list of keys stays open";
    press(Key::escape);
    EXPECT_FALSE(memory_.keys);
}

TEST_F(Values, TheClickThatClosesADropDownActsWhereItLands) {
    scene_.ladders.push_back({});
    scene_.ladders[0].name = "FRESNEL";
    scene_.ladders[0].rungs = {"f0", "schlick", "exact"};
    controls_.rungs = {0};
    add_slider("uA", 0, .1, 1).widget = Widget::check_box;
    for (int i = 0; i < 8; ++i) add_slider("uB" + std::to_string(i), 0, .1, 1);
    const Rect slider = place("Glass.uB7");
    click(place("FRESNEL"));
    EXPECT_TRUE(has("FRESNEL.exact"));
    click(slider, MouseButton::left, .8);
    EXPECT_FALSE(has("FRESNEL.exact"));
    EXPECT_NEAR(value(8), .8, .05);
    click(place("FRESNEL"));
    EXPECT_TRUE(has("FRESNEL.exact"));
    press(Key::escape);
    EXPECT_FALSE(has("FRESNEL.exact"));
    const Rect closed = place("FRESNEL");
    click(closed);
    EXPECT_TRUE(has("FRESNEL.exact"));
    click(closed);
    EXPECT_FALSE(has("FRESNEL.exact")) << "a click on the list's own button closes it";
    click(place("FRESNEL"));
    frame({move(300, 300)});
    frame({button(true), move(340, 300), button(false)});
    EXPECT_NE(view_.scene, Transformation{}) << "a drag in the scene turns it";
}

TEST_F(Values, ADraggedColorHasFewDigits) {
    color("uC", {.123456789, .5, .25});
    const Rect row = place("Glass.uC");
    frame({move(row.x + 20, row.y + 10), button(true)});
    frame({move(row.x + 57, row.y + 10), button(false)});
    EXPECT_NE(value(), .123456789);
    EXPECT_LE(exact(value()).size(), 5u) << exact(value());
    click({row.x + 18, row.y, 4, row.height});
    type(".123456789");
    EXPECT_EQ(value(), .123456789) << "as typed";
}

}  // namespace
}  // namespace snell::ui
