// Mistakes that are printed in well-known teaching material, each beside the right form, and how far they are apart:
// the figures of docs/teaching.md.
#include "tests/harness/harness.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/ray.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryErrata : public LibraryTest {};

// Rays from an eye at this distance to a ball of radius 1, spread evenly over the disc that it covers. a = (from the
// eye to the surface, the cosine of incidence), b = (normal, 0).
std::vector<Arguments> rays_at_ball(double distance) {
    constexpr int rings = 10'000;
    const double rim = 1 / std::sqrt(distance * distance - 1);  // of the ball's outline, at distance 1
    std::vector<Arguments> out;
    for (int i = 0; i < rings; ++i) {
        const Ray ray{{0, 0, distance}, *unit({rim * std::sqrt((i + .5) / rings), 0., -1.})};
        const glm::dvec3 at = ray.at(cross_sphere(ray, glm::dvec3(0), 1).value().enter);
        out.push_back({glm::vec4(at - ray.origin, -glm::dot(at, ray.direction)), glm::vec4(at, 0), {}});
    }
    return out;
}

constexpr double afar = 1e4;

struct Mistake {
    std::string off;  // how far what is printed is from what is right
    double distance;
    double mean, largest;  // 0: the page has none
};

std::string degrees_between(const std::string& printed, const std::string& right) {
    return "degrees(snellAngle(" + printed + ", " + right + "))";
}
std::string refracted_too_long() {
    return degrees_between("refract(a.xyz, b.xyz, 1. / 1.5)", "snellRefractSingle(a.xyz, b.xyz, 1., 1.5)");
}
std::string mirrored_at(const std::string& length) {
    return degrees_between("reflect(a.xyz, " + length + " * b.xyz)", "snellReflect(a.xyz, b.xyz)");
}
// The angle of incidence, where a ray is refracted at all.
std::string refracted_by(const std::string& ratio) {
    return "refract(normalize(a.xyz), b.xyz, " + ratio + ") != vec3(0.) ? degrees(acos(a.w)) : 0.";
}
std::string from_exact(const std::string& printed) { return "abs(" + printed + " - snellFresnelExact(a.w, 1., 1.52))"; }

TEST_P(LibraryErrata, AreAsFarOffAsThePageSays) {
    const std::string plus_cosine = "(snellFresnelF0(1., 1.52) + (1. - snellFresnelF0(1., 1.52)) * pow(1. + a.w, 2.))";
    const Mistake mistakes[] = {
        {refracted_too_long(), 2, 4.3, 0},
        {refracted_too_long(), 4, 14.9, 32},
        {refracted_too_long(), 10, 17.6, 0},
        {mirrored_at(".99"), afar, 0, 1.2},
        {mirrored_at(".95"), afar, 0, 6.2},
        {refracted_by("1.1"), afar, 0, 65.4},
        {refracted_by("1.5"), afar, 0, 41.8},
        {refracted_by("1. / 1.5"), afar, 0, 90},
        {plus_cosine, afar, 0, 3.9},
        {from_exact(plus_cosine), afar, 2.7, 3.8},
        {from_exact("pow(a.w, 1.55)"), afar, .52, 1},
    };
    for (const Mistake& mistake : mistakes) {
        SCOPED_TRACE(mistake.off);
        double mean = 0, largest = 0;
        const auto results = run("#include <snell/fresnel.glsl>\n#include <snell/refraction.glsl>\n",
                                 "return vec4(" + mistake.off + ");", rays_at_ball(mistake.distance));
        for (const glm::vec4& r : results) {
            mean += static_cast<double>(r.x) / static_cast<double>(results.size());
            largest = worse(largest, static_cast<double>(r.x));
        }
        if (mistake.mean > 0) {
            EXPECT_NEAR(mean / mistake.mean, 1, .05);
        }
        if (mistake.largest > 0) {
            EXPECT_NEAR(largest / mistake.largest, 1, .05);
        }
    }
}

SNELL_IN_THE_FIRST_DIALECT(LibraryErrata);

// ---- The library as scenes get it: by #include in their own shaders, in any version of GLSL.

class LibraryScene : public GlTest, public testing::WithParamInterface<const char*> {};

// Half of each picture is a formula written out, the other the library's; no step between them may show.
TEST_P(LibraryScene, IncludesItInAnyVersion) {
    const std::string version = GetParam();
    const bool old = version.find("120") != std::string::npos || version.empty();
    folder.write("a.vert",
                 version + (old ? "varying vec2 vST;" : "out vec2 vST;") +
                     "\nvoid main() { vST = gl_MultiTexCoord0.st; gl_Position = gl_ModelViewProjectionMatrix * "
                     "gl_Vertex; }\n");
    folder.write("a.frag", version +
                               "#include <snell/dispersion.glsl>\n#include <snell/environment.glsl>\n"
                               "#include <snell/irradiance.glsl>\n#include <snell/noise.glsl>\n" +
                               (old ? "varying vec2 vST;" : "in vec2 vST;") +
                               "\nvoid main() {\n"
                               "    float c = vST.t;\n"
                               "    float f = snellFresnelExact(c, 1., 1.5);\n"
                               "    if (vST.s < .5) {\n"
                               "        float t = sqrt(1. - (1. - c * c) / 2.25);\n"
                               "        float s = (c - 1.5 * t) / (c + 1.5 * t), p = (t - 1.5 * c) / (t + 1.5 * c);\n"
                               "        f = .5 * (s * s + p * p);\n"
                               "    }\n"
                               "    gl_FragColor = vec4(f, snellNoise(vec3(1., 2., 3.)), snellFresnelF0(1., 3.), 1.);\n"
                               "}\n");
    const Picture picture =
        draw("Ortho -1 1 -1 1\nLookAt 0 0 1  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n");
    for (int y = 0; y < picture.height; ++y) {
        const Pixel left = picture.at(8, y), right = picture.at(56, y);
        EXPECT_TRUE(near(left, right, 1)) << y << ": " << left[0] << " " << right[0];
        EXPECT_EQ(right[1], 0);
        EXPECT_NEAR(right[2], 64, 1);
    }
    EXPECT_GT(picture.at(56, 63)[0], 200) << "grazing";
    EXPECT_NEAR(picture.at(56, 0)[0], 10, 1) << "normal incidence";
}

INSTANTIATE_TEST_SUITE_P(Versions, LibraryScene,
                         testing::Values("", "#version 120\n", "#version 330 compatibility\n",
                                         "#version 400 compatibility\n"));

}  // namespace
}  // namespace snell::test
