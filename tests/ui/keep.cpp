// What is kept and saved: buttons and keys become requests, fields become numbers.
#include <imgui.h>

#include <cmath>

#include "tests/ui/screen.h"

namespace snell::ui {

namespace {

class UiKeep : public UiTest {
protected:
    // The requests of the frame in which the button went up.
    // `menu`: what the widget is an entry of.
    Requests clicked(const std::string& widget, Modifiers modifiers = {}, const char* menu = nullptr) {
        if (menu) click(place(std::string("menu.") + menu));
        const Rect at = place(widget);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        if (modifiers.ctrl)
            frame({{.kind = Event::Kind::key, .key = Key::other, .down = true, .modifiers = modifiers}});
        frame({button(true, MouseButton::left, modifiers)});
        const Requests down = requests_;
        frame({button(false, MouseButton::left, modifiers)});
        const Requests up = requests_;
        if (modifiers.ctrl) frame({{.kind = Event::Kind::key, .key = Key::other, .down = false}});
        return down.picture == PictureRequest::none ? up : down;
    }
    Requests pressed(Key which, Modifiers modifiers = {}) {
        frame({{.kind = Event::Kind::key, .key = which, .down = true, .modifiers = modifiers}});
        const Requests requests = requests_;
        frame({{.kind = Event::Kind::key, .key = which, .down = false}});
        return requests;
    }
    static Key digit(int number) { return static_cast<Key>(static_cast<int>(Key::one) + number - 1); }
};

TEST_F(UiKeep, SaveAsSaysInWhichFolder) {
    open_save_as(memory_.save_as, "a.glib", "~/scenes");
    EXPECT_TRUE(has("save as folder"));
    EXPECT_EQ(place("save as folder").width, ImGui::CalcTextSize("in ~/scenes").x);
    memory_.save_as.open = false;
    frame();
    open_save_as(memory_.save_as, "x/a.glib", "~/scenes");
    EXPECT_EQ(place("save as folder").width,
              ImGui::CalcTextSize("with the files that the scene would not find there").x);
    memory_.save_as.place = "as ~/scenes/x/room/a.glib, with its files";
    EXPECT_EQ(place("save as folder").width, ImGui::CalcTextSize(memory_.save_as.place.c_str()).x);
    memory_.save_as.open = false;
    open_save_as(memory_.save_as, "a.glib", "");
    EXPECT_FALSE(has("save as folder"));
}

TEST_F(UiKeep, TheTimeHasItsUnit) {
    facts_.animated = facts_.timed = true;
    const Rect field = place("time"), unit = place("time.unit");
    EXPECT_EQ(unit.width, ImGui::CalcTextSize("s").x);
    EXPECT_LT(unit.x - field.x - field.width, ImGui::GetFontSize());
}

TEST_F(UiKeep, RewindBeginsAgainAndGoesOn) {
    facts_.animated = facts_.timed = true;
    memory_.clock.time = 7.5;
    click(place("rewind"));
    EXPECT_EQ(memory_.clock.time, 0);
    EXPECT_FALSE(memory_.clock.paused);
}

TEST_F(UiKeep, EveryDigitIsASnapshot) {
    for (int number = 1; number <= snapshot_count; ++number) {
        EXPECT_EQ(pressed(digit(number)).restore_snapshot, number);
        EXPECT_EQ(pressed(digit(number)).store_snapshot, 0);
        EXPECT_EQ(pressed(digit(number), {.ctrl = true}).store_snapshot, number);
        EXPECT_EQ(pressed(digit(number), {.ctrl = true}).restore_snapshot, 0);
    }
    EXPECT_EQ(pressed(Key::zero).restore_snapshot, 0);
}

TEST_F(UiKeep, SnapshotButtonsStoreWhatIsNotThereAndRestoreWhatIs) {
    facts_.snapshots[4] = true;
    EXPECT_EQ(clicked("snapshot 3").store_snapshot, 3);
    const Requests there = clicked("snapshot 4");
    EXPECT_EQ(there.restore_snapshot, 4);
    EXPECT_EQ(there.store_snapshot, 0);
    EXPECT_EQ(clicked("snapshot 4", {.ctrl = true}).store_snapshot, 4);
}

TEST_F(UiKeep, StoredSnapshotsAreMarkedAndDeletedByTheirMenu) {
    facts_.snapshots[4] = true;
    EXPECT_FALSE(has("snapshot 3.stored"));
    EXPECT_TRUE(has("snapshot 4.stored"));
    for (const auto& [number, entry] : {std::pair(3, "store"), {4, "store"}, {3, "delete"}, {4, "delete"}}) {
        const std::string button = "snapshot " + std::to_string(number);
        click(place(button), MouseButton::right);
        const Requests asked = clicked(button + "." + entry);
        const bool stores = std::string(entry) == "store";
        EXPECT_EQ(asked.store_snapshot, stores ? number : 0);
        EXPECT_EQ(asked.delete_snapshot, !stores && number == 4 ? 4 : 0) << "there is none to delete";
        EXPECT_EQ(asked.restore_snapshot, 0);
        frame({key(Key::escape, true)});
        frame({key(Key::escape, false)});
    }
}

TEST_F(UiKeep, DigitsThatAreTypedAreNoSnapshots) {
    add_slider("uEta", .1, 1.1, 5);
    click(place("Glass.uEta"), MouseButton::left, .5, {.ctrl = true});
    frame({key(Key::one, true), {.kind = Event::Kind::text, .text = U'1'}});
    EXPECT_EQ(requests_.restore_snapshot, 0);
    frame({key(Key::one, false)});
}

TEST_F(UiKeep, SavingAsksForItOnlyWhereThereIsSomething) {
    facts_.changed = false;
    EXPECT_FALSE(clicked("save", {}, "save").save);
    frame({key(Key::escape, true)});
    frame({key(Key::escape, false)});
    facts_.changed = true;
    EXPECT_TRUE(clicked("save", {}, "save").save);
    EXPECT_TRUE(pressed(Key::s, {.ctrl = true}).save);
    const Requests as = pressed(Key::s, {.shift = true, .ctrl = true});
    EXPECT_TRUE(as.save_as);
    EXPECT_FALSE(as.save);
}

TEST_F(UiKeep, UndoAndRedoHaveTheirKeysAndFieldsHaveTheirOwn) {
    EXPECT_TRUE(pressed(Key::z, {.ctrl = true}).undo);
    EXPECT_TRUE(pressed(Key::z, {.shift = true, .ctrl = true}).redo);
    EXPECT_TRUE(pressed(Key::y, {.ctrl = true}).redo);
    EXPECT_FALSE(pressed(Key::z).undo);
    EXPECT_FALSE(pressed(Key::z, {.shift = true, .ctrl = true}).undo);
    add_slider("uEta", .1, 1.1, 5);
    click(place("Glass.uEta"), MouseButton::left, .5, {.ctrl = true});
    EXPECT_FALSE(pressed(Key::z, {.ctrl = true}).undo) << "a number is being typed";
}

TEST_F(UiKeep, UndoWaitsUntilNoButtonIsDown) {
    add_slider("uEta", .1, 1.1, 5);
    const Rect track = place("Glass.uEta");
    for (const Rect& at : {track, Rect{300, 300, 2, 2}}) {
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        frame({button(true)});
        frame({move(at.x + at.width / 3, at.y + at.height / 2)});
        EXPECT_FALSE(pressed(Key::z, {.ctrl = true}).undo);
        EXPECT_FALSE(pressed(Key::y, {.ctrl = true}).redo);
        frame({button(false)});
        frame();
        EXPECT_TRUE(pressed(Key::z, {.ctrl = true}).undo);
    }
}

TEST_F(UiKeep, TheNameOfAnotherSceneIsAskedFor) {
    open_save_as(memory_.save_as, "room.glib");
    frame();
    EXPECT_TRUE(clicked("save as save").save_as_now);
    EXPECT_FALSE(pressed(Key::z, {.ctrl = true}).undo) << "keys are the dialog's";
    EXPECT_FALSE(has("save as error"));
    memory_.save_as.error = "the scene would not find glass.vert from there";
    frame();
    EXPECT_TRUE(has("save as error"));
    clicked("save as cancel");
    EXPECT_FALSE(memory_.save_as.open);
}

TEST_F(UiKeep, TheNameOfAPageIsAskedForByItself) {
    EXPECT_TRUE(clicked("page", {}, "save").save_page);
    frame({key(Key::escape, true)});
    frame({key(Key::escape, false)});
    open_save_as(memory_.save_page, "room.html");
    frame();
    EXPECT_FALSE(has("save as save"));
    const Requests saved = clicked("save page save");
    EXPECT_TRUE(saved.save_page_now);
    EXPECT_FALSE(saved.save_as_now);
    EXPECT_FALSE(pressed(Key::z, {.ctrl = true}).undo) << "keys are the dialog's";
    clicked("save page cancel");
    EXPECT_FALSE(memory_.save_page.open);
}

TEST_F(UiKeep, TheMenuOfANameMakesASliderLogarithmic) {
    add_slider("uEta", .01, 1, 100);
    const auto at_half = [&] {
        click(place("Glass.uEta"), MouseButton::left, .5);
        return controls_.items[0].value[0];
    };
    EXPECT_NEAR(at_half(), 50, 1);
    click(place("uEta.name"), MouseButton::right);
    click(place("uEta.logarithmic"));
    EXPECT_NEAR(at_half(), 1, .05) << "equal ways are equal ratios";
    click(place("uEta.name"), MouseButton::right);
    click(place("uEta.logarithmic"));
    EXPECT_NEAR(at_half(), 50, 1) << "and back";
}

TEST_F(UiKeep, WhatReachesZeroIsNeverLogarithmic) {
    add_slider("uMix", 0, .5, 1);
    click(place("uMix.name"), MouseButton::right);
    click(place("uMix.logarithmic"));
    EXPECT_TRUE(memory_.logarithmic.empty());
    click({1, 1, 1, 1});  // the menu stays open until then
    click(place("Glass.uMix"), MouseButton::left, .25);
    EXPECT_NEAR(controls_.items[0].value[0], .25, .02);
}

TEST_F(UiKeep, TheMenuAndTheSectionResetToTheScenesValues) {
    add_slider("uEta", .1, 1.1, 5);
    add_slider("uMix", 0, .5, 1);
    EXPECT_FALSE(has("Glass.reset")) << "nothing moved";
    controls_.items[0].value = {3};
    controls_.items[1].value = {.9};
    click(place("uEta.name"), MouseButton::right);
    click(place("uEta.reset"));
    EXPECT_EQ(controls_.items[0].value[0], 1.1);
    EXPECT_EQ(controls_.items[1].value[0], .9) << "the other stays";
    controls_.items[0].value = {4};
    add_program("Other");
    add_slider("uEta", .1, 2, 5).value = {3};
    click(place("Glass.reset"));
    EXPECT_EQ(controls_.items[0].value[0], 1.1);
    EXPECT_EQ(controls_.items[1].value[0], .5);
    EXPECT_EQ(controls_.items[2].value[0], 3) << "of that section only";
}

TEST_F(UiKeep, ThePictureWindowAsksAndIsAsked) {
    EXPECT_EQ(clicked("picture", {}, "save").picture, PictureRequest::open);
    memory_.picture.open = true;
    memory_.picture.width = 640;
    memory_.picture.height = 480;
    EXPECT_EQ(clicked("picture save").picture, PictureRequest::save);
    EXPECT_EQ(clicked("picture command").picture, PictureRequest::command);
    memory_.scene = {0, 0, 500, 400};
    clicked("picture times 4");
    EXPECT_EQ(memory_.picture.width, 4 * memory_.scene.width);
    EXPECT_EQ(memory_.picture.height, 4 * memory_.scene.height);
    EXPECT_FALSE(has("picture sequence")) << "nothing moves";
    EXPECT_EQ(pressed(digit(1)).restore_snapshot, 0) << "keys are the window's";
    memory_.picture.progress = .25;
    EXPECT_FALSE(has("picture save"));
    EXPECT_EQ(clicked("picture stop").picture, PictureRequest::stop);
    memory_.picture.progress.reset();
    clicked("picture cancel");
    EXPECT_FALSE(memory_.picture.open);
}

TEST_F(UiKeep, ThePictureWindowSaysWhatIsSavedWhereSomethingElseIsSeen) {
    memory_.picture.open = true;
    memory_.picture.width = memory_.picture.height = 64;
    const StateFacts states;
    FoundFacts found;
    facts_.found = &found;
    EXPECT_FALSE(has("picture which"));
    facts_.states = &states;
    EXPECT_EQ(place("picture which").width, ImGui::CalcTextSize("of now, without the comparison").x);
    found.shown = "3";
    EXPECT_TRUE(has("picture which"));
    facts_.states = nullptr;
    EXPECT_EQ(place("picture which").width, ImGui::CalcTextSize("of the scene, without the found rung").x);
}

TEST_F(UiKeep, ASequenceSaysWhereItsPicturesGo) {
    memory_.picture.open = true;
    memory_.picture.width = memory_.picture.height = 64;
    memory_.picture.folder = "~/scenes";
    memory_.picture.names = "waves-0000.png, waves-0001.png \u2026";
    facts_.animated = true;
    EXPECT_TRUE(has("picture folder"));
    EXPECT_FALSE(has("picture names")) << "one picture";
    memory_.picture.sequence = true;
    EXPECT_TRUE(has("picture names"));
    memory_.picture.open = facts_.animated = false;
    click(place("menu.save"));
    const Rect at = place("sequence");
    frame({move(at.x + at.width / 2, at.y + at.height / 2)});
    frame({}, 1);
    EXPECT_TRUE(kit().tip.text.starts_with("Nothing moves")) << kit().tip.text;
}

TEST_F(UiKeep, ThePictureWindowRefusesNumbersThatItCannotTake) {
    struct Row {
        const char *field, *text, *wrong;
    };
    memory_.picture.open = true;
    memory_.picture.width = 640;
    memory_.picture.height = 480;
    memory_.picture.sequence = facts_.animated = true;
    memory_.picture.largest = 16384;
    memory_.picture.most = 1'000'000;
    for (const Row& row : {Row{"width", "0", "not from 1 to 16384"},
                           {"width", "1e9", "not from 1 to 16384"},
                           {"width", "100.5", "not a whole number"},
                           {"height", ".4", "not a whole number"},
                           {"height", "nan", "not a number"},
                           {"samples", "65", "not from 1 to 64"},
                           {"samples", "four", "not a number"},
                           {"rate", "0", "not from 0.001 to 100000"}}) {
        SCOPED_TRACE(row.text);
        const auto type_it = [&] {
            click(place(std::string("picture ") + row.field), MouseButton::left, .5, {.ctrl = true});
            std::vector<Event> events;
            for (const char* c = row.text; *c; ++c) events.push_back({.kind = Event::Kind::text, .text = char32_t(*c)});
            frame(events);
        };
        type_it();
        EXPECT_EQ(pressed(Key::enter).picture, PictureRequest::none);
        EXPECT_TRUE(kit().remark.shown);
        EXPECT_EQ(kit().remark.text, row.wrong) << "entered";
        EXPECT_STREQ(kit().typing.text.data(), row.text) << "the text stays";
        pressed(Key::escape);
        for (const char* taker : {"picture save", "picture command"}) {
            type_it();
            EXPECT_EQ(clicked(taker).picture, PictureRequest::none) << "a press of the button only leaves the field";
            EXPECT_TRUE(kit().remark.shown);
            EXPECT_EQ(kit().remark.text, "'" + std::string(row.text) + "' is " + row.wrong);
        }
        EXPECT_EQ(memory_.picture.width, 640);
        EXPECT_EQ(memory_.picture.height, 480);
        EXPECT_EQ(memory_.picture.samples, 4);
        EXPECT_EQ(memory_.picture.rate, 25);
        EXPECT_EQ(clicked("picture save").picture, PictureRequest::save) << "the next one saves what is seen";
    }
    const Rect width = place("picture width");
    frame({move(width.x + width.width / 2, width.y + width.height / 2)});
    frame({button(true)});
    frame({move(-1e5, width.y)});
    frame({button(false)});
    EXPECT_EQ(memory_.picture.width, 1) << "a drag ends at the limit";
}

TEST_F(UiKeep, APictureIsNamedWithoutAClick) {
    memory_.picture.open = true;
    has("picture file");
    type("a.png");
    EXPECT_STREQ(memory_.picture.file.data(), "a.png");
    memory_.picture.error = "there is no folder o";
    frame();
    EXPECT_EQ(pressed(Key::enter).picture, PictureRequest::save) << "it may have been made meanwhile";
}

TEST_F(UiKeep, AFileThatIsThereIsReplacedOnlyWhenAsked) {
    memory_.picture.open = true;
    std::string("a.png").copy(memory_.picture.file.data(), 5);
    EXPECT_FALSE(confirmed(memory_.picture, true, "folder/a.png")) << "the dialog asks";
    EXPECT_EQ(memory_.picture.existing, "a.png");
    EXPECT_EQ(clicked("picture save").picture, PictureRequest::save);
    EXPECT_TRUE(confirmed(memory_.picture, true, "folder/a.png"));
    EXPECT_FALSE(confirmed(memory_.picture, true, "folder/a.png")) << "the next time it asks again";
    memory_.picture.file[0] = 'b';
    EXPECT_FALSE(confirmed(memory_.picture, true, "folder/b.png")) << "another name";
    EXPECT_TRUE(confirmed(memory_.picture, false, "folder/b.png")) << "there is none";
}

TEST_F(UiKeep, ASequenceThatThereIsNotIsRefused) {
    PictureMemory& picture = memory_.picture;
    picture.open = picture.sequence = facts_.animated = true;
    picture.width = picture.height = 64;
    picture.most = 1'000'000;
    picture.from = 4;
    for (const auto& [to, problem] : {std::pair(-1., "-1 s is not after 4 s"),
                                      {4., "4 s is not after 4 s"},
                                      {1e9, "2.5e+10 pictures are more than 1000000"},
                                      {40005., "1.00002e+06 pictures are more than 1000000"},
                                      {5., ""},
                                      {4.001, ""}}) {
        picture.to = to;
        EXPECT_EQ(sequence_problem(picture), problem) << to;
        const bool taken = *problem == '\0';
        EXPECT_NE(has("sequence error"), taken) << to;
        EXPECT_EQ(clicked("picture save").picture, taken ? PictureRequest::save : PictureRequest::none) << to;
        EXPECT_EQ(clicked("picture command").picture, taken ? PictureRequest::command : PictureRequest::none) << to;
    }
    picture.to = -1;
    picture.sequence = false;
    EXPECT_EQ(clicked("picture save").picture, PictureRequest::save) << "of one picture";
}

TEST(PictureCount, EndsBeforeTheLastMoment) {
    PictureMemory picture;
    picture.most = 1'000'000;
    EXPECT_EQ(picture_count(picture), 1);
    picture.sequence = true;
    EXPECT_EQ(picture_count(picture), 250);
    picture.from = .1;
    picture.to = .4;
    picture.rate = 10;
    EXPECT_EQ(picture_count(picture), 3) << ".4 - .1 is a little less than .3";
    picture.to = -5;
    EXPECT_EQ(picture_count(picture), 1);
    picture.to = 1e300;
    EXPECT_EQ(picture_count(picture), 1000000);
}

}  // namespace

}  // namespace snell::ui
