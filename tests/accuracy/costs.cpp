// How often claims about costs are wrong: thousands of measurements of costs that are known, on machines with any
// noise.
#include "src/accuracy/costs.h"
#include "tests/std.h"

namespace snell::accuracy {
namespace {

// By what the time of one frame is multiplied.
using Noise = std::function<double(std::mt19937&)>;

double busy(std::mt19937& random) { return std::exp(std::normal_distribution(0., .2)(random)); }
// Interrupted now and then, for long.
double skewed(std::mt19937& random) {
    return 1 + .02 * std::exponential_distribution(1.)(random) + (random() % 5 == 0 ? .7 : 0.);
}
// Two speeds, as of two kinds of cores.
double two_speeds(std::mt19937& random) {
    return (random() % 2 == 0 ? 1. : 1.6) * std::exp(std::normal_distribution(0., .002)(random));
}
// With a few outliers of any size.
double wild(std::mt19937& random) { return std::exp(.05 * std::cauchy_distribution(0., 1.)(random)); }

const Noise noises[]{busy, skewed, two_speeds, wild};

// times[i][round]; load that lasts for a round is common to all.
std::vector<std::vector<double>> measured(const std::vector<double>& costs, int rounds, const Noise& noise,
                                          std::mt19937& random) {
    std::vector<std::vector<double>> times(costs.size());
    for (int round = 0; round < rounds; ++round) {
        const double load = busy(random);
        for (std::size_t i = 0; i < costs.size(); ++i) times[i].push_back(costs[i] * load * noise(random));
    }
    return times;
}

// The part of 3000 measurements in which `claimed` is so.
double part(const std::vector<double>& costs, int rounds, const Noise& noise,
            const std::function<bool(const Costs&)>& claimed) {
    constexpr int trials = 3000;
    std::mt19937 random(17);
    int count = 0;
    for (int trial = 0; trial < trials; ++trial)
        count += claimed(Costs(measured(costs, rounds, noise, random), 0)) ? 1 : 0;
    return count / static_cast<double>(trials);
}

constexpr double chance = .012;  // three standard deviations of such a part

TEST(Costs, FourAnswers) {
    EXPECT_EQ(compare_costs({.40, .43, .47}), Cost::cheaper);
    EXPECT_EQ(compare_costs({1.1, 1.2, 1.3}), Cost::dearer);
    EXPECT_EQ(compare_costs({.98, .99, 1.02}), Cost::equal);
    EXPECT_EQ(compare_costs({.98, .985, .99}), Cost::equal) << "surely cheaper, and by no more than 3 %";
    EXPECT_EQ(compare_costs({.9, 1, 1.1}), Cost::not_told) << "nobody said that they are equal";
    EXPECT_EQ(compare_costs({0, 1, INFINITY}), Cost::not_told);
    EXPECT_EQ(compare_costs({NAN, NAN, NAN}), Cost::not_told);
    EXPECT_EQ(compare_costs({.8, 1, 1.2}, 0, .25), Cost::equal);
}

TEST(Costs, NoiseHidesSmallDifferencesOnly) {
    const double noise = .13;
    EXPECT_EQ(compare_costs({.40, .43, .47}, noise), Cost::cheaper);
    EXPECT_EQ(compare_costs({.8, .85, .9}, noise), Cost::not_told);
    EXPECT_EQ(compare_costs({.99, 1, 1.01}, noise), Cost::not_told) << "and it hides what is equal";
    EXPECT_EQ(compare_costs({1.1, 1.12, 1.2}, noise), Cost::not_told);
    EXPECT_EQ(compare_costs({.40, .43, .47}, INFINITY), Cost::not_told) << "a control of too few rounds";
    EXPECT_EQ(compare_costs({.40, .43, .47}, NAN), Cost::not_told);
}

TEST(Costs, EqualOnesAreRarelyToldApart) {
    for (const Noise& noise : noises)
        for (const int rounds : {6, 11, 31}) {
            const auto wrong = [](const Costs& costs) {
                return costs.of(0, 1) == Cost::cheaper || costs.of(0, 1) == Cost::dearer;
            };
            EXPECT_LE(part({10, 10}, rounds, noise, wrong), family_level + chance);
        }
}

// A rung that is dearer by no more than a hair is called cheaper at one end of the interval only.
TEST(Costs, DearerOnesAreHardlyEverCalledCheaper) {
    for (const Noise& noise : noises)
        EXPECT_LE(part({10.01, 10}, 15, noise, [](const Costs& costs) { return costs.of(0, 1) == Cost::cheaper; }),
                  family_level / 2 + chance);
}

TEST(Costs, DifferentOnesAreRarelyCalledEqual) {
    for (const Noise& noise : noises)
        for (const double ratio : {1 + same_cost, 1 / (1 + same_cost), 1.1})
            for (const int rounds : {6, 31})
                EXPECT_LE(part({10 * ratio, 10}, rounds, noise,
                               [](const Costs& costs) { return costs.of(0, 1) == Cost::equal; }),
                          family_level / 2 + chance);
}

// Nine rungs make 36 pairs, of which two would differ by chance at a level of 5 % each.
TEST(Costs, ClaimsOfAllPairsHoldTogether) {
    for (const Noise& noise : noises) {
        const auto wrong = [](const Costs& costs) {
            for (std::size_t i = 0; i < 9; ++i)
                for (std::size_t j = 0; j < 9; ++j)
                    if (costs.of(i, j) == Cost::cheaper) return true;
            return false;
        };
        EXPECT_LE(part(std::vector<double>(9, 10), 21, noise, wrong), family_level + chance);
    }
}

// What is said is worth something: large differences and equal costs are told, and nothing of a few rounds.
TEST(Costs, WhatIsPlainIsTold) {
    const auto cheaper = [](const Costs& costs) { return costs.of(0, 1) == Cost::cheaper; };
    for (const Noise& noise : noises) EXPECT_GE(part({4, 10}, 21, noise, cheaper), .9);
    EXPECT_EQ(part({4, 10}, 5, busy, cheaper), 0) << "a factor of 2.5 in five rounds may be chance";
    const Noise quiet = [](std::mt19937& random) { return 1 + std::normal_distribution(0., .01)(random); };
    EXPECT_GE(part({10, 10}, 31, quiet, [](const Costs& costs) { return costs.of(0, 1) == Cost::equal; }), .99);
}

TEST(Costs, WithoutCommonRoundsNothingIsTold) {
    const Costs costs(std::vector<std::vector<double>>{std::vector<double>(9, 1.), std::vector<double>(9, 0.)}, 0);
    EXPECT_EQ(costs.of(0, 1), Cost::not_told);
    EXPECT_EQ(costs.of(0, 7), Cost::not_told) << "no such rung";
    EXPECT_EQ(costs.middle(0, 1), 1);
}

}  // namespace
}  // namespace snell::accuracy
