// Glass seen from both sides, by pictures of its back faces.
#include "tests/oracle/optics/two_sided.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {
namespace {

using namespace optics;

constexpr int size = 256;
constexpr double range = 8;

// A ball of radius 1 about (0, 0, -3) in a view whose clip coordinates are those of the eye.
class LibraryTwoSided : public LibraryTest {
protected:
    static std::optional<glm::dvec3> back(double x, double y) {
        const double r2 = x * x + y * y;
        if (r2 > 1) return std::nullopt;
        return glm::dvec3(x, y, -3 - std::sqrt(1 - r2));
    }
    static glm::dvec3 texel(const glm::dvec3& p) {
        const auto middle = [](double v) { return (std::floor((0.5 + 0.5 * v) * size) + 0.5) / size * 2 - 1; };
        return {middle(p.x), middle(p.y), 0};
    }
    // What the picture shows at the texel in which a point appears.
    static std::optional<BackFace> nearest(const glm::dvec3& p) {
        const glm::dvec3 at = texel(p);
        const auto position = back(at.x, at.y);
        if (!position) return std::nullopt;
        return BackFace{{p.x, p.y, position->z}, *position - glm::dvec3(0, 0, -3)};
    }

    void make(gl::Pixels type, bool linear) {
        std::vector<Arguments> places;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto p = back((x + 0.5) / size * 2 - 1, (y + 0.5) / size * 2 - 1);
                places.push_back({p ? glm::vec4(glm::vec3(*p), 1) : glm::vec4(0), {}, {}});
            }
        const std::string include = "#include <snell/refraction.glsl>\n";
        upload(
            normals,
            run(include, "return vec4(a.w > 0. ? snellBackNormal(a.xyz + vec3(0., 0., 3.)) : vec3(0.), 1.);", places),
            type, linear);
        upload(depths, run(include, "return vec4(a.w > 0. ? snellBackDepth(a.xyz, 8.) : vec3(0.), 1.);", places), type,
               false);
    }
    static void upload(gl::Texture& to, const std::vector<glm::vec4>& values, gl::Pixels type, bool linear) {
        std::vector<std::uint8_t> bytes;
        for (const glm::vec4& v : values)
            for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<std::uint8_t>(std::lround(v[k] * 255)));
        const void* data = type == gl::Pixels::rgba8 ? static_cast<const void*>(bytes.data()) : values.data();
        to = gl::make_texture(GL_TEXTURE_2D, {type, size, size, 1, static_cast<const std::byte*>(data)},
                              {linear ? gl::Sampling::Mode::linear : gl::Sampling::Mode::nearest, 1, true});
    }
    void bind(GLuint program) override {
        const std::array<std::pair<const char*, const gl::Texture*>, 2> textures = {
            {{"backNormals", &normals}, {"backDepths", &depths}}};
        for (std::size_t i = 0; i < textures.size(); ++i) {
            glActiveTexture(GL_TEXTURE4 + static_cast<GLenum>(i));
            glBindTexture(GL_TEXTURE_2D, textures[i].second->get());
            glUniform1i(glGetUniformLocation(program, textures[i].first), 4 + static_cast<GLint>(i));
        }
    }
    std::vector<glm::vec4> refracted(const std::vector<Arguments>& arguments) {
        return run("#include <snell/refraction.glsl>\nuniform sampler2D backNormals, backDepths;\n",
                   "return vec4(snellRefractTwoSided(a.xyz, vec3(0., 0., -1.), b.xyz, 1., a.w, 2., mat4(1.), "
                   "backNormals, backDepths, 8.), 1.);",
                   arguments);
    }
    // a = (point, n), b = (normal, impact)
    static std::vector<Arguments> rain(int side) {
        std::vector<Arguments> out;
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                const double x = (2 * i + 1.03) / side - 1, y = (2 * k + 1.07) / side - 1, r2 = x * x + y * y;
                if (r2 > 0.98) continue;
                const glm::vec3 normal(x, y, std::sqrt(1 - r2));
                out.push_back({{normal - glm::vec3(0, 0, 3), 1.5F}, {normal, std::sqrt(r2)}, {}});
            }
        return out;
    }

    gl::Texture normals, depths;
};

TEST_P(LibraryTwoSided, AgreesWithTheOracle) {
    make(gl::Pixels::rgba32f, false);
    const auto arguments = rain(45);
    ASSERT_GE(arguments.size(), 1000U);
    const auto out = refracted(arguments);
    int compared = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const glm::dvec3 p = vec(arguments[i].a), n = vec(arguments[i].b);
        // Where the chord ends within a rounding of a texel's border either texel is right.
        bool border = false;
        const auto watched = [&](const glm::dvec3& at) {
            for (double dx : {-1e-5, 1e-5})
                for (double dy : {-1e-5, 1e-5}) border = border || texel(at + glm::dvec3(dx, dy, 0)) != texel(at);
            return nearest(at);
        };
        const auto truth = refract_two_sided(p, {0, 0, -1}, n, 1, 1.5, 2, watched);
        ASSERT_TRUE(truth);
        if (border) continue;
        // At the critical angle of the back the direction turns infinitely fast.
        EXPECT_LT(angle_between(vec(out[i]), *truth), arguments[i].b.w < 0.85F ? 1e-4 : 2e-3) << arguments[i].b.w;
        ++compared;
    }
    EXPECT_GT(compared, 1000);
}

TEST_P(LibraryTwoSided, IsWithinADegreeUpToSixTenths) {
    for (const gl::Pixels type : {gl::Pixels::rgba32f, gl::Pixels::rgba8}) {
        make(type, true);
        const auto arguments = rain(90);
        const auto out = refracted(arguments);
        double inner = 0, outer = 0, mean = 0;
        // What docs/light.md prints for rays that far from the axis.
        const struct {
            float impact;
            double degrees;
        } printed[] = {{.1F, .002}, {.3F, .07}, {.5F, .40}, {.6F, .88}, {.7F, 1.9}, {.8F, 4.9}};
        double sums[std::size(printed)] = {}, counts[std::size(printed)] = {};
        for (std::size_t i = 0; i < out.size(); ++i) {
            const glm::dvec3 n = vec(arguments[i].b), along(0, 0, -1);
            const float impact = arguments[i].b.w;
            const auto truth = leave_sphere(along, meet(along, n, 1, 1.5)->transmitted);
            const double off = glm::degrees(angle_between(vec(out[i]), truth));
            (impact <= 0.6F ? inner : outer) = std::max(impact <= 0.6F ? inner : outer, off);
            mean += off / static_cast<double>(out.size());
            for (std::size_t k = 0; k < std::size(printed); ++k)
                if (std::abs(impact - printed[k].impact) < .01F) sums[k] += off, ++counts[k];
        }
        // A byte of a normal is .4 degrees.
        EXPECT_LT(inner, type == gl::Pixels::rgba8 ? 1.4 : 1.0);
        EXPECT_GT(outer, 10) << "the rim";
        if (type == gl::Pixels::rgba8) continue;
        EXPECT_NEAR(mean, 4.6, .4);
        for (std::size_t k = 0; k < std::size(printed); ++k)
            EXPECT_NEAR(sums[k] / counts[k] / printed[k].degrees, 1, .1) << printed[k].impact;
    }
}

TEST_P(LibraryTwoSided, DepthsKeepTheirDigitsInBytes) {
    std::vector<Arguments> arguments;
    for (int i = 0; i < 2000; ++i) arguments.push_back({{0, 0, -8.0F * static_cast<float>(i) / 2000, 0}, {}, {}});
    const auto digits =
        run("#include <snell/refraction.glsl>\n", "return vec4(snellBackDepth(a.xyz, 8.), 1.);", arguments);
    for (std::size_t i = 0; i < digits.size(); ++i) {
        double depth = 0;
        for (int k = 0; k < 3; ++k) depth += std::round(digits[i][k] * 255.0) / 255 * std::pow(255.0, -k) * range;
        EXPECT_NEAR(depth, -arguments[i].a.z, 2e-6 * range) << i;
    }
}

TEST_P(LibraryTwoSided, SpecialValuesGiveDirections) {
    make(gl::Pixels::rgba8, false);
    const auto results =
        run("#include <snell/refraction.glsl>\nuniform sampler2D backNormals, backDepths;\n",
            "return vec4(snellRefractTwoSided(a.xyz, b.xyz, c.xyz, a.w, b.w, c.w, mat4(1.), backNormals, backDepths, "
            "8.), 1.);",
            special_arguments(20000));
    int bad = 0;
    for (const glm::vec4& r : results) bad += !finite(r) || std::abs(glm::length(vec(r)) - 1) > 1e-5;
    EXPECT_EQ(bad, 0);
}

SNELL_IN_ALL_DIALECTS(LibraryTwoSided);

}  // namespace
}  // namespace snell::test
