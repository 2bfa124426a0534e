// Drop-downs of ladders, judged by what becomes of the choice.
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

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

TEST_F(LadderRows, WhatIsNoRungIsNotShown) {
    controls_.rungs = {7};
    EXPECT_FALSE(has("FRESNEL"));
    controls_.rungs = {};
    EXPECT_FALSE(has("FRESNEL"));
}

}  // namespace
}  // namespace snell::ui
