#include "tests/oracle/optics/glass.h"
#include "tests/hard_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace snell::optics {
namespace {

// The index at the d line that tables of minerals and catalogues of glass print.
TEST(Glass, HasTheIndexOfTheTables) {
    const struct {
        const char* name;
        double n_d, within;
    } printed[] = {{"air", 1.000277, 1e-6},    {"ice", 1.3098, 4e-4},      {"water", 1.3330, 5e-4},
                   {"Pyrex", 1.4714, 1e-6},    {"quartz", 1.5443, 2e-4},   {"window glass", 1.5234, 2e-4},
                   {"BK7", 1.51680, 1e-5},     {"SF11", 1.78472, 1e-5},    {"cubic zirconia", 2.1585, 1e-3},
                   {"diamond", 2.41749, 1e-4}, {"moissanite", 2.690, 2e-3}};
    for (const auto& p : printed) {
        const Glass* glass = find_glass(p.name);
        ASSERT_TRUE(glass) << p.name;
        EXPECT_NEAR(glass->index_d(), p.n_d, p.within) << p.name;
        EXPECT_FALSE(glass->source.empty());
    }
    EXPECT_EQ(glasses().size(), std::size(printed));
    EXPECT_EQ(find_glass("kryptonite"), nullptr);
}

TEST(Glass, HasTheAbbeNumberOfTheCatalogues) {
    EXPECT_NEAR(find_glass("BK7")->abbe(), 64.17, 0.02);
    EXPECT_NEAR(find_glass("SF11")->abbe(), 25.68, 0.02);
    EXPECT_NEAR(find_glass("Pyrex")->abbe(), 65.4, 0.1);
    const struct {
        const char* name;
        double abbe;
    } printed[] = {{"air", 89.3},          {"ice", 54.6},     {"water", 55.8},      {"quartz", 69.7},
                   {"window glass", 64.0}, {"diamond", 55.3}, {"moissanite", 23.9}, {"cubic zirconia", 33.5}};
    for (const auto& p : printed) EXPECT_NEAR(find_glass(p.name)->abbe(), p.abbe, 0.1) << p.name;
}

// Ice's two-term fit against the table that it stands for (Warren and Brandt 2008).
TEST(Glass, IceFollowsItsTable) {
    const double table[][2] = {{400, 1.3194}, {450, 1.3157}, {500, 1.3130}, {550, 1.3110},
                               {600, 1.3094}, {650, 1.3080}, {700, 1.3069}, {750, 1.3059}};
    for (const auto& [nm, n] : table) EXPECT_NEAR(find_glass("ice")->index(nm), n, 4e-4) << nm;
}

TEST(Glass, BlueIsBentMost) {
    for (const Glass& glass : glasses()) {
        double before = 10;
        for (double nm = 380; nm <= 780; nm += 10) {
            EXPECT_LT(glass.index(nm), before) << glass.name << " at " << nm;
            before = glass.index(nm);
        }
    }
}

// At the poles of the fits, and outside of what can be seen.
TEST(Glass, EveryWavelengthHasAnIndex) {
    constexpr double wavelengths[] = {-1e9,  -100.0,  0.0,   62.543, 77.5, 100.3,   106.0,
                                      141.5, 166.739, 175.0, 189.7,  1e4,  10176.5, HUGE_VAL};
    const auto is_index = [](double n) { return n >= 1.0 && n < 3.5; };
    int bad = 0, bad_formula = 0;
    for (const Glass& glass : glasses()) {
        for (double nm : wavelengths) bad += !is_index(glass.index(nm));
        EXPECT_EQ(glass.index(std::numeric_limits<double>::quiet_NaN()), glass.index_d()) << glass.name;
        EXPECT_EQ(glass.index(0), glass.index(glass.shortest)) << glass.name;
        EXPECT_LE(glass.shortest, 380) << glass.name;
        EXPECT_GE(glass.longest, 780) << glass.name;
    }
    // Sellmeier's formula as printed, with the coefficients of BK7.
    for (double nm : wavelengths) {
        const double l2 = nm * nm * 1e-6;
        bad_formula +=
            !is_index(std::sqrt(1 + 1.03961212 * l2 / (l2 - 0.00600069867) + 0.231792344 * l2 / (l2 - 0.0200179144) +
                                1.01046945 * l2 / (l2 - 103.560653)));
    }
    test::hard_case(
        {"14",
         "indices of every glass at the poles of Sellmeier's formula and at wavelengths nobody sees; naive: "
         "the formula, for BK7 alone",
         "indices that are none", 0, static_cast<double>(bad), static_cast<double>(bad_formula)});
}

TEST(Metal, IsWhatWasMeasuredAndStraightBetween) {
    const Metal& gold = metals()[0];
    EXPECT_EQ(gold.name, "gold");
    EXPECT_EQ(gold.index(548.6).eta, 0.43);
    EXPECT_EQ(gold.index(548.6).k, 2.455);
    EXPECT_NEAR(gold.index((548.6 + 582.1) / 2).k, (2.455 + 2.863) / 2, 1e-12);
    EXPECT_EQ(gold.index(100).k, 1.952);
    EXPECT_EQ(gold.index(5000).k, 4.542);
    for (const Metal& metal : metals())
        EXPECT_EQ(metal.index(std::numeric_limits<double>::quiet_NaN()).k, metal.index(587.56).k) << metal.name;
}

}  // namespace
}  // namespace snell::optics
