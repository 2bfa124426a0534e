#include "tests/oracle/optics/ray.h"
#include "shaders/embedded.h"
#include "tests/hard_case.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryRay : public LibraryTest {};

constexpr std::string_view ray_include = "#include <snell/ray.glsl>\n";
constexpr std::string_view hit_ball =
    "float t0, t1; bool hit = snellHitSphere(a.xyz, b.xyz, vec3(0.), 1., t0, t1); return vec4(t0, t1, hit ? 1. : 0., "
    "0.);";

// Toward points within .95 of the ball's radius, from a distance.
std::vector<Arguments> from_afar(double distance) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> any(0, 0.95);
    std::vector<Arguments> out;
    for (const glm::dvec3& d : unit_vectors(1000)) {
        const glm::dvec3 side = *unit(glm::cross(d, glm::dvec3(0.3, 0.5, 0.8)));
        out.push_back({{glm::vec3(d * distance), 0}, {glm::vec3(*unit(any(random) * side - d * distance)), 0}, {}});
    }
    return out;
}

TEST_P(LibraryRay, ABallIsHitFromAfar) {
    for (double distance : {3.0, 10.0, 100.0, 1000.0}) {
        const auto arguments = from_afar(distance);
        const auto results = run(ray_include, hit_ball, arguments);
        const auto textbook = run("",
                                  "float q = dot(a.xyz, b.xyz), k = q * q - (dot(a.xyz, a.xyz) - 1.);"
                                  "return vec4(k < 0. ? 0. : -q - sqrt(k));",
                                  arguments);
        double worst = 0, worst_textbook = 0;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            // The direction as it was given: its rounding is not the function's.
            const glm::dvec3 d = vec(arguments[i].b);
            const auto truth = cross_sphere({vec(arguments[i].a), d}, glm::dvec3(0), 1);
            ASSERT_TRUE(truth);
            EXPECT_EQ(results[i].z, 1) << distance;
            EXPECT_NEAR(results[i].x, truth->enter * glm::length(d), 1e-6 * distance + 2e-6) << distance;
            worst = worse(worst, std::abs(results[i].x - truth->enter * glm::length(d)));
            EXPECT_NEAR(results[i].y, truth->leave * glm::length(d), 1e-6 * distance + 2e-6) << distance;
            worst_textbook = std::max(worst_textbook, std::abs(textbook[i].x - truth->enter));
        }
        if (distance == 1000.0)
            hard_case({"68", "a unit ball 1000 away is hit where it is; naive: b² - c", "units of length", 1e-3, worst,
                       worst_textbook});
    }
}

TEST_P(LibraryRay, BoxesAndMissesAgreeWithTheOracle) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-4, 4);
    std::vector<Arguments> arguments;
    for (const glm::dvec3& d : unit_vectors(2000))
        arguments.push_back({{any(random), any(random), any(random), 0}, {glm::vec3(d), 0}, {}});
    for (int axis = 0; axis < 3; ++axis)
        for (float at : {-3.0F, -1.0F, 0.0F, 2.0F, 2.5F}) {
            Arguments along{{at, at, at, 0}, {}, {}};
            along.b[axis] = 1;
            arguments.push_back(along);
        }
    const auto balls = run(ray_include, hit_ball, arguments);
    const auto boxes = run(ray_include,
                           "float t0, t1; bool hit = snellHitBox(a.xyz, b.xyz, vec3(-1., -2., -3.), vec3(2.), t0, t1);"
                           "return vec4(t0, t1, hit ? 1. : 0., 0.);",
                           arguments);
    int hits = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Ray ray{vec(arguments[i].a), vec(arguments[i].b)};
        const auto ball = cross_sphere(ray, glm::dvec3(0), 1), box = cross_box(ray, {-1, -2, -3}, {2, 2, 2});
        const bool ball_grazed = ball && ball->leave - ball->enter < 0.02;
        const bool box_grazed = box && box->leave - box->enter < 1e-4;
        EXPECT_TRUE(ball_grazed || balls[i].z == (ball ? 1 : 0)) << i;
        EXPECT_TRUE(box_grazed || boxes[i].z == (box ? 1 : 0)) << i;
        if (!box || boxes[i].z == 0) continue;
        ++hits;
        EXPECT_NEAR(boxes[i].x, box->enter, 1e-5 * (1 + std::abs(box->enter))) << i;
        EXPECT_NEAR(boxes[i].y, box->leave, 1e-5 * (1 + std::abs(box->leave))) << i;
    }
    EXPECT_GT(hits, 200);
}

// GPUs' compilers take !(x > 0.) for x <= 0., which is false for NaN: conditions say what must hold. llvmpipe doesn't,
// so that only their text shows it here.
TEST(Library, ConditionsSayWhatMustHold) {
    for (const char* file : {"bands", "color", "core", "dispersion", "environment", "fresnel", "irradiance", "mesh",
                             "noise", "ray", "refraction"}) {
        const std::string_view text = embedded_shader("snell/" + std::string(file) + ".glsl");
        EXPECT_FALSE(text.empty()) << file;
        EXPECT_EQ(text.find("!("), std::string_view::npos) << file;
    }
}

// Values that break naive code.
TEST_P(LibraryRay, SpecialValuesGiveNumbers) {
    const auto arguments = special_arguments(10000);
    const std::string_view bodies[] = {hit_ball,
                                       "float t0, t1; bool hit = snellHitBox(a.xyz, b.xyz, vec3(-1.), vec3(1.), t0, "
                                       "t1); return vec4(t0, t1, 0., 0.);"};
    for (const std::string_view body : bodies) expect_each(run(ray_include, body, arguments), arguments, body, finite);
    const Arguments bright{{1, 2, 3, 0}, {HUGE_VALF, HUGE_VALF, HUGE_VALF, 0}, {}};
    const auto mixed = run("#include <snell/core.glsl>\n", "return vec4(snellMix(a.xyz, b.xyz, a.w), 1.);", {bright});
    const auto by_glsl = run("", "return vec4(mix(a.xyz, b.xyz, a.w), 1.);", {bright});
    hard_case({"69", "mixing none of an infinite colour in; naive: mix(x, inf, 0.)", "off the colour", 0,
               glm::length(vec(mixed[0]) - glm::dvec3(1, 2, 3)), glm::length(vec(by_glsl[0]) - glm::dvec3(1, 2, 3))});
    const auto half =
        run("#include <snell/core.glsl>\n", "return vec4(snellMix(a.xyz, vec3(3., 4., 5.), .5), 1.);", {bright});
    EXPECT_LT(glm::length(vec(half[0]) - glm::dvec3(2, 3, 4)), 1e-6);
}

SNELL_IN_ALL_DIALECTS(LibraryRay);

}  // namespace
}  // namespace snell::test
