// Mistakes that are printed in well-known teaching material, each beside the right form, and how far they are apart:
// the figures of docs/teaching.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

using std::numbers::pi;
constexpr double degrees = 180 / pi;

struct Error {
    double mean = 0, largest = 0;
};

// Over the disc that a ball seen from afar covers; `off` by the cosine of the angle of incidence.
Error over_disc(const std::function<double(double)>& off) {
    Error error;
    constexpr int rings = 20'000;
    for (int i = 0; i < rings; ++i) {
        const double impact2 = (i + .5) / rings, e = off(std::sqrt(1 - impact2));
        error.mean += e / rings;
        error.largest = std::max(error.largest, e);
    }
    return error;
}

void expect_near(double value, double expected) { EXPECT_NEAR(value / expected, 1, .1) << value; }

glm::dvec3 incident(double angle) { return {std::sin(angle), 0, -std::cos(angle)}; }
const glm::dvec3 up{0, 0, 1};

// The direction to the surface as it comes from the vertex shader: as long as the surface is far.
Error unnormalised_refract(double distance) {
    Error error;
    int count = 0;
    constexpr int size = 400;
    const double extent = 1 / std::sqrt(distance * distance - 1);  // of the ball's outline, at distance 1
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::dvec3 d = *unit({extent * ((2 * x + 1.) / size - 1), extent * ((2 * y + 1.) / size - 1), -1.0});
            const glm::dvec3 eye{0, 0, distance};
            const double b = glm::dot(eye, d), k = b * b - distance * distance + 1;
            if (k <= 0) continue;
            const glm::dvec3 point = eye + (-b - std::sqrt(k)) * d;
            const double off =
                angle_between(glsl_refract(point - eye, point, 1 / 1.5), glsl_refract(d, point, 1 / 1.5));
            error.mean += off * degrees;
            error.largest = std::max(error.largest, off * degrees);
            ++count;
        }
    error.mean /= count;
    return error;
}

TEST(Errata, RefractOfADirectionThatIsTooLong) {
    expect_near(unnormalised_refract(4).mean, 14.9);
    expect_near(unnormalised_refract(4).largest, 33);
    expect_near(unnormalised_refract(2).mean, 4.3);
    expect_near(unnormalised_refract(10).mean, 17.6);
}

// An interpolated normal is a little short. reflect() is linear in the direction, but not in the normal.
TEST(Errata, ReflectAtANormalThatIsTooShort) {
    const auto turned = [](double length) {
        double largest = 0;
        for (double a = 0; a < pi / 2; a += .001)
            largest =
                std::max(largest, angle_between(glsl_reflect(incident(a), length * up), *mirror(incident(a), up)));
        return largest * degrees;
    };
    expect_near(turned(.99), 1.16);
    expect_near(turned(.95), 6.2);
    const glm::dvec3 i = incident(.7);
    EXPECT_LT(angle_between(glsl_reflect(3. * i, up), *mirror(i, up)), 1e-12)
        << "the direction's length does not matter";
}

// The cube map belongs to the world. What is looked up in eye coordinates is off by the camera's turn.
TEST(Errata, EyeCoordinatesAreTurnedWithTheCamera) {
    for (const double turn : {0., 10., 47., 90.}) {
        double largest = 0;
        for (double a = 0; a < 2 * pi; a += .1)
            for (double h = -1; h <= 1; h += .1) {
                const double r = std::sqrt(std::max(0., 1 - h * h)), c = std::cos(turn / degrees),
                             s = std::sin(turn / degrees);
                const glm::dvec3 world{r * std::cos(a), h, r * std::sin(a)};
                const glm::dvec3 eye{c * world.x - s * world.z, world.y, s * world.x + c * world.z};
                largest = std::max(largest, angle_between(eye, world) * degrees);
            }
        EXPECT_NEAR(largest, turn, 1e-4 + turn * .001);
    }
}

// As n1/n2 an index is light on its way out: it begins to be totally reflected, which light on its way in never is.
TEST(Errata, AnIndexWhereARatioIsDue) {
    const auto total = [](double eta) {
        double first = 90;
        for (double a = 89.99; a > 0; a -= .01)
            if (glsl_refract(incident(a / degrees), up, eta) == glm::dvec3(0)) first = a;
        return first;
    };
    EXPECT_NEAR(total(1.1), 65.4, .1);
    EXPECT_NEAR(total(1.5), 41.8, .1);
    EXPECT_EQ(total(1 / 1.1), 90);
    // Where there is a ray, it bends the wrong way.
    const double a = 30 / degrees;
    EXPECT_GT(angle_between(glsl_refract(incident(a), up, 1.5), -up), a);
    EXPECT_LT(angle_between(glsl_refract(incident(a), up, 1 / 1.5), -up), a);
}

constexpr double glass = 1.52;
double exact(double c) { return fresnel(c, 1, glass); }
double f0() { return normal_reflectance(1, glass); }

TEST(Errata, OnePlusTheCosine) {
    const auto printed = [](double c) { return f0() + (1 - f0()) * std::pow(1 + c, 2); };
    expect_near(printed(1), 3.87);
    const Error error = over_disc([&](double c) { return std::abs(printed(c) - exact(c)); });
    expect_near(error.largest, 3.83);
    expect_near(error.mean, 2.67);
}

// Schlick's reflectance worked out, and the one for normal incidence used.
TEST(Errata, TheConstantInsteadOfTheReflectance) {
    const Error error = over_disc([](double c) { return std::abs(f0() - exact(c)); });
    expect_near(error.mean, .052);
    expect_near(error.largest, .957);
}

TEST(Errata, PowerTwoIsNotSchlicks) {
    const auto off = [](double power) {
        return over_disc([power](double c) { return std::abs(schlick(c, f0(), power) - exact(c)); });
    };
    expect_near(off(2).mean, .107);
    expect_near(off(2).largest, .315);
    expect_near(off(5).mean, .0090);
    expect_near(off(5).largest, .0345);
}

// n1/n2 that grows from red to blue: the index falls, and red is bent most.
TEST(Errata, RedBentMost) {
    const auto bent = [](double eta, double a) {
        return angle_between(glsl_refract(incident(a), up, eta), incident(a)) * degrees;
    };
    double smallest = 90;
    for (double a = .05; a < 1.5; a += .05) {
        EXPECT_GT(bent(.66, a), bent(.66 + .02, a)) << "as printed";
        EXPECT_LT(bent(.66, a), bent(.66 - .02, a)) << "as it is";
        smallest = std::min(smallest, bent(.66, a) - bent(.68, a));
    }
    EXPECT_GT(smallest, 0);
    // (n yellow - 1) / (n blue - n red) of the printed steps: no glass has so little, and none a negative one.
    expect_near((1 / .67 - 1) / (1 / .66 - 1 / .68), 11.05);
}

TEST(Errata, WeightsOfMirrorAndGlassSwapped) {
    const auto printed = [](double c) { return std::pow(c, 1.55); };
    const Error swapped = over_disc([&](double c) { return std::abs(printed(c) - exact(c)); });
    const Error right = over_disc([&](double c) { return std::abs(1 - printed(c) - exact(c)); });
    expect_near(swapped.largest, 1);
    expect_near(swapped.mean, .52);
    EXPECT_GT(swapped.mean, 1.3 * right.mean);
    EXPECT_GT(printed(1), 20 * exact(1)) << "all light mirrored where glass mirrors 4 %";
}

}  // namespace
}  // namespace snell::optics
