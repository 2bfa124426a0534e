// Where samples lie within a pixel.
#include <gtest/gtest.h>

#include <cmath>

#include "src/accuracy/sample_mean.h"

namespace snell::accuracy {
namespace {

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

}  // namespace
}  // namespace snell::accuracy
