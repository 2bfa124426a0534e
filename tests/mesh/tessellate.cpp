// Domains of patches: what OpenGL demands of every tessellator.
#include "src/content/mesh/tessellate.h"
#include "tests/std.h"

namespace snell::content {
namespace {

using Place = std::array<float, 2>;

constexpr Spacing spacings[] = {Spacing::equal, Spacing::fractional_even, Spacing::fractional_odd};

TessellationLevels levels(std::mt19937& random) {
    std::uniform_real_distribution<float> level(1, 20);
    TessellationLevels made;
    for (float& each : made.outer) each = level(random);
    for (float& each : made.inner) each = level(random);
    return made;
}

// Places along the edge of the domain on which `across` of a vertex is 0, from `along`.
template <class Across, class Along>
std::set<float> on_edge(const DividedDomain& domain, const Across& across, const Along& along) {
    std::set<float> places;
    for (const Place& place : domain.vertices)
        if (across(place) == 0) places.insert(along(place));
    return places;
}

float area(const DividedDomain& domain, std::size_t i) {
    const Place &a = domain.vertices[domain.indices[i]], &b = domain.vertices[domain.indices[i + 1]],
                &c = domain.vertices[domain.indices[i + 2]];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
}

// Whatever the other levels are, and in whichever direction a patch goes along the edge.
TEST(Tessellate, EdgesOfOneLevelMeetToTheBit) {
    std::mt19937 random(1);
    for (const Spacing spacing : spacings)
        for (int i = 0; i < 100; ++i) {
            TessellationLevels one = levels(random), other = levels(random);
            one.outer[0] = other.outer[1] = other.outer[2] = one.outer[3];
            const DividedDomain triangle = divide({Domain::triangles, spacing}, one);
            const auto u = [](const Place& p) { return p[0]; };
            const auto v = [](const Place& p) { return p[1]; };
            const auto w = [](const Place& p) { return 1 - p[0] - p[1]; };
            const std::set<float> edge = on_edge(triangle, u, v);
            EXPECT_EQ(edge, on_edge(triangle, u, w)) << "the other way round";
            const DividedDomain second = divide({Domain::triangles, spacing}, other);
            EXPECT_EQ(edge, on_edge(second, v, u));
            EXPECT_EQ(edge, on_edge(second, w, v));
            const DividedDomain quad = divide({Domain::quads, spacing}, one);
            EXPECT_EQ(edge, on_edge(quad, u, v));
            EXPECT_EQ(edge, on_edge(
                                quad, [](const Place& p) { return 1 - p[1]; }, u));
        }
}

// Without gaps, overlaps and triangles that look the other way.
TEST(Tessellate, TrianglesCoverTheDomainOnce) {
    std::mt19937 random(2);
    for (const Domain domain : {Domain::triangles, Domain::quads})
        for (const Spacing spacing : spacings)
            for (const bool clockwise : {false, true})
                for (int i = 0; i < 50; ++i) {
                    const DividedDomain made = divide({domain, spacing, clockwise}, levels(random));
                    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
                    double all = 0;
                    for (std::size_t k = 0; k < made.indices.size(); k += 3) {
                        const float one = area(made, k);
                        EXPECT_GE(clockwise ? -one : one, 0);
                        all += one;
                        for (std::size_t side = 0; side < 3; ++side)
                            ++sides[{made.indices[k + side], made.indices[k + (side + 1) % 3]}];
                    }
                    EXPECT_NEAR(std::abs(all), domain == Domain::quads ? 1 : .5, 1e-4);
                    for (const auto& [side, count] : sides) {
                        EXPECT_EQ(count, 1);
                        const Place &a = made.vertices[side.first], &b = made.vertices[side.second];
                        const bool rim = (a[0] == b[0] && (a[0] == 0 || a[0] == 1)) ||
                                         (a[1] == b[1] && (a[1] == 0 || a[1] == 1)) ||
                                         (domain == Domain::triangles && a[0] + a[1] == 1 && b[0] + b[1] == 1);
                        EXPECT_TRUE(rim || sides.contains({side.second, side.first}));
                    }
                }
}

TEST(Tessellate, LevelsDiscardAndEndAt64) {
    for (const float level : {0.F, -2.F, NAN}) {
        EXPECT_TRUE(divide({Domain::triangles}, {{4, 4, level, 4}, {4, 4}}).indices.empty()) << level;
        EXPECT_TRUE(divide({Domain::quads}, {{4, 4, 4, level}, {4, 4}}).indices.empty()) << level;
        EXPECT_TRUE(divide({Domain::isolines}, {{level, 4, 4, 4}, {4, 4}}).indices.empty()) << level;
        EXPECT_FALSE(divide({Domain::triangles}, {{4, 4, 4, level}, {level, level}}).indices.empty()) << level;
    }
    EXPECT_EQ(divide({Domain::isolines}, {{1e9F, INFINITY, 1, 1}, {1, 1}}).indices.size(), 2U * 64 * 64);
    EXPECT_EQ(divide({Domain::quads}, {{99, 99, 99, 99}, {99, 99}}).indices.size(), 6U * 64 * 64);
}

}  // namespace
}  // namespace snell::content
