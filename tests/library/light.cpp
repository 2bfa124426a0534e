// Irradiance, dispersion and noise of the library, and that all of it compiles wherever it must.
#include <fmt/format.h>
#include <iomanip>

#include "src/content/cube/convolve.h"
#include "tests/hard_case.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/color.h"
#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/dispersion.h"
#include "tests/oracle/optics/glass.h"
#include "tests/oracle/optics/irradiance.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/oracle/optics/sphere.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryLight : public LibraryTest {};

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

std::vector<Arguments> normals(int count) {
    std::vector<Arguments> out;
    for (const glm::dvec3& n : unit_vectors(count)) out.push_back({{glm::vec3(n), 0}, {}, {}});
    return out;
}

// The nine coefficients as scenes get them.
std::string coefficients(const Radiance& radiance) {
    content::CubeLight light;
    light.size = 64;
    for (int i = 0; i < 6 * 64 * 64; ++i) {
        const glm::dvec3 c = radiance(*unit(cube_direction({i / 4096, (i % 64 + .5) / 64, (i / 64 % 64 + .5) / 64})));
        light.texels.push_back({static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)});
    }
    std::string text = "vec3 sh[9];\n";
    int i = 0;
    for (const auto& c : content::harmonics(light))
        text += fmt::format("sh[{}] = vec3({:#}, {:#}, {:#});\n", i++, c[0], c[1], c[2]);
    return text;
}

// Root mean square over normals that are spread evenly, relative to the mean irradiance.
class Gathered {
public:
    explicit Gathered(const Radiance& radiance) {
        for (int i = 0; i < count; ++i) {
            const double z = (2. * i + 1) / count - 1, turn = 2 * std::numbers::pi * i / std::numbers::phi;
            const glm::dvec3 n(std::sqrt(1 - z * z) * std::cos(turn), z, std::sqrt(1 - z * z) * std::sin(turn));
            arguments.push_back({glm::vec4(n, 0), {}, {}});
            truth_.push_back(irradiance(radiance, n, 64));
        }
    }
    double error(const std::vector<glm::vec4>& found) const {
        double squares = 0, sum = 0;
        for (std::size_t i = 0; i < truth_.size(); ++i) {
            const glm::dvec3 off = vec(found[i]) - truth_[i];
            squares += glm::dot(off, off);
            sum += truth_[i].x + truth_[i].y + truth_[i].z;
        }
        return std::sqrt(squares / 3 / count) / (sum / 3 / count);
    }
    std::vector<Arguments> arguments;

private:
    static constexpr int count = 100;
    std::vector<glm::dvec3> truth_;
};

// What docs/light.md prints of one, four and nine coefficients.
TEST_P(LibraryLight, IrradianceHasTheErrorsThatAreKnown) {
    const auto found = [&](const Gathered& light, const Radiance& radiance, int order) {
        const auto out = run("#include <snell/irradiance.glsl>\n",
                             coefficients(radiance) + "return vec4(snellIrradianceHarmonics(sh, a.xyz, " +
                                 std::to_string(order) + "), 0.);",
                             light.arguments);
        return light.error(out);
    };
    const struct {
        Radiance radiance;
        double order[3];
    } printed[] = {{sky, {.367, .0285, .0011}}, {walls, {.259, .0351, .0009}}, {window, {.769, .291, .0606}}};
    for (const auto& p : printed) {
        const Gathered light(p.radiance);
        for (int order = 0; order <= 2; ++order)
            EXPECT_NEAR(found(light, p.radiance, order) / p.order[order], 1, .1) << order;
    }
    // Undoes a texel's share, as who counts all texels alike.
    const Radiance flat = [](const glm::dvec3& d) {
        const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        return window(d) / (largest * largest * largest) * (4 * std::numbers::pi / 24);
    };
    const Gathered light(window);
    hard_case({"A22", "spherical harmonics of a room with a window; naive: texels without their solid angles",
               "relative", .15, found(light, window, 2), found(light, flat, 2)});
}

// Light of the first three orders alone: the cosine keeps 1, 2/3 and 1/4 of them (Ramamoorthi and Hanrahan 2001).
TEST_P(LibraryLight, IrradianceOfThreeOrdersIsExact) {
    const auto light = [](const glm::dvec3& d, double constant, double linear, double quadratic) {
        const double one = glm::dot(d, {.3, -.2, .1});
        const double two = .4 * d.x * d.y + .3 * d.y * d.z - .2 * d.x * d.z + .2 * (3 * d.z * d.z - 1) +
                           .3 * (d.x - d.y) * (d.x + d.y);
        return constant + linear * one + quadratic * two;
    };
    const std::string sh = coefficients([&](const glm::dvec3& d) { return glm::dvec3(light(d, 1, 1, 1), 2, d.y + 2); });
    const auto arguments = normals(500);
    for (int order = 0; order <= 2; ++order) {
        const auto out =
            run("#include <snell/irradiance.glsl>\n",
                sh + "return vec4(snellIrradianceHarmonics(sh, a.xyz, " + std::to_string(order) + "), 0.);", arguments);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const glm::dvec3 n = vec(arguments[i].a);
            const double linear = order > 0 ? 2. / 3 : 0;
            const glm::dvec3 truth(light(n, 1, linear, order > 1 ? .25 : 0), 2, linear * n.y + 2);
            EXPECT_LT(glm::length(vec(out[i]) - truth), 3e-5) << order;
        }
    }
}

TEST_P(LibraryLight, IrradianceIsNeverNegative) {
    const Radiance sun = [](const glm::dvec3& d) { return glm::dvec3(d.y > 0.996 ? 300 : 0); };
    int clamped = 0, negative = 0;
    for (const glm::vec4& r :
         run("#include <snell/irradiance.glsl>\n",
             coefficients(sun) + "return vec4(snellIrradianceHarmonics(sh, a.xyz, 2), 0.);", normals(500))) {
        negative += r.x < 0;
        clamped += r.x == 0;
    }
    hard_case({"22", "spherical harmonics of a small sun are negative opposite to it: clamped", "of 500 directions", 0,
               static_cast<double>(negative), static_cast<double>(clamped)});
}

TEST_P(LibraryLight, QuadratureApproachesTheOracle) {
    set_cube([](const glm::dvec3& d) { return glm::vec3(walls(d)); }, 32);
    const auto arguments = normals(1000);
    double before = 1;
    for (int count : {16, 64, 256, 1024}) {
        const auto results =
            run("#include <snell/irradiance.glsl>\n",
                "return vec4(snellIrradianceQuadrature(cube, a.xyz, " + std::to_string(count) + "), 0.);", arguments);
        double squares = 0;
        for (std::size_t i = 0; i < arguments.size(); i += 20) {
            const glm::dvec3 off = vec(results[i]) - irradiance(walls, vec(arguments[i].a), 32);
            squares += glm::dot(off, off) / 150;
        }
        EXPECT_LT(std::sqrt(squares), before) << count;
        before = std::sqrt(squares);
    }
    EXPECT_LT(before, 0.006);
}

TEST_P(LibraryLight, CosineDirectionsLieOnTheHemisphere) {
    std::vector<Arguments> arguments = normals(300);
    for (float z : {1.0F, -1.0F}) arguments.push_back({{0, 0, z, 0}, {}, {}});
    for (int i : {0, 1, 17, 63}) {
        const auto results =
            run("#include <snell/irradiance.glsl>\n",
                "return vec4(snellCosineDirection(a.xyz, " + std::to_string(i) + ", 64), 0.);", arguments);
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            EXPECT_NEAR(glm::length(vec(results[k])), 1, 1e-5);
            EXPECT_NEAR(glm::dot(vec(results[k]), vec(arguments[k].a)), std::sqrt(1 - (i + 0.5) / 64), 1e-5);
        }
    }
}

// Every number of the table of bands, from the matching functions.
TEST_P(LibraryLight, BandsAgreeWithTheOracle) {
    std::vector<Arguments> arguments;
    std::vector<Band> truth;
    for (int count : {4, 6, 8, 16, 32, 64})
        for (const Band& band : spectral_bands(count)) {
            arguments.push_back({{static_cast<float>(arguments.size()), static_cast<float>(count), 0, 0}, {}, {}});
            truth.push_back(band);
        }
    const auto bands = run("#include <snell/bands.glsl>\n", "return SNELL_BANDS[int(a.x)];", arguments);
    const auto places = run("#include <snell/bands.glsl>\n",
                            "int n = int(a.y); return vec4(float(snellBandFirst(n)), float(snellBandCount(n)), "
                            "float(snellBandCount(n - 1)), float(snellBandCount(1000)));",
                            arguments);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_LT(glm::length(vec(bands[i]) - truth[i].rgb), 1e-6) << i;
        EXPECT_NEAR(bands[i].w, truth[i].nanometres, 1e-3) << i;
        EXPECT_EQ(places[i].y, arguments[i].a.y);
        EXPECT_LE(places[i].x, static_cast<float>(i));
        EXPECT_GT(places[i].x + places[i].y, static_cast<float>(i));
        EXPECT_EQ(places[i].z, places[i].y);
        EXPECT_EQ(places[i].w, 64);
    }
}

// A BK7 ball in white light before a step edge. Along the radius of its picture, what is turned by more than the edge's
// angle is bright. One edge meets few wavelengths, so many edges are tried. In linear light, against 1024 wavelengths.
class Fringe {
public:
    double rmse(const std::vector<Band>& bands) const {
        const std::vector<glm::dvec3> p = picture(bands);
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += glm::dot(p[i] - reference_[i], p[i] - reference_[i]);
        return std::sqrt(sum / 3 / static_cast<double>(p.size()));
    }

private:
    static constexpr std::size_t pixels = 1000, edges = 14;
    static std::vector<glm::dvec3> picture(const std::vector<Band>& bands) {
        std::vector<glm::dvec3> out(edges * pixels, glm::dvec3(0));
        for (const Band& band : bands) {
            const double n = find_glass("BK7")->index(band.nanometres);
            for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
                const double b = 0.2 + 0.75 * (static_cast<double>(pixel) + 0.5) / pixels;
                const double turned = 2 * (std::asin(b) - std::asin(b / n));
                for (std::size_t edge = 0; edge < edges; ++edge)
                    if (turned > 0.4 + 0.02 * static_cast<double>(edge)) out[edge * pixels + pixel] += band.rgb;
            }
        }
        return out;
    }
    const std::vector<glm::dvec3> reference_ = picture(spectral_bands(1024));
};

// What docs/light.md and docs/teaching.md print.
TEST_P(LibraryLight, BandsHaveTheErrorsThatAreKnown) {
    const Fringe fringe;
    const auto rgb = [](double r, double g, double b) {
        return std::vector<Band>{{r, {1, 0, 0}}, {g, {0, 1, 0}}, {b, {0, 0, 1}}};
    };
    const glm::dvec3 w(rgb_wavelengths);
    EXPECT_NEAR(fringe.rmse({{587.56, glm::dvec3(1)}}) / .052, 1, .1) << "one index";
    EXPECT_NEAR(fringe.rmse(rgb(w.r, w.g, w.b)) / .019, 1, .1) << "three";
    EXPECT_NEAR(fringe.rmse(rgb(w.b, w.g, w.r)) / .070, 1, .1) << "in the wrong order";
    std::vector<Arguments> arguments(130);
    for (std::size_t i = 0; i < arguments.size(); ++i) arguments[i].a.x = static_cast<float>(i);
    const auto table = run("#include <snell/bands.glsl>\n", "return SNELL_BANDS[int(a.x)];", arguments);
    std::size_t first = 0;
    for (const auto& [count, error] : {std::pair(4U, .0169), {6U, .0135}, {8U, .0114}, {16U, .0058}, {32U, .0030}}) {
        std::vector<Band> bands;
        for (std::size_t i = first; i < first + count; ++i) bands.push_back({table[i].w, vec(table[i])});
        EXPECT_NEAR(fringe.rmse(bands) / error, 1, .1) << count;
        first += count;
    }
}

// a = I, b = N of rays that meet a ball.
std::vector<Arguments> impacts() {
    std::vector<Arguments> out;
    const auto directions = unit_vectors(2400);
    for (std::size_t i = 0; i + 1 < directions.size(); i += 2) {
        const double side = glm::dot(directions[i], directions[i + 1]) > 0 ? -1 : 1;
        out.push_back({{glm::vec3(side * directions[i + 1]), 0}, {glm::vec3(directions[i]), 0}, {}});
    }
    return out;
}

const Cauchy flint = cauchy_from_abbe(1.78472, 25.68);
std::string digits(double value) {
    std::ostringstream out;
    out << std::setprecision(9) << std::showpoint << value;
    return out.str();
}
const std::string flint_text = digits(flint.a) + ", " + digits(flint.b);

TEST_P(LibraryLight, DispersionAgreesWithTheOracle) {
    constexpr int size = 64;
    const auto smooth = [](const glm::dvec3& d) { return glm::vec3(0.5 + 0.5 * d); };
    set_cube(smooth, size);
    const auto arguments = impacts();
    ASSERT_GE(arguments.size(), 1000U);
    for (int count : {4, 16, 64}) {
        const auto results = run("#include <snell/dispersion.glsl>\n",
                                 "return vec4(snellDisperseSphere(cube, a.xyz, b.xyz, 1., " + flint_text + ", " +
                                     std::to_string(count) + "), 0.);",
                                 arguments);
        const auto bands = spectral_bands(count);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            glm::dvec3 truth(0);
            for (const Band& band : bands) {
                const auto light =
                    through_sphere(vec(arguments[i].a), vec(arguments[i].b), 1, flint.index(band.nanometres));
                if (light.exits.size() > 1) truth += band.rgb * glm::dvec3(smooth(light.exits[1].direction));
            }
            EXPECT_LT(glm::length(vec(results[i]) - truth), 0.08) << i;  // two texels of the map
        }
    }
}

TEST_P(LibraryLight, IndicesAgreeWithTheOracle) {
    std::vector<Arguments> arguments;
    for (int i = 0; i <= 1000; ++i) arguments.push_back({{static_cast<float>(200 + i), 0, 0, 0}, {}, {}});
    const auto results =
        run("#include <snell/dispersion.glsl>\n",
            "return vec4(snellCauchy(" + flint_text + ", a.x), snellCauchyRgb(" + flint_text + "));", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        EXPECT_NEAR(results[i].x, flint.index(arguments[i].a.x), 2e-6);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(results[i][k + 1], flint.index(rgb_wavelengths[k]), 2e-6);
    }
    EXPECT_LT(results[0].y, results[0].w) << "blue is bent most";
}

TEST_P(LibraryLight, SellmeierAgreesWithTheOracle) {
    std::vector<Arguments> arguments;
    for (int i = 0; i <= 1000; ++i) arguments.push_back({{static_cast<float>(370 + 0.73 * i), 0, 0, 0}, {}, {}});
    const auto results = run("#include <snell/dispersion.glsl>\n",
                             "return vec4(snellSellmeier(vec3(1.73759695, .313747346, 1.89878101), "
                             "vec3(.013188707, .0623068142, 155.23629), a.x), "
                             "snellSellmeier(vec3(1.03961212, .231792344, 1.01046945), "
                             "vec3(.00600069867, .0200179144, 103.560653), a.x), 0., 0.);",
                             arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        EXPECT_NEAR(results[i].x, find_glass("SF11")->index(arguments[i].a.x), 2e-6);
        EXPECT_NEAR(results[i].y, find_glass("BK7")->index(arguments[i].a.x), 2e-6);
    }
}

// At the poles of the formula, and outside of what can be seen.
TEST_P(LibraryLight, EveryWavelengthHasAnIndex) {
    auto arguments = special_arguments(2000);
    for (const float nm : {-100.F, 62.543F, 77.5F, 100.3F, 106.F, 141.5F, 166.739F, 175.F, 189.7F, 1e4F, 10176.5F})
        arguments.push_back({{nm, 0, 0, 0}, {}, {}});
    const auto none = [&](std::string_view before, std::string_view body) {
        const auto out = run(before, body, arguments);
        return static_cast<double>(
            std::count_if(out.begin(), out.end(), [](const glm::vec4& r) { return !(r.x >= 1 && r.x < 3); }));
    };
    hard_case(
        {"14",
         "the index of BK7 at the poles of Sellmeier's formula and at wavelengths nobody sees; naive: the formula",
         "of 2011 indices that are none", 0,
         none("#include <snell/dispersion.glsl>\n",
              "return vec4(snellSellmeier(vec3(1.03961212, .231792344, 1.01046945), "
              "vec3(.00600069867, .0200179144, 103.560653), a.x));"),
         none("",
              "float w2 = a.x * a.x * 1e-6;\n"
              "return vec4(sqrt(1. + 1.03961212 * w2 / (w2 - .00600069867) + "
              ".231792344 * w2 / (w2 - .0200179144) + 1.01046945 * w2 / (w2 - 103.560653)));")});
}

// Hard case 26: without spread all methods are one lookup; 27: a channel past its critical angle sees the mirror image.
TEST_P(LibraryLight, DispersionWithoutSpreadIsOneLookup) {
    set_cube([](const glm::dvec3& d) { return glm::vec3(0.5 + 0.5 * d); }, 64);
    const auto arguments = impacts();
    constexpr std::string_view include = "#include <snell/dispersion.glsl>\n";
    const auto one = run(include, "return texture(cube, snellRefractSphere(a.xyz, b.xyz, 1., 1.5));", arguments);
    for (const char* body :
         {"return vec4(snellDisperseSphere(cube, a.xyz, b.xyz, 1., 1.5, 0., 16), 1.);",
          "return vec4(snellDisperseSphereRgb(cube, a.xyz, b.xyz, 1., snellCauchyRgb(1.5, 0.)), 1.);"})
        EXPECT_EQ(run(include, body, arguments), one) << body;
    const auto surface = run(include, "return texture(cube, snellRefractSingle(a.xyz, b.xyz, 1., 1.5));", arguments);
    EXPECT_EQ(run(include, "return vec4(snellDisperseSurfaceRgb(cube, a.xyz, b.xyz, 1., vec3(1.5)), 1.);", arguments),
              surface);
}

TEST_P(LibraryLight, AChannelPastItsCriticalAngleSeesTheMirrorImage) {
    set_cube([](const glm::dvec3& d) { return glm::vec3(0.5 + 0.5 * d); }, 64);
    const auto arguments = impacts();
    const auto results =
        run("#include <snell/dispersion.glsl>\n",
            "vec3 i = normalize(vec3(.72, 0., -.69));\n"
            "vec3 both = snellDisperseSurfaceRgb(cube, i, vec3(0., 0., 1.), 1.5, vec3(1.2, 1.2, 1.));\n"
            "vec3 mirrored = texture(cube, snellReflect(i, vec3(0., 0., 1.))).rgb;\n"
            "vec3 bent = texture(cube, snellRefractSingle(i, vec3(0., 0., 1.), 1.5, 1.2)).rgb;\n"
            "return vec4(both - vec3(bent.rg, mirrored.b), abs(bent.b - mirrored.b));",
            arguments);
    EXPECT_EQ(glm::length(vec(results[0])), 0);
    EXPECT_GT(results[0].w, 0.1F);
}

// Gradient noise as its sources define it: the hash pcg3d, Perlin's twelve directions and quintic fade.
double gradient_noise(const glm::dvec3& p) {
    const glm::ivec3 cell(glm::floor(p));
    const glm::dvec3 f = p - glm::floor(p), fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        glm::uvec3 v = glm::uvec3(cell + step) * 1664525U + 1013904223U;
        for (int round = 0; round < 2; ++round) {
            v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
            if (round == 0) v ^= v >> 16U;
        }
        const unsigned edge = v.x >> 28U;
        const glm::dvec3 off = f - glm::dvec3(step), weight = glm::mix(1.0 - fade, fade, glm::dvec3(step));
        const double a = edge < 8 ? off.x : off.y, b = edge < 4 ? off.y : edge == 12 || edge == 14 ? off.x : off.z;
        sum += weight.x * weight.y * weight.z * ((edge & 1U ? -a : a) + (edge & 2U ? -b : b));
    }
    return sum;
}

TEST_P(LibraryLight, NoiseAgreesWithItsDefinition) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> any(-50, 50);
    std::vector<Arguments> arguments;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 p(any(random), any(random), any(random));
        arguments.push_back({{p, 0}, {glm::floor(p), 0}, {}});
    }
    const auto results = run("#include <snell/noise.glsl>\n",
                             "return vec4(snellNoise(a.xyz), snellNoise(a.xyz + vec3(1e-3, 0., 0.)), "
                             "snellNoise(b.xyz), snellFractalNoise(a.xyz, 5));",
                             arguments);
    double mean = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const glm::vec4& r = results[i];
        EXPECT_NEAR(r.x, gradient_noise(vec(arguments[i].a)), 1e-5);
        EXPECT_TRUE(std::abs(r.x) <= 1 && std::abs(r.w) <= 1);
        EXPECT_LT(std::abs(r.x - r.y), 5e-3) << "not smooth";
        EXPECT_EQ(r.z, 0) << "at integers";
        mean += r.x / 4000;
    }
    EXPECT_NEAR(mean, 0, 0.02);
    int bad = 0;
    for (const glm::vec4& r :
         run("#include <snell/noise.glsl>\n",
             "return vec4(snellNoise(a.xyz), snellFractalNoise(b.xyz, int(clamp(c.w, -9., 9.))), 0., 0.);",
             special_arguments(10000)))
        bad += !(std::abs(r.x) <= 1 && std::abs(r.y) <= 1);
    EXPECT_EQ(bad, 0);
}

class LibraryDialects : public LibraryTest {};

TEST_P(LibraryDialects, CompileEveryFile) {
    const bool es = GetParam().request.es;
    const std::vector<const char*> versions =
        es                                 ? std::vector{"#version 300 es", "#version 310 es", "#version 320 es"}
        : GetParam().request.version == 33 ? std::vector{"#version 330 core"}
                                           : std::vector{"#version 330 core", "#version 410 core", "#version 450 core"};
    for (const char* version : versions) {
        std::string all;
        for (const char* file :
             {"core", "fresnel", "refraction", "environment", "bands", "dispersion", "irradiance", "noise", "ray"}) {
            const std::string include = "#include <snell/" + std::string(file) + ".glsl>\n";
            EXPECT_TRUE(compiles(version, include)) << file;
            EXPECT_TRUE(compiles(version, include + include)) << file << " twice";
            all += include;
        }
        EXPECT_TRUE(compiles(version, all)) << "together";
    }
}

SNELL_IN_THE_FIRST_DIALECT(LibraryLight);
SNELL_IN_ALL_DIALECTS(LibraryDialects);

// ---- The sRGB curve on the GPU.

class LibraryColor : public LibraryTest {};

constexpr std::string_view curve = "#include <snell/color.glsl>\n";

// IEC 61966-2-1.
double encode(double light) { return light <= .0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - .055; }

TEST_P(LibraryColor, EncodesAndDecodes) {
    std::vector<Arguments> arguments;
    for (int i = 0; i <= 1000; ++i)
        arguments.push_back({glm::vec4(i / 1000., -i / 500., .0031308 + (i - 500) * 1e-6, 0), {}, {}});
    const auto encoded = run(curve, "return vec4(snellEncode(a.xyz), 1.);", arguments);
    const auto back = run(curve, "return vec4(snellDecode(snellEncode(a.xyz)), 1.);", arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const glm::dvec3 a(arguments[i].a);
        EXPECT_NEAR(encoded[i].x, encode(a.x), 2e-6);
        EXPECT_NEAR(encoded[i].y, -encode(-a.y), 4e-6) << "odd";
        EXPECT_NEAR(encoded[i].z, encode(a.z), 2e-6) << "continuous at the knee";
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[i][c], a[c], 1e-5);
    }
}

TEST_P(LibraryColor, SpecialValuesAreFinite) {
    int bad = 0;
    for (const float value : {0.f, -0.f, 1e-40f, -1e-40f, 1e30f, -1e30f}) {
        const auto r = run(curve, "return vec4(snellEncode(a.xxx).x, snellDecode(a.yyy).x, 0., 1.);",
                           {{glm::vec4(value, value > 1 || value < -1 ? 1.f : value, 0, 0), {}, {}}});
        bad += !finite(r[0]);
    }
    EXPECT_EQ(bad, 0);
}

SNELL_IN_ALL_DIALECTS(LibraryColor);

}  // namespace
}  // namespace snell::test
