// What the oracle has from the literature, against numbers that are printed elsewhere than its formulas.
#include "tests/oracle/optics/color.h"
#include "tests/oracle/optics/glass.h"
#include "tests/oracle/optics/irradiance.h"
#include "tests/std.h"

namespace snell::optics {
namespace {

// CIE 1931 2°, the printed table at five wavelengths; the fit is within .03.
TEST(Tables, MatchingFunctions) {
    const double table[][4] = {{450, 0.3362, 0.0380, 1.7721},
                               {500, 0.0049, 0.3230, 0.2720},
                               {550, 0.4334, 0.9950, 0.0087},
                               {600, 1.0622, 0.6310, 0.0008},
                               {650, 0.2835, 0.1070, 0.0000}};
    for (const auto& [nm, x, y, z] : table)
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(cie_1931(nm)[i], (glm::dvec3{x, y, z})[i], 0.03) << nm;
    EXPECT_LT(glm::length(xyz_to_linear_srgb({0.95047, 1.0, 1.08883}) - glm::dvec3(1)), 1e-4) << "white is white";
    for (int count : {3, 4, 8, 64, 500}) {
        glm::dvec3 sum(0);
        for (const Band& band : spectral_bands(count)) sum += band.rgb;
        EXPECT_LT(glm::length(sum - glm::dvec3(1)), 1e-12) << count;
    }
}

// The index at the d line that tables of minerals and catalogues of glass print, and the Abbe number.
TEST(Tables, Glass) {
    const struct {
        const char* name;
        double n_d, within, abbe;
    } printed[] = {
        {"air", 1.000277, 1e-6, 89.3},    {"ice", 1.3098, 4e-4, 54.6},      {"water", 1.3330, 5e-4, 55.8},
        {"Pyrex", 1.4714, 1e-6, 65.4},    {"quartz", 1.5443, 2e-4, 69.7},   {"window glass", 1.5234, 2e-4, 64.0},
        {"BK7", 1.51680, 1e-5, 64.17},    {"SF11", 1.78472, 1e-5, 25.68},   {"cubic zirconia", 2.1585, 1e-3, 33.5},
        {"diamond", 2.41749, 1e-4, 55.3}, {"moissanite", 2.690, 2e-3, 23.9}};
    for (const auto& p : printed) {
        const Glass* glass = find_glass(p.name);
        ASSERT_TRUE(glass) << p.name;
        EXPECT_NEAR(glass->index_d(), p.n_d, p.within) << p.name;
        EXPECT_NEAR(glass->abbe(), p.abbe, 0.1) << p.name;
    }
    EXPECT_NEAR(find_glass("ice")->index(400), 1.3194, 4e-4) << "Warren and Brandt 2008";
    EXPECT_NEAR(find_glass("ice")->index(750), 1.3059, 4e-4) << "Warren and Brandt 2008";
}

TEST(Tables, MetalsAreStraightBetweenMeasurements) {
    const Metal& gold = metals()[0];
    EXPECT_EQ(gold.name, "gold");
    EXPECT_EQ(gold.index(548.6).eta, 0.43);
    EXPECT_EQ(gold.index(548.6).k, 2.455);
    EXPECT_NEAR(gold.index((548.6 + 582.1) / 2).k, (2.455 + 2.863) / 2, 1e-12);
    EXPECT_EQ(gold.index(100).k, 1.952);
    EXPECT_EQ(gold.index(5000).k, 4.542);
}

TEST(Tables, SolidAnglesSumToTheSphere) {
    for (int size : {1, 2, 7, 64}) {
        double sum = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) sum += texel_solid_angle(column, row, size);
        EXPECT_NEAR(6 * sum, 4 * std::numbers::pi, 1e-12) << size;
    }
    const Radiance linear = [](const glm::dvec3& d) { return glm::dvec3(1 + d.x); };
    EXPECT_NEAR(irradiance(linear, {.6, 0, .8}, 64).x, 1 + 2. / 3 * .6, 1e-3) << "Ramamoorthi and Hanrahan's A1";
}

}  // namespace
}  // namespace snell::optics
