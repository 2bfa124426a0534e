// Values by name: what comes back after its uniform was gone, and where the text wins.
#include "src/plan/setup.h"

#include <gtest/gtest.h>

#include "parser/read/parse.h"
#include "src/app/open/states.h"
#include "src/plan/view.h"
#include "tests/plan/uniforms.h"

namespace snell {
namespace {

using Kind = UniformValue::Kind;
using Values = std::vector<double>;

Scene slider(const std::string& name, Values range, const std::string& program = "Glass") {
    return scene_with({{program, {value_of(name, Kind::range, std::move(range))}}});
}

Controls controls_of(const Scene& scene, std::string_view type = "float") {
    Diagnostics ignored;
    std::vector<std::vector<ActiveUniform>> linked;
    for (const Program& program : scene.programs) {
        std::vector<ActiveUniform> uniforms;
        for (const UniformValue& value : program.uniforms) {
            if (type.empty()) continue;  // the program is broken
            uniforms.push_back(active(type));
            uniforms.back().name = value.name;
        }
        linked.push_back(std::move(uniforms));
    }
    return make_controls(scene, linked, ignored);
}

TEST(Remembered, ARenamedUniformHasItsValueWhenItIsRenamedBack) {
    const Scene before = slider("uKa", {0, .5, 1}), between = slider("uKb", {0, .5, 1});
    Controls controls = controls_of(before);
    controls.items[0].value = {.75};
    Remembered memory;
    remember(before, controls, memory);
    Controls other = controls_of(between);
    EXPECT_FALSE(recall(memory, between, other));
    EXPECT_EQ(other.items[0].value, Values{.5});
    remember(between, other, memory);
    Controls back = controls_of(before);
    EXPECT_TRUE(recall(memory, before, back));
    EXPECT_EQ(back.items[0].value, Values{.75});
}

// The program still uses the uniform, so it has a control meanwhile, with the program's own value.
TEST(Remembered, AUniformThatIsNotListedForAWhileHasItsValueWhenItIsListedAgain) {
    const Scene before = slider("uKa", {0, .5, 1}), between = slider("uKb", {0, .5, 1});
    std::vector<ActiveUniform> uniforms(1, active("float"));
    uniforms[0].name = "uKa";
    Diagnostics ignored;
    Controls controls = make_controls(before, {uniforms}, ignored);
    controls.items[0].value = {.75};
    Remembered memory;
    remember(before, controls, memory);
    Controls unlisted = make_controls(between, {uniforms}, ignored);
    Control* meanwhile = unlisted.find(0, "uKa");
    ASSERT_TRUE(meanwhile != nullptr && !meanwhile->listed);
    EXPECT_FALSE(recall(memory, between, unlisted));
    EXPECT_EQ(meanwhile->value, Values{0});
    remember(between, unlisted, memory);
    Controls back = make_controls(before, {uniforms}, ignored);
    EXPECT_TRUE(recall(memory, before, back));
    EXPECT_EQ(back.items[0].value, Values{.75});
    // What is set there, and reset, is forgotten.
    meanwhile->value = {.25};
    remember(between, unlisted, memory);
    meanwhile->value = {0};
    remember(between, unlisted, memory);
    EXPECT_EQ(memory.chosen.count("--set Glass.uKa"), 0U);
}

// After a save of 1.5 the text said <0. 1.5 1.5>; then the file was reverted.
TEST(Remembered, ALiveValueOutlivesTheRangeThatWasReverted) {
    const Scene saved = slider("uKa", {0, 1.5, 1.5}), reverted = slider("uKa", {0, .5, 1});
    Remembered memory;
    remember(saved, controls_of(saved), memory, true);
    Controls controls = controls_of(reverted);
    EXPECT_TRUE(recall(memory, reverted, controls, Follow::memory));
    EXPECT_EQ(controls.items[0].value, Values{1.5});
    EXPECT_EQ(controls.items[0].min, 0);
    EXPECT_EQ(controls.items[0].max, 1.5);
}

TEST(Remembered, WhatIsTheScenesOwnAgainIsForgotten) {
    const Scene scene = slider("uKa", {0, .5, 1});
    Controls controls = controls_of(scene);
    controls.items[0].value = {.75};
    Remembered memory;
    remember(scene, controls, memory);
    controls.items[0].value = {.5};
    remember(scene, controls, memory);
    EXPECT_EQ(memory, Remembered{});
}

TEST(Remembered, TheTextsNewValueWinsUnlessItIsHeld) {
    const Scene before = slider("uKa", {0, .5, 1}), after = slider("uKa", {0, .6, 1});
    Controls controls = controls_of(before);
    controls.items[0].value = {.75};
    Remembered memory;
    remember(before, controls, memory);
    Controls text = controls_of(after), held = controls_of(after);
    EXPECT_FALSE(recall(memory, after, text));
    EXPECT_EQ(text.items[0].value, Values{.6});
    EXPECT_TRUE(recall(memory, after, held, Follow::memory));
    EXPECT_EQ(held.items[0].value, Values{.75});
}

TEST(Remembered, ARangeIsWiderOnlyWhileItsValueNeedsIt) {
    const Scene scene = slider("uKa", {0, .5, 1});
    Controls controls = controls_of(scene);
    controls.items[0].max = 500;
    controls.items[0].value = {401.61};
    Controls fresh = controls_of(scene);
    carry_over(controls, scene, fresh, scene);
    EXPECT_EQ(fresh.items[0].value, Values{401.61});
    EXPECT_EQ(fresh.items[0].max, 500);
    EXPECT_EQ(fresh.items[0].initial_max, 1);
    Remembered memory;
    remember(scene, controls, memory);
    fresh = controls_of(scene);
    recall(memory, scene, fresh);
    EXPECT_EQ(fresh.items[0].max, 500);
    controls.items[0].value = {.25};
    fresh = controls_of(scene);
    carry_over(controls, scene, fresh, scene);
    EXPECT_EQ(fresh.items[0].value, Values{.25});
    EXPECT_EQ(fresh.items[0].max, 1) << "nothing needs more";
}

TEST(Remembered, AValueThatWasSetWhileItsProgramWasBrokenIsKept) {
    const Scene scene = slider("uColor", {0, .5, 1});
    Controls broken = controls_of(scene, "");
    ASSERT_EQ(broken.items[0].value, Values{.5});
    broken.items[0].value = {.75};
    Remembered memory;
    remember(scene, broken, memory);
    Controls vector = controls_of(scene, "vec3"), whole = controls_of(slider("uColor", {0, .5, 1}), "int");
    recall(memory, scene, vector);
    EXPECT_EQ(vector.items[0].value, (Values{.75, .75, .75}));
    recall(memory, scene, whole);
    for (const double value : whole.items[0].value) EXPECT_EQ(value, std::round(value)) << "as its type can hold";
}

TEST(Remembered, NoNumberMakesAValueThatItsTypeCannotHold) {
    const Scene scene = slider("uKa", {0, .5, 1});
    Remembered memory;
    const auto put = [&](const std::string& value, const std::string& written, const std::string& range) {
        memory.chosen = {{"--set Glass.uKa", value}, {"--range Glass.uKa", range}};
        memory.written = {{"--set Glass.uKa", written}, {"--range Glass.uKa", "0,1"}};
    };
    put("1e300", "0.5", "-1e308,1e308");
    Controls controls = controls_of(scene);
    recall(memory, scene, controls);
    const Control& control = controls.items[0];
    EXPECT_LE(control.value[0], 3.5e38);
    EXPECT_TRUE(std::isfinite(control.max - control.min));
    const Controls before = controls;
    for (const char* value : {"1,2", "", "x", "1,", "nan", "1e999", "0.5 "}) {
        put(value, "0.5", "0,1");
        EXPECT_FALSE(recall(memory, scene, controls)) << value;
    }
    put("1", "0.5,0.5", "0,1");
    EXPECT_FALSE(recall(memory, scene, controls)) << "another count";
    EXPECT_EQ(controls.items[0].value, before.items[0].value);
}

TEST(Remembered, NamesThatAreGoneAreBounded) {
    Remembered memory;
    for (int i = 0; i < 3000; ++i) {
        const Scene scene = slider("u" + std::to_string(i), {0, .5, 1});
        Controls controls = controls_of(scene);
        controls.items[0].value = {.75};
        remember(scene, controls, memory);
        ASSERT_LE(memory.chosen.size(), 2002U);
        ASSERT_TRUE(memory.chosen.contains("--set Glass.u" + std::to_string(i)));
    }
}

TEST(Remembered, ProgramsOfOneNameAreToldApart) {
    const UniformValue line = value_of("u", Kind::range, {0, 1, 5});
    const Scene scene = scene_with({{"P", {line}}, {"Q", {line}}, {"P", {line}}});
    Controls controls = controls_of(scene);
    EXPECT_EQ(control_names(scene, controls), (std::vector<std::string>{"P.u", "Q.u", "P#2.u"}));
    Diagnostics none;
    EXPECT_TRUE(set_control(controls, scene, "P#1.u=3", none)) << "the first has a number, too";
    EXPECT_TRUE(set_control(controls, scene, "P#2.u=4", none));
    EXPECT_EQ(controls.items[0].value, std::vector<double>{3});
    EXPECT_EQ(controls.items[1].value, std::vector<double>{1});
    EXPECT_EQ(controls.items[2].value, std::vector<double>{4});
}

// Programs of the name Glass, by their fragment shaders, with a number of the text and the value that they have.
struct Glass {
    std::string file;
    double written = 1, value = 0;
};
using Glasses = std::vector<Glass>;

Scene glasses(const Glasses& programs) {
    Scene scene;
    for (const Glass& glass : programs) {
        Program& program = scene.programs.emplace_back();
        program.name = "Glass";
        program.stages[static_cast<std::size_t>(Stage::fragment)] = FileName{glass.file, {}};
        program.uniforms = {value_of("u", Kind::range, {0, 1, 9}), value_of("v", Kind::scalar, {glass.written})};
    }
    return scene;
}

// Values of u, where 1 is the text's, after an edit: of the old programs, then of the new ones.
struct Edit {
    const char* what;
    Glasses before, after;
};
const std::vector<Edit>& edits() {
    static const std::vector<Edit> all{
        {"the first is removed", {{"a", 1, 2}, {"b", 1, 3}}, {{"b", 1, 3}}},
        {"one is added before", {{"a", 1, 2}}, {{"b", 1, 1}, {"a", 1, 2}}},
        {"one is added between", {{"a", 1, 2}, {"b", 1, 3}}, {{"a", 1, 2}, {"c", 1, 1}, {"b", 1, 3}}},
        {"they change places", {{"a", 1, 2}, {"b", 1, 3}}, {{"b", 1, 3}, {"a", 1, 2}}},
        {"one gets another shader", {{"a", 1, 2}, {"b", 1, 3}}, {{"c", 1, 2}, {"b", 1, 3}}},
        {"both do", {{"a", 1, 2}, {"b", 1, 3}}, {{"c", 1, 2}, {"d", 1, 3}}},
        {"of one shader, one has another number", {{"a", 1, 2}, {"a", 5, 3}}, {{"a", 4, 2}, {"a", 5, 3}}},
        {"both have the number of one", {{"a", 1, 2}, {"a", 5, 3}}, {{"a", 5, 2}, {"a", 5, 3}}},
        {"of one shader, the first is removed", {{"a", 1, 2}, {"a", 5, 3}}, {{"a", 5, 3}}},
        {"which one was removed is not known", {{"a", 1, 2}, {"a", 1, 3}}, {{"a", 1, 1}}},
        {"which one has another shader is not known", {{"a", 1, 2}, {"b", 1, 3}}, {{"c", 1, 1}}},
        {"one is copied", {{"a", 1, 2}}, {{"a", 1, 2}, {"a", 1, 1}}},
    };
    return all;
}

Controls set_values(const Scene& scene, const Glasses& programs) {
    Controls controls = controls_of(scene);
    for (std::size_t i = 0; i < programs.size(); ++i)
        if (programs[i].value != 0) controls.find(static_cast<Index>(i), "u")->value = {programs[i].value};
    return controls;
}

void expect_values(const Controls& controls, const Edit& edit, const char* path) {
    for (std::size_t i = 0; i < edit.after.size(); ++i)
        EXPECT_EQ(controls.find(static_cast<Index>(i), "u")->value, Values{edit.after[i].value})
            << edit.what << ", " << path << ", program " << i;
}

TEST(Remembered, ProgramsOfOneNameKeepTheirOwnValuesThroughEdits) {
    for (const Edit& edit : edits()) {
        const Scene before = glasses(edit.before), after = glasses(edit.after);
        const Controls values = set_values(before, edit.before);
        Controls carried = controls_of(after), recalled = carried, restored = carried;
        carry_over(values, before, carried, after);
        expect_values(carried, edit, "at once");
        Remembered memory;
        remember(before, values, memory);
        recall(memory, after, recalled);
        expect_values(recalled, edit, "kept");
        apply_setup(read_setup(setup_text(setup_of(before, values))), after, restored);
        expect_values(restored, edit, "as a snapshot");
    }
}

TEST(Remembered, AStateByNameHasTheValuesOfEachProgramOfOneName) {
    const Glasses programs{{"a", 1, 2}, {"b", 1, 3}};
    const Scene scene = glasses(programs);
    NamedState state;
    state.sets = arguments_of(setup_of(scene, set_values(scene, programs)), set_option);
    Controls controls = controls_of(scene);
    EXPECT_EQ(apply_state(state, scene, controls), "");
    expect_values(controls, {"nothing", {}, programs}, "by name");
}

TEST(Remembered, ATypedStateMayHaveCommasBetweenItsValuesAndInThem) {
    const Glasses programs{{"a", 1, 2}, {"b", 1, 3}}, typed{{"a", 1, 1.5}, {"b", 1, 4}};
    const Scene scene = glasses(programs);
    for (const char* text : {"Glass.u=1.5 Glass#2.u=4", "Glass.u=1.5, Glass#2.u=4", "Glass.u=1,5, Glass#2.u=4,",
                             "Glass#2.u=4,0,  Glass#1.u=1,5"}) {
        Controls controls = controls_of(scene);
        EXPECT_EQ(apply_state(named_state(text, "scene.glib", scene), scene, controls), "") << text;
        expect_values(controls, {"nothing", {}, typed}, text);
    }
    for (const char* text : {"Glass.u=1,5,2", "Glass.u=,5", "Glass.u=1,,5", "Glass.u=1,-5"}) {
        Controls controls = controls_of(scene);
        EXPECT_NE(apply_state(named_state(text, "scene.glib", scene), scene, controls), "") << text;
    }
    EXPECT_NE(named_state("Glass.u=1, 5", "scene.glib", scene).error, "");
}

TEST(Remembered, AProgramOfOneNameThatIsBackHasItsOwnValue) {
    const Glasses all{{"a", 1, 2}, {"b", 1, 3}};
    const Scene both = glasses(all), second = glasses({all[1]}), third = glasses({all[1], {"c"}});
    Remembered memory;
    remember(both, set_values(both, all), memory);
    for (const Scene* meanwhile : {&second, &third}) {
        Controls controls = controls_of(*meanwhile);
        recall(memory, *meanwhile, controls);
        EXPECT_EQ(controls.find(0, "u")->value, Values{3});
        const Control* const other = controls.find(1, "u");
        EXPECT_EQ(other ? other->value : Values{1}, Values{1}) << "c is not a";
        remember(*meanwhile, controls, memory);
    }
    Controls controls = controls_of(both);
    recall(memory, both, controls);
    expect_values(controls, {"back", {}, all}, "kept");
}

TEST(Remembered, RungsGoByNameAndFollowTheText) {
    Scene scene;
    scene.ladders.push_back({"F", {"a", "b", "c"}, 0, {}, {}, {}});
    Controls controls;
    controls.rungs = {2};
    Remembered memory;
    remember(scene, controls, memory);
    Rungs rungs{0};
    EXPECT_TRUE(recall(memory, scene, rungs));
    EXPECT_EQ(rungs, Rungs{2});
    scene.ladders[0].rungs = {"c", "a", "b"};
    scene.ladders[0].current = 1;
    rungs = {1};
    recall(memory, scene, rungs);
    EXPECT_EQ(rungs, Rungs{0}) << "c is the first now";
    scene.ladders[0].current = 2;
    rungs = {2};
    EXPECT_FALSE(recall(memory, scene, rungs)) << "the text marks another";
}

bool flat(const std::string& text) {
    Sources sources;
    return flat_picture(parse(sources.add("a.glib", text), sources).scene);
}

TEST(FlatPicture, IsOnePlaneOfUndividedQuads) {
    EXPECT_TRUE(flat("QuadXY 0. 1.\n"));
    EXPECT_TRUE(flat("QuadXY\nQuadXY\n"));
    EXPECT_TRUE(flat("Texture2D 5 64 64\nRenderToTexture 5\nSphere\nRenderToTexture\nQuadXY 0. 1.\n"));
    EXPECT_FALSE(flat("")) << "there is nothing";
    EXPECT_FALSE(flat("QuadXY 0. 1.\nSphere\n"));
    EXPECT_FALSE(flat("QuadXY 0. 1.\nQuadXZ 0. 1.\n")) << "a corner of a room";
    EXPECT_FALSE(flat("QuadXY 0. 1.\nQuadXY 1. 1.\n")) << "two walls";
    EXPECT_FALSE(flat("QuadXY 0. 1.\nTranslate 0 0 1\nQuadXY 0. 1.\n")) << "two walls";
    EXPECT_FALSE(flat("QuadXY 0. 1. 50 50\n")) << "it was divided because a shader bends it";
}

}  // namespace
}  // namespace snell
