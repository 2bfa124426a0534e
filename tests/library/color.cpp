// The sRGB curve on the GPU.
#include "tests/library/common.h"

namespace snell::test {
namespace {

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
