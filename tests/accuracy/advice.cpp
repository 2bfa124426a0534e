// Which combination is chosen, of sweeps whose numbers are known; and presets through their file.
#include <gtest/gtest.h>

#include "src/accuracy/quality.h"

namespace snell::accuracy {
namespace {

RungResult rung(std::string name, double error, double milliseconds) {
    RungResult result{.name = std::move(name), .drawn = true};
    result.own.rmse = error;
    result.milliseconds = milliseconds;
    result.ratio = {.99 * milliseconds / 10, milliseconds / 10, 1.01 * milliseconds / 10};
    result.rounds = 9;
    return result;
}

SweepResult sweep() {
    SweepResult result;
    result.rungs = {rung("quick", .5, 5), rung("good", .01, 10), rung("same", .004, 10.05), rung("dear", .002, 20),
                    rung("exact", 0, 40)};
    return result;
}

TEST(Advice, CheapestThatIsExactEnough) {
    EXPECT_EQ(choose(sweep(), {.error = .005}), 2U);
    EXPECT_EQ(choose(sweep(), {.error = .003}), 3U);
    EXPECT_EQ(choose(sweep(), {.error = 0}), 4U);
    EXPECT_EQ(choose(sweep(), {.error = 1}), 0U);
    EXPECT_EQ(choose(sweep(), {}), 0U);
}

TEST(Advice, OfThoseThatCostTheSameTheMostExact) { EXPECT_EQ(choose(sweep(), {.error = .1}), 2U); }

TEST(Advice, MostExactThatIsQuickEnough) {
    EXPECT_EQ(choose(sweep(), {.milliseconds = 16}), 2U);
    EXPECT_EQ(choose(sweep(), {.milliseconds = 20}), 3U);
    EXPECT_EQ(choose(sweep(), {.milliseconds = 1000}), 4U);
}

TEST(Advice, WhereNothingFulfilsItTheNearest) {
    EXPECT_EQ(choose(sweep(), {.milliseconds = 1}), 0U);
    const Wish both{.milliseconds = 1, .error = .003};
    EXPECT_EQ(choose(sweep(), both), 3U) << "exact enough, and the cheapest of these";
    EXPECT_FALSE(fulfils(sweep().rungs[3], both));
    SweepResult without = sweep();
    without.rungs.pop_back();
    EXPECT_EQ(choose(without, {.error = .001}), 3U);
}

TEST(Advice, WhatWasNotTimedIsNotChosen) {
    SweepResult result = sweep();
    result.rungs[0].rounds = 0;
    EXPECT_EQ(choose(result, {}), 2U);
    for (RungResult& r : result.rungs) r.rounds = 0;
    EXPECT_EQ(choose(result, {}), std::nullopt);
}

TEST(Quality, PresetsComeBackFromTheirFile) {
    Circumstances where;
    where.renderer = "a \"renderer\"";
    const std::vector<Preset> presets{{.name = "fast", .choices = {"A=x", "B=y"}, .rmse = .25, .ratio = {.4, .5, .6}}};
    std::string error;
    const auto stored = read_quality(quality_json(where, presets), "fast", error);
    ASSERT_TRUE(stored) << error;
    EXPECT_EQ(stored->choices, presets[0].choices);
    EXPECT_NE(stored->measured.find("RMSE 0.25"), std::string::npos) << stored->measured;
    EXPECT_NE(stored->measured.find("too noisy"), std::string::npos) << "it was not trusted";
    EXPECT_FALSE(read_quality(quality_json(where, presets), "exact", error));
    for (const char* text : {"", "[]", "{}", "{\"schema\": 1}", "{\"schema\": 1, \"presets\": {\"fast\": 3}}", "{"}) {
        error.clear();
        EXPECT_FALSE(read_quality(text, "fast", error)) << text;
        EXPECT_FALSE(error.empty()) << text;
    }
}

}  // namespace
}  // namespace snell::accuracy
