#include "tests/oracle/optics/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "tests/oracle/optics/glass.h"

namespace snell::optics {
namespace {

// CIE 1931 2°, the printed table at five wavelengths; the fit is within .03.
TEST(Cie1931, IsNearTheTable) {
    const double table[][4] = {{450, 0.3362, 0.0380, 1.7721},
                               {500, 0.0049, 0.3230, 0.2720},
                               {550, 0.4334, 0.9950, 0.0087},
                               {600, 1.0622, 0.6310, 0.0008},
                               {650, 0.2835, 0.1070, 0.0000}};
    for (const auto& [nm, x, y, z] : table) {
        EXPECT_NEAR(cie_1931(nm).x, x, 0.03) << nm;
        EXPECT_NEAR(cie_1931(nm).y, y, 0.03) << nm;
        EXPECT_NEAR(cie_1931(nm).z, z, 0.03) << nm;
    }
}

TEST(Cie1931, IsFiniteEverywhere) {
    for (double nm : {-1e30, 0.0, 1e30, HUGE_VAL, -HUGE_VAL}) {
        EXPECT_TRUE(std::isfinite(cie_1931(nm).x)) << nm;
        EXPECT_LT(glm::length(cie_1931(nm)), 1e-3) << nm;
    }
    EXPECT_EQ(cie_1931(std::numeric_limits<double>::quiet_NaN()), glm::dvec3(0));
}

TEST(LinearSrgb, WhiteOfD65IsWhite) {
    const glm::dvec3 white = xyz_to_linear_srgb({0.95047, 1.0, 1.08883});
    EXPECT_LT(glm::length(white - glm::dvec3(1)), 1e-4);
    // Luminance of the primaries, as the standard rounds them.
    EXPECT_GT(xyz_to_linear_srgb({0.4124, 0.2126, 0.0193}).r, 0.999);
    EXPECT_NEAR(xyz_to_linear_srgb({0.4124, 0.2126, 0.0193}).g, 0.0, 1e-3);
}

TEST(SpectralBands, KeepWhiteWhite) {
    for (Weights weights : {Weights::integrated, Weights::midpoint})
        for (int count : {3, 4, 6, 8, 16, 32, 64, 500}) {
            glm::dvec3 sum(0);
            double before = 380;
            for (const Band& band : spectral_bands(count, weights)) {
                sum += band.rgb;
                EXPECT_GT(band.nanometres, before);
                before = band.nanometres;
            }
            EXPECT_LE(before, 780);
            EXPECT_LT(glm::length(sum - glm::dvec3(1)), 1e-12) << count;
        }
}

// The ladder of dispersion: a glass ball in white light before a step edge. Along the radius of its picture, what is
// turned by more than the edge's angle is bright. One edge meets few wavelengths, so many edges are tried.
class Fringe {
public:
    explicit Fringe(const Glass& glass) : glass_(glass), reference_(picture(spectral_bands(1024, Weights::midpoint))) {}

    using Picture = std::vector<glm::dvec3>;
    Picture picture(const std::vector<Band>& bands) const {
        Picture out(edges * pixels, glm::dvec3(0));
        for (const Band& band : bands) {
            const double n = glass_.index(band.nanometres);
            for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
                const double b = 0.2 + 0.75 * (static_cast<double>(pixel) + 0.5) / pixels;
                const double turned = 2 * (std::asin(b) - std::asin(b / n));
                for (std::size_t edge = 0; edge < edges; ++edge)
                    if (turned > 0.4 + 0.02 * static_cast<double>(edge)) out[edge * pixels + pixel] += band.rgb;
            }
        }
        return out;
    }
    // Against 1024 wavelengths, in linear sRGB.
    double rmse(const std::vector<Band>& bands) const {
        const Picture p = picture(bands);
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += glm::dot(p[i] - reference_[i], p[i] - reference_[i]);
        return std::sqrt(sum / 3 / static_cast<double>(p.size()));
    }

private:
    static constexpr std::size_t pixels = 1500, edges = 14;
    const Glass& glass_;
    Picture reference_;
};

const std::vector<Band> one_index = {{587.56, glm::dvec3(1)}};
const std::vector<Band> three_indices = {
    {rgb_wavelengths.r, {1, 0, 0}}, {rgb_wavelengths.g, {0, 1, 0}}, {rgb_wavelengths.b, {0, 0, 1}}};

TEST(DispersionLadder, HasTheErrorsItPrints) {
    const Fringe fringe(*find_glass("BK7"));
    EXPECT_NEAR(fringe.rmse(one_index) / 0.052, 1, 0.1);
    EXPECT_NEAR(fringe.rmse(three_indices) / 0.0186, 1, 0.1);
    const std::pair<int, double> midpoint[] = {{4, .034}, {6, .019}, {8, .0134}, {16, .0061}, {32, .0032}, {64, .0014}};
    for (const auto& [count, expected] : midpoint)
        EXPECT_NEAR(fringe.rmse(spectral_bands(count, Weights::midpoint)) / expected, 1, 0.1) << count;
    const std::pair<int, double> integrated[] = {{4, .0169}, {6, .0135}, {8, .0114}, {16, .0058}, {32, .0030}};
    for (const auto& [count, expected] : integrated)
        EXPECT_NEAR(fringe.rmse(spectral_bands(count)) / expected, 1, 0.1) << count;
}

TEST(DispersionLadder, IntegratedWeightsMakeFourBandsBetterThanThreeIndices) {
    for (const char* name : {"BK7", "SF11", "diamond"}) {
        const Fringe fringe(*find_glass(name));
        EXPECT_LT(fringe.rmse(spectral_bands(4)), fringe.rmse(three_indices)) << name;
        EXPECT_GT(fringe.rmse(spectral_bands(4, Weights::midpoint)), fringe.rmse(three_indices)) << name;
        double before = 1;
        for (int count : {4, 8, 16, 32, 64}) {
            const double error = fringe.rmse(spectral_bands(count));
            EXPECT_LT(error, before) << name << " " << count;
            before = error;
        }
    }
}

// As in tutorials that give blue the largest ratio of indices.
TEST(DispersionLadder, ColoursInTheWrongOrderAreWorseThanNone) {
    const Fringe fringe(*find_glass("BK7"));
    const double none = fringe.rmse(one_index);
    const std::vector<Band> swapped = {
        {rgb_wavelengths.b, {1, 0, 0}}, {rgb_wavelengths.g, {0, 1, 0}}, {rgb_wavelengths.r, {0, 0, 1}}};
    EXPECT_GT(fringe.rmse(swapped), none);
    EXPECT_NEAR(fringe.rmse(swapped) / 0.0696, 1, 0.1);
}

}  // namespace
}  // namespace snell::optics
