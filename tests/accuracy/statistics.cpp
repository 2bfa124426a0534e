// Medians, intervals and fronts with known answers.
#include "src/accuracy/costs.h"
#include "tests/std.h"

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

std::vector<Verdict> verdicts_of(const std::vector<double>& errors, std::vector<std::vector<double>> times,
                                 double noise = 0) {
    const std::vector<Point> all = points(errors, std::move(times));
    return pareto_front(all, costs_of(all, noise));
}

std::vector<bool> cliffs_of(std::vector<std::vector<double>> times) { return cliffs(times.size(), Costs(times, 0)); }

TEST(Statistics, MediansAreTheMiddle) {
    EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2);
    EXPECT_EQ(median(std::vector<double>{4, 1, 2, 3}), 2.5);
    EXPECT_TRUE(std::isnan(median({})));
    EXPECT_EQ(mad(std::vector<double>{1, 1, 2, 2, 4, 6, 9}), 1);
    EXPECT_NEAR(variation(std::vector<double>{9, 10, 11}), .1, 1e-12);
}

TEST(Statistics, IntervalsCoverTheTruthNineteenTimesInTwenty) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> skewed(1, 1);
    for (const std::size_t n : {7, 12, 31}) {
        int covered = 0;
        for (int trial = 0; trial < 4000; ++trial) {
            std::vector<double> values(n);
            for (double& value : values) value = skewed(random);
            covered += median_interval(values).contains(std::exp(1)) ? 1 : 0;
        }
        EXPECT_GE(covered, 3760) << n << ": 95 %, and chance";
        EXPECT_LT(covered, 3990) << "an interval that always covers says nothing";
    }
}

TEST(Statistics, IntervalsAreValuesThatCoinsWouldHaveToMiss) {
    std::vector<double> values{5, 3, 8, 1, 9, 4, 7};
    EXPECT_EQ(median_interval(values).low, 1);
    EXPECT_EQ(median_interval(values).high, 9) << "2 / 128 is below .05, and 16 / 128 is not";
    values.insert(values.end(), {2, 6});
    EXPECT_EQ(median_interval(values).low, 2) << "20 / 512 is below .05";
    EXPECT_EQ(median_interval(values, .01).low, 1);
    const Interval few = median_interval(std::vector<double>{6, 7, 8, 9, 10});
    EXPECT_EQ(few.low, 0);
    EXPECT_TRUE(std::isinf(few.high)) << "of five values little is known";
    EXPECT_TRUE(std::isnan(median_interval({}).middle));
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
    const Interval ratio =
        paired_ratio(std::vector<double>{2, 0, 4, 6, 2, 8, 2}, std::vector<double>{1, 1, 2, 3, 1, 4, 1});
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
        const auto verdicts = verdicts_of({1, .5, .25, .125, 0}, times);
        for (const Verdict& verdict : verdicts) EXPECT_EQ(verdict.standing, Standing::front) << "run " << run;
    }
}

TEST(Front, SlowerAndWorseIsDominatedByTheCheapestBetterOne) {
    Machine machine(5);
    // The third costs more than the second and is worse than it; the fourth is better, but dearer still.
    const auto verdicts = verdicts_of({.9, .2, .5, .1}, machine.measure({1, 2, 3, 4}, 31));
    EXPECT_EQ(verdicts[2], (Verdict{Standing::dominated, 1}));
    for (std::size_t i : {0, 1, 3}) EXPECT_EQ(verdicts[i].standing, Standing::front);
}

TEST(Front, DearerAndNoBetterIsDominated) {
    Machine machine(5);
    const auto verdicts = verdicts_of({.3, .3}, machine.measure({1, 2}, 31));
    EXPECT_EQ(verdicts[0].standing, Standing::front);
    EXPECT_EQ(verdicts[1], (Verdict{Standing::dominated, 0}));
}

TEST(Front, WorseAtEqualCostSavesNothing) {
    Machine machine(6);
    const auto times = machine.measure({10, 10, 20}, 41);
    EXPECT_TRUE(compare_costs(paired_ratio(times[0], times[1])) == Cost::equal);
    const auto verdicts = verdicts_of({.5, .1, 0}, times);
    EXPECT_EQ(verdicts[0], (Verdict{Standing::saves_none, 1}));
    EXPECT_EQ(verdicts[1].standing, Standing::front);
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Front, HardlyDearerCostsTheSame) {
    const std::vector<double> one(15, 1), two_percent(15, 1.02), five_percent(15, 1.05);
    EXPECT_EQ(verdicts_of({.5, 0}, {one, two_percent})[0], (Verdict{Standing::saves_none, 1}));
    EXPECT_EQ(verdicts_of({.5, 0}, {one, five_percent})[0].standing, Standing::front);
    EXPECT_EQ(verdicts_of({0, .5}, {two_percent, one})[1], (Verdict{Standing::saves_none, 0}));
}

// .69 [.65, .76] beside .81 [.72, .88]: nobody said that they are equal.
TEST(Front, WhatIsNotToldApartIsNotSaidToBeEqual) {
    Machine machine(6);
    const auto times = machine.measure({.9, 1}, 9, .3);
    EXPECT_EQ(verdicts_of({.5, 0}, times)[0], (Verdict{Standing::unsure, 1}));
    const auto quiet = machine.measure({1, 1}, 41, .005);
    EXPECT_EQ(verdicts_of({.5, 0}, quiet)[0], (Verdict{Standing::saves_none, 1}));
}

// A crowd of rungs, each too close to the next, hid the cheap end of the front.
TEST(Front, NeighboursThatAreNotToldApartDoNotKeepTheCheaperOneAway) {
    std::vector<std::vector<double>> times(3, std::vector<double>(31));
    for (std::size_t round = 0; round < 31; ++round) {
        times[0][round] = .9;                           // surely cheaper than the last
        times[1][round] = round % 2 == 0 ? .88 : 1.02;  // anything between both
        times[2][round] = 1;
    }
    const auto verdicts = verdicts_of({.03, .02, .01}, times);
    EXPECT_EQ(verdicts[0].standing, Standing::front);
    EXPECT_EQ(verdicts[1], (Verdict{Standing::unsure, 2}));
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Front, AsManyRoundsAsTheComparisonsNeed) {
    for (std::size_t rungs : {2, 3, 5, 10, 15}) {
        const std::size_t rounds = rounds_for(rungs);
        std::vector<double> errors;
        std::vector<std::vector<double>> times;
        for (std::size_t i = 0; i < rungs; ++i) {
            errors.push_back(.5);
            times.emplace_back(rounds, 1 + .1 * static_cast<double>(i));
        }
        for (std::size_t i = 1; i < rungs; ++i)
            EXPECT_EQ(verdicts_of(errors, times)[i], (Verdict{Standing::dominated, 0})) << rungs;
        for (auto& t : times) t.pop_back();
        EXPECT_EQ(verdicts_of(errors, times)[1].standing, Standing::front) << "one round less is not enough";
    }
}

TEST(Front, PictureThatIsNotFiniteIsLast) {
    Machine machine(14);
    const double infinite = std::numeric_limits<double>::infinity();
    const auto verdicts = verdicts_of({infinite, .3, 0}, machine.measure({10, 5, 20}, 31));
    EXPECT_EQ(verdicts[0], (Verdict{Standing::dominated, 1}));
    EXPECT_EQ(verdicts[1].standing, Standing::front);
    const auto cheapest = verdicts_of({infinite, .3, 0}, machine.measure({1, 5, 20}, 31));
    EXPECT_EQ(cheapest[0].standing, Standing::unknown) << "nobody wants it at any price";
    EXPECT_EQ(cheapest[1].standing, Standing::front);
}

TEST(Front, TwinsAreBothOnIt) {
    Machine machine(8);
    const auto verdicts = verdicts_of({.3, .3}, machine.measure({5, 5}, 31));
    EXPECT_EQ(verdicts[0].standing, Standing::front);
    EXPECT_EQ(verdicts[1].standing, Standing::front);
}

TEST(Front, OneRungAndNone) {
    EXPECT_TRUE(pareto_front({}, {}).empty());
    EXPECT_EQ(verdicts_of({0}, {{1, 2, 3}})[0].standing, Standing::front);
}

TEST(Front, WhatWasNotMeasuredIsUnknownAndDominatesNobody) {
    const double nan = std::nan("");
    const auto verdicts = verdicts_of({0, nan, .5}, {{}, {1, 1, 1}, {2, 2, 2}});
    EXPECT_EQ(verdicts[0].standing, Standing::unknown);
    EXPECT_EQ(verdicts[1].standing, Standing::unknown);
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Front, EverythingAboveACheaperReferenceIsDominated) {
    Machine machine(9);
    const auto verdicts = verdicts_of({.4, .2, 0}, machine.measure({3, 2, 1}, 31));
    EXPECT_EQ(verdicts[0], (Verdict{Standing::dominated, 2}));
    EXPECT_EQ(verdicts[1], (Verdict{Standing::dominated, 2}));
    EXPECT_EQ(verdicts[2].standing, Standing::front);
}

TEST(Control, WhatARungShowsAgainstItselfIsNoDifference) {
    Machine machine(3);
    const auto times = machine.measure({7, 7, 7.9}, 31, .01);
    EXPECT_LT(control(times[0], times[1]).noise, .03);
    EXPECT_NEAR(control(times[0], times[2]).noise, .13, .03);
    EXPECT_NEAR(control(times[2], times[0]).noise, .13, .03) << "whichever of them was the faster one";
    EXPECT_TRUE(std::isinf(control(std::vector<double>(3, 1.), std::vector<double>(3, 1.)).noise));
    EXPECT_FALSE(control({}, {}).noise <= 0);
}

// A busy machine hides small differences, and no large ones.
TEST(Control, AClaimIsJudgedByTheNoiseAndNotTheRun) {
    Machine machine(5);
    const auto times = machine.measure({10, 9.3, 4.3}, 31, .005);
    const auto verdicts = [&](double noise) { return verdicts_of({0, .1, .2}, times, noise); };
    EXPECT_EQ(verdicts(0)[1].standing, Standing::front);
    EXPECT_EQ(verdicts(.13)[1], (Verdict{Standing::unsure, 0}));
    EXPECT_EQ(verdicts(.13)[2].standing, Standing::front);
}

TEST(Cliffs, DearerThanBothNeighbours) {
    Machine machine(2);
    const auto times = machine.measure({2.5, 7.8, 3.2, 3.5}, 31);
    const std::vector<bool> found = cliffs_of(times);
    EXPECT_EQ(found, (std::vector<bool>{false, true, false, false}));
    EXPECT_EQ(cliffs_of(machine.measure({9, 1}, 31)), (std::vector<bool>{false, false}));
}

}  // namespace
}  // namespace snell::accuracy
