// The ladder of metals on the GPU.
#include "tests/library/common.h"
#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/glass.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryMetal : public LibraryTest {};

constexpr std::string_view metal_include = "#include <snell/fresnel.glsl>\n";

// a = (c, eta, k, 0): every metal of the table at five wavelengths.
std::vector<Arguments> mirrors() {
    std::vector<Arguments> out;
    for (const Metal& metal : metals())
        for (double nm : {420.0, 480.0, 550.0, 611.0, 680.0})
            for (int i = 0; i <= 50; ++i) {
                const Complex n = metal.index(nm);
                out.push_back({glm::vec4(i / 50.0, n.eta, n.k, 0), {}, {}});
            }
    return out;
}

TEST_P(LibraryMetal, EveryRungAgreesWithTheOracle) {
    const auto arguments = mirrors();
    ASSERT_GE(arguments.size(), 1000U);
    const auto rungs = run(metal_include,
                           "float f0 = snellFresnelConductor(1., 1., a.y, a.z);\n"
                           "float d = snellFresnelLazanyiDepth(1., a.y, a.z);\n"
                           "return vec4(snellFresnelSchlick5(a.x, f0), snellFresnelLazanyi(a.x, f0, d), "
                           "snellFresnelConductor(a.x, 1., a.y, a.z), d);",
                           arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::dvec4 a(arguments[i].a);
        const double f0 = fresnel_conductor(1, 1, a.y, a.z), depth = lazanyi_depth(a.y, a.z);
        EXPECT_NEAR(rungs[i].x, schlick(a.x, f0), 1e-5);
        EXPECT_NEAR(rungs[i].y, lazanyi(a.x, f0, depth), 1e-5);
        EXPECT_NEAR(rungs[i].z, fresnel_conductor(a.x, 1, a.y, a.z), 1e-4);
        EXPECT_NEAR(rungs[i].w, depth, 1e-4);
    }
}

// What docs/light.md prints: the reflectance at normal incidence, and the largest errors over all angles.
TEST_P(LibraryMetal, RungsHaveTheErrorsThatAreKnown) {
    const struct {
        const char* name;
        double nanometres, f0, schlick, lazanyi;
    } printed[] = {{"gold", 650, .96, .0165, .0050},       {"gold", 450, .41, .0179, .0170},
                   {"silver", 650, .99, .0064, .00116},    {"copper", 650, .935, .0245, .0070},
                   {"aluminium", 550, .915, .0962, .0078}, {"chromium", 550, .554, .1979, .0236}};
    constexpr int steps = 4000;
    for (const auto& row : printed) {
        SCOPED_TRACE(row.name);
        const Complex n = std::ranges::find(metals(), row.name, &Metal::name)->index(row.nanometres);
        std::vector<Arguments> arguments;
        for (int i = 0; i <= steps; ++i) arguments.push_back({glm::vec4(1 - i / 4000., n.eta, n.k, 0), {}, {}});
        const auto shares = run(metal_include,
                                "float f0 = snellFresnelConductor(1., 1., a.y, a.z);\n"
                                "return vec4(snellFresnelConductor(a.x, 1., a.y, a.z), snellFresnelSchlick5(a.x, f0), "
                                "snellFresnelLazanyi(a.x, f0, snellFresnelLazanyiDepth(1., a.y, a.z)), 0.);",
                                arguments);
        double schlick = 0, lazanyi = 0;
        for (const glm::vec4& r : shares) {
            schlick = worse(schlick, std::abs(r.y - r.x));
            lazanyi = worse(lazanyi, std::abs(r.z - r.x));
        }
        EXPECT_NEAR(shares[0].x, row.f0, .005);
        EXPECT_NEAR(schlick / row.schlick, 1, .1);
        EXPECT_NEAR(lazanyi / row.lazanyi, 1, .1);
    }
}

TEST_P(LibraryMetal, SpecialValuesGiveReflectances) {
    for (const char* body : {"return vec4(snellFresnelLazanyi(a.x, a.y, a.z));",
                             "return vec4(snellFresnelLazanyi(a.x, .9, snellFresnelLazanyiDepth(a.y, a.z, a.w)));"}) {
        int bad = 0;
        for (const glm::vec4& r : run(metal_include, body, special_arguments(10000))) bad += !(r.x >= 0 && r.x <= 1);
        EXPECT_EQ(bad, 0) << body;
    }
}

SNELL_IN_ALL_DIALECTS(LibraryMetal);

}  // namespace
}  // namespace snell::test
