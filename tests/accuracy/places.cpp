// Places come from a seed alone, and stay where a user could move.
#include "src/accuracy/found/places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/accuracy/found/climb.h"

namespace snell::accuracy {
namespace {

snell::Control slider(std::string name, double min, double max, int components = 1,
                      ValueType type = ValueType::float_) {
    snell::Control control;
    control.name = std::move(name);
    control.widget = Widget::slider;
    control.min = min;
    control.max = max;
    control.type = type;
    control.components = components;
    control.value.assign(static_cast<std::size_t>(components), min);
    return control;
}

struct Glass {
    Controls controls;
    Scene scene;
    Glass() {
        scene.programs.resize(1);
        scene.programs[0].name = "Glass";
        controls.items = {slider("uEta", 1, 2), slider("uCount", 1, 9, 1, ValueType::int_), slider("uLight", -1, 1, 3),
                          slider("uStill", 3, 3)};
        snell::Control on = slider("uOn", 0, 1, 1, ValueType::bool_);
        on.widget = Widget::check_box;
        controls.items.push_back(on);
        snell::Control color = slider("uColor", 0, 1, 3);
        color.widget = Widget::color;
        controls.items.push_back(color);
    }
    std::vector<Place> places(std::uint64_t seed, const Place& own = {}, bool animated = true) const {
        return make_places(controls, scene, animated, own, {.searched = 20, .held_out = 20, .seed = seed});
    }
};

TEST(Places, TheSceneIsFirstAndTheSeedDecidesTheOthers) {
    const Glass glass;
    const auto a = glass.places(1), b = glass.places(1), c = glass.places(2);
    ASSERT_EQ(a.size(), 40u);
    EXPECT_EQ(a[0], Place{});
    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
    for (std::size_t i = 1; i < a.size(); ++i) EXPECT_NE(a[i], a[i - 1]);
}

// The generator is the standard's, the rest is arithmetic: these numbers hold on every machine.
TEST(Places, TheNumbersOfASeedAreKnown) {
    const Glass glass;
    const auto places = glass.places(1, {}, true);
    EXPECT_EQ(place_text(places[1], places[0]),
              "--view rotate_x=-22,rotate_y=-22,scale=1.02 --time 0.21 --set Glass.uEta=1.351 --set "
              "Glass.uLight=0.14,0.27,-0.822 --set Glass.uColor=0.419,0.25,0.292");
    EXPECT_EQ(place_text(places[0], places[0]), "the scene's own");
}

TEST(Places, ValuesStayWithinTheirRangesAndViewsAreModerate) {
    const Glass glass;
    std::size_t moved = 0, sets = 0;
    for (const Place& place : glass.places(7)) {
        EXPECT_LE(std::abs(place.view.scene.rotate_x), 30);
        EXPECT_LE(std::abs(place.view.scene.rotate_y), 30);
        EXPECT_GE(place.view.scene.scale, .7);
        EXPECT_LE(place.view.scene.scale, 1.4);
        EXPECT_GE(place.time, 0);
        moved += place.view.scene.scale != 1;
        for (const std::string& set : place.sets) {
            ++sets;
            const std::string name = set.substr(0, set.find('=')), value = set.substr(set.find('=') + 1);
            EXPECT_NE(name, "Glass.uStill");
            if (name == "Glass.uOn") {
                EXPECT_TRUE(value == "true" || value == "false") << value;
            }
            if (name == "Glass.uEta") {
                EXPECT_TRUE(std::stod(value) >= 1 && std::stod(value) <= 2) << value;
            }
            if (name == "Glass.uCount") {
                EXPECT_EQ(std::stod(value), std::round(std::stod(value)));
            }
            if (name == "Glass.uLight") {
                EXPECT_EQ(std::count(value.begin(), value.end(), ','), 2);
            }
        }
    }
    EXPECT_GT(moved, 30u);
    EXPECT_GT(sets, 60u);
    EXPECT_LT(sets, 140u) << "about half of five in each of 39 places";
}

TEST(Places, WhatTheUserSetsStaysAndAStillSceneHasOneTime) {
    const Glass glass;
    const Place own{{}, 1.5, {"uEta=1.33", "Glass.uLight.x=.5"}};
    const auto places = glass.places(3, own, false);
    for (const Place& place : places) {
        EXPECT_EQ(place.time, 1.5);
        ASSERT_GE(place.sets.size(), 2u);
        EXPECT_EQ(place.sets[0], own.sets[0]);
        for (std::size_t i = 2; i < place.sets.size(); ++i) {
            EXPECT_FALSE(place.sets[i].starts_with("Glass.uEta")) << place.sets[i];
            EXPECT_FALSE(place.sets[i].starts_with("Glass.uLight")) << place.sets[i];
        }
    }
    const auto names = varying(places, own);
    EXPECT_EQ(names.size(), 3u);
}

// Errors add up here, so which combinations stay below a limit is known.
TEST(Climbs, ChangesAreAddedByTheirErrorsWhileThePictureStaysBelowALimit) {
    std::vector<Change> changes;
    for (std::uint32_t i = 0; i < 4; ++i)
        changes.push_back({ChangeKind::polynomial, {}, "", "", {{{0, 9 * i, 9 * i + 2}, "x"}}});
    changes[3].edits[0].span = changes[0].edits[0].span;  // these two exclude each other
    const std::vector<double> errors{.0002, .0005, .0009, .0001};
    Climbs climbs({{0, errors[0]}, {1, errors[1]}, {2, errors[2]}, {3, errors[3]}}, changes, 1);
    std::vector<std::vector<std::size_t>> tried;
    while (const auto next = climbs.next()) {
        double sum = 0;
        for (const std::size_t change : *next) sum += errors[change];
        EXPECT_EQ(std::count(tried.begin(), tried.end(), *next), 0) << "each once";
        tried.push_back(*next);
        climbs.tell(sum);
    }
    ASSERT_GE(tried.size(), 3u);
    EXPECT_EQ(tried[0], (std::vector<std::size_t>{1, 3})) << "the two smallest that go together";
    EXPECT_EQ(tried[1], (std::vector<std::size_t>{1, 2, 3}))
        << "more than .001 in all: the first climb ends without it";
    for (const auto& one : tried) {
        EXPECT_GT(one.size(), 1u);
        EXPECT_FALSE(one.front() == 0 && one.back() == 3);
    }
}

}  // namespace
}  // namespace snell::accuracy
