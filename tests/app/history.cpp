// Undo and redo, without a window.
#include "src/document/history.h"

#include <gtest/gtest.h>

#include <random>

#include "src/app/open/write_copy.h"
#include "src/plan/view.h"
#include "tests/plan/uniforms.h"
#include "tests/scratch.h"

namespace snell {
namespace {

using Kind = UniformValue::Kind;
using Values = std::vector<double>;

class Undo : public testing::Test {
protected:
    Undo() {
        scene_ = scene({"uEta", "uMix"});
        controls_ = fresh(scene_);
        history_.begin(scene_, controls_, view_);
    }

    static Scene scene(const std::vector<std::string>& names) {
        std::vector<UniformValue> line;
        for (const std::string& name : names) line.push_back(value_of(name, Kind::range, {0, .5, 2}));
        Scene scene = scene_with({{"Glass", line}});
        scene.ladders.push_back({"F", {"cheap", "exact"}, 0, {}, {}, {}});
        return scene;
    }
    static Controls fresh(const Scene& scene) {
        Diagnostics ignored;
        std::vector<ActiveUniform> uniforms;
        for (const UniformValue& value : scene.programs[0].uniforms) {
            uniforms.push_back(active("float"));
            uniforms.back().name = value.name;
        }
        return make_controls(scene, {uniforms}, ignored);
    }
    double& value(std::size_t index) { return controls_.items[index].value[0]; }
    // A new press: another gesture.
    bool step(bool busy = false) { return history_.follow(scene_, controls_, view_, {busy, ++presses_, now_ += 1}); }
    bool same_gesture(double later = .1) {
        return history_.follow(scene_, controls_, view_, {false, presses_, now_ += later});
    }
    UserState state() {
        return {scene_, controls_, view_, [this] { ++followed_; }, {}, exchange_saved};
    }
    std::string undo() { return history_.undo(state()); }
    std::string redo() { return history_.redo(state()); }
    // The text was edited: the values carry over as in a session.
    std::string edit(Scene scene, std::span<const Animated> moving = {}, Follow follow = Follow::text) {
        Controls next = fresh(scene);
        carry_over(controls_, scene_, next, scene);
        if (follow == Follow::memory)
            for (std::size_t i = 0; i < next.items.size(); ++i) take_value(controls_.items[i], next.items[i], follow);
        scene_ = std::move(scene);
        controls_ = std::move(next);
        return history_.reread(scene_, controls_, view_, moving, follow);
    }

    Scene scene_;
    Controls controls_;
    View view_;
    History history_;
    std::uint64_t presses_ = 0;
    double now_ = 0;
    int followed_ = 0;
};

TEST_F(Undo, OneDragIsOneStepAndGoesBothWays) {
    for (const double at : {.6, .7, .8}) {
        value(0) = at;
        EXPECT_FALSE(step(true)) << "the button is down";
    }
    value(0) = 1.1;
    EXPECT_TRUE(step());
    EXPECT_EQ(history_.size(), 1U);
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.1 \u2192 0.5");
    EXPECT_EQ(value(0), .5);
    EXPECT_FALSE(step()) << "going back is not a change";
    EXPECT_EQ(undo(), "nothing to undo");
    EXPECT_EQ(redo(), "redo: Glass.uEta 0.5 \u2192 1.1");
    EXPECT_EQ(value(0), 1.1);
    EXPECT_EQ(redo(), "nothing to redo");
}

TEST_F(Undo, AWheelGestureIsOneStepAndTwoPressesAreTwo) {
    for (const double scale : {1.1, 1.2, 1.3}) {
        view_.scene.scale = scale;
        same_gesture();
    }
    EXPECT_EQ(history_.size(), 1U);
    view_.scene.scale = 1.4;
    same_gesture(2);
    EXPECT_EQ(history_.size(), 2U) << "after a pause";
    value(0) = 1;
    same_gesture();
    EXPECT_EQ(history_.size(), 3U) << "something else";
    value(0) = 1.2;
    step();
    value(0) = 1.4;
    step();
    EXPECT_EQ(history_.size(), 5U);
    undo();
    EXPECT_EQ(value(0), 1.2);
    for (int i = 0; i < 4; ++i) undo();
    EXPECT_EQ(view_, View{});
    EXPECT_EQ(value(0), .5);
}

TEST_F(Undo, TheWheelAfterADragIsAStepOfItsOwn) {
    view_.scene.rotate_y = 10;
    step(true);
    same_gesture();
    view_.scene.scale = 2;
    same_gesture();
    EXPECT_EQ(history_.size(), 2U);
    view_.scene.scale = 3;
    same_gesture();
    EXPECT_EQ(history_.size(), 2U) << "its own goes on";
}

TEST_F(Undo, AGestureThatEndsWhereItBeganIsNoStep) {
    view_.scene.scale = 1.1;
    same_gesture();
    view_.scene.scale = 1;
    same_gesture();
    EXPECT_EQ(history_.size(), 0U);
    EXPECT_EQ(history_.bytes(), 0U);
}

TEST_F(Undo, TimeAndMouseAreNoSteps) {
    view_.mouse_x = .25;
    EXPECT_FALSE(step());
    value(0) = 1;
    step();
    view_.mouse_x = .75;
    view_.axes = true;
    step();
    EXPECT_EQ(undo(), "undo: axes shown \u2192 hidden");
    EXPECT_EQ(view_.mouse_x, .75) << "the mouse is where it is";
}

TEST_F(Undo, WhatMovesByItselfIsAStepWhenItEnds) {
    const std::vector<Animated> moving{{0, "uEta"}};
    const auto frame = [&] {
        value(0) += .1;
        return history_.follow(scene_, controls_, view_, {false, ++presses_, now_ += 1, moving});
    };
    const auto undo_meanwhile = [&] {
        UserState now = state();
        now.moving = moving;
        return history_.undo(now);
    };
    EXPECT_FALSE(frame()) << "the motion alone is no step";
    value(1) = 1.5;
    EXPECT_TRUE(frame()) << "other changes are, at once";
    view_.scene.scale = 2;
    EXPECT_TRUE(frame());
    EXPECT_FALSE(frame());
    EXPECT_EQ(undo_meanwhile(), "undo: view");
    EXPECT_FALSE(frame());
    EXPECT_EQ(undo_meanwhile(), "undo: Glass.uMix 1.5 \u2192 0.5");
    EXPECT_FALSE(frame());
    EXPECT_EQ(history_.redo({scene_, controls_, view_, [] {}, moving}), "redo: Glass.uMix 0.5 \u2192 1.5");
    value(0) = 1.8;
    EXPECT_TRUE(step()) << "the motion has ended";
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.8 \u2192 0.5") << "all of it";
    EXPECT_EQ(value(1), 1.5);
    EXPECT_EQ(undo(), "undo: Glass.uMix 1.5 \u2192 0.5");
    EXPECT_EQ(undo(), "nothing to undo");
}

TEST_F(Undo, WhatAPressDidIsTakenBackWithItsHistory) {
    for (const std::size_t index : {0U, 1U}) {
        value(index) = 1;
        step();
    }
    undo();
    const std::size_t bytes = history_.bytes();
    value(0) = 2;
    step();
    value(0) = 1;
    history_.take_back(++presses_);
    EXPECT_FALSE(same_gesture());
    EXPECT_EQ(history_.bytes(), bytes);
    EXPECT_EQ(redo(), "redo: Glass.uMix 0.5 \u2192 1");
    value(0) = 2;
    step();
    ++presses_;
    history_.take_back(++presses_);
    EXPECT_EQ(undo(), "undo: Glass.uEta 2 \u2192 1") << "it was not the last press";
    history_.take_back(++presses_);
    EXPECT_EQ(undo(), "undo: Glass.uMix 1 \u2192 0.5");
    EXPECT_EQ(undo(), "undo: Glass.uEta 1 \u2192 0.5");
}

TEST_F(Undo, AMotionOutlivesEditsOfTheText) {
    const std::vector<Animated> moving{{0, "uMix"}};
    value(1) = .7;
    history_.follow(scene_, controls_, view_, {.moving = moving});
    edit(scene({"uNew", "uMix"}));
    value(1) = .9;
    EXPECT_FALSE(history_.follow(scene_, controls_, view_, {.moving = moving}));
    EXPECT_TRUE(step());
    EXPECT_EQ(undo(), "undo: Glass.uMix 0.9 \u2192 0.5");
}

TEST_F(Undo, ASaveDuringAMotionKeepsWhereItBegan) {
    const std::vector<Animated> moving{{0, "uEta"}};
    value(0) = .7;
    step();
    const auto moved_to = [&](double at) {
        value(0) = at;
        EXPECT_FALSE(history_.follow(scene_, controls_, view_, {.moving = moving})) << at;
    };
    moved_to(1.2);
    for (const double written : {1.2, .5}) {  // a save, and its undo
        Scene text = scene({"uEta", "uMix"});
        text.programs[0].uniforms[0].values[1] = written;
        edit(text, moving);
        moved_to(1.5);
    }
    EXPECT_TRUE(step()) << "the motion has ended";
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.5 \u2192 0.7");
    EXPECT_EQ(undo(), "undo: Glass.uEta 0.7 \u2192 0.5");
}

TEST_F(Undo, TheHistoriesThatWereUsedLastAreKept) {
    Histories histories;
    const auto steps = [&](const std::string& name) { return histories.use(name).size(); };
    for (char name = 'z'; name > 'z' - static_cast<char>(Histories::most); --name)
        histories.use(std::string(1, name)).add("snapshot 1", {{"one", "", "1"}});
    EXPECT_EQ(steps("z"), 1U) << "it was used first, and is again";
    histories.use("a");
    EXPECT_EQ(steps("z"), 1U);
    EXPECT_EQ(steps("y"), 0U) << "not used for the longest time";
}

TEST_F(Undo, TheMouseMovesNoGesture) {
    view_.mouse_x = .1;
    view_.scene.scale = 2;
    same_gesture();
    view_.mouse_x = .2;
    view_.scene.scale = 1;
    same_gesture();
    EXPECT_EQ(history_.size(), 0U);
}

TEST_F(Undo, ACheckBoxIsOnOrOff) {
    controls_.items[1].widget = Widget::check_box;
    value(1) = 0;
    step();
    EXPECT_EQ(undo(), "undo: Glass.uMix off \u2192 on");
}

TEST_F(Undo, ANewChangeDropsWhatCouldBeRedone) {
    value(0) = 1;
    step();
    value(0) = 1.5;
    step();
    undo();
    value(1) = 2;
    step();
    EXPECT_EQ(redo(), "nothing to redo");
    EXPECT_EQ(value(0), 1);
    undo();
    undo();
    EXPECT_EQ(value(0), .5);
    EXPECT_EQ(value(1), .5);
}

TEST_F(Undo, SeveralValuesRungsAndRanges) {
    value(0) = 1;
    value(1) = 401.61;
    controls_.items[1].max = 500;
    step();
    EXPECT_EQ(undo(), "undo: 2 values");
    EXPECT_EQ(controls_.items[1].max, 2);
    redo();
    EXPECT_EQ(controls_.items[1].max, 500);
    EXPECT_EQ(value(1), 401.61);
    controls_.rungs = {1};
    step();
    EXPECT_EQ(undo(), "undo: F exact \u2192 cheap");
    EXPECT_EQ(controls_.rungs, Rungs{0});
    EXPECT_EQ(followed_, 1);
}

TEST_F(Undo, StepsOutliveEditsOfTheText) {
    value(0) = 1;
    step();
    value(1) = 1.5;
    step();
    edit(scene({"uNew", "uMix", "uEta"}));
    EXPECT_FALSE(step()) << "an edit is not a step";
    EXPECT_EQ(undo(), "undo: Glass.uMix 1.5 \u2192 0.5");
    edit(scene({"uMix"}));
    EXPECT_EQ(undo(), "nothing to undo") << "uEta is gone: its step is skipped";
    edit(scene({"uEta", "uMix"}));
    EXPECT_EQ(redo(), "redo: Glass.uEta 0.5 \u2192 1");
}

// A change that was made while the text had another value leads back to the value of the text, not to that one.
TEST_F(Undo, StepsFollowTheValuesOfTheText) {
    const auto with = [](double initial) {
        return scene_with({{"Glass", {value_of("uEta", Kind::range, {0, initial, 2})}}});
    };
    edit(with(.5));
    edit(with(0));  // such as a line that is cut off
    EXPECT_EQ(value(0), 0);
    value(0) = 1.5;
    EXPECT_TRUE(step());
    edit(with(.5));
    EXPECT_EQ(value(0), .5);
    undo();
    EXPECT_EQ(value(0), 1.5) << "which the text replaced";
    undo();
    EXPECT_EQ(value(0), .5);
    redo();
    EXPECT_EQ(value(0), 1.5);
    undo();
    // What is saved moves nothing, so the way back is as it was.
    value(0) = 1.25;
    EXPECT_TRUE(step());
    edit(with(1.25));
    EXPECT_EQ(value(0), 1.25);
    undo();
    EXPECT_EQ(value(0), .5);
}

TEST_F(Undo, AChangeDuringWhichTheTextIsReadIsStillAStep) {
    value(0) = 1;
    step(true);
    edit(scene({"uEta"}));
    value(0) = 1.2;
    EXPECT_TRUE(step());
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.2 \u2192 0.5");
}

TEST_F(Undo, AChangeDuringWhichASaveIsReadIsAStepFromTheSavedValue) {
    value(0) = 1;
    step();
    value(0) = 1.2;
    step(true);
    Scene saved = scene({"uEta", "uMix"});
    saved.programs[0].uniforms[0].values[1] = 1;
    edit(saved, {}, Follow::memory);
    ASSERT_EQ(value(0), 1.2);
    value(0) = 1.3;
    EXPECT_TRUE(step());
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.3 \u2192 1");
    EXPECT_EQ(undo(), "undo: Glass.uEta 1 \u2192 0.5") << "the text moved nothing";
}

TEST_F(Undo, AStepOfAValueThatADamagedTextDidNotListLeadsToTheTexts) {
    const Scene damaged = scene({"uOther", "uMix"});
    Diagnostics ignored;
    std::vector<ActiveUniform> uniforms(3, active("float"));
    uniforms[0].name = "uOther";
    uniforms[1].name = "uMix";
    uniforms[2].name = "uEta";  // the program uses it still
    scene_ = damaged;
    controls_ = make_controls(damaged, {uniforms}, ignored);
    history_.begin(scene_, controls_, view_);
    Control* unlisted = controls_.find(0, "uEta");
    ASSERT_TRUE(unlisted && !unlisted->listed && unlisted->value[0] == 0);
    unlisted->value[0] = .5;  // by chance what the mended text says
    ASSERT_TRUE(step());
    edit(scene({"uEta", "uMix"}));
    ASSERT_EQ(value(0), .5);
    undo();
    EXPECT_EQ(value(0), .5) << "0 was no value of the text";
}

TEST_F(Undo, AValueThatTheTextReplacedComesBack) {
    value(0) = 1.25;
    ASSERT_TRUE(step());
    Scene other = scene({"uEta", "uMix"});
    other.programs[0].uniforms[1].values[1] = .75;
    EXPECT_EQ(edit(other), "") << "of another number";
    EXPECT_EQ(value(0), 1.25);
    Scene edited = other;
    edited.programs[0].uniforms[0].values[1] = 1.5;
    EXPECT_EQ(edit(edited), "Glass.uEta 1.25 was replaced by the file's 1.5; Ctrl+Z brings it back");
    EXPECT_EQ(value(0), 1.5);
    EXPECT_FALSE(step()) << "it is a step already";
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.5 \u2192 1.25");
    EXPECT_EQ(redo(), "redo: Glass.uEta 1.25 \u2192 1.5");
    undo();
    EXPECT_EQ(undo(), "undo: Glass.uEta 1.25 \u2192 1.5") << "the text's, which is another now";
    value(0) = 1.75;
    value(1) = 1;
    ASSERT_TRUE(step());
    EXPECT_EQ(edit(scene({"uEta", "uMix"})), "2 values were replaced by the file's; Ctrl+Z brings them back");
    EXPECT_EQ(undo(), "undo: 2 values");
    EXPECT_EQ(value(0), 1.75);
    EXPECT_EQ(value(1), 1);
    edited.programs[0].uniforms[0].values[1] = 1.75;
    EXPECT_EQ(edit(edited), "Glass.uMix 1 was replaced by the file's 0.75; Ctrl+Z brings it back")
        << "the other is what the user has";
}

TEST(UndoOfPrograms, OfOneNameChangesTheOneThatWasChanged) {
    const auto scene_of = [](const std::vector<const char*>& files) {
        Scene scene =
            scene_with(std::vector<ProgramLine>(files.size(), {"Glass", {value_of("u", Kind::range, {0, .5, 2})}}));
        for (std::size_t i = 0; i < files.size(); ++i)
            scene.programs[i].stages[static_cast<std::size_t>(Stage::fragment)] = FileName{files[i], {}};
        return scene;
    };
    Scene scene;
    Controls controls;
    View view;
    History history;
    const auto read = [&](const std::vector<const char*>& files) {
        Scene next = scene_of(files);
        std::vector<ActiveUniform> uniforms(1, active("float"));
        uniforms[0].name = "u";
        Diagnostics ignored;
        Controls fresh = make_controls(next, std::vector(files.size(), uniforms), ignored);
        carry_over(controls, scene, fresh, next);
        scene = std::move(next);
        controls = std::move(fresh);
    };
    const auto reread = [&](const std::vector<const char*>& files) {
        read(files);
        history.reread(scene, controls, view);
    };
    const auto undo = [&] { return history.undo({scene, controls, view, [] {}}); };
    read({"a", "b"});
    history.begin(scene, controls, view);
    controls.items[0].value = {1};
    ASSERT_TRUE(history.follow(scene, controls, view, {false, 1, 1}));
    controls.items[1].value = {1.5};
    ASSERT_TRUE(history.follow(scene, controls, view, {false, 2, 2}));
    reread({"b"});
    EXPECT_EQ(undo(), "undo: Glass.u 1.5 \u2192 0.5");
    EXPECT_EQ(history.redo({scene, controls, view, [] {}}), "redo: Glass.u 0.5 \u2192 1.5");
    reread({"b", "c"});
    EXPECT_EQ(undo(), "undo: Glass.u 1.5 \u2192 0.5");
    EXPECT_EQ(undo(), "nothing to undo") << "a is gone, and c is not a";
    reread({"a", "b"});
    controls.items[0].value = {1};
    EXPECT_EQ(controls.items[1].value, Values{.5});
    history.begin(scene, controls, view);
    EXPECT_EQ(history.redo({scene, controls, view, [] {}}), "redo: Glass#2.u 0.5 \u2192 1.5");
}

TEST(UndoOfPrograms, WhatNobodyCanTellApartIsDroppedAndSaid) {
    struct Row {
        std::vector<double> before, now;  // numbers of the lines
        std::vector<double> values;       // that the user sets before
        const char *said, *undone;
        std::vector<double> left;  // after undo
    };
    const auto scene_of = [](const std::vector<double>& lines) {
        std::vector<ProgramLine> programs;
        for (const double number : lines) programs.push_back({"Glass", {value_of("u", Kind::range, {0, number, 2})}});
        return scene_with(programs);
    };
    const auto controls_of = [](const Scene& scene) {
        std::vector<ActiveUniform> uniforms(1, active("float"));
        uniforms[0].name = "u";
        Diagnostics ignored;
        return make_controls(scene, std::vector(scene.programs.size(), uniforms), ignored);
    };
    // With the lines as before, none of them has a value that any of them had.
    const auto expect_forgotten = [&](History& history, Remembered& kept, const Scene& scene, const Scene& before) {
        Controls between = controls_of(scene), again = controls_of(before);
        recall(kept, scene, between);
        remember(scene, between, kept);
        carry_over(between, scene, again, before);
        recall(kept, before, again);
        EXPECT_EQ(values_of(again), values_of(controls_of(before)));
        View view;
        history.reread(scene, between, view);
        history.reread(before, again, view);
        EXPECT_EQ(history.undo({before, again, view, [] {}}), "nothing to undo");
        EXPECT_EQ(values_of(again), values_of(controls_of(before)));
    };
    for (const Row& row : {Row{{.5, .5, .5},
                               {.5, .5},
                               {.51, .52, .53},
                               "3 values were dropped: which program of the name is which is not known; Ctrl+Z sets "
                               "them by their numbers",
                               "undo: 2 values",
                               {.51, .52}},
                           Row{{.5, .5, .5},
                               {.5, .5},
                               {.51, .5, .5},
                               "Glass.u 0.51 was dropped: which program of the name is which is not known; Ctrl+Z sets "
                               "them by their numbers",
                               "undo: Glass.u 0.5 \u2192 0.51",
                               {.51, .5}},
                           Row{{.5, .5, .5},
                               {.5, .5},
                               {.5, .5, .53},
                               "Glass#3.u 0.53 was dropped: which program of the name is which is not known",
                               "nothing to undo",
                               {.5, .5}},
                           Row{{.1, .2},
                               {.3, .3, .3},
                               {.1, 1},
                               "Glass#2.u 1 was dropped: which program of the name is which is not known; "
                               "Ctrl+Z sets them by their numbers",
                               "undo: Glass#2.u 0.3 \u2192 1",
                               {.3, 1, .3}},
                           Row{{.1, .2}, {.2}, {1, 1.5}, "", "undo: Glass.u 1.5 \u2192 0.2", {.2}},
                           Row{{.1, .2}, {.2}, {.1, .1}, "", "undo: Glass.u 0.1 \u2192 0.2", {.2}}}) {
        SCOPED_TRACE(row.said);
        const Scene before = scene_of(row.before), scene = scene_of(row.now);
        Controls old = controls_of(before), controls = controls_of(scene);
        View view;
        History history;
        history.begin(before, old, view);
        Remembered kept;
        for (std::size_t i = 0; i < row.values.size(); ++i) old.items[i].value = {row.values[i]};
        ASSERT_TRUE(history.follow(before, old, view, {false, 1, 1}));
        remember(before, old, kept);
        carry_over(old, before, controls, scene);
        const std::string_view said = row.said;
        EXPECT_EQ(lost_values(kept, scene, controls), said.substr(0, said.find("; Ctrl+Z")));
        History other = history;
        EXPECT_EQ(history.reread(scene, controls, view), said);
        EXPECT_EQ(history.undo({scene, controls, view, [] {}}), row.undone);
        EXPECT_EQ(values_of(controls), row.left);
        if (said.find("dropped") != said.npos) expect_forgotten(other, kept, scene, before);
    }
}

TEST_F(Undo, AValueOfLastTimeThatTheTextReplacedIsSaid) {
    value(0) = 1.25;
    Remembered kept;
    remember(scene_, controls_, kept);
    EXPECT_EQ(lost_values(kept, scene_, controls_), "");
    Scene edited = scene_;
    edited.programs[0].uniforms[0].values[1] = 1.5;
    EXPECT_EQ(lost_values(kept, edited, fresh(edited)), "Glass.uEta 1.25 was replaced by the file's 1.5");
    edited.programs[0].uniforms[0].values[1] = 1.25;
    EXPECT_EQ(lost_values(kept, edited, fresh(edited)), "") << "it is what the user had";
}

// The program uses the uniform still, but for one save its line does not list it.
TEST_F(Undo, AStepOfAValueThatWasNotListedForAWhileIsThatStepAgain) {
    value(0) = .9;
    ASSERT_TRUE(step());
    Remembered memory;
    remember(scene_, controls_, memory);
    Diagnostics ignored;
    std::vector<ActiveUniform> uniforms(2, active("float"));
    uniforms[0].name = "uMix";
    uniforms[1].name = "uEta";
    scene_ = scene({"uMix"});
    controls_ = make_controls(scene_, {uniforms}, ignored);
    history_.reread(scene_, controls_, view_);
    remember(scene_, controls_, memory);
    scene_ = scene({"uEta", "uMix"});
    controls_ = fresh(scene_);
    recall(memory, scene_, controls_);
    ASSERT_EQ(value(0), .9);
    history_.reread(scene_, controls_, view_);
    EXPECT_FALSE(step()) << "an edit is not a step";
    EXPECT_EQ(undo(), "undo: Glass.uEta 0.9 \u2192 0.5");
    EXPECT_EQ(redo(), "redo: Glass.uEta 0.5 \u2192 0.9");
}

TEST_F(Undo, AStepThatChangesNothingIsSkipped) {
    value(1) = 1.5;
    ASSERT_TRUE(step());
    value(0) = .9;
    ASSERT_TRUE(step());
    value(0) = .5;  // not by the user
    history_.begin(scene_, controls_, view_);
    EXPECT_EQ(undo(), "undo: Glass.uMix 1.5 \u2192 0.5");
    EXPECT_EQ(redo(), "redo: Glass.uMix 0.5 \u2192 1.5");
    EXPECT_EQ(redo(), "redo: Glass.uEta 0.5 \u2192 0.9");
}

TEST_F(Undo, AStepOfARangeAloneNamesTheRange) {
    controls_.items[0].max = 5;
    ASSERT_TRUE(step());
    EXPECT_EQ(undo(), "undo: Glass.uEta range 0 to 5 \u2192 0 to 2");
}

TEST_F(Undo, ObjectsAreFoundAgain) {
    scene_.draws = {Draw{.shape = Sphere{}}, Draw{.shape = Torus{}}};
    history_.begin(scene_, controls_, view_);
    view_.objects[1].x = 2;
    step();
    Scene longer = scene_;
    longer.draws.insert(longer.draws.begin(), Draw{.shape = Box{}});
    carry_objects(object_names(scene_), object_names(longer), view_);
    scene_ = longer;
    history_.reread(scene_, controls_, view_);
    EXPECT_FALSE(step());
    undo();
    EXPECT_TRUE(view_.objects.empty());
    redo();
    ASSERT_EQ(view_.objects.size(), 1U);
    EXPECT_EQ(view_.objects.begin()->first, 2U) << "the torus";
}

TEST_F(Undo, ThousandStepsAreKeptAndNoMore) {
    for (int i = 1; i <= 1500; ++i) {
        value(0) = i / 1000.;
        step();
    }
    EXPECT_EQ(history_.size(), History::most_steps);
    std::size_t undone = 0;
    while (undo() != "nothing to undo") ++undone;
    EXPECT_EQ(undone, History::most_steps);
    EXPECT_EQ(value(0), .5) << "the 500th step";
}

TEST_F(Undo, MotionsThatUndoEndsAreNoMoreThanThousandSteps) {
    for (int i = 1; i <= 1500; ++i) {
        value(0) = i / 1000.;
        history_.follow(scene_, controls_, view_, {.presses = ++presses_, .undone = true});
        undo();
    }
    EXPECT_EQ(history_.size(), History::most_steps);
    EXPECT_EQ(history_.done(), 0U);
}

TEST_F(Undo, MemoryIsBounded) {
    scene_ = scene_with({{"Glass", {value_of("uMany", Kind::array, Values(100000, 1.))}}});
    ActiveUniform many = active("float", 100000);
    many.name = "uMany";
    Diagnostics ignored;
    controls_ = make_controls(scene_, {{many}}, ignored);
    history_.begin(scene_, controls_, view_);
    for (int i = 0; i < 30; ++i) {
        controls_.items[0].value[0] = i + 2;
        step();
        EXPECT_LE(history_.bytes(), History::most_bytes);
    }
    EXPECT_GE(history_.size(), 5U);
}

class UndoOfSaves : public Undo {
protected:
    UndoOfSaves() {
        for (const char* text : {"one", "two"}) {
            value(0) += .1;
            step();
            history_.add(std::string("save ") + text, {{file_, bytes_of(file_), text}});
            folder_.write("a.glib", text);
        }
    }
    std::string go(bool forward) {
        UserState now = state();
        now.exchange = [this](const std::vector<SavedFile>& files, bool onward) {
            return full_ ? "a.glib: No space left on device" : exchange_saved(files, onward);
        };
        return forward ? history_.redo(now) : history_.undo(now);
    }

    const Scratch folder_;
    std::string file_ = folder_.write("a.glib", "zero");
    bool full_ = false;
};

TEST_F(UndoOfSaves, WhatCouldNotBeExchangedIsTriedAgain) {
    full_ = true;
    EXPECT_EQ(go(false), "not undone: a.glib: No space left on device");
    full_ = false;
    EXPECT_EQ(go(false), "undo: save two");
    EXPECT_EQ(bytes_of(file_), "one");
    full_ = true;
    EXPECT_EQ(go(true), "not redone: a.glib: No space left on device");
    full_ = false;
    EXPECT_EQ(go(true), "redo: save two");
    EXPECT_EQ(bytes_of(file_), "two");
    for (const char* what : {"save two", "Glass.uEta 0.7 \u2192 0.6", "save one", "Glass.uEta 0.6 \u2192 0.5"})
        EXPECT_EQ(go(false), std::string("undo: ") + what);
    EXPECT_EQ(bytes_of(file_), "zero");
}

TEST_F(UndoOfSaves, WhatCannotBeExchangedIsLeftOutOnTheWayBackAndForth) {
    full_ = true;
    go(false);
    EXPECT_EQ(go(false), "undo: Glass.uEta 0.7 \u2192 0.6; save two is not undone");
    EXPECT_EQ(go(true), "redo: Glass.uEta 0.6 \u2192 0.7");
    EXPECT_EQ(go(true), "nothing to redo") << "the file is so already";
    full_ = false;
    EXPECT_EQ(go(false), "undo: save two") << "it is tried again";
    full_ = true;
    go(true);
    EXPECT_EQ(go(true), "not redone: a.glib: No space left on device") << "there is nothing behind it";
    full_ = false;
    EXPECT_EQ(go(true), "redo: save two");
    EXPECT_EQ(bytes_of(file_), "two");
}

TEST_F(UndoOfSaves, AMotionThatUndoEndsKeepsWhatCanBeRedone) {
    go(false);
    const std::vector<Animated> moving{{0, "uMix"}};
    value(1) = .7;
    history_.follow(scene_, controls_, view_, {.moving = moving});
    const std::size_t bytes = history_.bytes();
    EXPECT_TRUE(history_.follow(scene_, controls_, view_, {.presses = ++presses_, .undone = true}));
    EXPECT_GT(history_.bytes(), bytes);
    EXPECT_EQ(go(false), "undo: Glass.uMix 0.7 \u2192 0.5");
    EXPECT_EQ(go(true), "redo: Glass.uMix 0.5 \u2192 0.7");
    EXPECT_EQ(go(true), "redo: save two");
    EXPECT_EQ(bytes_of(file_), "two");
}

TEST_F(UndoOfSaves, AChangeInBetweenBeginsAnew) {
    full_ = true;
    EXPECT_EQ(go(false), "not undone: a.glib: No space left on device");
    value(1) = 1;
    step();
    EXPECT_EQ(go(false), "undo: Glass.uMix 1 \u2192 0.5");
    EXPECT_EQ(go(false), "not undone: a.glib: No space left on device");
    EXPECT_EQ(go(true), "redo: Glass.uMix 0.5 \u2192 1");
    EXPECT_EQ(go(false), "undo: Glass.uMix 1 \u2192 0.5");
    EXPECT_EQ(go(false), "not undone: a.glib: No space left on device");
    EXPECT_EQ(bytes_of(file_), "two");
}

// Random changes and ways through the history, against a list of whole states.
TEST_F(Undo, AnyWayBackGivesTheSameBits) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1e3, 1e3);
    struct Whole {
        double a, b;
        View view;
        bool operator==(const Whole&) const = default;
    };
    const auto now = [&] { return Whole{value(0), value(1), view_}; };
    std::vector<Whole> states{now()};
    std::size_t at = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto what = random() % 5;
        if (what == 0 && at > 0) {
            undo();
            --at;
        } else if (what == 1 && at + 1 < states.size()) {
            redo();
            ++at;
        } else {
            if (what < 4) value(random() % 2) = any(random);
            if (what > 2) view_.scene.rotate_x = any(random);
            if (!step()) continue;
            states.resize(++at);
            states.push_back(now());
        }
        ASSERT_TRUE(now() == states[at]) << i;
    }
    while (at > 0 && undo() != "nothing to undo") --at;
    EXPECT_TRUE(now() == states[at]);
}

TEST_F(Undo, AReplacedSnapshotComesBackUnlessItsFileChanged) {
    const Scratch folder;
    const std::string file = folder.write("a.snapshots.json", "new");
    history_.add("snapshot 3", {{file, "old", "new"}});
    EXPECT_EQ(undo(), "undo: snapshot 3");
    EXPECT_EQ(bytes_of(file), "old");
    EXPECT_EQ(redo(), "redo: snapshot 3");
    EXPECT_EQ(bytes_of(file), "new");
    folder.write("a.snapshots.json", "of someone else");
    EXPECT_EQ(undo().substr(0, 12), "not undone: ");
    EXPECT_EQ(bytes_of(file), "of someone else");
    EXPECT_EQ(undo().substr(0, 12), "not undone: ") << "there is nothing else";
    const std::string first = folder.write("b.snapshots.json", "first");
    history_.add("snapshot 1", {{first, "", "first"}});
    undo();
    EXPECT_FALSE(std::filesystem::exists(first)) << "there was no file before";
}

}  // namespace
}  // namespace snell
