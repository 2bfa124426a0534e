#include "tests/oracle/optics/fresnel.h"
#include "tests/hard_case.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/glass.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryFresnel : public LibraryTest {};

constexpr std::string_view fresnel_include = "#include <snell/fresnel.glsl>\n";

// a = (c, n1, n2): both sides of eight materials, cosines denser toward grazing and next to the critical angle.
std::vector<Arguments> incidences() {
    std::vector<Arguments> out;
    for (float n : {1.0003F, 1.31F, 1.33F, 1.47F, 1.52F, 2.16F, 2.42F, 2.69F})
        for (int i = 0; i <= 200; ++i) {
            const float t = static_cast<float>(i) / 200, c = t * t;
            out.push_back({{c, 1, n, 0}, {}, {}});
            out.push_back({{c, n, 1, 0}, {}, {}});
        }
    return out;
}

// The largest distance of results from the truth at any cosine within `ulps` roundings of the argument: at the
// critical angle the slope is infinite, so a perfect routine in float is 1e-4 to 1e-3 away.
template <class Truth>
double worst(const std::vector<Arguments>& arguments, const std::vector<glm::vec4>& results, Truth truth,
             int ulps = 4) {
    double worst = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::dvec4 a(arguments[i].a);
        double low = 1e9, high = -1e9;
        for (int k = -ulps; k <= ulps; ++k) {
            const double value = truth(a.x + k * 6e-8, a.y, a.z);
            low = std::min(low, value), high = std::max(high, value);
        }
        const double r = results[i].x;
        worst = std::isnan(r) ? 1e9 : std::max({worst, low - r, r - high});
    }
    return worst;
}

TEST_P(LibraryFresnel, ExactAgreesWithTheOracle) {
    const auto arguments = incidences();
    ASSERT_GE(arguments.size(), 1000U);
    const auto results = run(fresnel_include, "return vec4(snellFresnelExact(a.x, a.y, a.z));", arguments);
    EXPECT_LT(worst(arguments, results, fresnel), 3e-6);
    const auto polarised = run(
        fresnel_include, "vec2 f = snellFresnelPolarised(a.x, a.y, a.z); return vec4(f.y, f.x, 0., 0.);", arguments);
    EXPECT_LT(
        worst(arguments, polarised, [](double c, double n1, double n2) { return fresnel_polarised(c, n1, n2).p; }),
        3e-6);
}

// Every rung, and what docs/light.md prints of it: its mean and its largest error outside of a ball of window glass,
// and its mean error inside.
struct Rung {
    const char* body;
    double (*truth)(double c, double n1, double n2);
    double mean, largest, inside;
};
const Rung rungs[] = {
    {"return vec4(snellFresnelF0(a.y, a.z));", [](double, double n1, double n2) { return normal_reflectance(n1, n2); },
     .052, .957, .566},
    {"return vec4(snellFresnelOneMinusCos(a.x));", [](double c, double, double) { return 1 - std::clamp(c, 0., 1.); },
     .242, .489, .309},
    {"return vec4(snellFresnelSchlick2(a.x, snellFresnelF0(a.y, a.z)));",
     [](double c, double n1, double n2) { return schlick(c, normal_reflectance(n1, n2), 2); }, .107, .315, .407},
    {"return vec4(snellFresnelCg(a.x, .3, 2., 2.));", [](double c, double, double) { return cg_fresnel(c, .3, 2, 2); },
     .476, .869, .252},
    {"return vec4(snellFresnelCg(a.x, .048, .848, 4.55));",
     [](double c, double, double) { return cg_fresnel(c, .048, .848, 4.55); }, .0049, .104, .515},
    {"return vec4(snellFresnelSchlick5(a.x, snellFresnelF0(a.y, a.z)));",
     [](double c, double n1, double n2) { return schlick(c, normal_reflectance(n1, n2)); }, .0090, .0345, .52},
    {"return vec4(snellFresnelSchlick(a.x, a.y, a.z));", schlick_dielectric, .0090, .0345, .0039},
    {"return vec4(snellFresnelGaussian(a.x, a.y, a.z));", gaussian_dielectric, .0077, .038, .0033},
};

// Over the disc that a distant ball covers, cosines have the density 2 c.
TEST_P(LibraryFresnel, RungsAgreeWithTheOracleAndHaveTheErrorsThatAreKnown) {
    auto arguments = incidences();
    const std::size_t first = arguments.size();
    constexpr int steps = 10000;
    for (const bool inside : {false, true})
        for (int i = 0; i < steps; ++i)
            arguments.push_back({{(i + .5) / steps, inside ? 1.52 : 1, inside ? 1 : 1.52, 0}, {}, {}});
    for (const Rung& rung : rungs) {
        SCOPED_TRACE(rung.body);
        const auto results = run(fresnel_include, rung.body, arguments);
        EXPECT_LT(worst(arguments, results, rung.truth), 1e-5);
        double mean[2] = {}, largest = 0;
        for (std::size_t i = first; i < results.size(); ++i) {
            const glm::dvec4 a(arguments[i].a);
            const bool inside = a.y > 1;
            const double off = std::abs(results[i].x - fresnel(a.x, a.y, a.z));
            mean[inside] += 2 * a.x * off / steps;
            if (!inside) largest = worse(largest, off);
        }
        EXPECT_NEAR(mean[0] / rung.mean, 1, .1) << mean[0];
        EXPECT_NEAR(largest / rung.largest, 1, .1) << largest;
        EXPECT_NEAR(mean[1] / rung.inside, 1, .1) << mean[1];
    }
}

TEST_P(LibraryFresnel, MetalsAgreeWithTheOracle) {
    std::vector<Arguments> arguments;
    for (float n1 : {1.0F, 1.33F})
        for (float eta : {0.04F, 0.14F, 0.43F, 1.02F, 1.5F, 3.2F})
            for (float k : {0.0F, 0.01F, 1.9F, 4.5F, 12.0F})
                for (int i = 0; i <= 40; ++i) arguments.push_back({{static_cast<float>(i) / 40, n1, eta, k}, {}, {}});
    ASSERT_GE(arguments.size(), 1000U);
    const auto results = run(fresnel_include, "return vec4(snellFresnelConductor(a.x, a.y, a.z, a.w));", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::vec4 a = arguments[i].a;
        double nearest = 1;
        for (int ulps = -4; ulps <= 4; ++ulps)
            nearest = std::min(nearest, std::abs(fresnel_conductor(a.x + ulps * 6e-8, a.y, a.z, a.w) - results[i].x));
        EXPECT_LT(nearest, 1e-4) << a.x << " " << a.y << " " << a.z << " " << a.w;
    }
}

// Whatever goes in, a reflectance comes out.
TEST_P(LibraryFresnel, SpecialValuesGiveReflectances) {
    const auto arguments = special_arguments(20000);
    for (const char* body :
         {"return vec4(snellFresnelExact(a.x, a.y, a.z));", "return vec4(snellFresnelSchlick(a.x, a.y, a.z));",
          "return vec4(snellFresnelGaussian(a.x, a.y, a.z));", "return vec4(snellFresnelF0(a.y, a.z));",
          "return vec4(snellFresnelCg(a.x, .3, 2., a.y));", "return vec4(snellFresnelConductor(a.x, a.y, a.z, a.w));",
          "vec2 f = snellFresnelPolarised(a.x, a.y, a.z); return vec4(f.xyxy);"}) {
        expect_each(run(fresnel_include, body, arguments), arguments, body,
                    [](const glm::vec4& r) { return r.x >= 0 && r.x <= 1 && r.y >= 0 && r.y <= 1; });
    }
    const auto out_of_range = [&](std::string_view before, std::string_view body, const std::vector<Arguments>& with) {
        const auto out = run(before, body, with);
        return static_cast<double>(
            std::count_if(out.begin(), out.end(), [](const glm::vec4& r) { return !(r.x >= 0 && r.x <= 1); }));
    };
    hard_case({"70", "reflectances of anything lie in [0,1]", "of 20000 out of [0,1]", 0,
               out_of_range(fresnel_include, "return vec4(snellFresnelSchlick(a.x, a.y, a.z));", arguments),
               std::nullopt});
    std::vector<Arguments> rounded, odd;
    for (int i = 0; i < 100; ++i) rounded.push_back({{1 + static_cast<float>(i) * 3.6e-9F, 1, 1.5F, 0}, {}, {}});
    hard_case({"7", "dot products of unit vectors are up to 1 + 3.6e-7; naive: pow(1. - dot, 5.)",
               "of 100 out of [0,1]", 0,
               out_of_range(fresnel_include, "return vec4(snellFresnelSchlick5(a.x, .04));", rounded),
               out_of_range("", "return vec4(.04 + .96 * pow(1. - a.x, 5.));", rounded)});
    for (const float x : {0.0F, -0.1F, -0.5F})
        for (const float power : {0.0F, -1.0F, 1.55F}) odd.push_back({{1 - x, power, 0, 0}, {}, {}});
    hard_case({"8", "pow(0, 0), pow(0, -1), pow(-.5, 1.55) are undefined; naive: pow() of the same",
               "of 9 out of [0,1]", 0,
               out_of_range(fresnel_include, "return vec4(snellFresnelCg(a.x, 0., 1., a.y));", odd),
               out_of_range("", "return vec4(pow(1. - a.x, a.y));", odd)});
}

// The textbook's difference of products loses nearly all digits for air in vacuum.
TEST_P(LibraryFresnel, NearlyEqualIndicesKeepTheirDigits) {
    std::vector<Arguments> arguments, indices;
    for (int i = 1; i <= 20000; ++i) arguments.push_back({{static_cast<float>(i) / 20000, 1, 1.0003F, 0}, {}, {}});
    const auto worst = [](const std::vector<glm::vec4>& out, const std::vector<Arguments>& in, const auto& error) {
        double most = 0;
        for (std::size_t i = 0; i < out.size(); ++i) most = worse(most, error(in[i].a, static_cast<double>(out[i].x)));
        return most;
    };
    const auto of_light = [](const glm::vec4& a, double f) { return std::abs(f - fresnel(a.x, a.y, a.z)); };
    constexpr std::string_view textbook =
        "float eta = a.y / a.z, t = sqrt(max(0., 1. - eta * eta * (1. - a.x * a.x)));\n"
        "float s = (a.y * a.x - a.z * t) / (a.y * a.x + a.z * t), p = (a.z * a.x - a.y * t) / (a.z * a.x + a.y * t);\n"
        "return vec4(.5 * (s * s + p * p));";
    hard_case(
        {"9", "exact Fresnel where n is 1.0003: difference of squares; naive: of products", "of the light", 2e-6,
         worst(run(fresnel_include, "return vec4(snellFresnelExact(a.x, a.y, a.z));", arguments), arguments, of_light),
         worst(run("", textbook, arguments), arguments, of_light)});
    for (const auto& [n1, n2] : {std::pair(1.5F, 1.5003F), {1.33F, 1.3301F}, {1.0003F, 1.0F}, {1.5168F, 1.518F}})
        indices.push_back({{1, n1, n2, 0}, {}, {}});
    const auto relative = [](const glm::vec4& a, double f) { return std::abs(f / normal_reflectance(a.y, a.z) - 1); };
    hard_case({"10", "f0 of nearly equal indices, such as oil on glass; naive: ((n - 1) / (n + 1))² of their ratio n",
               "relative", 1e-5,
               worst(run(fresnel_include, "return vec4(snellFresnelF0(a.y, a.z));", indices), indices, relative),
               worst(run("", "float n = a.z / a.y, r = (n - 1.) / (n + 1.); return vec4(r * r);", indices), indices,
                     relative)});
}

// Whichever way rounding goes at the critical angle, the answer is that of a neighbouring cosine, and all light is
// reflected on one side of it.
TEST_P(LibraryFresnel, TheCriticalAngle) {
    std::vector<Arguments> arguments;
    constexpr int around = 200;
    for (float n : {1.31F, 1.33F, 1.47F, 1.5F, 1.52F, 2.16F, 2.42F, 2.69F}) {
        float c = static_cast<float>(std::cos(*critical_angle(n, 1)));
        for (int i = 0; i < around; ++i) c = std::nextafter(c, 0.0F);
        for (int i = 0; i < 2 * around; ++i, c = std::nextafter(c, 1.0F)) arguments.push_back({{c, n, 1, 0}, {}, {}});
    }
    const auto results = run(fresnel_include, "return vec4(snellFresnelExact(a.x, a.y, a.z));", arguments);
    int backward = 0, flips = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const float c = arguments[i].a.x, n = arguments[i].a.y, f = results[i].x;
        if (i % (2 * around) > 0) flips += (f == 1) != (results[i - 1].x == 1);
        // How many units of its last place the cosine must be moved for the exact answer to be this one.
        const double ulp = c - std::nextafter(c, 0.0F);
        const auto reached = [&](int ulps) {
            const double low = fresnel(c - ulps * ulp, n, 1), high = fresnel(c + ulps * ulp, n, 1);
            return f >= std::min(low, high) - 1e-6 && f <= std::max(low, high) + 1e-6;
        };
        int ulps = 0;
        while (ulps < 100 && !reached(ulps)) ++ulps;
        backward = std::max(backward, ulps);
    }
    EXPECT_EQ(flips, 8);
    hard_case({"1", "the critical angle, n from 1.31 to 2.69: the answer is that of a neighbouring cosine",
               "units of the cosine's last place", 4, static_cast<double>(backward), std::nullopt});
}

TEST_P(LibraryFresnel, PowersAreMultiplied) {
    std::vector<Arguments> arguments;
    for (int i = 1; i <= 5000; ++i) arguments.push_back({{static_cast<float>(i) / 5000, 0, 0, 0}, {}, {}});
    const auto ulps = [&](std::string_view before, std::string_view body) {
        double worst = 0;
        const auto out = run(before, body, arguments);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double x = static_cast<double>(arguments[i].a.x), truth = x * x * x * x * x;
            worst = worse(worst, std::abs(static_cast<double>(out[i].x) - truth) / truth * 8388608.0);
        }
        return worst;
    };
    hard_case({"A21", "the fifth power of Schlick's form: multiplied; naive: pow(x, 5.)", "units of the last place", 3,
               ulps(fresnel_include, "return vec4(snellPow5(a.x));"), ulps("", "return vec4(pow(a.x, 5. + b.x));")});
}

TEST_P(LibraryFresnel, NoneOfPAtBrewstersAngleAndAllAtGrazing) {
    std::vector<Arguments> arguments;
    for (const double n : {1.0003, 1.31, 1.33, 1.5, 1.52, 2.42, 4.0})
        arguments.push_back({{std::cos(brewster_angle(1, n)), 1, n, normal_reflectance(1, n)}, {}, {}});
    double worst = 0;
    for (const glm::vec4& r : run(fresnel_include,
                                  "return vec4(snellFresnelPolarised(a.x, a.y, a.z).y, "
                                  "1. - snellFresnelExact(0., a.y, a.z), snellFresnelExact(1., a.y, a.z) - a.w, 0.);",
                                  arguments))
        for (int i = 0; i < 3; ++i) worst = worse(worst, std::abs(static_cast<double>(r[i])));
    hard_case({"12", "Brewster's angle: nothing of p; grazing: everything; normal incidence: f0", "of the light", 3e-7,
               worst, std::nullopt});
}

TEST_P(LibraryFresnel, EveryRungIsMonotone) {
    std::vector<Arguments> arguments;
    constexpr int steps = 2000;
    for (const float n : {1.0003F, 1.31F, 1.33F, 1.52F, 2.42F})
        for (int i = 0; i <= steps; ++i)
            arguments.push_back({{std::cos(static_cast<float>(i) * 1.5707963F / steps), 1, n, 0}, {}, {}});
    const auto wrong = [&](std::string_view before, std::string_view body) {
        const auto out = run(before, body, arguments);
        int count = 0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const bool falls = i % (steps + 1) > 0 && !(out[i].x >= out[i - 1].x - 2e-6F);
            count += falls || !(out[i].x >= 0 && out[i].x <= 1);
        }
        return static_cast<double>(count);
    };
    double all = wrong(fresnel_include, "return vec4(snellFresnelExact(a.x, a.y, a.z));");
    for (const Rung& rung : rungs) all += wrong(fresnel_include, rung.body);
    hard_case({"70", "reflectances lie in [0,1] and grow toward grazing, every rung; naive: 1 + cos as printed",
               "cosines where not", 0, all, wrong("", "return vec4(.04 + .96 * pow(1. + a.x, 5.));")});
}

// What is reflected one way is reflected the other way. Flat rays come back next to the critical
// angle, where a rounding of the cosine is 3e-4 of the reflectance: they count a tenth.
TEST_P(LibraryFresnel, ExactSchlickAndGaussianAreReciprocal) {
    std::vector<Arguments> arguments;
    for (const float n : {1.0003F, 1.33F, 1.52F, 2.42F})
        for (int i = 1; i <= 400; ++i) arguments.push_back({{static_cast<float>(i) / 400, 1, n, 0}, {}, {}});
    const auto worst = [&](const std::string& there, const std::string& back) {
        const auto out =
            run(fresnel_include,
                "float t = snellCosTransmitted(a.x, a.y, a.z); return vec4(" + there + ", " + back + ", 0., 0.);",
                arguments);
        double most = 0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double off = std::abs(static_cast<double>(out[i].x) - static_cast<double>(out[i].y));
            most = worse(most, arguments[i].a.x < .05F ? off / 10 : off);
        }
        return most;
    };
    double most = 0;
    for (const std::string name : {"snellFresnelExact", "snellFresnelSchlick", "snellFresnelGaussian"})
        most = worse(most, worst(name + "(a.x, a.y, a.z)", name + "(t, a.z, a.y)"));
    hard_case({"11",
               "reciprocity: as much is reflected from inside as from outside; naive: Schlick by the incident cosine",
               "of the light", 3e-5, most,
               worst("snellFresnelSchlick(a.x, a.y, a.z)", "snellFresnelSchlick5(t, snellFresnelF0(a.z, a.y))")});
}

SNELL_IN_ALL_DIALECTS(LibraryFresnel);

// ---- The ladder of metals on the GPU.

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
