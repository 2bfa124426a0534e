// Which combination is chosen, of sweeps whose numbers are known; and presets through their file.
#include "src/accuracy/advice.h"
#include "src/accuracy/report/quality.h"
#include "tests/std.h"

namespace snell::accuracy {
namespace {

RungResult rung(std::string name, double error, double milliseconds) {
    RungResult result{.name = std::move(name), .drawn = true};
    result.own.light.rmse = result.alone.rmse = error;
    result.milliseconds = milliseconds;
    result.low = .99 * milliseconds;
    result.high = 1.01 * milliseconds;
    result.ratio = {.99 * milliseconds / 10, milliseconds / 10, 1.01 * milliseconds / 10};
    result.rounds = 9;
    return result;
}

// Times of nine rounds, which all rungs took part in.
void compare_all(SweepResult& result, double noise = 0) {
    std::vector<std::vector<double>> times;
    for (const RungResult& rung : result.rungs) times.emplace_back(9, rung.milliseconds);
    result.costs = Costs(times, noise);
}

SweepResult sweep() {
    SweepResult result;
    result.residual = 0;
    result.rungs = {rung("quick", .5, 5), rung("good", .01, 10), rung("same", .004, 10.05), rung("costly", .002, 20),
                    rung("exact", 0, 40)};
    compare_all(result);
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

TEST(Advice, NothingIsNamedThatIsNotSurelyCheaperThanTheScene) {
    SweepResult result = sweep();
    result.sweep.current = 1;  // .01, 10 ms
    EXPECT_EQ(choose_surely(result, {.error = .1}), 1U) << "'same' costs as much";
    EXPECT_EQ(choose_surely(result, {.error = 1}), 0U);
    EXPECT_EQ(choose_surely(result, {.error = .005}), 2U) << "the scene itself is not exact enough";
    EXPECT_EQ(choose_surely(result, {.milliseconds = 1000}), 4U);
    compare_all(result, 1);
    EXPECT_EQ(choose_surely(result, {.error = 1}), 1U) << "timed twice, the scene itself differs as much";
}

TEST(Advice, ASceneThatWasNotTimedIsNotTheCheapest) {
    SweepResult result = sweep();
    result.sweep.current = 4;
    result.rungs[4] = rung("scene", 0, 0);
    result.rungs[4].rounds = 0;
    EXPECT_EQ(choose_surely(result, {.error = .1}), std::nullopt);
}

TEST(Advice, MostExactThatIsQuickEnough) {
    EXPECT_EQ(choose(sweep(), {.milliseconds = 16}), 2U);
    EXPECT_EQ(choose(sweep(), {.milliseconds = 20}), 2U) << "in half of all runs it would take longer";
    EXPECT_EQ(choose(sweep(), {.milliseconds = 20.3}), 3U);
    EXPECT_EQ(choose(sweep(), {.milliseconds = 1000}), 4U);
}

TEST(Advice, WhereNothingFulfilsItTheNearest) {
    EXPECT_EQ(choose(sweep(), {.milliseconds = 1}), 0U);
    const Wish both{.milliseconds = 1, .error = .003};
    EXPECT_EQ(choose(sweep(), both), 3U) << "exact enough, and the cheapest of these";
    EXPECT_FALSE(fulfils(sweep(), sweep().rungs[3], both));
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

// Rungs that were timed, but never in a round with the scene.
TEST(Advice, RatiosThatAreUnknownAreNoReasonAgainstARung) {
    SweepResult result = sweep();
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (RungResult& r : result.rungs) r.ratio = {unknown, unknown, unknown};
    result.costs = {};
    EXPECT_EQ(choose(result, {.milliseconds = 1000}), 4U);
    EXPECT_TRUE(choose(result, {}).has_value());
    for (RungResult& r : result.rungs) r.alone.rmse = unknown;
    EXPECT_TRUE(choose(result, {.milliseconds = 1000}).has_value());
}

TEST(Advice, PictureThatIsNotFiniteIsNeverChosen) {
    SweepResult result = sweep();
    result.rungs[0].own.light.rmse = std::numeric_limits<double>::infinity();
    EXPECT_EQ(choose(result, {}), 2U);
    EXPECT_EQ(choose(result, {.milliseconds = 6}), 1U) << "nothing else is as fast: the cheapest of the others";
    result.cannot_say = "the ladder's draws cover no pixel";
    EXPECT_EQ(choose(result, {}), std::nullopt);
}

// What a picture hides may show in the next one.
TEST(Advice, OfEqualErrorsTheOneNearerToTheLastRungs) {
    SweepResult result;
    result.residual = 0;
    result.rungs = {rung("mistake", .001, 10), rung("right", .001, 10), rung("other", .001, 20)};
    for (std::size_t i = 0; i < 3; ++i) result.rungs[i].steps = {i};
    compare_all(result);
    EXPECT_EQ(choose(result, {.error = .01}), 1U);
    EXPECT_EQ(choose(result, {.milliseconds = 15}), 1U);
    EXPECT_EQ(choose(result, {}), 1U);
}

TEST(Advice, ErrorsCountWithTheResidualOfTheReference) {
    SweepResult result = sweep();
    result.residual = .003;
    EXPECT_EQ(choose(result, {.error = .005}), 3U) << "'same' has .004, and may have .007";
    EXPECT_EQ(choose(result, {.milliseconds = 1000}), 3U) << "'costly' and 'exact' are not told apart: the cheaper one";
}

TEST(Advice, WithoutAResidualNoErrorIsCertified) {
    SweepResult result = sweep();
    result.residual.reset();
    const Wish wish{.error = .1};
    EXPECT_FALSE(fulfils(result, result.rungs[*choose(result, wish)], wish));
    EXPECT_TRUE(fulfils(result, result.rungs[0], {.alone = .6}));
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
    EXPECT_NE(stored->measured.find("too few rounds"), std::string::npos) << "it was not trusted";
    EXPECT_FALSE(read_quality(quality_json(where, presets), "exact", error));
    for (const char* text : {"", "[]", "{}", "{\"schema\": 1}", "{\"schema\": 1, \"presets\": {\"fast\": 3}}", "{"}) {
        error.clear();
        EXPECT_FALSE(read_quality(text, "fast", error)) << text;
        EXPECT_FALSE(error.empty()) << text;
    }
}

}  // namespace
}  // namespace snell::accuracy
