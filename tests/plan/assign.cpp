// Values from a command line, and values kept over a reload.
#include "src/plan/values/controls.h"
#include "tests/fuzz/set_input.h"
#include "tests/plan/uniforms.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

using Kind = UniformValue::Kind;
using Values = std::vector<double>;

ActiveUniform named(std::string name, std::string_view type, int array = 1) {
    ActiveUniform uniform = active(type, array);
    uniform.name = std::move(name);
    return uniform;
}

class Assign : public testing::Test {
protected:
    Assign()
        : scene(scene_with({{"Glass",
                             {value_of("uEta", Kind::range, {.1, 1.1, 5}), value_of("uMix", Kind::range, {0, 0, 1}),
                              value_of("uColor", Kind::color, {1, 0, 0, .5}), value_of("uOn", Kind::boolean, {0}),
                              value_of("uCount", Kind::range, {0, 3, 8}), value_of("uUnit", Kind::scalar, {6}),
                              value_of("uGone", Kind::scalar, {1})}},
                            {"Height Field", {value_of("uEta", Kind::range, {0, 2, 3})}}})) {
        Diagnostics ignored;
        controls = make_controls(
            scene,
            {{named("uEta", "float"), named("uMix", "float"), named("uColor", "vec4"), named("uOn", "bool"),
              named("uCount", "int"), named("uUnit", "samplerCube"), named("light.pos", "vec3")},
             {named("uEta", "float"), named("uSize", "uint")}},
            ignored);
    }

    bool set(std::string_view assignment) {
        diagnostics = {};
        return set_control(controls, scene, assignment, diagnostics);
    }
    const Values& value(Index program, std::string_view name) { return controls.find(program, name)->value; }

    Scene scene;
    Controls controls;
    Diagnostics diagnostics;
};

TEST_F(Assign, TellsNumbersThatDoNotFitFromWords) {
    EXPECT_FALSE(set("uMix=1e999"));
    EXPECT_EQ(diagnostics.items()[0].message, "the value '1e999' of 'uMix' is not a number that fits");
    EXPECT_FALSE(set("uMix=1e"));
    EXPECT_EQ(diagnostics.items()[0].message, "the value '1e' of 'uMix' is not a number");
}

TEST_F(Assign, ElementsOfArrays) {
    controls.items.push_back(controls.items[0]);
    Control& array = controls.items.back();
    array.name = "uGain";
    array.widget = Widget::none;
    array.components = 2;
    array.array_size = 3;
    array.value = array.initial = {1, 2, 3, 4, 5, 6};
    EXPECT_TRUE(set("uGain[1]=7,8"));
    EXPECT_EQ(value(0, "uGain"), (Values{1, 2, 7, 8, 5, 6}));
    EXPECT_TRUE(set("Glass.uGain[0]=0 0"));
    EXPECT_EQ(value(0, "uGain"), (Values{0, 0, 7, 8, 5, 6}));
    EXPECT_FALSE(set("uGain[1]=7"));
    EXPECT_EQ(diagnostics.items()[0].message, "'uGain[1]' takes 2 numbers, not 1");
    EXPECT_FALSE(set("uGain[3]=7,8"));
    EXPECT_EQ(diagnostics.items()[0].help, "'uGain' has the elements uGain[0] to uGain[2]");
    for (const char* wrong : {"uGain[-1]=1,1", "uGain[]=1,1", "uGain[1=1,1", "uGain[1]x=1,1", "uGain.g=1"})
        EXPECT_FALSE(set(wrong)) << wrong;
    EXPECT_EQ(value(0, "uGain"), (Values{0, 0, 7, 8, 5, 6}));
}

TEST_F(Assign, EveryProgramOrOne) {
    EXPECT_TRUE(set("uEta=1.3"));
    EXPECT_EQ(value(0, "uEta"), Values{1.3});
    EXPECT_EQ(value(1, "uEta"), Values{1.3});
    EXPECT_TRUE(set("Glass.uEta = 2.5"));
    EXPECT_EQ(value(0, "uEta"), Values{2.5});
    EXPECT_EQ(value(1, "uEta"), Values{1.3});
    EXPECT_TRUE(set("Height Field.uEta=+.5e0"));
    EXPECT_EQ(value(1, "uEta"), Values{.5});
    EXPECT_TRUE(set("light.pos=1,2,3")) << "a dot may belong to the uniform";
    EXPECT_TRUE(set("Glass.light.pos=[4 5 6]"));
    EXPECT_EQ(value(0, "light.pos"), (Values{4, 5, 6}));
    EXPECT_EQ(controls.find(0, "uEta")->initial, Values{1.1}) << "what reset goes back to";
}

TEST_F(Assign, TypesAreTheUniforms) {
    EXPECT_TRUE(set("uColor=1,.5,0"));
    EXPECT_EQ(value(0, "uColor"), (Values{1, .5, 0, 1}));
    EXPECT_TRUE(set("uColor={0, .5, 0, .25}"));
    EXPECT_EQ(value(0, "uColor"), (Values{0, .5, 0, .25}));
    for (const char* yes : {"uOn=true", "uOn=1", "uOn=ON"}) {
        EXPECT_TRUE(set(yes));
        EXPECT_EQ(value(0, "uOn"), Values{1});
    }
    EXPECT_TRUE(set("uOn=false"));
    EXPECT_EQ(value(0, "uOn"), Values{0});
    EXPECT_TRUE(set("uCount=2.5"));
    EXPECT_EQ(value(0, "uCount"), Values{3});
    EXPECT_EQ(codes_of(diagnostics), Codes{"uniform-value-type"}) << "it is told that it is another number";
    EXPECT_TRUE(set("uUnit=7"));
    EXPECT_EQ(value(0, "uUnit"), Values{7});
}

TEST_F(Assign, BeyondTheRangeWidensIt) {
    EXPECT_TRUE(set("Glass.uEta=9"));
    EXPECT_EQ(value(0, "uEta"), Values{9});
    EXPECT_EQ(controls.find(0, "uEta")->max, 9);
    EXPECT_EQ(controls.find(0, "uEta")->min, .1);
}

TEST_F(Assign, UnknownNamesSuggest) {
    const std::vector<std::pair<const char*, const char*>> rows{
        {"uMxi=1", "'uMix'"}, {"Glas.uMix=1", "'Glass.uMix'"}, {"Glass.uSize=1", ""}, {"umix=1", "'uMix'"}};
    for (const auto& [assignment, suggestion] : rows) {
        EXPECT_FALSE(set(assignment));
        ASSERT_EQ(codes_of(diagnostics), Codes{"unknown-uniform-name"}) << assignment;
        EXPECT_TRUE(diagnostics.has_errors());
        EXPECT_NE(diagnostics.items()[0].help.find(suggestion), std::string::npos) << diagnostics.items()[0].help;
    }
}

TEST_F(Assign, WhatDoesNotFitIsAnErrorAndChangesNothing) {
    const Controls before = controls;
    for (const char* assignment : {"uEta",         "=1",         "",
                                   "uEta=",        "uEta=abc",   "uEta=1 2",
                                   "uEta=1,2",     "uColor=1,2", "uColor=1,2,3,4,5",
                                   "uEta=nan",     "uEta=inf",   "uEta=-inf",
                                   "uEta=1e39",    "uEta=1e999", "uCount=1e12",
                                   "uEta=1,",      "uEta=,1",    "uEta=1,,2",
                                   "uSize=-1",     "uUnit=-1",   "uEta=1.5x",
                                   "uEta=0x10",    "uEta=+-1",   "uEta=[]",
                                   "light.pos=1,2"}) {
        EXPECT_FALSE(set(assignment)) << assignment;
        EXPECT_TRUE(diagnostics.has_errors()) << assignment;
    }
    for (std::size_t i = 0; i < before.items.size(); ++i) EXPECT_EQ(controls.items[i].value, before.items[i].value);
}

TEST_F(Assign, UnusedUniformIsSetWithAWarning) {
    EXPECT_TRUE(set("uGone=4"));
    EXPECT_EQ(codes_of(diagnostics), Codes{"inactive-uniform"});
    EXPECT_FALSE(diagnostics.has_errors());
}

// ---- reload ----------------------------------------------------------------------------------------------

Controls control_for(const Scene& scene, std::string_view type = "float") {
    Diagnostics ignored;
    std::vector<std::vector<ActiveUniform>> uniforms(scene.programs.size(), {named("u", type)});
    return make_controls(scene, uniforms, ignored);
}

TEST(CarryOver, KeepsWhatTheUserSet) {
    const Scene scene = scene_with({{"Glass", {value_of("u", Kind::range, {0, 1, 5})}}});
    Controls from = control_for(scene), to = control_for(scene);
    Diagnostics diagnostics;
    ASSERT_TRUE(set_control(from, scene, "u=7", diagnostics));
    carry_over(from, scene, to, scene);
    EXPECT_EQ(to.items[0].value, Values{7});
    EXPECT_EQ(to.items[0].max, 7) << "typed beyond the range";
    EXPECT_EQ(to.items[0].initial, Values{1});
}

TEST(CarryOver, TheTextsNewValueWins) {
    const Scene old_scene = scene_with({{"Glass", {value_of("u", Kind::range, {0, 1, 5})}}});
    const Scene new_scene = scene_with({{"Glass", {value_of("u", Kind::range, {0, 2, 5})}}});
    Controls from = control_for(old_scene), to = control_for(new_scene);
    from.items[0].value = {4};
    carry_over(from, old_scene, to, new_scene);
    EXPECT_EQ(to.items[0].value, Values{2});
}

TEST(CarryOver, TheTextsNewRangeHolds) {
    const Scene old_scene = scene_with({{"Glass", {value_of("u", Kind::range, {0, 1, 5})}}});
    const Scene new_scene = scene_with({{"Glass", {value_of("u", Kind::range, {0, 1, 3})}}});
    Controls from = control_for(old_scene), to = control_for(new_scene);
    from.items[0].value = {4};
    carry_over(from, old_scene, to, new_scene);
    EXPECT_EQ(to.items[0].value, Values{3});
    EXPECT_EQ(to.items[0].max, 3);
}

TEST(CarryOver, OnlyTheSameProgramNameAndType) {
    const Scene scene = scene_with({{"Glass", {value_of("u", Kind::range, {0, 1, 5})}}});
    const Scene other = scene_with({{"Metal", {value_of("u", Kind::range, {0, 1, 5})}}});
    Controls from = control_for(scene);
    from.items[0].value = {4};
    Controls renamed = control_for(other), retyped = control_for(scene, "int");
    carry_over(from, scene, renamed, other);
    carry_over(from, scene, retyped, scene);
    EXPECT_EQ(renamed.items[0].value, Values{1});
    EXPECT_EQ(retyped.items[0].value, Values{1});
}

TEST(CarryOver, ProgramsOfOneNameGoByOrder) {
    const std::vector<UniformValue> line{value_of("u", Kind::range, {0, 1, 5})};
    const Scene scene = scene_with({{"P", line}, {"P", line}});
    const Scene longer = scene_with({{"Q", line}, {"P", line}, {"P", line}});
    Controls from = control_for(scene), to = control_for(longer);
    from.items[0].value = {2};
    from.items[1].value = {3};
    carry_over(from, scene, to, longer);
    EXPECT_EQ(to.items[0].value, Values{1});
    EXPECT_EQ(to.items[1].value, Values{2});
    EXPECT_EQ(to.items[2].value, Values{3});
}

// ---- The corpus of the fuzzer of --set, what small changes make of it, and every kind of value.

TEST(SetCorpus, HoldsAndSoDoItsMutations) {
    std::size_t count = 0;
    std::mt19937 random(1);
    constexpr std::string_view letters = "=,.<>[]+-e019nai \nuE";
    for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/set_corpus")) {
        const std::string bytes = bytes_of(entry.path());
        ASSERT_FALSE(bytes.empty()) << entry.path();
        ASSERT_EQ(fuzz::check_settings(bytes), "") << entry.path();
        for (int i = 0; i < 300; ++i) {
            std::string changed = bytes;
            for (int k = 0; k <= i % 4; ++k) changed[random() % changed.size()] = letters[random() % letters.size()];
            if (i % 5 == 0) changed.erase(random() % changed.size(), 1 + random() % 8);
            ASSERT_EQ(fuzz::check_settings(changed), "") << entry.path() << " changed to\n" << changed;
        }
        ++count;
    }
    EXPECT_GE(count, 4U);
}

TEST(SetNotFinite, NoUniformOfAnyKindTakesIt) {
    const fuzz::Settable all;
    for (const Control& control : all.controls.items)
        for (const char* value :
             {"nan", "NaN", "-nan", "inf", "-inf", "+inf", "infinity", "1e400", "-1e400", "1e999999"}) {
            for (std::size_t at = 0; at < control.value.size(); ++at) {
                fuzz::Settable fresh;
                std::string text = all.scene.programs[control.program].name + "." + control.name + "=";
                for (std::size_t i = 0; i < control.value.size(); ++i)
                    text += (i ? "," : "") + std::string(i == at ? value : "1");
                Diagnostics diagnostics;
                EXPECT_FALSE(set_control(fresh.controls, fresh.scene, text, diagnostics)) << text;
                EXPECT_TRUE(diagnostics.has_errors()) << text;
                EXPECT_EQ(values_of(fresh.controls), values_of(all.controls)) << text;
            }
        }
    // What is finite as a double and not as a float is refused where it would become infinite.
    for (const char* name : {"uEta", "uDouble"}) {
        fuzz::Settable fresh;
        Diagnostics diagnostics;
        EXPECT_EQ(set_control(fresh.controls, fresh.scene, std::string(name) + "=1e39", diagnostics),
                  name == std::string("uDouble"));
    }
}

// The oracle is one: what it is to find, it finds.
TEST(SetCorpus, TheOracleFindsWhatIsWrong) {
    fuzz::Settable settable;
    Control control = settable.controls.items.front();
    EXPECT_EQ(fuzz::check_control(control), "");
    control.value[0] = std::nan("");
    EXPECT_NE(fuzz::check_control(control), "");
    control.value[0] = 1e39;
    EXPECT_NE(fuzz::check_control(control), "");
    control.value[0] = 1;
    control.min = 2;
    EXPECT_NE(fuzz::check_control(control), "");
}

}  // namespace
}  // namespace snell
