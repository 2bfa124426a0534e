#include <algorithm>
#include <cmath>
#include <random>

#include "src/optics/cube.h"
#include "src/optics/locality.h"
#include "src/optics/refraction.h"
#include "tests/gl/library_common.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryEnvironment : public LibraryTest {};

constexpr std::string_view include = "#include <snell/environment.glsl>\n";
const Room room{{1, -2, 0.5}, {5, 3, 4}};
const std::string in_room = "vec3(5., 3., 4.), vec3(1., -2., .5)";

glm::dvec3 vec(const glm::vec4& v) { return {v.x, v.y, v.z}; }

// a: a point in the room, b: a direction of any length.
std::vector<Arguments> views(double reach = 0.98) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-reach, reach);
    std::vector<Arguments> out;
    for (const glm::dvec3& d : unit_vectors(2000)) {
        const glm::dvec3 p = room.centre + room.half * glm::dvec3(any(random), any(random), any(random));
        out.push_back({glm::vec4(glm::vec3(p), 0), glm::vec4(glm::vec3(d), 0), {}});
    }
    return out;
}

TEST_P(LibraryEnvironment, TheBoxAgreesWithTheOracle) {
    const auto arguments = views();
    const auto results = run(include, "return vec4(snellBoxDirection(a.xyz, b.xyz, " + in_room + "), 0.);", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::dvec3 truth = box_direction(vec(arguments[i].a), vec(arguments[i].b), room);
        EXPECT_LT(glm::length(vec(results[i]) - truth), 2e-5) << i;
    }
}

// Hard case 21: on a wall, outside, with components of zero.
TEST_P(LibraryEnvironment, TheBoxIsDefinedForEveryPoint) {
    std::vector<Arguments> arguments;
    const float places[] = {0, -0.0F, 1, 4.9999F, 5, -5, 6, 1e20F, -1e30F};
    const float ways[] = {0, -0.0F, 1, -1, 1e-30F, 0.5F};
    for (float x : places)
        for (float y : places)
            for (float dx : ways)
                for (float dy : ways) arguments.push_back({{x, y, 1, 0}, {dx, dy, 1, 0}, {}});
    ASSERT_GE(arguments.size(), 1000U);
    const auto results =
        run(include, "return vec4(snellBoxDirection(a.xyz, b.xyz, vec3(5.), vec3(0.)), 0.);", arguments);
    for (const glm::vec4& r : results) {
        ASSERT_TRUE(finite(r));
        EXPECT_NEAR(std::max({std::abs(r.x), std::abs(r.y), std::abs(r.z)}), 5, 1e-4);
    }
    int bad = 0;
    for (const glm::vec4& r :
         run(include, "return vec4(snellBoxDirection(vec3(1., 2., 3.), b.xyz, vec3(5.), vec3(0.)), 0.);",
             special_arguments(5000)))
        bad += !finite(r);
    EXPECT_EQ(bad, 0);
}

TEST_P(LibraryEnvironment, TheWallAgreesWithTheOracle) {
    const auto arguments = views();
    const auto results = run(
        include, "vec2 st; int face = snellWall(a.xyz, b.xyz, " + in_room + ", st); return vec4(st, float(face), 0.);",
        arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::dvec3 hit = box_direction(vec(arguments[i].a), vec(arguments[i].b), room) / room.half;
        const auto truth = wall_point(hit);
        const glm::dvec3 a = glm::abs(hit);
        const double second = a.x + a.y + a.z - std::max({a.x, a.y, a.z}) - std::min({a.x, a.y, a.z});
        if (second > 1 - 1e-4) continue;  // in an edge of the room either wall is right
        EXPECT_EQ(results[i].z, static_cast<float>(truth->face)) << i;
        EXPECT_NEAR(results[i].x, truth->s, 1e-5) << i;
        EXPECT_NEAR(results[i].y, truth->t, 1e-5) << i;
    }
}

TEST_P(LibraryEnvironment, TheInfiniteDirectionPointsTheSameWay) {
    std::vector<Arguments> arguments;
    for (const glm::dvec3& d : unit_vectors(1000))
        for (double length : {1.0, 1e-30, 1e30, 2.9e38}) arguments.push_back({{glm::vec3(d * length), 0}, {}, {}});
    const auto results = run(include, "return vec4(snellInfiniteDirection(a.xyz), 0.);", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i)
        EXPECT_LT(angle_between(vec(results[i]), vec(arguments[i].a)), 1e-6) << i;
    int bad = 0;
    for (const glm::vec4& r : run(include, "return vec4(snellInfiniteDirection(a.xyz), 0.);", special_arguments(5000)))
        bad += !finite(r) || !(glm::length(vec(r)) > 0.9);
    EXPECT_EQ(bad, 0);
}

// Each iteration of the impostor as the oracle does it, from the same distance map; and nearer to the wall.
TEST_P(LibraryEnvironment, TheImpostorAgreesWithTheOracle) {
    const Room here{{0, 0, 0}, {5, 5, 5}};
    constexpr int size = 256;
    const auto texel = [](const glm::dvec3& d) {
        const CubePoint p = *cube_point(d);
        const auto middle = [](double at) { return (std::min(std::floor(at * size), size - 1.0) + 0.5) / size; };
        return wall_distance(*unit(cube_direction({p.face, middle(p.s), middle(p.t)})), glm::dvec3(5));
    };
    set_cube([](const glm::dvec3& d) { return glm::vec3(static_cast<float>(wall_distance(d, glm::dvec3(5)))); }, size);
    std::vector<Arguments> arguments;
    for (const Arguments& view : views()) {
        const glm::dvec3 p = (vec(view.a) - room.centre) / room.half * 2.0;
        arguments.push_back({{glm::vec3(p), 0}, view.b, {}});
    }
    double mean_before = 10;
    for (int k : {0, 1, 2, 4, 8}) {
        const auto results =
            run(include, "return vec4(snellImpostorDirection(cube, a.xyz, b.xyz, " + std::to_string(k) + "), 0.);",
                arguments);
        double mean = 0;
        int strayed = 0;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            ASSERT_TRUE(finite(results[i]));
            const glm::dvec3 p = vec(arguments[i].a), d = vec(arguments[i].b);
            strayed += glm::length(vec(results[i]) - impostor_direction(p, d, k, texel)) > 1e-4;
            mean += angle_between(vec(results[i]), box_direction(p, d, here)) / static_cast<double>(arguments.size());
        }
        // A float may fall on the other side of a texel's edge.
        EXPECT_LT(strayed, 20) << k;
        EXPECT_LT(mean, mean_before) << k;
        mean_before = mean + 1e-4;
    }
    EXPECT_LT(mean_before, 3e-3);
    const auto many = run(include, "return vec4(snellImpostorDirection(cube, a.xyz, b.xyz, 1000000), 0.);", arguments);
    EXPECT_EQ(many, run(include, "return vec4(snellImpostorDirection(cube, a.xyz, b.xyz, 8), 0.);", arguments));
}

SNELL_IN_ALL_DIALECTS(LibraryEnvironment);

}  // namespace
}  // namespace snell::test
