// Medians, intervals and fronts with known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "src/accuracy/front.h"
#include "src/accuracy/statistics.h"

namespace snell::accuracy {
namespace {

// A cost with the noise of a shared machine: load that lasts for a round, and a few per cent of its own.
class Machine {
public:
    explicit Machine(unsigned seed) : random_(seed) {}

    // times[i][round] for true costs; 0 where a rung sits a round out.
    std::vector<std::vector<double>> measure(const std::vector<double>& costs, int rounds, double own = .02) {
        std::vector<std::vector<double>> times(costs.size());
        for (int round = 0; round < rounds; ++round) {
            const double load = 1 + std::abs(normal_(random_));
            for (std::size_t i = 0; i < costs.size(); ++i)
                times[i].push_back(costs[i] * load * (1 + own * std::abs(normal_(random_))));
        }
        return times;
    }

private:
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
};

std::vector<Point> points(const std::vector<double>& errors, std::vector<std::vector<double>> times) {
    std::vector<Point> result;
    for (std::size_t i = 0; i < errors.size(); ++i) result.push_back({errors[i], std::move(times[i])});
    return result;
}

TEST(Statistics, MediansAreTheMiddle) {
    EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2);
    EXPECT_EQ(median(std::vector<double>{4, 1, 2, 3}), 2.5);
    EXPECT_TRUE(std::isnan(median({})));
    EXPECT_EQ(mad(std::vector<double>{1, 1, 2, 2, 4, 6, 9}), 1);
    EXPECT_NEAR(variation(std::vector<double>{9, 10, 11}), .1, 1e-12);
}

TEST(Statistics, IntervalsCoverTheTruthNineteenTimesInTwenty) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(10, 1);
    int covered = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> values(31);
        for (double& value : values) value = normal(random);
        covered += bootstrap_median(values, 1, 400).contains(10) ? 1 : 0;
    }
    EXPECT_GE(covered, 180);
    EXPECT_LT(covered, 200) << "an interval that always covers says nothing";
}

TEST(Statistics, IntervalsOfOneSeedAreTheSame) {
    const std::vector<double> values{5, 3, 8, 1, 9, 4, 7};
    EXPECT_EQ(bootstrap_median(values, 3).low, bootstrap_median(values, 3).low);
    EXPECT_EQ(bootstrap_median(values, 3).high, bootstrap_median(values, 3).high);
    const Interval one = bootstrap_median(std::vector<double>{6});
    EXPECT_EQ(one.low, 4);
    EXPECT_EQ(one.high, 9) << "of one value little is known";
    EXPECT_TRUE(std::isnan(bootstrap_median({}).middle));
}

TEST(Statistics, LoadThatLastsForARoundCancelsInPairedRatios) {
    Machine machine(11);
    const auto times = machine.measure({10, 11}, 31);
    EXPECT_GT(variation(times[0]), .3) << "the machine of the test is noisy";
    const Interval ratio = paired_ratio(times[1], times[0]);
    EXPECT_NEAR(ratio.middle, 1.1, .02);
    EXPECT_LT(ratio.width(), .04);
}

TEST(Statistics, RoundsThatOneSatOutAreNoPairs) {
    const Interval ratio = paired_ratio(std::vector<double>{2, 0, 4, 6, 2, 8}, std::vector<double>{1, 1, 2, 3, 1, 4});
    EXPECT_EQ(ratio.low, 2);
    EXPECT_EQ(ratio.high, 2);
}

// Rungs that cost k units and have error 1/k are all on the front, whatever the machine does meanwhile.
TEST(Front, HarmonicLadderIsOnTheFrontInThreeRuns) {
    for (unsigned run = 1; run <= 3; ++run) {
        Machine machine(run);
        const std::vector<double> costs{1, 2, 4, 8, 16};
        const auto times = machine.measure(costs, 31);
        for (std::size_t i = 0; i < costs.size(); ++i)
            EXPECT_NEAR(paired_ratio(times[i], times[0]).middle, costs[i], .1 * costs[i]);
        const auto verdicts = pareto_front(points({1, .5, .25, .125, 0}, times));
        for (const Verdict& verdict : verdicts) EXPECT_EQ(verdict.standing, Standing::front) << "run " << run;
    }
}

TEST(Front, SlowerAndWorseIsDominatedByTheCheapestBetterOne) {
    Machine machine(5);
    // The third costs more than the second and is worse than it; the fourth is better, but dearer still.
    const auto verdicts = pareto_front(points({.9, .2, .5, .1}, machine.measure({1, 2, 3, 4}, 31)));
    EXPECT_EQ(verdicts[2], (Verdict{Standing::dominated, 1}));
    for (std::size_t i : {0, 1, 3}) EXPECT_EQ(verdicts[i].standing, Standing::front);
}

TEST(Front, DearerAndNoBetterIsDominated) {
    Machine machine(5);
    const auto verdicts = pareto_front(points({.3, .3}, machine.measure({1, 2}, 31)));
    EXPECT_EQ(verdicts[0].standing, Standing::front);
    EXPECT_EQ(verdicts[1], (Verdict{Standing::dominated, 0}));
}

TEST(Front, WorseAtEqualCostSavesNothing) {
    Machine machine(6);
    const auto times = machine.measure({10, 10, 20}, 41);
    EXPECT_TRUE(equal_cost(paired_ratio(times[0], times[1])));
    const auto verdicts = pareto_front(points({.5, .1, 0}, times));
    EXPECT_EQ(verdicts[0], (Verdict{Standing::saves_none, 1}));
    EXPECT_EQ(verdicts[1].standing, Standing::front);
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Front, HardlyDearerCostsTheSame) {
    const std::vector<double> one(15, 1), two_percent(15, 1.02), five_percent(15, 1.05);
    EXPECT_EQ(pareto_front(points({.5, 0}, {one, two_percent}))[0], (Verdict{Standing::saves_none, 1}));
    EXPECT_EQ(pareto_front(points({.5, 0}, {one, five_percent}))[0].standing, Standing::front);
    EXPECT_EQ(pareto_front(points({0, .5}, {two_percent, one}))[1], (Verdict{Standing::saves_none, 0}));
}

// Fifteen equal rungs make 105 pairs, of which five would differ "surely" in every run without a correction.
TEST(Front, ClaimsOfAllPairsHoldTogether) {
    int wrong = 0;
    for (unsigned run = 0; run < 100; ++run) {
        Machine machine(1000 + run);
        const auto verdicts =
            pareto_front(points(std::vector<double>(15, .5), machine.measure(std::vector<double>(15, 10), 31)));
        wrong += std::ranges::any_of(verdicts, [](const Verdict& v) { return v.standing == Standing::dominated; });
    }
    EXPECT_LE(wrong, 10) << "5 % of runs, and chance";
}

TEST(Statistics, SignTestsAndTheirCorrection) {
    const auto chance = [](int below, int above) {
        std::vector<double> ratios(static_cast<std::size_t>(below), .9);
        ratios.resize(static_cast<std::size_t>(below + above), 1.1);
        return chance_of_signs(ratios);
    };
    EXPECT_NEAR(chance(10, 0), 2 / 1024., 1e-9);
    EXPECT_NEAR(chance(1, 9), 22 / 1024., 1e-9);
    EXPECT_NEAR(chance(5, 5), 1, 1e-9);
    EXPECT_EQ(chance(0, 0), 1);
    EXPECT_EQ(chance_of_signs(std::vector<double>{.1, .2}), 0) << "no noise is as large";
    // .01 <= .05 / 4, .013 <= .05 / 3, but .03 > .05 / 2: it and what follows are chance.
    EXPECT_EQ(holm(std::vector<double>{.03, .01, .04, .013}, .05), (std::vector<bool>{false, true, false, true}));
    EXPECT_TRUE(holm({}, .05).empty());
}

TEST(Front, AsManyRoundsAsTheComparisonsNeed) {
    for (std::size_t rungs : {2, 3, 5, 10, 15}) {
        const std::size_t rounds = rounds_for(rungs);
        std::vector<double> errors;
        std::vector<std::vector<double>> times;
        for (std::size_t i = 0; i < rungs; ++i) {
            errors.push_back(.5);
            times.emplace_back(rounds, 1 + .01 * static_cast<double>(i));
        }
        for (std::size_t i = 1; i < rungs; ++i)
            EXPECT_EQ(pareto_front(points(errors, times))[i], (Verdict{Standing::dominated, 0})) << rungs;
        for (auto& t : times) t.pop_back();
        EXPECT_EQ(pareto_front(points(errors, times))[1].standing, Standing::front) << "one round less is not enough";
    }
}

TEST(Front, PictureThatIsNotFiniteIsLast) {
    Machine machine(14);
    const double infinite = std::numeric_limits<double>::infinity();
    const auto verdicts = pareto_front(points({infinite, .3, 0}, machine.measure({10, 5, 20}, 31)));
    EXPECT_EQ(verdicts[0], (Verdict{Standing::dominated, 1}));
    EXPECT_EQ(verdicts[1].standing, Standing::front);
    const auto cheapest = pareto_front(points({infinite, .3, 0}, machine.measure({1, 5, 20}, 31)));
    EXPECT_EQ(cheapest[0].standing, Standing::unknown) << "nobody wants it at any price";
    EXPECT_EQ(cheapest[1].standing, Standing::front);
}

TEST(Front, TwinsAreBothOnIt) {
    Machine machine(8);
    const auto verdicts = pareto_front(points({.3, .3}, machine.measure({5, 5}, 31)));
    EXPECT_EQ(verdicts[0].standing, Standing::front);
    EXPECT_EQ(verdicts[1].standing, Standing::front);
}

TEST(Front, OneRungAndNone) {
    EXPECT_TRUE(pareto_front({}).empty());
    EXPECT_EQ(pareto_front(points({0}, {{1, 2, 3}}))[0].standing, Standing::front);
}

TEST(Front, WhatWasNotMeasuredIsUnknownAndDominatesNobody) {
    const double nan = std::nan("");
    const auto verdicts = pareto_front(points({0, nan, .5}, {{}, {1, 1, 1}, {2, 2, 2}}));
    EXPECT_EQ(verdicts[0].standing, Standing::unknown);
    EXPECT_EQ(verdicts[1].standing, Standing::unknown);
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Front, EverythingAboveACheaperReferenceIsDominated) {
    Machine machine(9);
    const auto verdicts = pareto_front(points({.4, .2, 0}, machine.measure({3, 2, 1}, 31)));
    EXPECT_EQ(verdicts[0], (Verdict{Standing::dominated, 2}));
    EXPECT_EQ(verdicts[1], (Verdict{Standing::dominated, 2}));
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Control, SameRungTwiceIsQuiet) {
    Machine machine(3);
    const auto times = machine.measure({7, 7}, 31, .01);
    const Control quiet = control(times[0], times[1]);
    EXPECT_FALSE(quiet.noisy) << quiet.ratio.low << " to " << quiet.ratio.high;
}

TEST(Control, DifferentOrScatteredTimesAreNoisy) {
    Machine machine(4);
    const auto drifted = machine.measure({7, 7.9}, 31, .01);
    EXPECT_TRUE(control(drifted[0], drifted[1]).noisy);
    const auto scattered = machine.measure({7, 7}, 7, .5);
    EXPECT_TRUE(control(scattered[0], scattered[1]).noisy);
    EXPECT_TRUE(control({}, {}).noisy);
}

TEST(Control, CostsWithinTheNoiseOfTheRunAreEqual) {
    Machine machine(5);
    const auto times = machine.measure({7, 7.35, 6.65, 6.}, 31, .005);
    const Control drift = control(times[0], times[1]);
    EXPECT_FALSE(drift.noisy);
    EXPECT_NEAR(drift.noise, .05, .01);
    const auto front = [&](double noise) {
        return pareto_front(points({.2, .2, .2}, {times[0], times[2], times[3]}), noise);
    };
    // Without drift, 5 % less is sure after 31 rounds.
    EXPECT_EQ(front(0)[0].standing, Standing::dominated);
    EXPECT_EQ(front(drift.noise + .02)[0], (Verdict{Standing::dominated, 2})) << "by 14 %, and not by 5 %";
    EXPECT_EQ(pareto_front(points({.2, .2}, {times[0], times[2]}), drift.noise + .02)[0].standing, Standing::front);
    EXPECT_EQ(pareto_front(points({.2, .1}, {times[2], times[0]}), drift.noise + .02)[0],
              (Verdict{Standing::saves_none, 1}));
}

TEST(Cliffs, DearerThanBothNeighbours) {
    Machine machine(2);
    const auto times = machine.measure({2.5, 7.8, 3.2, 3.5}, 31);
    const std::vector<bool> found = cliffs(points({.3, .2, .1, 0}, times));
    EXPECT_EQ(found, (std::vector<bool>{false, true, false, false}));
    EXPECT_EQ(cliffs(points({.2, .1}, machine.measure({9, 1}, 31))), (std::vector<bool>{false, false}));
}

}  // namespace
}  // namespace snell::accuracy
