// Places come from a seed alone, and stay where a user could move.
#include "src/accuracy/bench.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/measure.h"
#include "tests/std.h"

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

// Computed apart from the code, from the words in search.h: the numbers of std::mt19937_64 with seed 1 are first those
// of all views and times, then, for each uniform, those of its order and its values.
TEST(Places, TheNumbersOfASeedAreKnown) {
    const Glass glass;
    const auto places = glass.places(1, {}, true);
    EXPECT_EQ(place_text(places[1], places[0]),
              "--view rotate_x=-22,rotate_y=-22,scale=1.02 --time 0.21 --set Glass.uEta=1.45 --set Glass.uCount=6 "
              "--set Glass.uOn=true");
    EXPECT_EQ(place_text(places[39], places[0]),
              "--view rotate_x=-6,rotate_y=12,scale=0.83 --time 4.65 --set Glass.uEta=1.193 --set Glass.uCount=9 --set "
              "Glass.uOn=false");
    EXPECT_EQ(place_text(places[0], places[0]), "the scene's own");
}

// By place, the value of a component; the scene's own where it is not set.
std::vector<double> values(const std::vector<Place>& places, std::string_view name, double own,
                           std::size_t component = 0) {
    std::vector<double> values(places.size(), own);
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const std::string& set : places[i].sets) {
            if (set.substr(0, set.find('=')) != name) continue;
            std::string text = set.substr(set.find('=') + 1);
            for (std::size_t k = 0; k < component; ++k) text = text.substr(text.find(',') + 1);
            values[i] = text.starts_with("true") ? 1 : text.starts_with("false") ? 0 : std::stod(text);
        }
    return values;
}

TEST(Places, EveryModeOfASliderHasAPlaceAndTheOthersShareTheRangeEvenly) {
    Controls controls;
    Scene scene;
    scene.programs.resize(1);
    scene.programs[0].name = "P";
    controls.items = {slider("uView", 0, 3, 1, ValueType::int_), slider("uSeven", 1, 8, 1, ValueType::int_),
                      slider("uMany", 0, 100, 1, ValueType::int_), slider("uNone", .2, .8, 1, ValueType::int_)};
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const auto places = make_places(controls, scene, false, {}, {.searched = 4, .held_out = 4, .seed = seed});
        std::vector<double> view = values(places, "P.uView", 0), seven = values(places, "P.uSeven", 1),
                            many = values(places, "P.uMany", 0);
        std::sort(view.begin(), view.begin() + 4);
        EXPECT_EQ(std::vector<double>(view.begin(), view.begin() + 4), (std::vector<double>{0, 1, 2, 3}))
            << "all of them where it is searched, as there are just as many";
        std::sort(seven.begin(), seven.end());
        EXPECT_EQ(seven, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
        std::sort(many.begin() + 1, many.end());
        EXPECT_EQ(many[1], 0);
        EXPECT_EQ(many[7], 100);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_GE(many[2 + i], 20. * static_cast<double>(i));
            EXPECT_LE(many[2 + i], 20. * static_cast<double>(i + 1));
        }
    }
}

TEST(Places, ACheckBoxHasTheOtherValueInHalfOfThePlacesOfEitherKind) {
    Glass glass;
    for (const double own : {0., 1.}) {
        glass.controls.items[4].value[0] = own;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const auto places = make_places(glass.controls, glass.scene, false, {}, {4, 4, seed});
            const auto on = values(places, "Glass.uOn", own);
            EXPECT_EQ(on[0], own);
            EXPECT_NE(on[1], on[2]);
            EXPECT_EQ(on[3], 1 - own);
            EXPECT_NE(on[4], on[5]);
            EXPECT_NE(on[6], on[7]);
        }
    }
}

TEST(Places, BothEndsOfASliderHaveOnePlaceEachAndHalfOfThePlacesTheScenesOwn) {
    Glass glass;
    for (snell::Control& control : glass.controls.items)
        if (control.type == ValueType::float_)
            control.value.assign(control.value.size(), (control.min + control.max) / 3);
    std::size_t together = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const auto places = make_places(glass.controls, glass.scene, false, {}, {4, 4, seed});
        std::vector<double> eta = values(places, "Glass.uEta", 0);
        const std::vector<double> light = values(places, "Glass.uLight", -9, 2);
        EXPECT_EQ(std::count(eta.begin(), eta.end(), 1), 1);
        EXPECT_EQ(std::count(eta.begin(), eta.end(), 2), 1);
        EXPECT_EQ(std::count(light.begin(), light.end(), -1), 1);
        EXPECT_EQ(std::count(light.begin(), light.end(), 1), 1);
        for (std::size_t i = 0; i < 8; ++i) together += eta[i] == 1 && light[i] == -1;
        EXPECT_EQ(std::count(eta.begin(), eta.end(), 0), 4) << "its own place, and three of seven";
        std::sort(eta.begin(), eta.end());
        EXPECT_TRUE(eta[5] >= 1 && eta[5] <= 1.5 && eta[6] >= 1.5 && eta[6] <= 2) << eta[5] << " " << eta[6];
    }
    EXPECT_LT(together, 20u) << "of fifty: their orders differ";
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
    EXPECT_EQ(sets, 3 * 20 + 2 * 39u) << "numbers and colours in half of the places, the others in each";
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
    const std::vector<double> errors{.001, .0025, .0045, .0005};
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
        << "more than .005 in all: the first climb ends without it";
    for (const auto& one : tried) {
        EXPECT_GT(one.size(), 1u);
        EXPECT_FALSE(one.front() == 0 && one.back() == 3);
    }
}

// ---- Where samples lie within a pixel; and the rung of a knob that is called the scene's own draws the scene as it
// is.

TEST(SamplePositions, BeginWherePicturesAlwaysStand) { EXPECT_EQ(sample_position(0), (std::array<double, 2>{0, 0})); }

TEST(SamplePositions, AreSpreadEvenlyHoweverManyThereAre) {
    for (int count : {4, 16, 64}) {
        double x = 0, y = 0;
        std::array<int, 4> quadrants{};
        for (int i = 0; i < count; ++i) {
            const auto [right, up] = sample_position(i);
            ASSERT_LE(std::abs(right), .5);
            ASSERT_LE(std::abs(up), .5);
            x += right;
            y += up;
            ++quadrants[(right < 0 ? 0U : 1U) + (up < 0 ? 0U : 2U)];
        }
        // A mean of random ones would be off by .29 / sqrt(count).
        EXPECT_LT(std::hypot(x, y) / count, .5 / std::sqrt(count)) << count;
        for (int inside : quadrants) EXPECT_NEAR(inside, count / 4., .2 * count + 1) << count;
    }
}

Texture cube_of(int size, bool from_file) {
    Texture texture;
    texture.target = TextureTarget::cube;
    texture.size[0] = size;
    if (from_file) texture.files.resize(1);
    return texture;
}

Texture picture_with(Filter filter) {
    Texture texture;
    texture.files.resize(1);
    texture.filter = filter;
    return texture;
}

Sweep knob(const Scene& scene, const std::string& name) {
    Diagnostics problems;
    const std::vector<Sweep> sweeps = knob_sweeps(scene, {}, {name}, From::scene, true, problems);
    return sweeps.size() == 1 ? sweeps[0] : Sweep{};
}

// The name of the current rung, or what it changes.
std::string own_rung(const Scene& scene, const std::string& name) {
    const Sweep sweep = knob(scene, name);
    if (sweep.rungs.empty()) return "none";
    const SweepRung& own = sweep.rungs[sweep.current];
    Plan plan;
    plan.scene = scene;
    const std::vector<Texture> drawn = with_knobs(plan, own.variant.knobs.plan).scene.textures;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Texture &a = drawn[i], &b = scene.textures[i];
        const bool bytes = a.files.empty() && (a.bits == 16) != (b.bits == 16);
        const bool smaller = a.size[0] != b.size[0] && (a.size[0] > 0 || b.size[0] > 0);
        if (a.filter != b.filter || bytes || smaller) return "'" + own.name + "' is not the scene's own";
    }
    return own.name;
}

TEST(KnobsOfAScene, CubeMapsOfAnySize) {
    Scene scene;
    for (const int size : {16, 64, 300, 1000, 2048, 4096}) {
        scene.textures = {cube_of(size, false)};
        EXPECT_EQ(own_rung(scene, "cube-size"), std::to_string(size));
        const Sweep sweep = knob(scene, "cube-size");
        EXPECT_TRUE(
            std::ranges::is_sorted(sweep.rungs, {}, [](const SweepRung& rung) { return std::stoi(rung.name); }));
        EXPECT_EQ(sweep.reference, sweep.rungs.size() - 1);
    }
    scene.textures = {cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-size"), "files");
    scene.textures = {cube_of(300, false), cube_of(128, false), cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-size"), "300") << "the others keep their sizes, too";
}

TEST(KnobsOfAScene, CubeMapsThatAreDrawnToHaveBytes) {
    Scene scene;
    scene.textures = {cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-precision"), "half");
    scene.textures = {cube_of(64, false)};
    EXPECT_EQ(own_rung(scene, "cube-precision"), "8bit");
    scene.textures = {cube_of(64, false), cube_of(0, true)};
    EXPECT_EQ(own_rung(scene, "cube-precision"), "scene");
    EXPECT_EQ(knob(scene, "cube-precision").rungs.back().name, "half");
}

TEST(KnobsOfAScene, FiltersOfAllFiles) {
    using Mode = Filter::Mode;
    Scene scene;
    scene.textures = {picture_with({Mode::mipmap, 1})};
    EXPECT_EQ(own_rung(scene, "filter"), "mipmap");
    scene.textures.push_back(picture_with({Mode::nearest, 1}));
    EXPECT_EQ(own_rung(scene, "filter"), "scene") << "two filters";
    EXPECT_EQ(knob(scene, "filter").rungs.back().name, "linear_8x8");
    scene.textures = {picture_with({Mode::anisotropic, 16})};
    EXPECT_EQ(own_rung(scene, "filter"), "scene") << "more than is offered";
    scene.textures = {picture_with({Mode::anisotropic, 8})};
    EXPECT_EQ(own_rung(scene, "filter"), "anisotropic8");
}

}  // namespace
}  // namespace snell::accuracy
