#include <algorithm>
#include <cmath>

#include "src/optics/refraction.h"
#include "src/optics/sphere.h"
#include "tests/gl/library_common.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryRefraction : public LibraryTest {};

constexpr std::string_view include = "#include <snell/refraction.glsl>\n";

glm::dvec3 vec(const glm::vec4& v) { return {v.x, v.y, v.z}; }

// a = (I, n1), b = (N, n2), lengths from .01 to 100, from both sides.
std::vector<Arguments> meetings() {
    const auto directions = unit_vectors(4000);
    std::vector<Arguments> out;
    const float indices[] = {1.0F, 1.0003F, 1.33F, 1.5F, 2.42F};
    for (std::size_t i = 0; i + 1 < directions.size(); i += 2) {
        const auto length = static_cast<float>(std::pow(10.0, static_cast<double>(i % 41) / 10 - 2));
        const glm::vec3 incident = glm::vec3(directions[i]) * length, normal = glm::vec3(directions[i + 1]) / length;
        out.push_back({{incident, indices[i / 2 % 5]}, {normal, indices[i / 10 % 5]}, {}});
    }
    return out;
}

TEST_P(LibraryRefraction, DirectionsAgreeWithTheOracle) {
    const auto arguments = meetings();
    ASSERT_GE(arguments.size(), 1000U);
    const auto refracted = run(
        include, "vec3 T; bool through = snellRefract(a.xyz, b.xyz, a.w, b.w, T); return vec4(T, through ? 1. : 0.);",
        arguments);
    const auto mirrored = run(include, "return vec4(snellReflect(a.xyz, b.xyz), 1.);", arguments);
    int compared = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Arguments& in = arguments[i];
        const auto truth = meet(vec(in.a), vec(in.b), in.a.w, in.b.w);
        ASSERT_TRUE(truth);
        EXPECT_NEAR(glm::length(vec(refracted[i])), 1, 1e-6);
        EXPECT_LT(angle_between(vec(mirrored[i]), truth->reflected), 2e-6);
        // Within a few roundings of the critical angle either answer is right.
        const double k = transmitted_cos2(truth->cos_incident, truth->n1, truth->n2);
        if (std::abs(k) < 1e-5) continue;
        EXPECT_EQ(refracted[i].w == 0.0F, truth->total) << i;
        EXPECT_LT(angle_between(vec(refracted[i]), truth->transmitted), 1e-6 / std::sqrt(std::abs(k)) + 1e-6) << i;
        ++compared;
    }
    EXPECT_GE(compared, 1000);
}

// Hard case 3: equal indices; 25: there and back.
TEST_P(LibraryRefraction, EqualIndicesChangeNothing) {
    std::vector<Arguments> arguments;
    for (int i = 0; i < 1000; ++i) {
        const double c = std::pow(10.0, -4.0 * i / 1000);
        arguments.push_back({{std::sqrt((1 - c) * (1 + c)), 0, -c, 1.4F}, {0, 0, 1, 1.4F}, {}});
    }
    const auto results =
        run(include, "vec3 T; snellRefract(a.xyz, b.xyz, a.w, b.w, T); return vec4(T, 1.);", arguments);
    const auto naive = run("", "return vec4(refract(a.xyz, b.xyz, a.w / b.w), 1.);", arguments);
    double worst = 0, worst_naive = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        worst = std::max(worst, angle_between(vec(results[i]), vec(arguments[i].a)));
        worst_naive = std::max(worst_naive, angle_between(vec(naive[i]), vec(arguments[i].a)));
    }
    EXPECT_LT(worst, 2e-7);
    EXPECT_GT(worst_naive, 1e-4);
}

// Hard cases 4, 5 and A12: no meaningless input gives a direction that is not one.
TEST_P(LibraryRefraction, SpecialValuesGiveDirections) {
    const auto arguments = special_arguments(20000);
    const char* bodies[] = {"vec3 T; snellRefract(a.xyz, b.xyz, a.w, b.w, T); return vec4(T, 1.);",
                            "return vec4(snellRefractSingle(a.xyz, b.xyz, a.w, b.w), 1.);",
                            "return vec4(snellRefractSphere(a.xyz, b.xyz, a.w, b.w), 1.);",
                            "return vec4(snellNormalize(a.xyz, vec3(0., 0., 1.)), 1.);"};
    for (const char* body : bodies) {
        int bad = 0;
        for (const glm::vec4& r : run(include, body, arguments))
            bad += !finite(r) || std::abs(glm::length(vec(r)) - 1) > 1e-5;
        EXPECT_EQ(bad, 0) << body;
    }
    int bad = 0;
    for (const glm::vec4& r : run(include, "return vec4(snellReflect(a.xyz, b.xyz), 1.);", arguments))
        bad += !finite(r);
    EXPECT_EQ(bad, 0);
    int naive = 0;
    for (const glm::vec4& r :
         run("", "return vec4(refract(normalize(a.xyz), normalize(b.xyz), a.w / b.w), 1.);", arguments))
        naive += !finite(r);
    EXPECT_GT(naive, 2000);
}

// Hard case 2: a slab lets out what it let in, at every angle.
TEST_P(LibraryRefraction, WhatEnteredASlabLeavesIt) {
    std::vector<Arguments> arguments;
    for (float n : {1.0003F, 1.33F, 1.5F, 2.42F})
        for (int i = 0; i < 500; ++i) {
            const double c = std::pow(10.0, -5.0 * i / 500);
            arguments.push_back({{std::sqrt((1 - c) * (1 + c)), 0, -c, 1}, {0, 0, 1, n}, {}});
        }
    const auto results = run(include,
                             "vec3 T, U; bool entered = snellRefract(a.xyz, b.xyz, a.w, b.w, T);\n"
                             "bool left = snellRefract(T, -b.xyz, a.w, b.w, U);\n"
                             "return vec4(U, entered && left ? 1. : 0.);",
                             arguments);
    int caught = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        caught += results[i].w == 0.0F;
        EXPECT_LT(angle_between(vec(results[i]), vec(arguments[i].a)), 3e-3) << i;
    }
    EXPECT_EQ(caught, 0);
}

std::vector<Arguments> impacts() {
    std::vector<Arguments> out;
    const auto directions = unit_vectors(3000);
    const float indices[] = {1.31F, 1.5F, 2.42F};
    for (std::size_t i = 0; i + 1 < directions.size(); i += 2) {
        const glm::dvec3 n = directions[i],
                         d = glm::dot(directions[i + 1], n) > 0 ? -directions[i + 1] : directions[i + 1];
        out.push_back({{glm::vec3(d), 1}, {glm::vec3(n), indices[i / 2 % 3]}, {}});
    }
    return out;
}

TEST_P(LibraryRefraction, TheSphereAgreesWithTheOracle) {
    const auto arguments = impacts();
    ASSERT_GE(arguments.size(), 1000U);
    const auto results = run(include, "return vec4(snellRefractSphere(a.xyz, b.xyz, a.w, b.w), 1.);", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const auto truth = through_sphere(vec(arguments[i].a), vec(arguments[i].b), 1, arguments[i].b.w);
        if (truth.exits.size() < 2) continue;
        EXPECT_LT(angle_between(vec(results[i]), truth.exits[1].direction), 3e-6) << i;
    }
}

TEST_P(LibraryRefraction, EveryOrderAgreesWithTheOracle) {
    const auto arguments = impacts();
    for (int order : {0, 1, 2, 3, 5, 8, 16}) {
        const std::string walk =
            "SnellSphere s = snellSphereBegin(a.xyz, b.xyz, a.w, b.w); float steps = 0.;\n"
            "for (int i = 0; i < " +
            std::to_string(order) + "; ++i) if (snellSphereNext(s)) steps += 1.;\n";
        const auto out = run(include, walk + "return vec4(s.direction, s.energy);", arguments);
        const auto state = run(include, walk + "return vec4(s.normal, s.inside);", arguments);
        const auto steps = run(include, walk + "return vec4(steps);", arguments);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const auto truth = through_sphere(vec(arguments[i].a), vec(arguments[i].b), 1, arguments[i].b.w, order);
            const auto last = static_cast<std::size_t>(steps[i].x);
            ASSERT_LE(std::abs(static_cast<int>(last) + 1 - static_cast<int>(truth.exits.size())), 1);
            if (last + 1 != truth.exits.size()) continue;  // the end of the series, within a rounding
            const Exit& exit = truth.exits[last];
            EXPECT_LT(angle_between(vec(out[i]), exit.direction), 5e-6 * (order + 1)) << "order " << order;
            EXPECT_LT(angle_between(vec(state[i]), exit.normal), 5e-6 * (order + 1)) << "order " << order;
            EXPECT_NEAR(out[i].w, exit.energy, 1e-4) << "order " << order;
            EXPECT_NEAR(state[i].w, truth.inside, 1e-4) << "order " << order;
        }
    }
}

// Hard cases 11 and 15: all the light is accounted for, and the series ends by itself.
TEST_P(LibraryRefraction, TheSphereKeepsTheLight) {
    auto arguments = impacts();
    for (const Arguments& special : special_arguments(3000)) arguments.push_back(special);
    const auto results =
        run(include,
            "SnellSphere s = snellSphereBegin(a.xyz, b.xyz, a.w, b.w);\n"
            "float sum = s.energy, count = 0.;\n"
            "for (int i = 0; i < 1000; ++i) { if (!snellSphereNext(s)) break; sum += s.energy; count += 1.; }\n"
            "return vec4(sum, s.inside, count, dot(s.direction, s.direction));",
            arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        ASSERT_TRUE(finite(results[i])) << i;
        EXPECT_NEAR(results[i].x + results[i].y, 1, 2e-6) << i;
        EXPECT_LE(results[i].z, 32) << i;
        EXPECT_NEAR(results[i].w, 1, 1e-5) << i;
    }
}

SNELL_IN_ALL_DIALECTS(LibraryRefraction);

}  // namespace
}  // namespace snell::test
