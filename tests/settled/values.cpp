// A constant has the bits that the uniform had.
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "tests/settled/settled.h"

namespace snell::test {
namespace {

class SettledValues : public SettledTest, public testing::WithParamInterface<ContextRequest> {
protected:
    void SetUp() override {
        request = GetParam();
        SettledTest::SetUp();
    }
    // Pixel n of the picture's row has the bits of number n, which the uniform of that number holds.
    void expect_bits(const std::string& type, const std::vector<double>& numbers) {
        std::string declarations, choice, uniforms;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            declarations += fmt::format("uniform {} u{};\n", type, i);
            choice += fmt::format("if (n == {}) bits = {}(u{});\n", i,
                                  type == "float"  ? "floatBitsToUint"
                                  : type == "bool" ? "uint"
                                                   : "uint",
                                  i);
            uniforms += fmt::format(" u{} 0", i);
        }
        folder.write("bits.frag", "#version 330 compatibility\n" + declarations +
                                      "void main() {\nint n = int(gl_FragCoord.x);\nuint bits = 0u;\n" + choice +
                                      "gl_FragColor = vec4(uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u) / "
                                      "255.;\n}\n");
        const std::string scene =
            "Ortho -1 1 -1 1\nBlend off\nVertex plain.vert\nFragment bits.frag\nProgram P" + uniforms + "\nQuadXY\n";
        folder.write("scene.glib", scene);
        const auto set = [&](Controls& controls) {
            for (std::size_t i = 0; i < numbers.size(); ++i)
                if (Control* control = controls.find(0, "u" + std::to_string(i))) control->value = {numbers[i]};
        };
        RuntimeOptions options;
        options.settle = [&](Controls& controls, const Scene&) { set(controls); };
        auto general = open_document(folder.path("scene.glib"), caps);
        auto settled = open_document(folder.path("scene.glib"), caps, nullptr, nullptr, options);
        set(general->controls);
        set(settled->controls);
        const Look look{.width = static_cast<int>(numbers.size()), .height = 2};
        EXPECT_EQ(draw(*general, look), draw(*settled, look)) << type;
        EXPECT_EQ(settled->runtime->counters().specialised_draws, 1U) << type;
        EXPECT_EQ(general->runtime->counters().specialised_draws, 0U) << type;
    }
};

TEST_P(SettledValues, AreTheSameBits) {
    std::mt19937 random(7);
    std::vector<double> floats{0,
                               1,
                               -1,
                               .1,
                               1. / 3,
                               1e-30,
                               3.4028234663852886e38,
                               1.1754943508222875e-38,
                               16777217,
                               6.0221407599999e23,
                               -2.5e-7,
                               1e10,
                               123456789};
    while (floats.size() < 48) {
        const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isnormal(value)) floats.push_back(static_cast<double>(value));
    }
    expect_bits("float", floats);
    std::vector<double> ints{0, 1, -1, 2147483647, -2147483647};
    std::vector<double> uints{0, 1, 4294967295., 2147483648.};
    while (ints.size() < 16) ints.push_back(static_cast<std::int32_t>(random()));
    while (uints.size() < 16) uints.push_back(static_cast<std::uint32_t>(random()));
    expect_bits("int", ints);
    expect_bits("uint", uints);
    expect_bits("bool", {0, 1, 1, 0});
}

// What no decimal gives on every driver: the program keeps the uniform.
TEST_P(SettledValues, ThatNoDecimalGivesStayUniforms) {
    for (const double value : {-0., 1e-42, std::numeric_limits<double>::infinity(), std::nan("")}) {
        RuntimeOptions options;
        options.settle = [&](Controls& controls, const Scene&) {
            if (Control* control = controls.find(0, "uValue")) control->value = {value};
        };
        folder.write("one.frag",
                     "#version 330 compatibility\nuniform float uValue, uOther;\nvoid main() { gl_FragColor = "
                     "vec4(uValue == 0. ? 1. : 0., isnan(uValue) ? 1. : 0., uOther, 1.); }\n");
        folder.write("scene.glib",
                     "Ortho -1 1 -1 1\nVertex plain.vert\nFragment one.frag\nProgram P uValue 1. uOther 1.\nQuadXY\n");
        auto settled = open_document(folder.path("scene.glib"), caps, nullptr, nullptr, options);
        auto general = open_document(folder.path("scene.glib"), caps);
        for (Document* document : {settled.get(), general.get()}) document->controls.find(0, "uValue")->value = {value};
        EXPECT_EQ(draw(*settled), draw(*general)) << value;
        EXPECT_EQ(settled->runtime->counters().specialised_draws, 1U) << "uOther is settled";
    }
}

TEST_P(SettledValues, OfVectorsAndMatricesAreInTheirOrder) {
    folder.write("many.frag",
                 "#version 330 compatibility\nuniform vec3 uColor;\nuniform mat2 uTurn;\nuniform ivec2 uWhole;\n"
                 "void main() { vec2 t = uTurn * vec2(1., 2.);\n"
                 "gl_FragColor = vec4(uColor.g, t.x, t.y, 1.) + vec4(vec2(uWhole) / 255., 0., 0.); }\n");
    const std::string scene =
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment many.frag\n"
        "Program P uColor {.1 .2 .3} uTurn [.1 .2 .03 .04] uWhole [3 7]\nQuadXY\n";
    auto general = open(scene), settled = settle(scene);
    expect_clean(*settled);
    EXPECT_EQ(draw(*general), draw(*settled));
    // (.2, .1 + 2 · .03, .2 + 2 · .04), and 3 and 7 codes more.
    EXPECT_EQ(draw(*settled).center(), (Pixel{54, 48, 71, 255}));
    EXPECT_LT(settled->runtime->counters().uniform_uploads, general->runtime->counters().uniform_uploads);
}

INSTANTIATE_TEST_SUITE_P(Contexts, SettledValues, all_contexts, context_name);

}  // namespace
}  // namespace snell::test
