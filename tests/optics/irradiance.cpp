#include "tests/oracle/optics/irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/hard_case.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

std::vector<glm::dvec3> directions(int count) {
    std::mt19937 random(5);
    std::normal_distribution<double> any;
    std::vector<glm::dvec3> out;
    while (static_cast<int>(out.size()) < count) out.push_back(*unit({any(random), any(random), any(random)}));
    return out;
}

glm::dvec3 sky(const glm::dvec3& d) {
    return d.y > 0 ? glm::mix(glm::dvec3(0.6, 0.8, 1.0), glm::dvec3(0.2, 0.4, 0.9), d.y) : glm::dvec3(0.2, 0.15, 0.1);
}
glm::dvec3 walls(const glm::dvec3& d) {
    const glm::dvec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x > 0 ? glm::dvec3(0.9, 0.3, 0.3) : glm::dvec3(0.3, 0.9, 0.3);
    if (a.y >= a.z) return d.y > 0 ? glm::dvec3(0.9) : glm::dvec3(0.4);
    return d.z > 0 ? glm::dvec3(0.3, 0.3, 0.9) : glm::dvec3(0.8, 0.8, 0.2);
}
// The same room with a bright window in the middle of the ceiling.
glm::dvec3 window(const glm::dvec3& d) {
    const bool open = d.y > 0 && std::abs(d.x) < 0.25 * d.y && std::abs(d.z) < 0.25 * d.y;
    return open ? glm::dvec3(40) : walls(d);
}

// Root mean square over normals, relative to the mean irradiance.
class Truth {
public:
    explicit Truth(const Radiance& radiance) {
        for (const glm::dvec3& n : normals_) truth_.push_back(irradiance(radiance, n, 64));
    }
    template <class F>
    double error(F approximation) const {
        double squares = 0, mean = 0;
        for (std::size_t i = 0; i < normals_.size(); ++i) {
            const glm::dvec3 off = approximation(normals_[i]) - truth_[i];
            squares += glm::dot(off, off);
            mean += truth_[i].x + truth_[i].y + truth_[i].z;
        }
        const double count = 3.0 * static_cast<double>(normals_.size());
        return std::sqrt(squares / count) / (mean / count);
    }

private:
    std::vector<glm::dvec3> normals_ = directions(150), truth_;
};

TEST(TexelSolidAngle, SumsToTheWholeSphere) {
    for (int size : {1, 2, 7, 64}) {
        double sum = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) sum += texel_solid_angle(column, row, size);
        EXPECT_NEAR(6 * sum, 4 * pi, 1e-12) << size;
    }
    EXPECT_NEAR(texel_solid_angle(511, 511, 1024) / texel_solid_angle(0, 0, 1024), 5.196, 0.02);
}

TEST(Harmonics, AreOrthonormal) {
    for (std::size_t i = 0; i < 9; ++i) {
        const Harmonics9 c = project([i](const glm::dvec3& d) { return glm::dvec3(harmonics(d)[i]); }, 64);
        for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(c[k].x, i == k ? 1 : 0, 1e-3) << i << " " << k;
    }
}

TEST(Irradiance, OfUniformLightIsThatLight) {
    const Radiance uniform = [](const glm::dvec3&) { return glm::dvec3(0.5, 1, 2); };
    const Harmonics9 c = project(uniform, 16);
    for (const glm::dvec3& n : directions(50)) {
        for (int order = 0; order <= 2; ++order)
            EXPECT_LT(glm::length(irradiance(c, n, order) - glm::dvec3(0.5, 1, 2)), 1e-2);
        EXPECT_LT(glm::length(irradiance(uniform, n, 64) - glm::dvec3(0.5, 1, 2)), 1e-2);
    }
}

// Light that grows linearly with a direction: irradiance is 2/3 of its slope (Ramamoorthi and Hanrahan's A1).
TEST(Irradiance, OfLinearLightIsTwoThirds) {
    const Harmonics9 c = project([](const glm::dvec3& d) { return glm::dvec3(1 + d.x); }, 64);
    for (const glm::dvec3& n : directions(50)) EXPECT_NEAR(irradiance(c, n).x, 1 + 2.0 / 3 * n.x, 1e-3);
}

TEST(IrradianceLadder, HasTheErrorsItPrints) {
    const struct {
        Radiance radiance;
        double by_normal, order[3];
    } printed[] = {
        {sky, .466, {.367, .0285, .0011}}, {walls, .319, {.259, .0351, .0009}}, {window, 4.41, {.769, .291, .0606}}};
    for (const auto& p : printed) {
        const Harmonics9 c = project(p.radiance, 64);
        const Truth truth(p.radiance);
        EXPECT_NEAR(truth.error(p.radiance) / p.by_normal, 1, 0.1);
        for (int order = 0; order <= 2; ++order) {
            const double off = truth.error([&](const glm::dvec3& n) { return irradiance(c, n, order); });
            EXPECT_NEAR(off / p.order[order], 1, 0.1) << order;
        }
    }
}

// Every texel taken as equally large is off by tens of percent where a small light is bright.
TEST(IrradianceLadder, ForgottenSolidAnglesShowInTheRoomWithAWindow) {
    Harmonics9 flat{};
    constexpr int size = 64;
    const Radiance scaled = [](const glm::dvec3& d) {
        const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        return window(d) / (largest * largest * largest) * (4 * pi / 24);  // undoes a texel's share
    };
    flat = project(scaled, size);
    const Harmonics9 right = project(window, size);
    const Truth truth(window);
    const double wrong_error = truth.error([&](const glm::dvec3& n) { return irradiance(flat, n); });
    const double right_error = truth.error([&](const glm::dvec3& n) { return irradiance(right, n); });
    EXPECT_GT(wrong_error, 3 * right_error);
    test::hard_case({"A22", "spherical harmonics of a room with a window; naive: texels without their solid angles",
                     "relative", .15, right_error, wrong_error});
}

TEST(Irradiance, IsNeverNegative) {
    const Radiance sun = [](const glm::dvec3& d) { return glm::dvec3(d.y > 0.996 ? 300 : 0); };
    const Harmonics9 c = project(sun, 128);
    int clamped = 0, negative = 0;
    for (const glm::dvec3& n : directions(500)) {
        const double value = irradiance(c, n).x;
        negative += value < 0;
        clamped += value == 0;
    }
    test::hard_case({"22", "spherical harmonics of a small sun are negative opposite to it: clamped",
                     "of 500 directions", 0, static_cast<double>(negative), static_cast<double>(clamped)});
}

}  // namespace
}  // namespace snell::optics
