#include "src/content/cube/convolve.h"
#include "tests/hard_case.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/locality.h"
#include "tests/oracle/optics/ray.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/oracle/optics/sphere.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryEnvironment : public LibraryTest {};
class LibraryLocality : public LibraryTest {};

constexpr std::string_view environment_include = "#include <snell/environment.glsl>\n";
const Room room{{1, -2, 0.5}, {5, 3, 4}};
const std::string in_room = "vec3(5., 3., 4.), vec3(1., -2., .5)";

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

// Directions from an eye 3 away from a ball of radius 1, over the disc that it covers.
std::vector<glm::dvec3> over_ball() {
    constexpr int side = 80;
    std::vector<glm::dvec3> out;
    for (int i = 0; i < side * side; ++i) {
        const double x = (2. * (i % side) + 1) / side - 1, y = (2. * (i / side) + 1) / side - 1;
        if (x * x + y * y < 1) out.push_back(*unit({x / std::sqrt(8), y / std::sqrt(8), -1.}));
    }
    return out;
}

TEST_P(LibraryEnvironment, TheBoxAgreesWithTheOracle) {
    const auto arguments = views();
    const auto results =
        run(environment_include, "return vec4(snellBoxDirection(a.xyz, b.xyz, " + in_room + "), 0.);", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::dvec3 truth = box_direction(vec(arguments[i].a), vec(arguments[i].b), room);
        EXPECT_LT(glm::length(vec(results[i]) - truth), 2e-5) << i;
    }
}

// On a wall, outside, with components of zero.
TEST_P(LibraryEnvironment, TheBoxIsDefinedForEveryPoint) {
    std::vector<Arguments> arguments;
    const float places[] = {0, -0.0F, 1, 4.9999F, 5, -5, 6, 1e20F, -1e30F};
    const auto in_room = [](float v) { return std::abs(v) <= 5; };
    std::vector<Arguments> fair;  // points of the room, its walls included
    const float ways[] = {0, -0.0F, 1, -1, 1e-30F, 0.5F};
    for (float x : places)
        for (float y : places)
            for (float dx : ways)
                for (float dy : ways) {
                    arguments.push_back({{x, y, 1, 0}, {dx, dy, 1, 0}, {}});
                    if (in_room(x) && in_room(y)) fair.push_back(arguments.back());
                }
    ASSERT_GE(arguments.size(), 1000U);
    const auto results =
        run(environment_include, "return vec4(snellBoxDirection(a.xyz, b.xyz, vec3(5.), vec3(0.)), 0.);", arguments);
    const auto off_wall = [](const glm::vec4& r) {
        return !finite(r) || std::abs(std::max({std::abs(r.x), std::abs(r.y), std::abs(r.z)}) - 5) > 1e-4;
    };
    const auto printed = run("",
                             "vec3 far = max((vec3(5.) - a.xyz) / b.xyz, (vec3(-5.) - a.xyz) / b.xyz);\n"
                             "return vec4(a.xyz + min(min(far.x, far.y), far.z) * b.xyz, 0.);",
                             fair);
    const auto wrong = std::count_if(results.begin(), results.end(), off_wall);
    const auto wrong_printed = std::count_if(printed.begin(), printed.end(), off_wall);
    hard_case(
        {"21",
         "box projection in a shader: components of zero, on walls, outside; naive: as printed, in the room and on "
         "its walls",
         "rays off the walls", 0, static_cast<double>(wrong), static_cast<double>(wrong_printed)});
    int bad = 0;
    for (const glm::vec4& r :
         run(environment_include, "return vec4(snellBoxDirection(vec3(1., 2., 3.), b.xyz, vec3(5.), vec3(0.)), 0.);",
             special_arguments(5000)))
        bad += !finite(r);
    EXPECT_EQ(bad, 0);
}

TEST_P(LibraryEnvironment, TheWallAgreesWithTheOracle) {
    const auto arguments = views();
    const auto results =
        run(environment_include,
            "vec2 st; int face = snellWall(a.xyz, b.xyz, " + in_room + ", st); return vec4(st, float(face), 0.);",
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
    const auto results = run(environment_include, "return vec4(snellInfiniteDirection(a.xyz), 0.);", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i)
        EXPECT_LT(angle_between(vec(results[i]), vec(arguments[i].a)), 1e-6) << i;
    const auto no_direction = [](const glm::vec4& r) { return !finite(r) || !(glm::length(vec(r)) > 0.9); };
    const auto ours =
        run(environment_include, "return vec4(snellInfiniteDirection(a.xyz), 0.);", special_arguments(5000));
    const auto naive = run("", "return vec4(normalize(a.xyz), 0.);", special_arguments(5000));
    hard_case({"17", "directions with 0, 1e-44, 3e38, infinity, NaN into a cube map; naive: normalize()",
               "of 5000 that are none", 0, static_cast<double>(std::count_if(ours.begin(), ours.end(), no_direction)),
               static_cast<double>(std::count_if(naive.begin(), naive.end(), no_direction))});
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
            run(environment_include,
                "return vec4(snellImpostorDirection(cube, a.xyz, b.xyz, " + std::to_string(k) + "), 0.);", arguments);
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
    const auto many =
        run(environment_include, "return vec4(snellImpostorDirection(cube, a.xyz, b.xyz, 1000000), 0.);", arguments);
    const auto results_of_eight =
        run(environment_include, "return vec4(snellImpostorDirection(cube, a.xyz, b.xyz, 8), 0.);", arguments);
    // Mesa's software renderer ends the loops of a shader at 65,535 rounds in all, and says nothing.
    const glm::vec4 counted = run("", "float n = 0.; for (int i = 0; i < int(a.x); ++i) n += 1.; return vec4(n);",
                                  {{{70000, 0, 0, 0}, {}, {}}})[0];
    const bool silent = counted.x != 70000;
    hard_case({"61", "loops that ask for a million rounds: ours are bounded; naive: how many of 70,000 rounds are lost",
               "rounds beyond the bound", 0, many == results_of_eight ? 0. : 1.,
               silent ? std::optional<double>(70000 - counted.x) : std::nullopt});
}

// A direction in an edge or a corner belongs to no face: whichever answers, and on both sides of it, the colour is the
// same.
TEST_P(LibraryEnvironment, EdgesOfACubeMapAreNoSteps) {
    set_cube([](const glm::dvec3& d) { return glm::vec3(0.5 + 0.4 * d); }, 8);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube.get());
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    std::vector<Arguments> sides[2], exact;
    const auto near_edge = [&](const glm::vec3& d, int first, int second) {
        for (int side = 0; side < 2; ++side) {
            glm::vec3 moved = d;
            moved[side == 0 ? first : second] *= 1.00001F;
            sides[side].push_back({{moved, 0}, {}, {}});
        }
        exact.push_back({{d, 0}, {}, {}});
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const float x : {-1.0F, 1.0F})
            for (const float y : {-1.0F, 1.0F})
                for (const float z : {-1.0F, -0.6F, 0.0F, 0.3F, 1.0F}) {
                    glm::vec3 d;
                    d[axis] = z, d[(axis + 1) % 3] = x, d[(axis + 2) % 3] = y;
                    near_edge(d, (axis + 1) % 3, (axis + 2) % 3);
                }
    const auto step = [&] {
        const char* look = "return textureLod(cube, a.xyz, 0.);";
        const auto one = run("", look, sides[0]), other = run("", look, sides[1]), between = run("", look, exact);
        double worst = 0;
        for (std::size_t i = 0; i < one.size(); ++i)
            for (const glm::vec4& b : {other[i], between[i]}) worst = worse(worst, glm::length(vec(one[i]) - vec(b)));
        return worst;
    };
    std::optional<double> naive;
    if (!GetParam().request.es) {  // OpenGL ES 3 is always seamless
        naive = step();
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    }
    hard_case({"16",
               "edges and corners of a cube map: the same colour from either face; naive: without seamless filtering",
               "of 1", 1 / 255., step(), naive});
}

// Some GPUs have no denormals; the oracle, in double precision, has them.
TEST_P(LibraryEnvironment, DenormalsDoNotMatter) {
    const Room here{{0, 0, 0}, {5, 5, 5}};
    std::vector<Arguments> arguments;
    for (const glm::dvec3& d : unit_vectors(200))
        for (const float tiny : {1e-45F, -1e-40F, 1e-38F})
            for (const float y : {0.0F, 5.0F})
                arguments.push_back({{static_cast<float>(d.x), tiny, static_cast<float>(d.z), 0}, {1, y, 2, 0}, {}});
    const auto worst = [&](std::string_view before, std::string_view body, const auto& truth) {
        double most = 0;
        const auto out = run(before, body, arguments);
        for (std::size_t i = 0; i < out.size(); ++i)
            most = worse(most, angle_between(vec(out[i]), truth(arguments[i])));
        return most;
    };
    const auto same = [](const Arguments& in) { return vec(in.a); };
    const auto wall = [&](const Arguments& in) { return box_direction(vec(in.b), vec(in.a), here); };
    const double ours = worse(
        worse(worst(environment_include, "return vec4(snellInfiniteDirection(a.xyz), 0.);", same),
              worst(environment_include, "return vec4(snellNormalize(a.xyz, vec3(0.)), 0.);", same)),
        worst(environment_include, "return vec4(snellBoxDirection(b.xyz, a.xyz, vec3(5.), vec3(0.)), 0.);", wall));
    const double naive =
        worst("",
              "vec3 inverse = 1. / a.xyz, far = max((5. - b.xyz) * inverse, (-5. - b.xyz) * inverse);\n"
              "return vec4(b.xyz + min(min(far.x, far.y), far.z) * a.xyz, 0.);",
              wall);
    hard_case({"62",
               "denormal components, against an oracle that keeps all their digits; naive: a box by the "
               "inverse of the direction",
               "rad", 1e-4, ours, naive});
}

TEST_P(LibraryEnvironment, SmallAnglesKeepTheirDigits) {
    std::vector<Arguments> arguments;
    for (double angle = 1e-5; angle < 0.1; angle *= 1.3)
        arguments.push_back({{1, 0, 0, static_cast<float>(angle)}, {std::cos(angle), std::sin(angle), 0, 0}, {}});
    const auto error = [&](std::string_view before, std::string_view body) {
        double worst = 0;
        const auto out = run(before, body, arguments);
        for (std::size_t i = 0; i < out.size(); ++i)
            worst = worse(worst, std::abs(static_cast<double>(out[i].x) - static_cast<double>(arguments[i].a.w)));
        return worst;
    };
    std::vector<Arguments> tiny;
    for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12})
        tiny.push_back({{1, 0, 0, static_cast<float>(angle)}, {std::cos(angle), std::sin(angle), 0, 0}, {}});
    const auto relative = [&](std::string_view before, std::string_view body) {
        double worst = 0;
        const auto out = run(before, body, tiny);
        for (std::size_t i = 0; i < out.size(); ++i)
            worst = worse(worst, std::abs(static_cast<double>(out[i].x / tiny[i].a.w) - 1));
        return worst;
    };
    hard_case({"13", "angles from 1e-3 to 1e-12 rad by atan; naive: acos of the dot product", "relative", 1e-4,
               relative("#include <snell/core.glsl>\n", "return vec4(snellAngle(a.xyz, b.xyz));"),
               relative("", "return vec4(acos(clamp(dot(a.xyz, b.xyz), -1., 1.)));")});
    hard_case({"A20", "angles of 1e-5 to .1 rad in a shader, by snellAngle; naive: acos of the dot product", "rad",
               1e-5, error("#include <snell/core.glsl>\n", "return vec4(snellAngle(a.xyz, b.xyz));"),
               error("", "return vec4(acos(clamp(dot(a.xyz, b.xyz), -1., 1.)));")});
}

// What docs/light.md prints: in a room with walls at ±5, of what a mirror ball of radius 1 in its middle shows to an
// eye 3 away, degrees in the mean over the ball's disc. The map of distances has 256 texels a side.
TEST_P(LibraryLocality, HasTheErrorsThatAreKnown) {
    const auto wall = [](const glm::dvec3& d) {
        return glm::vec3(static_cast<float>(wall_distance(d, glm::dvec3(5))));
    };
    set_cube(wall, 256);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube.get());
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    std::vector<Arguments> arguments;
    std::vector<glm::dvec3> truth;
    for (const glm::dvec3& way : over_ball()) {
        const glm::dvec3 p = Ray{{0, 0, 3}, way}.at(cross_sphere({{0, 0, 3}, way}, glm::dvec3(0), 1).value().enter);
        const glm::dvec3 r = *mirror(way, p);
        arguments.push_back({glm::vec4(p, 0), glm::vec4(r, 0), {}});
        truth.push_back(*room_hit({p, r}, glm::dvec3(5)));
    }
    const struct {
        std::string body;
        double mean, within;
    } printed[] = {{"snellInfiniteDirection(b.xyz)", 6.49, .05},
                   {"snellImpostorDirection(cube, a.xyz, b.xyz, 0)", .70, .02},
                   {"snellImpostorDirection(cube, a.xyz, b.xyz, 1)", .034, .003},
                   {"snellImpostorDirection(cube, a.xyz, b.xyz, 2)", .0026, .0003},
                   {"snellBoxDirection(a.xyz, b.xyz, vec3(5.), vec3(0.))", 0, 1e-4}};
    for (const auto& [body, mean, within] : printed) {
        double sum = 0, largest = 0;
        const auto out = run(environment_include, "return vec4(" + body + ", 0.);", arguments);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double off = glm::degrees(angle_between(vec(out[i]), truth[i]));
            sum += off / static_cast<double>(out.size());
            largest = worse(largest, off);
        }
        EXPECT_NEAR(sum, mean, within) << body;
        if (mean > 1) {
            EXPECT_NEAR(largest, 10.2, .1) << body;
        }
    }
}

// Two wrong things may cancel: of a glass ball in a room the surface alone, seen infinitely far, is nearer to the truth
// than the surface alone in its box; with the way out of the glass the box is exact.
TEST_P(LibraryLocality, TheBoxNeedsTheWayOutOfTheGlass) {
    std::vector<Arguments> arguments;
    std::vector<glm::dvec3> truth;
    for (const glm::dvec3& way : over_ball()) {
        const glm::dvec3 p = Ray{{0, 0, 3}, way}.at(cross_sphere({{0, 0, 3}, way}, glm::dvec3(0), 1).value().enter);
        arguments.push_back({glm::vec4(p, 0), glm::vec4(way, 0), {}});
        const Exit exit = through_sphere(way, p, 1, 1.5).exits.at(1);
        truth.push_back(*room_hit({exit.normal, exit.direction}, glm::dvec3(5)));
    }
    const auto mean = [&](const std::string& from, const std::string& to) {
        double sum = 0;
        const auto out = run("#include <snell/refraction.glsl>\n#include <snell/environment.glsl>\n",
                             "SnellSphere s = snellSphereBegin(b.xyz, a.xyz, 1., 1.5); snellSphereNext(s);\n"
                             "vec3 single = snellRefractSingle(b.xyz, a.xyz, 1., 1.5);\n"
                             "return vec4(snellBoxDirection(" +
                                 from + ", " + to + ", vec3(5.), vec3(0.)), 0.);",
                             arguments);
        for (std::size_t i = 0; i < out.size(); ++i) sum += glm::degrees(angle_between(vec(out[i]), truth[i]));
        return sum / static_cast<double>(out.size());
    };
    const double entry = mean("a.xyz", "single");
    EXPECT_LT(mean("vec3(0.)", "single"), entry - 4) << "infinitely far";
    hard_case({"A24", "box projection of a glass ball: from where the light leaves it; naive: from where it enters",
               "degrees in the mean", 1e-4, mean("s.normal", "s.direction"), entry});
}

SNELL_IN_ALL_DIALECTS(LibraryEnvironment);
SNELL_IN_THE_FIRST_DIALECT(LibraryLocality);

// ---- Chains of rough mirrors, looked up by the library.

class LibraryRough : public LibraryTest {
protected:
    // Level l of the chain shows l everywhere.
    void set_numbered_chain(int size) {
        std::vector<std::vector<glm::vec4>> colors;
        std::vector<std::array<gl::Texels, 6>> levels;
        for (int level = 0; level < content::prefilter_levels(size); ++level) {
            const int side = size >> level;
            colors.emplace_back(static_cast<std::size_t>(side * side), glm::vec4(level));
            levels.emplace_back().fill(
                {gl::Pixels::rgba32f, side, side, 1, reinterpret_cast<const std::byte*>(colors.back().data())});
        }
        cube = gl::make_cube_levels(levels);
    }
    static constexpr std::string_view include = "#include <snell/environment.glsl>\n";
    static constexpr std::string_view lookup = "return vec4(snellPrefiltered(cube, a.xyz, b.x), 1.);";
};

// Roughness runs evenly through the levels, whatever their number; the shader counts them as the CPU does.
TEST_P(LibraryRough, RoughnessIsTheLevel) {
    for (const int size : {16, 64, 256}) {
        set_numbered_chain(size);
        const int last = content::prefilter_levels(size) - 1;
        std::vector<Arguments> arguments;
        const auto directions = unit_vectors(1000);
        for (std::size_t i = 0; i < directions.size(); ++i)
            arguments.push_back({{glm::vec3(directions[i]), 0}, {static_cast<float>(i) / 999, 0, 0, 0}, {}});
        const auto results = run(include, lookup, arguments);
        for (std::size_t i = 0; i < arguments.size(); ++i)
            EXPECT_NEAR(results[i].x, arguments[i].b.x * static_cast<float>(last), .01) << size;
    }
}

// Hard case 17 for chains: whatever goes in, light of some level comes out.
TEST_P(LibraryRough, NothingMeaninglessComesOut) {
    set_numbered_chain(64);
    for (const glm::vec4& r : run(include, lookup, special_arguments(3000))) {
        EXPECT_TRUE(finite(r));
        EXPECT_TRUE(r.x >= 0 && r.x <= 3) << r.x;
    }
}

SNELL_IN_ALL_DIALECTS(LibraryRough);

}  // namespace
}  // namespace snell::test
