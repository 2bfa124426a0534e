// Controls: values of the scene in the types of the linked program.
#include "src/plan/values/controls.h"
#include "tests/plan/uniforms.h"
#include "tests/std.h"

namespace snell {
namespace {

using Kind = UniformValue::Kind;

// One program with one value for one uniform.
struct Case {
    Controls controls;
    Diagnostics diagnostics;
    const Control& control() const { return controls.items.at(0); }
    Codes codes() const { return codes_of(diagnostics); }
};

Case make(UniformValue value, ActiveUniform uniform) {
    uniform.name = value.name;
    const Scene scene = scene_with({{"Glass", {std::move(value)}}});
    Case result;
    result.controls = make_controls(scene, {{std::move(uniform)}}, result.diagnostics);
    return result;
}

using Values = std::vector<double>;

TEST(Controls, RangeOnEveryNumberType) {
    struct Row {
        const char* type;
        Widget widget;
        double value;
    };
    for (const Row& row : {Row{"float", Widget::slider, 3},
                           {"int", Widget::slider, 3},
                           {"uint", Widget::slider, 3},
                           {"double", Widget::slider, 3},
                           {"bool", Widget::check_box, 1}}) {
        const Case made = make(value_of("u", Kind::range, {1, 3, 7}), active(row.type));
        EXPECT_EQ(made.control().widget, row.widget) << row.type;
        EXPECT_EQ(made.control().value, Values{row.value}) << row.type;
        EXPECT_EQ(made.control().initial, made.control().value);
        // A bool of 3 is true, and probably not what was meant.
        EXPECT_EQ(made.codes(), row.widget == Widget::slider ? Codes{} : Codes{"uniform-value-type"}) << row.type;
        if (row.widget == Widget::slider) {
            EXPECT_EQ(made.control().min, 1);
            EXPECT_EQ(made.control().max, 7);
        }
    }
}

// A range is limited where the type ends, and no earlier.
TEST(Controls, RangesReachAsFarAsTheirTypes) {
    const auto limited = [](const char* type, double low, double high) {
        const Case made = make(value_of("u", Kind::range, {low, 5, high}), active(type));
        EXPECT_EQ(made.diagnostics.empty(), made.control().min == low && made.control().max == high) << type;
        return std::pair(made.control().min, made.control().max);
    };
    EXPECT_EQ(limited("uint", 0, 4e9), std::pair(0., 4e9));
    EXPECT_EQ(limited("uint", -1, 5e9), std::pair(0., 4294967295.));
    EXPECT_EQ(limited("int", -2e9, 2e9), std::pair(-2e9, 2e9));
    EXPECT_EQ(limited("int", -3e9, 3e9), std::pair(-2147483648., 2147483647.));
}

TEST(Controls, AResetRestoresTheScenesRangeToo) {
    Controls controls = make(value_of("u", Kind::range, {1, 3, 7}), active("vec2")).controls;
    Control& control = controls.items[0];
    control.value = {500, -20};
    control.min = -20;
    control.max = 500;
    reset(control, 0);
    EXPECT_EQ(control.value, (Values{3, -20}));
    EXPECT_EQ(control.min, -20) << "the other component needs the room";
    EXPECT_EQ(control.max, 7);
    reset(control);
    EXPECT_EQ(control.value, control.initial);
    EXPECT_EQ(control.min, 1);
    EXPECT_EQ(control.max, 7);
}

TEST(Controls, RangeForIntegerIsRoundedOnce) {
    const Case made = make(value_of("u", Kind::range, {.4, 2.5, 9.6}), active("int"));
    EXPECT_EQ(made.control().value, Values{3});
    EXPECT_EQ(made.control().min, 0);
    EXPECT_EQ(made.control().max, 10);
    EXPECT_FALSE(made.diagnostics.empty());
}

UniformValue boolean_of(double value, std::uint32_t written_length) {
    UniformValue made = value_of("u", Kind::boolean, {value});
    made.integral = true;
    made.value_spans = {{0, 14, 14 + written_length}};
    return made;
}

TEST(Controls, RangeOfOneNumberIsBooleanOrConstant) {
    for (const double value : {0., 1.}) {
        const Case flag = make(boolean_of(value, 1), active("bool"));
        EXPECT_EQ(flag.control().widget, Widget::check_box);
        EXPECT_EQ(flag.control().value, Values{value});
        for (const char* type : {"float", "int", "uint"}) {
            const Case constant = make(boolean_of(value, 1), active(type));
            EXPECT_EQ(constant.control().widget, Widget::none) << type;
            EXPECT_EQ(constant.control().value, Values{value});
            EXPECT_TRUE(constant.diagnostics.empty());
        }
        EXPECT_TRUE(flag.diagnostics.empty());
    }
    EXPECT_EQ(make(boolean_of(1, 1), active("sampler2D")).control().value, Values{1}) << "texture unit <1>";
}

TEST(Controls, TrueAndFalseAreCheckBoxes) {
    for (const char* type : {"bool", "int", "float", "uint"}) {
        const Case made = make(boolean_of(1, 4), active(type));
        EXPECT_EQ(made.control().widget, Widget::check_box) << type;
        EXPECT_EQ(made.control().value, Values{1}) << type;
        EXPECT_TRUE(made.diagnostics.empty());
    }
}

TEST(Controls, ElementsOfAnArrayAreOneControl) {
    ActiveUniform weights = active("float", 4);
    weights.name = "weights";
    weights.initial = {.1, .2, .3, .4};
    ActiveUniform lights = active("vec3", 2);
    lights.name = "lights";
    const Scene scene =
        scene_with({{"Glass",
                     {value_of("weights[2]", Kind::scalar, {7}), value_of("weights[0]", Kind::range, {0, 5, 9}),
                      value_of("lights[1]", Kind::array, {1, 2, 3}), value_of("weights[4]", Kind::scalar, {1})}}});
    Diagnostics diagnostics;
    const Controls controls = make_controls(scene, {{weights, lights}}, diagnostics);
    ASSERT_NE(controls.find(0, "weights"), nullptr);
    EXPECT_EQ(controls.find(0, "weights")->value, (Values{5, .2, 7, .4}));
    EXPECT_EQ(controls.find(0, "weights")->initial, controls.find(0, "weights")->value);
    EXPECT_EQ(controls.find(0, "lights")->value, (Values{0, 0, 0, 1, 2, 3}));
    EXPECT_EQ(codes_of(diagnostics), (Codes{"element-without-slider", "unknown-uniform"}))
        << "there is no fifth element";
}

TEST(Controls, ColorsGainAndLoseAlpha) {
    EXPECT_EQ(make(value_of("u", Kind::color, {.1, .2, .3}), active("vec3")).control().value, (Values{.1, .2, .3}));
    EXPECT_EQ(make(value_of("u", Kind::color, {.1, .2, .3}), active("vec4")).control().value, (Values{.1, .2, .3, 1}));
    EXPECT_EQ(make(value_of("u", Kind::color, {.1, .2, .3, .4}), active("vec4")).control().value,
              (Values{.1, .2, .3, .4}));
    const Case dropped = make(value_of("u", Kind::color, {.1, .2, .3, .4}), active("vec3"));
    EXPECT_EQ(dropped.control().value, (Values{.1, .2, .3}));
    EXPECT_EQ(dropped.control().widget, Widget::color);
    EXPECT_TRUE(dropped.diagnostics.empty());
    const Case beyond = make(value_of("u", Kind::color, {2, -1, 0}), active("vec3"));
    EXPECT_EQ(beyond.control().value, (Values{2, -1, 0})) << "colours outside 0..1 are shown as they are";
    const Case wrong = make(value_of("u", Kind::color, {.1, .2, .3}), active("float"));
    EXPECT_EQ(wrong.control().value, Values{.1});
    EXPECT_EQ(wrong.control().widget, Widget::none);
    EXPECT_EQ(wrong.codes(), Codes{"uniform-value-count"});
}

TEST(Controls, ArraysFillVectorsArraysAndMatrices) {
    const struct {
        const char* type;
        int array;
        std::size_t count;
    } rows[] = {{"vec2", 1, 2},   {"vec3", 1, 3},  {"vec4", 1, 4}, {"ivec3", 1, 3}, {"uvec2", 1, 2},
                {"bvec4", 1, 4},  {"dvec3", 1, 3}, {"mat2", 1, 4}, {"mat3", 1, 9},  {"mat4", 1, 16},
                {"mat2x3", 1, 6}, {"float", 5, 5}, {"vec3", 2, 6}, {"int", 3, 3},   {"mat2", 2, 8}};
    for (const auto& row : rows) {
        const Values ones(row.count, 1);
        const Case made = make(value_of("u", Kind::array, ones), active(row.type, row.array));
        EXPECT_EQ(made.control().value, ones) << row.type;
        EXPECT_EQ(made.control().widget, Widget::none) << row.type;
        EXPECT_TRUE(made.diagnostics.empty()) << row.type;
    }
}

TEST(Controls, WrongCountsUseWhatIsThere) {
    ActiveUniform uniform = active("vec4");
    uniform.initial = {9, 9, 9, 9};
    const Case few = make(value_of("u", Kind::array, {1, 2}), uniform);
    EXPECT_EQ(few.control().value, (Values{1, 2, 9, 9}));
    EXPECT_EQ(few.codes(), Codes{"uniform-value-count"});
    const Case many = make(value_of("u", Kind::array, {1, 2, 3}), active("vec2"));
    EXPECT_EQ(many.control().value, (Values{1, 2}));
    EXPECT_EQ(many.codes(), Codes{"uniform-value-count"});
    const Case nothing = make(value_of("u", Kind::array, {}), active("float"));
    EXPECT_EQ(nothing.control().value, Values{0});
    const Case vector = make(value_of("u", Kind::range, {0, .5, 1}), active("vec3"));
    EXPECT_EQ(vector.control().value, (Values{.5, .5, .5}));
    EXPECT_EQ(vector.control().widget, Widget::slider);
    EXPECT_EQ(vector.codes(), Codes{"uniform-value-count"});
}

TEST(Controls, ScalarsToSamplersAreUnits) {
    const Case made = make(value_of("uTexUnit", Kind::scalar, {6}), active("samplerCube"));
    EXPECT_EQ(made.control().value, Values{6});
    EXPECT_EQ(made.control().type, ValueType::sampler);
    EXPECT_EQ(made.control().widget, Widget::none);
    EXPECT_TRUE(made.diagnostics.empty());
    const Case odd = make(value_of("uTexUnit", Kind::scalar, {-1.5}), active("sampler2D"));
    EXPECT_EQ(odd.control().value, Values{0});
    EXPECT_EQ(odd.codes(), Codes{"uniform-value-type"});
}

TEST(Controls, NumbersThatTheTypeCannotHold) {
    EXPECT_EQ(make(value_of("u", Kind::scalar, {2.5}), active("int")).control().value, Values{3});
    EXPECT_EQ(make(value_of("u", Kind::scalar, {-4}), active("uint")).control().value, Values{0});
    EXPECT_EQ(make(value_of("u", Kind::scalar, {7}), active("bool")).control().value, Values{1});
    EXPECT_EQ(make(value_of("u", Kind::scalar, {7}), active("bool")).codes(), Codes{"uniform-value-type"});
    EXPECT_TRUE(make(value_of("u", Kind::scalar, {1}), active("bool")).codes().empty());
    EXPECT_EQ(make(value_of("u", Kind::scalar, {1e300}), active("int")).control().value, Values{2147483647});
    EXPECT_TRUE(std::isfinite(
        static_cast<float>(make(value_of("u", Kind::scalar, {1e39}), active("float")).control().value[0])));
    EXPECT_EQ(make(value_of("u", Kind::scalar, {.1}), active("float")).control().value, Values{.1});
    EXPECT_EQ(make(value_of("u", Kind::scalar, {2.5}), active("int")).codes(), Codes{"uniform-value-type"});
}

TEST(Controls, RangesAreMended) {
    const Case swapped = make(value_of("u", Kind::range, {5, 2, 1}), active("float"));
    EXPECT_EQ(swapped.control().min, 1);
    EXPECT_EQ(swapped.control().max, 5);
    EXPECT_EQ(swapped.control().value, Values{2});
    EXPECT_EQ(swapped.codes(), Codes{"range-reversed"});

    const Case above = make(value_of("u", Kind::range, {0, 9, 1}), active("float"));
    EXPECT_EQ(above.control().value, Values{9});
    EXPECT_EQ(above.control().max, 9);
    EXPECT_EQ(above.codes(), Codes{"range-order"});
    const Case below = make(value_of("u", Kind::range, {0, -9, 1}), active("float"));
    EXPECT_EQ(below.control().min, -9);

    const Case empty = make(value_of("u", Kind::range, {2, 2, 2}), active("float"));
    EXPECT_EQ(empty.control().widget, Widget::none);
    EXPECT_EQ(empty.control().value, Values{2});
    EXPECT_EQ(empty.codes(), Codes{"range-empty"});
}

// <min max current> is the commonest slip: the order is said, and what was probably meant. The value stays as written.
TEST(Controls, NumbersOfARangeInAnotherOrder) {
    struct Slip {
        Values written;
        const char* meant;
    };
    for (const Slip& slip : {Slip{{0, 1, .5}, "'u <0. 0.5 1.>'"},
                             {{-1, 5, 5}, ""},
                             {{.5, 0, 1}, "'u <0. 0.5 1.>'"},
                             {{0, 20, 5}, "'u <0. 5. 20.>'"},
                             {{0, .5, 1}, ""}}) {
        const Case made = make(value_of("u", Kind::range, slip.written), active("float"));
        EXPECT_EQ(made.control().value, Values{slip.written[1]});
        EXPECT_EQ(made.control().min, std::ranges::min(slip.written));
        EXPECT_EQ(made.control().max, std::ranges::max(slip.written));
        EXPECT_EQ(made.codes(), *slip.meant != 0 ? Codes{"range-order"} : Codes{});
        if (*slip.meant == 0) continue;
        EXPECT_NE(made.diagnostics.items()[0].help.find(slip.meant), std::string::npos);
    }
    // In a vector of three it is a value for each component, a colour or not.
    for (const auto& [written, meant] : {std::pair(Values{.25, .22, .3}, "u {0.25 0.22 0.3}"),
                                         {Values{1, .85, .55}, "u {1. 0.85 0.55}"},
                                         {Values{1, 5, 2}, "u [1. 5. 2.]"}})
        EXPECT_EQ(make(value_of("u", Kind::range, written), active("vec3")).diagnostics.items()[0].fixes.at(0).text,
                  meant);
    const Case both = make(value_of("u", Kind::range, {5, 9, 1}), active("float"));
    EXPECT_EQ(both.codes(), (Codes{"range-reversed", "range-widened"}));
    EXPECT_EQ(both.diagnostics.items()[0].fixes.at(0).text, "u <1. 5. 9.>")
        << "not <1. 9. 5.>, which is no range either";
}

// What a user interface can take without overflow: sliders compute in doubles, and draw in floats.
TEST(Controls, SlidersHaveWidthsThatDoNotOverflow) {
    const double inf = std::numeric_limits<double>::infinity();
    const Values rows[] = {{-3e38, 0, 3e38}, {0, .5, inf},       {std::nan(""), .5, 1}, {0, std::nan(""), 1},
                           {-inf, inf, inf}, {-1e300, 0, 1e300}, {0, 1e-320, 1e-310}};
    for (const Values& range : rows) {
        for (const char* type : {"float", "int", "uint", "double", "bool", "vec3"}) {
            const Case made = make(value_of("u", Kind::range, range), active(type));
            const Control& control = made.control();
            EXPECT_TRUE(std::isfinite(control.min) && std::isfinite(control.max));
            EXPECT_LE(control.min, control.max);
            EXPECT_TRUE(std::isfinite(static_cast<float>(control.max) - static_cast<float>(control.min))) << type;
            if (control.type == ValueType::int_ || control.type == ValueType::uint_) {
                EXPECT_LE(control.max - control.min, 4294967295.);
                EXPECT_EQ(control.min, std::round(control.min));
            }
            for (const double value : control.value) EXPECT_TRUE(std::isfinite(value));
        }
    }
}

TEST(Controls, UnknownUniformSuggestsTheNearest) {
    const Scene scene = scene_with({{"Glass", {value_of("uMxi", Kind::range, {0, 0, 1})}}});
    Diagnostics diagnostics;
    ActiveUniform mix = active("float");
    mix.name = "uMix";
    ActiveUniform internal = active("float");
    internal.name = "snell_uMxi";
    const Controls controls = make_controls(scene, {{internal, mix}}, diagnostics);
    ASSERT_EQ(codes_of(diagnostics), Codes{"unknown-uniform"});
    EXPECT_EQ(diagnostics.items()[0].severity, Severity::warning);
    EXPECT_NE(diagnostics.items()[0].help.find("'uMix'"), std::string::npos);
    EXPECT_EQ(diagnostics.items()[0].span, scene.programs[0].uniforms[0].name_span);
    ASSERT_NE(controls.find(0, "uMxi"), nullptr);
    EXPECT_FALSE(controls.find(0, "uMxi")->active);
    EXPECT_TRUE(controls.find(0, "uMix")->active) << "the one it has gets a control all the same";
    EXPECT_FALSE(controls.find(0, "uMix")->listed);
    EXPECT_EQ(controls.find(0, "snell_uMxi"), nullptr);
}

// What this rung does not use may be another's, but a slip of the pen is still one.
TEST(Controls, BehindALadderUnusedIsNoMistakeUnlessItLooksLikeOne) {
    Scene scene = scene_with({{"Glass",
                               {value_of("uBias", Kind::range, {0, .3, 1}), value_of("uScale", Kind::range, {0, 2, 4}),
                                value_of("uMxi", Kind::range, {0, .5, 1})}}});
    scene.programs[0].ladders = 1;
    ActiveUniform scale = active("float"), mix = active("float");
    scale.name = "uScale";
    mix.name = "uMix";
    Diagnostics diagnostics;
    make_controls(scene, {{scale, mix}}, diagnostics);
    ASSERT_EQ(codes_of(diagnostics), Codes{"unknown-uniform"});
    EXPECT_NE(diagnostics.items()[0].message.find("uMxi"), std::string::npos);
}

// What no text has but a declaration is no rung's.
TEST(Controls, BehindALadderWhatNoTextUsesIsTold) {
    Scene scene = scene_with({{"Glass",
                               {value_of("uD", Kind::range, {0, .3, 1}), value_of("uOther", Kind::range, {0, .3, 1}),
                                value_of("uNo", Kind::range, {0, .5, 1})}}});
    scene.programs[0].ladders = 1;
    ActiveUniform kd = active("float");
    kd.name = "uKd";
    const auto told = [&](const std::string& text) {
        Sources sources;
        scene.programs[0].span.file = sources.add("a.glib", "Program Glass uD <0. .3 1.> uOther <0. .3 1.> uNo 1.");
        const FileId file = sources.add("dir/a.frag", text);
        Declared declared{sources, {{{"uD", "float"}, {"uOther", "float"}}}};
        for (glsl::DeclaredUniform& one : declared.programs[0]) one.span = {file, 15, 17};
        Diagnostics diagnostics;
        make_controls(scene, {{kd}}, diagnostics, &declared);
        std::vector<std::string> said;
        for (const Diagnostic& one : diagnostics.items()) said.push_back(one.message);
        return said;
    };
    const std::string text =
        "\nuniform float uD, uOther, uKd;\n#include \"dir/a.frag\"\n#ifdef MODE_other\nfloat f() { return uOther; "
        "}\n#endif\n";
    EXPECT_EQ(told(text), (std::vector<std::string>{"'uD' is declared in a.frag:2 and never used",
                                                    "no shader of program 'Glass' declares 'uNo'"}));
    EXPECT_EQ(told(text + "#ifdef MODE_other\n#include <more.glsl>\n#endif\n"), std::vector<std::string>{});
    EXPECT_EQ(told(text + "// uD uNo\n"), std::vector<std::string>{});
}

TEST(Controls, AUniformThatIsDeclaredIsNotMistyped) {
    const Scene scene = scene_with(
        {{"Glass",
          {value_of("uD", Kind::scalar, {1}), value_of("uW", Kind::scalar, {1}), value_of("uKd[7]", Kind::scalar, {1}),
           value_of("uNo", Kind::scalar, {1}), value_of("uKd", Kind::scalar, {1}),
           value_of("uW[1].k", Kind::scalar, {1}), value_of("Block.k", Kind::scalar, {1})}}});
    ActiveUniform kd = active("float");
    kd.name = "uKd";
    kd.array_size = 4;
    Sources sources;
    const FileId file = sources.add("dir/a.frag", "\nuniform float uD, uW;\n");
    Declared declared{sources, {{{"uD", "float"}, {"uW", "float"}, {"Block.k", "float"}}}};
    declared.programs[0][0].span = {file, 15, 17};
    declared.programs[0][1].functions = {"main (fragment)"};
    declared.programs[0][1].used = true;
    declared.programs[0][1].span = {file, 19, 21};
    declared.programs[0][2].in_block = true;
    Diagnostics diagnostics;
    make_controls(scene, {{kd}}, diagnostics, &declared);
    std::vector<std::string> said;
    for (const Diagnostic& one : diagnostics.items()) {
        if (one.code == "unknown-uniform") said.push_back(one.message);
        EXPECT_TRUE(one.fixes.empty()) << "uKd is set already";
    }
    EXPECT_EQ(said, (std::vector<std::string>{
                        "'uD' is declared in a.frag:2 and never used",
                        "'uW' is declared in a.frag:2 but changes nothing that is drawn",
                        "'uKd' is a float[4], which has no '[7]'", "no shader of program 'Glass' declares 'uNo'",
                        "'uW' is declared in a.frag:2 but no '[1].k' of it changes what is drawn",
                        "'Block.k' belongs to a uniform block, which no scene can set: it is 0"}));
}

TEST(Controls, ARangeBelowZeroNamesWhatATypeHolds) {
    const Scene scene = scene_with({{"Glass", {value_of("uN", Kind::range, {-3, 0, 10})}}});
    ActiveUniform whole = active("uint");
    whole.name = "uN";
    Diagnostics diagnostics;
    const Controls controls = make_controls(scene, {{whole}}, diagnostics);
    ASSERT_EQ(codes_of(diagnostics), Codes{"range-limited"});
    EXPECT_EQ(diagnostics.items()[0].message, "range of 'uN': a uint has no values below 0; 0 to 10 is used");
    EXPECT_EQ(controls.items[0].min, 0);
}

TEST(Controls, FailedProgramKeepsItsValuesQuietly) {
    const Scene scene =
        scene_with({{"Glass",
                     {value_of("a", Kind::range, {0, 1, 2}), value_of("b", Kind::color, {1, 0, 0}),
                      value_of("c", Kind::boolean, {1}), value_of("d", Kind::array, {1, 2, 3, 4, 5})}}});
    Diagnostics diagnostics;
    const Controls controls = make_controls(scene, {{}}, diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(controls.find(0, "a")->widget, Widget::slider);
    EXPECT_EQ(controls.find(0, "b")->widget, Widget::color);
    EXPECT_EQ(controls.find(0, "c")->widget, Widget::check_box);
    EXPECT_EQ(controls.find(0, "d")->value, (Values{1, 2, 3, 4, 5}));
    EXPECT_FALSE(controls.find(0, "a")->active);
    EXPECT_EQ(make_controls(scene, {}, diagnostics).items.size(), 4U);
}

TEST(Controls, UnlistedUniformsGetSensibleRanges) {
    const Scene scene = scene_with({{"Glass", {}}});
    std::vector<ActiveUniform> uniforms;
    const auto add = [&](const char* name, ActiveUniform uniform, Values initial) {
        uniform.name = name;
        uniform.initial = std::move(initial);
        uniforms.push_back(uniform);
    };
    add("uKa", active("float"), {.5});
    add("uFar", active("float"), {-40});
    add("uCount", active("int"), {25});
    add("uOn", active("bool"), {1});
    add("uSpecularColor", active("vec4"), {1, 2, 3, 1});
    add("uOffset", active("vec2"), {0, 3});
    add("uImage", active("sampler2D"), {0});
    add("uTransform", active("mat4"), Values(16, 0));
    add("uWeights", active("float", 9), Values(9, .1));
    ActiveUniform matrix = active("mat4");
    matrix.system = true;
    add("uModelViewMatrix", matrix, Values(16, 0));
    Diagnostics diagnostics;
    const Controls controls = make_controls(scene, {uniforms}, diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(controls.items.size(), 9U);
    EXPECT_EQ(controls.find(0, "uModelViewMatrix"), nullptr);
    for (const Control& control : controls.items) {
        EXPECT_FALSE(control.listed);
        EXPECT_EQ(control.uniform, none);
        for (const double value : control.value) {
            if (control.widget != Widget::slider) continue;
            EXPECT_LE(control.min, value) << control.name;
            EXPECT_GE(control.max, value) << control.name;
        }
    }
    EXPECT_EQ(controls.find(0, "uKa")->widget, Widget::slider);
    EXPECT_EQ(controls.find(0, "uKa")->max, 1);
    EXPECT_EQ(controls.find(0, "uFar")->min, -80);
    EXPECT_EQ(controls.find(0, "uCount")->max, 50);
    EXPECT_EQ(controls.find(0, "uOn")->widget, Widget::check_box);
    EXPECT_EQ(controls.find(0, "uSpecularColor")->widget, Widget::color);
    EXPECT_EQ(controls.find(0, "uOffset")->widget, Widget::slider);
    EXPECT_EQ(controls.find(0, "uImage")->widget, Widget::none);
    EXPECT_EQ(controls.find(0, "uTransform")->widget, Widget::none);
    EXPECT_EQ(controls.find(0, "uWeights")->value.size(), 9U);
}

TEST(Controls, TimerOnTheProgramLineWins) {
    ActiveUniform timer = active("float");
    timer.system = true;
    const Case made = make(value_of("Timer", Kind::range, {0, .25, 1}), timer);
    EXPECT_EQ(made.control().value, Values{.25});
    EXPECT_TRUE(made.control().active);
}

TEST(Controls, ArrayNamesWithAndWithoutIndex) {
    const Case made = make(value_of("w[0]", Kind::array, {1, 2}), active("float", 2));
    EXPECT_TRUE(made.control().active);
    EXPECT_NE(made.controls.find(0, "w"), nullptr);
}

TEST(Controls, OrderIsTheProgramLines) {
    const Scene scene = scene_with({{"A", {value_of("z", Kind::scalar, {1}), value_of("a", Kind::scalar, {1})}},
                                    {"B", {value_of("a", Kind::scalar, {2})}}});
    Diagnostics diagnostics;
    const Controls controls = make_controls(scene, {}, diagnostics);
    ASSERT_EQ(controls.items.size(), 3U);
    EXPECT_EQ(controls.items[0].name, "z");
    EXPECT_EQ(controls.items[1].name, "a");
    EXPECT_EQ(controls.items[2].program, 1U);
    EXPECT_EQ(controls.find(1, "a")->value, Values{2}) << "programs keep values of their own";
}

}  // namespace
}  // namespace snell
