// The accuracy panel and the list of costs, judged by what becomes of the input and by the colours and numbers shown.
#include "src/ui/panels/accuracy.h"

#include "parser/text/ranges.h"
#include "src/content/image/image.h"
#include "src/ui/panels/panels.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class AccuracyPanel : public UiTest {
protected:
    AccuracyPanel() {
        Ladder ladder;
        ladder.name = "FRESNEL";
        ladder.rungs = {"f0", "schlick", "exact"};
        ladder.current = 1;
        scene_.ladders.push_back(ladder);
        controls_.rungs = {1};
        values_.samples = values_.wanted = 16;
        memory_.tab = Tab::tools;
        values_.points = {{.name = "schlick", .rung = 1, .milliseconds = 2, .error = .01, .chosen = true},
                          {.name = "exact", .rung = 2, .milliseconds = 3, .error = 0}};
    }
    void open() {
        memory_.accuracy.open = true;
        facts_.accuracy = &values_;
    }

    StateFacts states_{{{"now", "now"}, {"saved", "as saved"}},
                       {{{"now", "now: uIndex 1.33"}, {"saved", "as saved: 2.4"}}}};
    AccuracyFacts values_;
};

TEST_F(AccuracyPanel, IsThereForEverySceneAndClosedAtFirst) {
    EXPECT_TRUE(has("accuracy"));
    EXPECT_FALSE(memory_.accuracy.open);
    EXPECT_FALSE(has("accuracy.plot"));
    scene_.ladders.clear();
    controls_.rungs.clear();
    EXPECT_TRUE(has("accuracy"));
    frame({key(Key::a, true)});
    EXPECT_TRUE(memory_.accuracy.open);
    EXPECT_FALSE(has("accuracy.plot")) << "there is no ladder";
    EXPECT_FALSE(has("accuracy.Split")) << "nor anything to compare with";
    no_scene_ = true;
    EXPECT_FALSE(has("accuracy"));
}

TEST_F(AccuracyPanel, OpensByAClickAndByAKey) {
    click(place("accuracy"));
    EXPECT_TRUE(memory_.accuracy.open);
    facts_.accuracy = &values_;
    EXPECT_TRUE(has("accuracy.plot"));
    frame({key(Key::a, true)});
    frame({key(Key::a, false)});
    EXPECT_FALSE(memory_.accuracy.open);
    frame({key(Key::a, true)});
    EXPECT_TRUE(memory_.accuracy.open);
}

TEST_F(AccuracyPanel, AClickInItsTableChoosesARung) {
    open();
    click(place("accuracy.rung.exact"), MouseButton::left, .1);
    EXPECT_EQ(controls_.rungs, Rungs{2});
}

TEST_F(AccuracyPanel, AsksForAMeasurementOnce) {
    open();
    const Rect button = place("accuracy.measure");
    frame({move(button.x + button.width / 2, button.y + button.height / 2)});
    frame({this->button(true)});
    EXPECT_FALSE(requests_.measure);
    frame({this->button(false)});
    EXPECT_TRUE(requests_.measure);
    frame();
    EXPECT_FALSE(requests_.measure);
}

TEST_F(AccuracyPanel, WithoutAReferenceThereIsNothingToMeasure) {
    open();
    values_.note = "The files have errors.";
    const Rect button = place("accuracy.measure");
    frame({move(button.x + button.width / 2, button.y + button.height / 2)});
    frame({this->button(true)});
    frame({this->button(false)});
    EXPECT_FALSE(requests_.measure);
}

TEST_F(AccuracyPanel, TheHintOfTheHiddenPanelIsAboveTheNamesOfTheStates) {
    memory_.accuracy.show = AccuracyMemory::Show::split;
    facts_.states = &states_;
    place("accuracy.swap");
    frame({key(Key::h, true)});
    frame({key(Key::h, false)});
    const Rect hint = place("hint");
    EXPECT_LE(hint.y + hint.height, place("accuracy.swap").y);
}

TEST_F(AccuracyPanel, TheDividerIsDraggedAndTheSceneIsNot) {
    open();
    memory_.accuracy.show = AccuracyMemory::Show::split;
    facts_.states = &states_;
    const Rect divider = place("accuracy.divider"), scene = memory_.scene;
    EXPECT_NEAR(divider.x + divider.width / 2, scene.x + scene.width / 2, 1);
    frame({move(divider.x + divider.width / 2, 300)});
    frame({button(true)});
    frame({move(scene.x + scene.width * .25, 320)});
    frame({move(scene.x + scene.width * .25, 330)});
    frame({button(false)});
    EXPECT_NEAR(memory_.accuracy.divider, .25, .01);
    EXPECT_EQ(view_.scene, Transformation{});
    // Escape restores where it was.
    frame({move(scene.x + scene.width * .25, 330)});
    frame({button(true)});
    frame({move(scene.x + scene.width * .7, 330)});
    frame({key(Key::escape, true)});
    frame({key(Key::escape, false), button(false)});
    EXPECT_NEAR(memory_.accuracy.divider, .25, .01);
    memory_.accuracy.show = AccuracyMemory::Show::picture;
    EXPECT_FALSE(has("accuracy.divider"));
}

TEST_F(AccuracyPanel, ThePlotSaysWhatItsMarksMeanAndNamesTheReference) {
    using Standing = AccuracyPoint::Standing;
    const auto says = [&](const std::string& words) {
        frame();
        return ranges::any_of(memory_.accuracy.plot.marks, [&](const content::Mark& m) { return m.text == words; });
    };
    open();
    values_.points = {{.name = "f0", .rung = 0, .milliseconds = 1, .error = .05},
                      // The other ladder is not at its last rung.
                      {.name = "exact, both", .milliseconds = 3, .error = 0, .reference = true}};
    EXPECT_TRUE(says("exact, both = reference"));
    const float before = place("accuracy.plot").height, row = place("accuracy.rung.exact").y;
    values_.measured = .5;
    EXPECT_EQ(place("accuracy.rung.exact").y, row) << "a measurement moves no row";
    values_.measured.reset();
    EXPECT_TRUE(says("not compared, or unsure"));
    for (const char* other : {"worth its time", "another is better", "is shown", "range of its time"})
        EXPECT_FALSE(says(other)) << "there is none";
    values_.points[0].standing = Standing::dominated;
    values_.points[0].chosen = true;
    values_.points[1].standing = Standing::front;
    values_.points[1].low = 2;
    values_.points[1].high = 4;
    EXPECT_FALSE(says("not compared, or unsure"));
    for (const char* words : {"worth its time", "another is better", "is shown", "range of its time"})
        EXPECT_TRUE(says(words)) << words;
    const Rect plot = place("accuracy.plot");
    EXPECT_EQ(plot.height, before) << "its room was there";
    for (const content::Mark& mark : memory_.accuracy.plot.marks) {
        EXPECT_LE(mark.at.x1, plot.x + plot.width) << mark.text;
        EXPECT_LE(mark.at.y1, plot.y + plot.height) << mark.text;
    }
}

TEST_F(AccuracyPanel, PlotsTheLadderThatWasChangedLastWhileItWasOutOfSight) {
    scene_.ladders.push_back(scene_.ladders[0]);
    scene_.ladders[1].name = "BEND";
    scene_.ladders[1].rungs = {"single", "bounces"};
    controls_.rungs = {1, 0};
    memory_.tab = Tab::controls;
    for (const auto& [ladder, rung] : {std::pair("FRESNEL", ".exact"), {"BEND", ".bounces"}}) {
        click(place(ladder));
        click(place(std::string(ladder) + rung));
    }
    ASSERT_EQ(controls_.rungs, (Rungs{2, 1}));
    facts_.accuracy = &values_;
    frame({key(Key::a, true)});
    frame({key(Key::a, false)});
    EXPECT_TRUE(has("accuracy.plot"));
    EXPECT_EQ(memory_.accuracy.ladder, 1U);
}

TEST_F(AccuracyPanel, PlotsTheLadderThatWasChangedLast) {
    scene_.ladders.push_back(scene_.ladders[0]);
    scene_.ladders[1].name = "BEND";
    scene_.ladders[1].rungs = {"single", "bounces"};
    controls_.rungs = {1, 0};
    open();
    frame();
    EXPECT_EQ(memory_.accuracy.ladder, 0U);
    controls_.rungs[1] = 1;
    frame();
    EXPECT_EQ(memory_.accuracy.ladder, 1U);
    click(place("accuracy.ladder"));
    click(place("accuracy.ladder.FRESNEL"));
    frame();
    EXPECT_EQ(memory_.accuracy.ladder, 0U) << "as the user says";
    memory_.accuracy.open = false;
    controls_.rungs[1] = 0;
    frame();
    memory_.accuracy.open = true;
    frame();
    EXPECT_EQ(memory_.accuracy.ladder, 1U) << "changed while the panel was closed";
}

TEST_F(AccuracyPanel, StatesAreChosenTypedAndSwapped) {
    EXPECT_EQ(memory_.accuracy.show, AccuracyMemory::Show::picture);
    frame({key(Key::s, true)});
    frame({key(Key::s, false)});
    EXPECT_EQ(memory_.accuracy.show, AccuracyMemory::Show::split) << "without the panel, too";
    facts_.states = &states_;
    const Rect first = place("accuracy.left");
    for (const float at : {.02F, .2F, .5F, .98F}) {
        memory_.accuracy.divider = at;
        EXPECT_EQ(place("accuracy.left"), first) << "one click more hits the same button";
        const Rect left = place("accuracy.left"), right = place("accuracy.right");
        EXPECT_GE(left.x, 0);
        EXPECT_LT(left.x + left.width, right.x);
        EXPECT_LE(right.x + right.width, memory_.scene.width);
        // The labels change while somebody uses the buttons.
        const Rect swap = place("accuracy.swap"), other = place("accuracy.other");
        const StateFacts before = states_;
        states_.sides[0].label = "n";
        states_.sides[1].label = "snapshot 1: uIndex 1.1, uDispersion .3, uThickness 2.5, uColor 1 .5 0";
        EXPECT_EQ(place("accuracy.swap"), swap);
        EXPECT_EQ(place("accuracy.right"), right);
        memory_.accuracy.show = AccuracyMemory::Show::heat;
        EXPECT_NEAR(place("accuracy.other").width, other.width, .1F) << "'Split' and 'Heat map' alike";
        memory_.accuracy.show = AccuracyMemory::Show::split;
        states_ = before;
    }
    click(place("accuracy.right"));
    click(place("right.saved"));
    EXPECT_EQ(memory_.accuracy.right, "saved");
    states_.example = "values, such as uRefractiveIndex=2.42";
    click(place("accuracy.left"));
    EXPECT_GE(place("left.settings").width, width_of(states_.example)) << "the example is whole";
    click(place("left.settings"));
    std::vector<Event> letters;
    for (const char c : std::string("uIndex=2.4"))
        letters.push_back({.kind = Event::Kind::text, .text = static_cast<char32_t>(c)});
    frame(letters);
    frame({key(Key::enter, true)});
    frame({key(Key::enter, false)});
    EXPECT_EQ(memory_.accuracy.left, "uIndex=2.4");
    states_.sides[0] = {.name = memory_.accuracy.left, .label = "uIndex=2.4: no such uniform", .failed = true};
    EXPECT_TRUE(has("left.settings")) << "a text that is refused stays";
    EXPECT_STREQ(memory_.accuracy.settings.data(), "uIndex=2.4");
    EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "what is typed next is no shortcut";
    EXPECT_TRUE(kit().remark.shown);
    EXPECT_EQ(kit().remark.text, "uIndex=2.4: no such uniform");
    states_.sides[0].failed = false;
    frame({key(Key::enter, true)});
    frame({key(Key::enter, false)});
    EXPECT_FALSE(has("left.settings"));
    EXPECT_FALSE(kit().remark.shown);
    states_.sides[1].name = memory_.accuracy.right;
    click(place("accuracy.swap"));
    EXPECT_EQ(memory_.accuracy.left, "saved");
    EXPECT_EQ(memory_.accuracy.right, "uIndex=2.4");
    click(place("accuracy.other"));
    EXPECT_EQ(memory_.accuracy.show, AccuracyMemory::Show::heat);
    EXPECT_TRUE(has("accuracy.left")) << "of the same two";
    EXPECT_TRUE(has("accuracy.legend")) << "what its colours mean";
    EXPECT_FALSE(has("accuracy.no number")) << "there is none";
    facts_.accuracy = &values_;
    values_.unknown = true;
    EXPECT_TRUE(has("accuracy.no number"));
    EXPECT_FALSE(has("accuracy.fixed"));
    states_.fixed = true;
    EXPECT_TRUE(has("accuracy.fixed")) << "why no slider changes anything";
    click(place("accuracy.other"));
    EXPECT_EQ(memory_.accuracy.show, AccuracyMemory::Show::split);
    frame({key(Key::s, true)});
    EXPECT_EQ(memory_.accuracy.show, AccuracyMemory::Show::picture);
}

TEST_F(AccuracyPanel, SaysHowTheTwoTimesAreMeant) {
    open();
    EXPECT_TRUE(has("accuracy.basis"));
    values_.clock = "process CPU time";
    facts_.samples = 4;
    EXPECT_EQ(
        basis_text(facts_).view(),
        "ms/sample compares rungs: process CPU time of all cores with one sample per pixel. The last picture's time "
        "is the wait for it, with 4 samples per pixel.");
    facts_.states = &states_;
    EXPECT_TRUE(basis_text(facts_).view().ends_with("4 samples per pixel in both states."));
}

TEST_F(AccuracyPanel, ColumnsAreHeaded) {
    open();
    for (const char* heading : {"rung", "ms/sample", "error"})
        EXPECT_TRUE(has(std::string("accuracy.heading.") + heading));
}

// Luminance tells them apart in print and for every eye.
TEST(Heat, GetsLighterAllTheWay) {
    double last = -1;
    for (int i = 0; i <= 100; ++i) {
        const auto [red, green, blue] = content::heat(i / 100.);
        const double luminance = .2126 * red + .7152 * green + .0722 * blue;
        EXPECT_GT(luminance, last) << i;
        last = luminance;
    }
    EXPECT_EQ(content::heat(-1), content::heat(0));
    EXPECT_EQ(content::heat(2), content::heat(1));
    EXPECT_EQ(content::heat(NAN), content::heat(1)) << "what is no number is as wrong as can be";
    EXPECT_LT(content::heat(0)[1], .04);
    EXPECT_GT(last, .9);
}

TEST(Texts, OfPicturesThatAreNotFiniteDoNotSayThatNothingDiffers) {
    const auto tip = [](double error, double psnr) { return error_tip({.error = error, .psnr = psnr}); };
    EXPECT_NE(tip(0, INFINITY).find("nothing differs"), std::string::npos);
    EXPECT_NE(tip(.1, 20).find("20.0 dB"), std::string::npos);
    for (const std::string& odd : {tip(INFINITY, -INFINITY), tip(NAN, NAN)}) {
        EXPECT_EQ(odd.find("nothing differs"), std::string::npos) << odd;
        EXPECT_NE(odd.find("there is no signal-to-noise ratio"), std::string::npos) << odd;
    }
}

TEST(Texts, AreShort) {
    EXPECT_EQ(error_text(0), "none");
    EXPECT_EQ(error_text(1.1e-8), "none") << "the same numbers, summed in another order";
    EXPECT_EQ(error_text(3.4e-6), "none") << "one sample of a pixel at an edge";
    EXPECT_EQ(error_text(2e-5), "2e-05");
    EXPECT_EQ(error_text(.0031415), ".0031");
    EXPECT_EQ(error_text(1.25), "1.2");
    EXPECT_EQ(error_text(NAN), "unknown");
    EXPECT_EQ(milliseconds_text(1.234), "1.23 ms");
    EXPECT_EQ(milliseconds_text(12.34), "12.3 ms");
    EXPECT_EQ(milliseconds_text(123.4), "123 ms");
    EXPECT_EQ(bytes_text(999), "999 B");
    EXPECT_EQ(bytes_text(4096), "4.1 kB");
    EXPECT_EQ(bytes_text(12600000), "13 MB");
}

class CostsPanel : public UiTest {
protected:
    Explanation explanation_;
};

TEST_F(CostsPanel, FoldsWhatIsPaidForByKind) {
    explanation_.paid.push_back({.kind = Explanation::Kind::image, .name = "wall.bmp", .why = "read", .bytes = 4096});
    explanation_.paid.push_back({.kind = Explanation::Kind::mesh, .name = "Sphere", .why = "drawn", .bytes = 100});
    const auto program = [](const char* name, const std::vector<Index>& programs) {
        return Explanation::Paid{
            .kind = Explanation::Kind::program, .name = name, .why = "drawn", .programs = programs};
    };
    for (const auto& [name, index] : {std::pair("Slow", 0), {"Slow, for any values", 0}, {"Fast", 1}})
        explanation_.paid.push_back(program(name, {static_cast<Index>(index)}));
    explanation_.unpaid.push_back({"Noise3", "inactive"});
    memory_.tab = Tab::tools;
    click(place("costs"));
    ASSERT_TRUE(memory_.costs);
    facts_.explanation = &explanation_;
    EXPECT_TRUE(has("costs.Images"));
    EXPECT_TRUE(has("costs.Meshes"));
    EXPECT_TRUE(has("costs.title.Programs: 2, in 3 forms"));
    std::erase_if(explanation_.paid, [](const auto& paid) { return !paid.programs.empty(); });
    explanation_.paid.push_back(program("Ball", {0, 1, 2}));
    explanation_.paid.back().frame = FrameCost{0, 16.2, {}};
    EXPECT_TRUE(has("costs.title.Programs: 3, 1 compiled"));
    click(place("costs.Programs"));
    EXPECT_TRUE(has("costs.row.Ball and 2 more"));
    EXPECT_TRUE(has("costs.amount.16.2 ms a frame"));
    EXPECT_TRUE(has("costs.title.Images: 1"));
    EXPECT_TRUE(has("costs.Not loaded"));
    EXPECT_FALSE(has("costs.Noise")) << "none of it";
    EXPECT_FALSE(has("costs.Declared but unused"));
    EXPECT_FALSE(has("costs.Switched off by values"));
    Explanation::SwitchedOff row{0, "Glass", "uMix", "0", {}, {}, {}};
    row.parts.push_back({Explanation::Kind::sampler, "samplerCube uMirrored", {"main (fragment)"}});
    explanation_.switched_off.push_back(std::move(row));
    EXPECT_TRUE(has("costs.Switched off by values"));
}

// Drop-downs of ladders, judged by what becomes of the choice.
class LadderRows : public UiTest {
protected:
    LadderRows() {
        Ladder ladder;
        ladder.name = "FRESNEL";
        ladder.rungs = {"f0", "schlick", "exact"};
        ladder.current = 1;
        scene_.ladders.push_back(ladder);
        controls_.rungs = {1};
        add_slider("uEta", .1, 1.1, 5);
    }
};

TEST_F(LadderRows, StandAboveTheSliders) {
    const Rect row = place("FRESNEL"), slider = place("Glass.uEta");
    EXPECT_GT(row.width, 0);
    EXPECT_LT(row.y + row.height, slider.y);
}

TEST_F(LadderRows, AClickedRungIsChosen) {
    click(place("FRESNEL"));
    click(place("FRESNEL.exact"));
    EXPECT_EQ(controls_.rungs, Rungs{2});
    EXPECT_FALSE(has("FRESNEL.exact")) << "the list closes";
}

TEST_F(LadderRows, ARightClickGivesTheScenesRungBack) {
    controls_.rungs = {0};
    click(place("FRESNEL"), MouseButton::right);
    EXPECT_EQ(controls_.rungs, Rungs{1});
}

TEST_F(LadderRows, AChangedRungHasTheDotAndTheMenuOfAChangedValue) {
    EXPECT_FALSE(has("FRESNEL.dot"));
    const Rect before = place("FRESNEL");
    controls_.rungs = {2};
    const Rect dot = place("FRESNEL.dot");
    EXPECT_EQ(place("FRESNEL"), before) << "nothing moves";
    click(dot);
    EXPECT_EQ(controls_.rungs, Rungs{1});
    EXPECT_FALSE(has("FRESNEL.dot"));
    controls_.rungs = {0};
    click(place("FRESNEL.name"), MouseButton::right);
    click(place("FRESNEL.reset"));
    EXPECT_EQ(controls_.rungs, Rungs{1});
    // By keys, too.
    controls_.rungs = {2};
    frame({key(Key::tab, true)});
    frame({key(Key::tab, false)});
    for (int i = 0; i < 40 && kit().focus.at != 0 && !has("FRESNEL.reset"); ++i) {
        frame({key(Key::menu, true)});
        frame({key(Key::menu, false)});
        if (has("FRESNEL.reset")) break;
        frame({key(Key::tab, true)});
        frame({key(Key::tab, false)});
    }
    ASSERT_TRUE(has("FRESNEL.reset"));
    click(place("FRESNEL.reset"));
    EXPECT_EQ(controls_.rungs, Rungs{1});
}

TEST_F(LadderRows, WhatIsNoRungIsNotShown) {
    controls_.rungs = {7};
    EXPECT_FALSE(has("FRESNEL"));
    controls_.rungs = {};
    EXPECT_FALSE(has("FRESNEL"));
}

}  // namespace
}  // namespace snell::ui
