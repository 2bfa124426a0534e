// Every panel, as large and as full as scenes make it: nothing overlaps, nothing is cut off, in any size of letters and
// in all themes. `./dev guide` leaves pictures of them for people to look at.
#include <fmt/format.h>

#include <span>

#include "src/ui/shell.h"
#include "tests/ui/full_panels.h"

namespace snell::ui {
namespace {

TEST_P(Screens, AreLegible) {
    const Panel& panel = GetParam();
    facts_.file = "refraction-room.glib";
    facts_.renderer = "llvmpipe";
    facts_.frame_ms = 16.66;
    facts_.changed = true;
    facts_.snapshots[3] = true;
    (this->*panel.prepare)();
    panel_widget_ = panel.widget;
    struct Variant {
        const char* name;
        float width, height, scale;
        std::vector<Theme> themes;  // pictures of all are kept, if any are; without pictures the last one counts
        bool kept;
    };
    const std::vector<Theme> all{Theme::dark, Theme::contrast, Theme::light};
    for (const Variant& variant :
         {Variant{"420x320-200", 420, 320, 2, {Theme::light}, true},
          Variant{"420x320-largest", 420, 320, fitting_scale(3, 420), {Theme::light}, true},
          Variant{"1280x720", 1280, 720, 1, all, true}, Variant{"1920x1080-200", 1920, 1080, 2, all, true},
          Variant{"1024x768", 1024, 768, 1, {Theme::dark}, false},
          Variant{"1024x768-200", 1024, 768, 2, {Theme::light}, false},
          Variant{"1024x768-150", 1024, 768, 1.5F, {Theme::contrast}, false},
          Variant{"640x480", 640, 480, 1, {Theme::light}, true},
          Variant{"3840x2160", 3840, 2160, 2, {Theme::contrast}, false}}) {
        SCOPED_TRACE(variant.name);
        const bool keeps = variant.kept && !screens_folder().empty();
        for (const Theme theme : std::span(variant.themes).last(keeps ? variant.themes.size() : 1)) {
            screen_ = {variant.width, variant.height, 1, variant.scale, theme};
            settle();
            unfold();
            const std::string name =
                fmt::format("{}-{}-{}", panel.name, variant.name, theme_names[static_cast<std::size_t>(theme)]);
            scroll(1000);
            expect_legible("top");
            if (keeps) keep_picture(name);
            const std::uint64_t top = picture_;
            scroll(-1000);
            expect_legible("bottom");
            if (keeps && picture_ != top) keep_picture(name + "-bottom");
            // The line below the smallest picture has room for no more than a number.
            const bool expected = has_room(memory_.scene) || !std::string_view(panel.widget).starts_with("status.");
            EXPECT_TRUE(has(panel.widget) || !expected) << panel.widget;
        }
    }
}

class SmallestWindow : public Screens {
protected:
    bool visible(std::string_view name) const {
        return std::any_of(layout_.items().begin(), layout_.items().end(),
                           [&](const Placed& item) { return item.name == name && item.visible; });
    }
};

TEST_F(SmallestWindow, ANoticeOverTwoStatesLeavesSomeOfThePanelInTheSmallestWindow) {
    facts_.changed = true;
    states_and_a_notice();
    screen_ = {420, 320, 1, fitting_scale(3, 420), Theme::light};
    settle();
    EXPECT_TRUE(visible("failure.store"));
    EXPECT_TRUE(visible("menu.open")) << "the panel";
    EXPECT_FALSE(visible("accuracy.swap")) << "once the notice is answered";
    click(place("failure.ok"));
    settle();
    EXPECT_TRUE(visible("accuracy.swap"));
}

TEST_F(SmallestWindow, AFailureIsSeenBeforeErrorsInTheSmallestWindow) {
    errors();
    memory_.failures.open = {{"not saved: no space left", Failure::Remedy::save}};
    screen_ = {420, 320, 1, fitting_scale(3, 420), Theme::light};
    settle();
    EXPECT_TRUE(has("failure.ok"));
    click(place("failure.ok"));
    settle();
    EXPECT_FALSE(has("failure.ok"));
    EXPECT_TRUE(has("problems.hide"));
}

TEST_F(SmallestWindow, WhatANoticeOffersIsSeenInTheSmallestWindow) {
    memory_.failures.open = {
        {"not saved: refraction-room.glib has changed since it was read: reload it, or save these "
         "values to another file",
         Failure::Remedy::reload}};
    screen_ = {420, 320, 1, fitting_scale(3, 420), Theme::light};
    settle();
    expect_legible("notice");
    if (!screens_folder().empty()) keep_picture("long-notice-420x320-largest-light");
    for (const char* button : {"failure.ok", "failure.reload", "failure.save as"})
        EXPECT_TRUE(visible(button)) << button;
    const Rect save = place("failure.save as");
    frame({move(save.x + save.width / 2, save.y + save.height / 2)});
    frame({button(true)});
    frame({button(false)});
    EXPECT_TRUE(requests_.save_as);
}

TEST_F(SmallestWindow, TheSnapshotsAreNamed) {
    programs();
    for (const float scale : {1.F, fitting_scale(3, 420)}) {
        screen_ = {420, 320, 1, scale, Theme::light};
        settle();
        EXPECT_TRUE(visible("snapshots"));
        EXPECT_EQ(place("snapshots").width, ImGui::CalcTextSize("Snapshots").x) << "whole, " << scale;
        for (int number = 1; number <= snapshot_count; ++number)
            EXPECT_TRUE(visible("snapshot " + std::to_string(number))) << number << ", " << scale;
    }
}

TEST_F(SmallestWindow, NoticesWithoutRoomAreCounted) {
    for (int number = 1; number <= 3; ++number)
        memory_.failures.add({"snapshot is not stored: no space left", Failure::Remedy::store, {}, number});
    screen_ = {420, 320, 1, fitting_scale(3, 420), Theme::light};
    settle();
    EXPECT_TRUE(visible("failure.ok"));
    EXPECT_FALSE(has("failure 3.ok"));
    EXPECT_TRUE(visible("failure.more"));
    EXPECT_GE(place("failure.again").y - place("failure.ok").y, 2 * ImGui::GetTextLineHeight()) << "two whole lines";
    if (!screens_folder().empty()) keep_picture("three-notices-420x320-largest-light");
}

// What a notice offers is above the one below it.
TEST_F(SmallestWindow, NoticesAreSeenWholeOrCountedInLargerOnes) {
    everything();
    for (const float height : {640.F, 720.F, 800.F, 900.F, 1000.F, 1080.F, 1200.F}) {
        SCOPED_TRACE(height);
        screen_ = {1920, height, 1, 2, Theme::light};
        settle();
        EXPECT_TRUE(has("failure.more"));
        for (int number = 3; number >= 2; --number) {
            const std::string name = fmt::format("failure {}", number);
            const std::string below = number > 2 ? "failure 2.ok" : "failure.ok";
            if (!has(name + ".ok")) continue;
            const Rect again = place(name + ".again");
            EXPECT_LT(again.y + again.height, place(below).y - ImGui::GetStyle().WindowPadding.y) << name;
        }
    }
}

TEST_F(SmallestWindow, OfANoticeTwoLinesAreSeen) {
    failures();
    screen_ = {420, 320, 1, fitting_scale(3, 420), Theme::light};
    settle();
    EXPECT_GE(place("failure.again").y - place("failure.ok").y, 2 * ImGui::GetTextLineHeight());
    EXPECT_TRUE(visible("failure.more"));
    EXPECT_TRUE(visible("menu.open")) << "the panel";
}

TEST_F(SmallestWindow, WhatIsWaitedForIsSeenWhole) {
    for (const float scale : {2.F, fitting_scale(3, 420)}) {
        first_picture();
        facts_.file = "refraction-room.glib";
        screen_ = {420, 320, 1, scale, Theme::light};
        settle();
        const Rect box = place("first picture");
        const float em = ImGui::GetFontSize();
        const float all = ImGui::CalcTextSize("Drawing the first picture of refraction-room.glib, for 60 s at most").x;
        EXPECT_GE((box.width - 2 * em) * (box.height - em) / ImGui::GetTextLineHeight(), all) << scale;
        EXPECT_TRUE(box.x >= 0 && box.x + box.width <= 420 && box.y >= 0 && box.y + box.height <= 320) << scale;
    }
}

TEST_F(SmallestWindow, TheFieldForANameIsSeenWhole) {
    screen_ = {420, 320, 1, fitting_scale(3, 420), Theme::light};
    browser();
    for (const bool start : {false, true}) {
        memory_.browser.start = start;
        const Rect field = place("browser.name");
        EXPECT_LE(field.y + field.height, 320 - .5F * ImGui::GetFontSize()) << (start ? "scenes" : "folders");
    }
}

const Panel panels[] = {
    {"programs", "Glass.uEta", &Screens::programs},
    {"many-sliders", "filter", &Screens::many_sliders},
    {"no-sliders", "Glass", &Screens::no_sliders},
    {"forty-sliders", "Glass.uValue40", &Screens::forty_sliders},
    {"ladders", "FRESNEL", &Screens::ladders},
    {"accuracy", "accuracy.plot", &Screens::accuracy},
    {"two-states", "accuracy.swap", &Screens::two_states},
    {"state-menu", "right.settings", &Screens::state_menu},
    {"heat-map", "accuracy.swap", &Screens::heat_map},
    {"blank-states", "accuracy.swap", &Screens::blank_states},
    {"marked-states", "accuracy.swap", &Screens::marked_states},
    {"found", "found.find", &Screens::found},
    {"found-untried", "found.find", &Screens::found_untried},
    {"clock", "scrub", &Screens::clock},
    {"values", "Glass.uEta", &Screens::values},
    {"errors", "problem.0", &Screens::errors},
    {"messages", "message.ok", &Screens::messages},
    {"everything", "failure.again", &Screens::everything},
    {"first-picture", "first picture", &Screens::first_picture},
    {"failures", "failure.again", &Screens::failures},
    {"states-and-a-notice", "failure.store", &Screens::states_and_a_notice},
    {"costs", "costs.Images", &Screens::costs},
    {"files", "file.room.glib", &Screens::files},
    {"window", "letters", &Screens::window},
    {"browser", "browser.entry.scene1.glib", &Screens::browser},
    {"refused-folder", "browser.cancel", &Screens::refused_folder},
    {"view", "background", &Screens::view},
    {"pixels", "flags", &Screens::pixels},
    {"marked-errors", "problems.hide", &Screens::marked_errors},
    {"inspector", "inspector", &Screens::inspected},
    {"textures", "textures.picture", &Screens::textures},
    {"frame-cost", "frame cost.plot", &Screens::frame_cost},
    {"picture", "picture save", &Screens::picture},
    {"save-as", "save as save", &Screens::save_as},
    {"write-rung", "write rung save", &Screens::write_rung},
    {"save-page", "save page save", &Screens::save_page},
    {"keys", "close keys", &Screens::keys},
    {"open-menu", "open", &Screens::open_menu},
    {"save-menu", "sequence", &Screens::save_menu},
    {"view-menu", "hide", &Screens::view_menu},
    {"empty", "open scene", &Screens::empty},
    {"empty-browser", "browser.recent.room.glib", &Screens::empty_browser},
    {"picking", "status.pick", &Screens::picking},
    {"hidden", "hint", &Screens::hidden},
    {"no-scene", "menu.open", &Screens::nothing},
};

INSTANTIATE_TEST_SUITE_P(Panels, Screens, ::testing::ValuesIn(panels), [](const auto& row) {
    std::string name = row.param.name;
    std::erase(name, '-');
    return name;
});

// It is there before any panel is.
TEST_F(UiTest, TheBarWhileASceneLoadsIsLegible) {
    for (const float scale : {1.F, 2.F}) {
        for (int i = 0; i < 3; ++i) {
            gui_.input({640, 480, 1, scale, scale > 1 ? Theme::dark : Theme::light}, .02, {});
            gui_.begin();
            loading("decoding " + long_path, .4);
            gui_.end();
        }
        for (const std::string& flaw : flaws(*ImGui::GetDrawData())) ADD_FAILURE() << scale << ": " << flaw;
        keep_picture(scale > 1 ? "loading-200" : "loading-100");
    }
}

}  // namespace
}  // namespace snell::ui
