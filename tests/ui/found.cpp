// The rungs that snell finds by itself, in the accuracy panel: what is listed, and what clicks and keys ask for.
#include "src/ui/panels/found.h"

#include "src/ui/panels/panels.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class FoundPanel : public UiTest {
protected:
    FoundPanel() {
        memory_.tab = Tab::tools;
        memory_.accuracy.open = true;
        facts_.found = &found_;
        screen_.height = 1600;
    }
    FoundRow& add(const std::string& name, FoundRow::Group group = FoundRow::Group::cheaper) {
        found_.asked = true;
        FoundRow& row = found_.rows.emplace_back();
        row.group = group;
        row.name = name;
        row.kind = "fewer-rounds";
        row.where = "glass.frag:12";
        row.place = {"/scenes/glass.frag", 12, 5};
        row.before = "i < 8";
        row.after = "i < 4";
        return row;
    }
    // Returns all requests that the click made, since they stand for one frame only.
    Requests clicked(const std::string& name, double fraction = .5) {
        const Rect at = place(name);
        frame({move(at.x + at.width * fraction, at.y + at.height / 2)});
        Requests all;
        for (const bool down : {true, false}) {
            frame({button(down)});
            if (requests_.show_rung) all.show_rung = requests_.show_rung;
            if (!requests_.edit.file.empty()) all.edit = requests_.edit;
            all.find_rungs |= requests_.find_rungs;
            all.write_rung |= requests_.write_rung;
            all.copy_rung |= requests_.copy_rung;
        }
        frame({}, 1);
        return all;
    }

    FoundFacts found_;
};

TEST_F(FoundPanel, ASearchOutOfSightIsSaidInTheStatusLine) {
    found_.asked = true;
    found_.progress = .4;
    EXPECT_FALSE(has("status.finding")) << "the panel shows it";
    memory_.tab = Tab::controls;
    EXPECT_TRUE(has("status.finding"));
    found_.progress.reset();
    EXPECT_FALSE(has("status.finding"));
}

TEST_F(FoundPanel, TheButtonStartsAndStopsTheSearch) {
    EXPECT_FALSE(has("found.none")) << "nobody asked";
    EXPECT_TRUE(clicked("found.find").find_rungs);
    EXPECT_FALSE(requests_.find_rungs) << "once";
    found_.asked = true;
    found_.progress = .5;
    found_.doing = "trying 3 of 8";
    EXPECT_TRUE(has("found.doing"));
    EXPECT_FALSE(has("found.none")) << "not yet";
    EXPECT_TRUE(clicked("found.find").find_rungs) << "it stops the search";
    found_.progress.reset();
    EXPECT_TRUE(has("found.none"));
    found_.note = "The files have errors.";
    EXPECT_FALSE(clicked("found.find").find_rungs);
    EXPECT_TRUE(has("found.note"));
}

TEST_F(FoundPanel, IsThereWithoutLaddersOnlyWhileAccuracyIsOpen) {
    EXPECT_TRUE(has("found.find"));
    EXPECT_FALSE(has("accuracy.plot"));
    memory_.accuracy.open = false;
    EXPECT_FALSE(has("found.find"));
}

TEST_F(FoundPanel, NoErrorIsNotVisible) {
    FoundRow& row = add("1");
    row.error = 1e-8;
    row.flip = 3.5e-6;
    const auto width = [&] { return place("found.error.1").width; };
    const float none = width();
    row.flip.reset();
    EXPECT_EQ(width(), none) << "no FLIP beside an error that is none";
    row.error = .1;
    row.flip = .2;
    EXPECT_GT(width(), none);
}

// The row's error is the largest of many views, the line's that of the picture.
TEST_F(FoundPanel, TheErrorOfThePictureNamesTheRowsOwn) {
    FoundRow& row = add("6");
    row.error = .0028;
    found_.shown = "6";
    EXPECT_EQ(error_line(.0016, shown_row(found_)).view(), "error .0016 of white here, worst .0028");
    EXPECT_EQ(error_line(0, shown_row(found_)).view(), "error none here, worst .0028");
    EXPECT_EQ(error_line(.0028, shown_row(found_)).view(), "error .0028 of white");
    row.error = 0;
    EXPECT_EQ(error_line(1.6e-6, shown_row(found_)).view(), "error none");
    found_.shown.clear();
    EXPECT_EQ(shown_row(found_), nullptr);
    EXPECT_EQ(error_line(.0016, nullptr).view(), "error .0016 of white");
}

TEST_F(FoundPanel, TooltipsSayWhatEachErrorIs) {
    AccuracyFacts accuracy;
    accuracy.samples = accuracy.wanted = 16;
    accuracy.of_scene = true;
    facts_.accuracy = &accuracy;
    add("6").error = .0028;
    const auto said = [&](const Rect& at, double down) {
        frame({move(at.x + at.width * .8, at.y + at.height * down)});
        frame({}, 1);
        frame({}, 1);
        return kit().tip.shown ? kit().tip.text : "";
    };
    for (const double down : {.1, .5, .9})
        EXPECT_NE(said(place("found.row.6"), down).find("of all views and values"), std::string::npos) << down;
    EXPECT_EQ(said(place("accuracy.error"), .5).find("Worst"), std::string::npos) << "the scene is shown";
    found_.shown = "6";
    EXPECT_NE(said(place("accuracy.error"), .5).find("Worst"), std::string::npos);
}

TEST_F(FoundPanel, ALegendSaysWhatNumbersAndFlipAre) {
    const std::string numbers = "found.legend.The number before a change names it for 'snell accuracy --apply'.";
    found_.asked = true;
    EXPECT_FALSE(has(numbers));
    add("1").error = .01;
    EXPECT_TRUE(has(numbers));
    found_.rows.back().flip = .1;
    EXPECT_TRUE(has(numbers + " FLIP is how visible an error is, from 0 to 1."));
}

TEST_F(FoundPanel, EachGroupHasItsHeading) {
    add("1").error = .01;
    EXPECT_TRUE(has("found.heading.Cheaper"));
    EXPECT_FALSE(has("found.heading.What the picture lacks"));
    EXPECT_FALSE(has("found.heading.Changes nothing"));
    add("2", FoundRow::Group::better);
    EXPECT_FALSE(has("found.heading.Not cheaper"));
    add("3", FoundRow::Group::unused);
    add("5", FoundRow::Group::dearer);
    const Rect dearer = place("found.heading.Not cheaper"), fourth = place("found.row.5");
    EXPECT_LT(place("found.row.1").y, dearer.y);
    EXPECT_LT(dearer.y, fourth.y);
    EXPECT_LT(fourth.y, place("found.heading.What the picture lacks").y);
    add("4", FoundRow::Group::untried).remark = "the time was up";
    const Rect cheaper = place("found.heading.Cheaper"), first = place("found.row.1");
    const Rect better = place("found.heading.What the picture lacks"), second = place("found.row.2");
    const Rect unused = place("found.heading.Changes nothing"), third = place("found.row.3");
    EXPECT_LT(cheaper.y, first.y);
    EXPECT_LT(first.y, better.y);
    EXPECT_LT(better.y, second.y);
    EXPECT_LT(second.y, unused.y);
    EXPECT_LT(unused.y, third.y);
    EXPECT_FALSE(has("found.row.4")) << "folded";
    click(place("found.untried"), MouseButton::left, .1);
    EXPECT_TRUE(has("found.row.4"));
    EXPECT_FALSE(clicked("found.row.4", .9).show_rung) << "there is no picture of it";
}

TEST_F(FoundPanel, AClickOnARowShowsItsPictureAndAnotherTheScene) {
    add("1");
    add("2+3");
    EXPECT_EQ(clicked("found.row.2+3", .9).show_rung, "2+3");
    EXPECT_EQ(clicked("found.row.1", .9).show_rung, "1");
    found_.shown = "1";
    EXPECT_EQ(clicked("found.row.1", .9).show_rung, "");
    EXPECT_EQ(clicked("found.row.2+3", .9).show_rung, "2+3") << "another one";
}

TEST_F(FoundPanel, AClickOnThePlaceOpensTheEditorAndNothingElse) {
    add("1");
    const Requests asked = clicked("found.place.1");
    EXPECT_EQ(asked.edit.file, "/scenes/glass.frag");
    EXPECT_EQ(asked.edit.line, 12);
    EXPECT_FALSE(asked.show_rung);
    found_.rows[0].place = {};
    frame({move(5, 5)});
    EXPECT_EQ(clicked("found.place.1").show_rung, "1") << "a built-in text has no place";
}

TEST_F(FoundPanel, EscapeEndsTheShowingBeforeAnythingElse) {
    memory_.hold.picking = true;
    add("1");
    found_.shown = "1";
    EXPECT_TRUE(has("status.found"));
    frame({key(Key::escape, true)});
    EXPECT_EQ(requests_.show_rung, "");
    EXPECT_TRUE(memory_.hold.picking);
    frame({key(Key::escape, false)});
    found_.shown.clear();
    EXPECT_FALSE(has("status.found"));
    frame({key(Key::escape, true)});
    EXPECT_FALSE(requests_.show_rung);
    EXPECT_FALSE(memory_.hold.picking);
}

TEST_F(FoundPanel, WhatIsShownCanBeWritten) {
    add("1");
    EXPECT_FALSE(clicked("found.write").write_rung) << "none is";
    EXPECT_TRUE(has("found.hint"));
    found_.shown = "1";
    EXPECT_TRUE(clicked("found.write").write_rung);
    EXPECT_TRUE(clicked("found.copy").copy_rung);
    open_save_as(memory_.write_rung, "room-rung-1");
    click(place("write rung save"));
    memory_.write_rung.open = true;
    frame({key(Key::escape, true)});
    EXPECT_FALSE(requests_.show_rung) << "the key is the dialog's";
    EXPECT_FALSE(memory_.write_rung.open);
}

TEST_F(FoundPanel, RungsOfAnOlderTextAreGrey) {
    add("1");
    found_.older = true;
    EXPECT_TRUE(has("found.older"));
    EXPECT_EQ(clicked("found.row.1", .9).show_rung, "1") << "the values are others, the rung is the same";
    found_.stale = true;
    EXPECT_TRUE(has("found.stale"));
    EXPECT_FALSE(has("found.older"));
    EXPECT_FALSE(clicked("found.row.1", .9).show_rung);
    EXPECT_TRUE(clicked("found.find").find_rungs) << "they can be sought again";
}

// Many rows cost no more than those in sight.
TEST_F(FoundPanel, OnlyRowsInSightAreDrawn) {
    screen_.height = 700;
    for (int i = 1; i <= 1000; ++i) add(std::to_string(i));
    frame();
    const auto drawn = std::ranges::count_if(
        layout_.items(), [](const Placed& placed) { return placed.name.starts_with("found.row."); });
    EXPECT_GT(drawn, 3);
    EXPECT_LT(drawn, 30);
    const Rect first = place("found.row.1"), second = place("found.row.2"), third = place("found.row.3");
    EXPECT_NEAR(second.y - first.y, third.y - second.y, .01);
}

// Whatever a click, the search or a measurement changes above them.
TEST_F(FoundPanel, RowsStayUnderThePointer) {
    for (const char* name : {"1", "2", "3"}) add(name).error = .01;
    const Rect before = place("found.row.2");
    EXPECT_EQ(clicked("found.row.2", .9).show_rung, "2");
    AccuracyFacts accuracy;
    accuracy.samples = accuracy.wanted = 16;
    facts_.accuracy = &accuracy;
    found_.shown = "2";
    found_.remark = "The time was up before every change was tried.";
    std::ranges::reverse(found_.rows);
    found_.rows.erase(found_.rows.begin());
    EXPECT_EQ(place("found.row.2").y, before.y);
    EXPECT_TRUE(has("found.row.3")) << "as it was";
    EXPECT_EQ(clicked("found.row.2", .9).show_rung, "") << "another click hits the same row";
    facts_.accuracy = nullptr;
    found_.shown.clear();
    found_.remark.clear();
    EXPECT_EQ(place("found.row.2").y, before.y);
    frame({move(5, 5)});
    EXPECT_LT(place("found.row.2").y, place("found.row.1").y) << "measured again";
    EXPECT_FALSE(has("found.row.3"));
}

TEST_F(FoundPanel, ButtonsStayUnderThePointerWhenTheSearchEnds) {
    add("1");
    found_.progress = .9;
    found_.doing = "trying 7 of 8";
    found_.shown = "1";
    const Rect before = place("found.write");
    frame({move(before.x + before.width / 2, before.y + before.height / 2)});
    found_.progress.reset();
    EXPECT_EQ(place("found.write").y, before.y);
    EXPECT_TRUE(clicked("found.write").write_rung);
    frame({move(5, 5)});
    EXPECT_LT(place("found.write").y, before.y) << "the room is given up";
}

TEST_F(FoundPanel, AChangeKeepsWhatDiffers) {
    frame();  // there are letters
    const std::string before = "vec3(uTint) + 4. * noise(vAt, 16) - bias",
                      after = "vec3(uTint) + 4. * noise(vAt, 8) - bias";
    const std::string whole = before + " \u2192 " + after;
    EXPECT_EQ(change_text(before, after, width_of(whole) + 1), whole);
    const std::string differs = "\u202616\u2026 \u2192 \u20268\u2026";
    EXPECT_EQ(change_text(before, after, width_of(whole) * .5F), differs);
    const std::string inserted = "CullFace back Sphere 1 60 60";
    EXPECT_EQ(change_text("Sphere 1 60 60", inserted, width_of(inserted)), "\u2026 \u2192 CullFace back \u2026");
    const std::string narrow = change_text("normalize(uMatrix * gl_Normal)", "uMatrix * gl_Normal", 10 * 16);
    EXPECT_LE(width_of(narrow), 10 * 16 + 1);
    EXPECT_NE(narrow.find(" \u2192 "), narrow.npos);
    EXPECT_TRUE(narrow.starts_with("nor") && narrow.find(" \u2192 uM") != narrow.npos) << narrow;
    // Where two changes are together, from the first one on.
    const std::string one = "vec4(0.25, 0., 0., 0.); float h = fbm(vAt * 12., 60",
                      other = "vec4(0.5, 0., 0., 0.); float h = fbm(vAt * 12., 30";
    const std::string first = change_text(one, other, width_of("\u20260.25,\u2026 \u2192 \u20260.5,\u2026") + 2);
    EXPECT_TRUE(first.starts_with("\u20260.25") && first.find(" \u2192 \u20260.5") != first.npos) << first;
    const std::string word =
        change_text("a = 1234567890", "a = 1234567990", width_of("\u202667\u2026 \u2192 \u202667\u2026"));
    EXPECT_TRUE(word.starts_with("\u20268") && word.find("\u2192 \u20269") != word.npos) << word;
}

TEST_F(FoundPanel, NarrowPanelsCutNoNumber) {
    memory_.panel_width = 13;
    FoundRow& row = add("1");
    row.error = .00123;
    row.flip = .000456;
    row.ratio = .72;
    row.low = .7;
    row.high = .75;
    add("2");
    const Rect first = place("found.row.1"), error = place("found.error.1");
    EXPECT_EQ(error.width, std::round(width_of("worst error .0012"))) << "FLIP has a line of its own";
    EXPECT_LE(error.x + error.width, first.x + first.width);
}

TEST_F(FoundPanel, TheSplitNamesTheRungAndTheScene) {
    AccuracyFacts accuracy;
    accuracy.samples = accuracy.wanted = 16;
    accuracy.of_scene = true;
    facts_.accuracy = &accuracy;
    add("1");
    found_.shown = "1";
    EXPECT_FALSE(has("accuracy.plot")) << "there is no ladder";
    click(place("accuracy.Split"), MouseButton::left, .2);
    EXPECT_EQ(memory_.accuracy.show, AccuracyMemory::Show::split);
    EXPECT_EQ(found_text(found_), "found rung 1");
    found_.shown = "1+2";
    EXPECT_EQ(found_text(found_), "found rungs 1+2");
}

TEST(FoundTexts, AreShort) {
    EXPECT_EQ(ratio_text(.724), "\u00D7.72");
    EXPECT_EQ(ratio_text(1.308), "\u00D71.31");
    EXPECT_EQ(ratio_text(12.4), "\u00D712");
}

}  // namespace
}  // namespace snell::ui
