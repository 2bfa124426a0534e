// Sliders without effect, by the driver's code: against what the shaders' texts say, and against pictures.
#include "src/runtime/resources/program.h"
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

struct Case {
    std::string_view declarations, code;  // of the fragment shader, before and in main()
    std::string_view values;              // on the Program line
};

class Effect : public PlainTest {
protected:
    void SetUp() override {
        PlainTest::SetUp();
        if (!IsSkipped() && !gl::gives_binaries()) GTEST_SKIP() << "the driver does not give its code";
    }
    // The names of the sliders without effect.
    std::string idle(const Case& c, std::string_view before = "") {
        folder.write("effect.frag", "uniform float uOther;\n" + std::string(c.declarations) + "\nvoid main() {\n" +
                                        std::string(c.code) + "\n}\n");
        document = open(std::string(before) + "Ortho -1 1 -1 1\nVertex plain.vert\nFragment effect.frag\n" +
                        "Program P uOther <0 .5 1> " + std::string(c.values) + "\nQuadXY\n");
        expect_clean(*document);
        std::string names;
        for (const Control* control : document->runtime->without_effect(600))
            names += (names.empty() ? "" : " ") + control->name;
        return names;
    }
    std::unique_ptr<Document> document;
};

constexpr std::string_view x = "uniform float uX;";

TEST_F(Effect, NoneOnAnyPixel) {
    for (const Case& c : {
             Case{x, "gl_FragColor = vec4(max(uX, 50.) * uOther);", "uX <0 .5 1>"},
             Case{x, "gl_FragColor = vec4(uX > 30. ? uOther : 1.);", "uX <0 .5 1>"},
             Case{x, "gl_FragColor = vec4(smoothstep(30., 40., uX) + uOther);", "uX <0 .5 1>"},
             Case{x, "gl_FragColor = vec4(clamp(uX, 30., 40.) * uOther);", "uX <0 .5 1>"},
             Case{x, "gl_FragColor = vec4(float(int(uX * .01)) + uOther);", "uX <0 .5 1>"},
             Case{"uniform int uX;", "gl_FragColor = vec4(uX > 50 ? uOther : 1.);", "uX <0 1 3>"},
             Case{"uniform bool uX;", "gl_FragColor = vec4(max(uX ? 2. : 1., 50.) * uOther);", "uX <false>"},
         }) {
        EXPECT_EQ(idle(c), "uX") << c.code;
        // A second path to the same answer.
        const Picture at_start = draw(*document, {.sets = {"uX=0"}});
        for (const char* value : {"uX=.37", "uX=.999", "uX=1"}) {
            const bool fits = c.declarations == x || value == std::string_view("uX=1");
            EXPECT_TRUE(!fits || draw(*document, {.sets = {value}}) == at_start) << c.code << value;
        }
    }
}

TEST_F(Effect, SomeAtSomeValue) {
    const Case rows[] = {{x, "gl_FragColor = vec4(uX * uOther);", "uX <0 .5 1>"},
                         {x, "gl_FragColor = vec4(uX == .37 ? 1. : uOther);", "uX <0 .5 1>"},
                         {x, "gl_FragColor = vec4(uX == -.37 ? 1. : uOther);", "uX <-1 .5 1>"},
                         {x, "gl_FragColor = vec4(uX > .371 && uX < .372 ? 1. : uOther);", "uX <0 .5 1>"},
                         {x, "gl_FragColor = vec4(abs(uX - .37) < .001 ? 1. : uOther);", "uX <0 .5 1>"},
                         {x, "gl_FragColor = vec4(max(uX, 50.) * uOther);", "uX <0 .5 60>"},
                         {x, "gl_FragColor = vec4(uX >= 30. ? 1. : uOther);", "uX <0 .5 30>"},
                         {x, "gl_FragColor = vec4(uX * 1e-6 + uOther);", "uX <0 .5 1>"},
                         {x, "if (uX > 30.5) discard; gl_FragColor = vec4(uOther);", "uX <0 .5 31>"},
                         {"uniform int uX;", "gl_FragColor = vec4(uX == 41 ? 1. : uOther);", "uX <0 1 50>"},
                         {"uniform bool uX;", "gl_FragColor = vec4(uX ? 1. : uOther);", "uX <false>"}};
    for (const Case& c : rows) EXPECT_EQ(idle(c), "") << c.code;
}

// Only what can be tried is judged.
TEST_F(Effect, NothingIsSaidOfOtherControls) {
    EXPECT_EQ(idle({"uniform int uX;", "gl_FragColor = vec4(uX > 5000 ? uOther : 1.);", "uX <0 1 1000>"}), "")
        << "too many values";
    EXPECT_EQ(idle({x, "gl_FragColor = vec4(max(uX, 50.) * uOther);", "uX .5"}), "") << "no slider";
    EXPECT_EQ(idle({"uniform vec3 uX;", "gl_FragColor = vec4(max(uX, vec3(50.)) * uOther, 1.);", "uX {.1 .2 .3}"}), "")
        << "a colour";
}

TEST_F(Effect, OfARungIsThatOfTheChosenOne) {
    const std::string_view code =
        "#if KIND == KIND_low\ngl_FragColor = vec4(max(uX, 50.) * uOther);\n#else\ngl_FragColor = vec4(uX * uOther);\n"
        "#endif";
    EXPECT_EQ(idle({x, code, "uX <0 .5 1>"}, "Ladder KIND <low> high\n"), "uX");
    EXPECT_EQ(idle({x, code, "uX <0 .5 1>"}, "Ladder KIND low <high>\n"), "");
}

// A slider must be without effect in every program that a pass is drawn with.
TEST_F(Effect, IsLookedForInAllVariants) {
    folder.write("two.frag",
                 "uniform float uX;\nvarying vec4 vColor;\nvoid main() { gl_FragColor = max(uX, 50.) * gl_Color; }\n");
    document = open(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment two.frag\nProgram P uX <0 .5 1>\nQuadXY\n"
        "Flat\nQuadXY\n");
    EXPECT_EQ(document->runtime->without_effect(600).size(), 1U) << "each slider is named once";
}

TEST_F(Effect, TakesNoMoreTimeThanItIsGiven) {
    idle({x, "gl_FragColor = vec4(max(uX, 50.) * uOther);", "uX <0 .5 1>"});
    EXPECT_TRUE(document->runtime->without_effect(0).empty());
}

// OpenGL 3.3 gives the code by an extension, OpenGL ES always.
class EffectInContexts : public Effect, public testing::WithParamInterface<int> {
protected:
    EffectInContexts() {
        request.version = GetParam();
        request.es = GetParam() < 33;
    }
};
INSTANTIATE_TEST_SUITE_P(All, EffectInContexts, testing::Values(30, 32, 33));

TEST_P(EffectInContexts, IsFoundAsInTheLatest) {
    EXPECT_EQ(idle({x, "gl_FragColor = vec4(max(uX, 50.) * uOther);", "uX <0 .5 1>"}), "uX");
    EXPECT_EQ(idle({x, "gl_FragColor = vec4(max(uX, 50.) * uOther);", "uX <0 .5 60>"}), "");
}

TEST_F(Effect, AllOfManySlidersAreTried) {
    std::string declarations, sum = "0.", values, names;
    for (int i = 0; i < 17; ++i) {
        const std::string name = "uX" + std::to_string(i);
        declarations += "uniform float " + name + ";";
        sum += " + max(" + name + ", 50.)";
        values += " " + name + " <0 .5 1>";
        names += (i ? " " : "") + name;
    }
    const std::string code = "gl_FragColor = vec4(uOther * (" + sum + "));";
    EXPECT_EQ(idle({declarations, code, values}), names);
}

Control slider_of(ValueType type, double min, double max) {
    Control control;
    control.type = type;
    control.min = min;
    control.max = max;
    return control;
}

TEST(TellingValues, AreBothEndsFirstAndBothSidesOfEachNumber) {
    const auto values = runtime::telling_values(slider_of(ValueType::float_, 0, 1), "x3 < .37 && 12. > a2.9 + 2.5e-1");
    ASSERT_GE(values.size(), 2U);
    EXPECT_EQ(values[0], 0);
    EXPECT_EQ(values[1], 1);
    const auto has = [&](double low, double high) {
        return std::ranges::any_of(values, [&](double value) { return value >= low && value <= high; });
    };
    EXPECT_TRUE(has(.37, .37));
    EXPECT_TRUE(has(.3701, .3749));
    EXPECT_TRUE(has(.26, .36));
    EXPECT_EQ(values.size(), 2 * 10 - 1U)
        << "eighths, .37, and the middles: .25 is an eighth, the rest are names or out";
    EXPECT_TRUE(std::ranges::all_of(values, [](double value) { return value >= 0 && value <= 1; }));
}

TEST(TellingValues, OfNumbersAreAllOrNone) {
    EXPECT_EQ(runtime::telling_values(slider_of(ValueType::int_, -1, 2), "7"), (std::vector<double>{-1, 2, 0, 1}));
    EXPECT_EQ(runtime::telling_values(slider_of(ValueType::bool_, 0, 1), ""), (std::vector<double>{0, 1}));
    EXPECT_TRUE(runtime::telling_values(slider_of(ValueType::uint_, 0, 1000), "").empty());
    std::string many;
    for (int i = 0; i < 40; ++i) many += " " + std::to_string(.001 + i * .01);
    EXPECT_TRUE(runtime::telling_values(slider_of(ValueType::float_, 0, 1), many).empty());
}

}  // namespace
}  // namespace snell::test
