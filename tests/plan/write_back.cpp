// Values back into the text: judged by reading the new text, and by the bytes that must not change.
#include "src/plan/values/write_back.h"
#include "parser/read/parse.h"
#include "tests/plan/uniforms.h"
#include "tests/std.h"

namespace snell {
namespace {

using Texts = std::map<std::string, std::string>;
using Types = std::vector<std::pair<std::string, ActiveUniform>>;  // of every program

ActiveUniform with_initial(ActiveUniform uniform, std::vector<double> initial) {
    uniform.initial = std::move(initial);
    return uniform;
}

// A scene in memory: what it says, what was changed, what its texts become.
struct Desk {
    Texts texts;
    Sources sources;
    Scene scene;
    Controls controls;

    Desk(Texts given, const Types& types) : texts(std::move(given)) {
        scene = read(texts, sources);
        std::vector<ActiveUniform> active_uniforms;
        for (const auto& [name, uniform] : types) {
            active_uniforms.push_back(uniform);
            active_uniforms.back().name = name;
        }
        Diagnostics ignored;
        controls = make_controls(scene, std::vector(scene.programs.size(), active_uniforms), ignored);
    }
    Desk(std::string text, const Types& types) : Desk(Texts{{"a.glib", std::move(text)}}, types) {}

    static Scene read(const Texts& texts, Sources& sources) {
        const auto include = [&](std::string_view, std::string_view name) -> std::optional<IncludedText> {
            const auto found = texts.find(std::string(name));
            if (found == texts.end()) return std::nullopt;
            return IncludedText{found->first, found->second};
        };
        return parse(sources.add("a.glib", texts.at("a.glib")), sources, include).scene;
    }

    Control& control(const std::string& name, Index program = 0) {
        Control* found = controls.find(program, name);
        if (found == nullptr) throw std::runtime_error("no control " + name);
        return *found;
    }
    void set(const std::string& name, std::vector<double> values, Index program = 0) {
        control(name, program).value = std::move(values);
    }

    // The new texts; checks that they read as they must.
    Texts save(std::size_t unwritten = 0) {
        const WriteBack back = write_back(scene, controls, sources);
        EXPECT_EQ(back.unwritten.size(), unwritten);
        reasons.clear();
        for (const Unwritten& u : back.unwritten) reasons += u.name + ": " + u.reason + "\n";
        Texts after = texts;
        for (FileId file = static_cast<FileId>(sources.size()); file-- > 0;) {
            std::string& text = after.at(std::string(sources.name(file)));
            const std::string edited = with_edits(sources.text(file), file, back.edits);
            if (edited != sources.text(file)) text = edited;
        }
        Sources again;
        const Scene reread = read(after, again);
        EXPECT_TRUE(reads_back(back, reread)) << after.at("a.glib");
        return after;
    }
    std::string text(std::size_t unwritten = 0) { return save(unwritten).at("a.glib"); }
    std::string reasons;
};

TEST(WriteBack, OnlyTheNumberOfTheChangedUniformIsOther) {
    Desk desk("Program Glass uEta <.1 1.1 5.>   uMix <0. .5 1.> # uEta <.1 1.1 5.>\nSphere\n",
              {{"uEta", active("float")}, {"uMix", active("float")}});
    EXPECT_EQ(desk.text(), desk.texts["a.glib"]) << "nothing changed: nothing is written";
    desk.set("uEta", {1.3});
    EXPECT_EQ(desk.text(), "Program Glass uEta <.1 1.3 5.>   uMix <0. .5 1.> # uEta <.1 1.1 5.>\nSphere\n");
    desk.set("uMix", {.25});
    EXPECT_EQ(desk.text(), "Program Glass uEta <.1 1.3 5.>   uMix <0. .25 1.> # uEta <.1 1.1 5.>\nSphere\n")
        << "a number keeps its style";
}

TEST(WriteBack, OnlyTheBoundThatTheValueExceedsIsWidenedToIt) {
    const std::string line = "Program Glass uKa <0. .5 1.> uDown <1. .5 0.>\n";
    Desk desk(line, {{"uKa", active("float")}, {"uDown", active("float")}});
    for (const char* name : {"uKa", "uDown"}) {  // as after typing 500 and going back
        desk.control(name).max = 500;
        desk.control(name).min = -500;
    }
    EXPECT_EQ(desk.text(), line) << "the range is the panel's";
    desk.set("uKa", {.25});
    desk.set("uDown", {.25});
    EXPECT_EQ(desk.text(), "Program Glass uKa <0. .25 1.> uDown <1. .25 0.>\n");
    desk.set("uKa", {401.61});
    desk.set("uDown", {-2});
    EXPECT_EQ(desk.text(), "Program Glass uKa <0. 401.61 401.61> uDown <1. -2. -2.>\n")
        << "without it the value would not read back";
}

TEST(WriteBack, LineEndsCommentsBlanksAndOddBytesStay) {
    const Types types{{"uA", active("float")}, {"uB", active("float")}};
    const std::vector<std::pair<std::string, std::string>> pairs{
        {"Program G\\\r\n\tuA <0. 1. 2.> \\  \r\n # caf\xE9\r\n uB { 1. }\r\n", "no final newline"},
        {"\xEF\xBB\xBFProgram G uA <0.,1.,2.> uB 1.\r\r\n# \xFF\xFE", "byte-order mark, CR, Latin-1"},
        {"Program G uA\xC2\xA0<0.\xC2\xA0"
         "1. 2.>uB[1.]",
         "no-break spaces"},
        {"Program G uA < 0. \\\n# what it is\n 1. \\\n 2. > uB 1.", "a comment between the numbers"},
    };
    for (const auto& [text, what] : pairs) {
        Desk desk(text, types);
        desk.set("uA", {.5});
        std::string expected = text;
        const std::size_t at = expected.find("1.");
        expected.replace(at, 2, "0.5");
        EXPECT_EQ(desk.text(), expected) << what;
    }
}

TEST(WriteBack, EveryKindOfValue) {
    const Types types{{"uI", active("int")},    {"uOn", active("bool")}, {"uW", active("float")},
                      {"uC", active("vec4")},   {"uV", active("vec3")},  {"uArray", active("float", 4)},
                      {"uFlag", active("bool")}};
    Desk desk(
        "Program G uI <1 8 32> uOn <true> uW <False> uC {1. .5 0.} uV [1 2. -.5] uArray [1. 2. 3. 4.] uFlag <0>\n",
        types);
    desk.set("uI", {12});
    desk.set("uOn", {0});
    desk.set("uW", {1});
    desk.set("uC", {1, .75, 0, .5});
    desk.set("uV", {3, 2.5, -.125});
    desk.set("uArray", {1, 2, 1e-7, 4});
    desk.set("uFlag", {1});
    EXPECT_EQ(
        desk.text(),
        "Program G uI <1 12 32> uOn <false> uW <True> uC {1. .75 0. 0.5} uV [3 2.5 -.125] uArray [1. 2. 1e-07 4.] "
        "uFlag <1>\n");
}

TEST(WriteBack, ElementsOfAnArrayAreWrittenWhereTheyStand) {
    Desk desk("Program G w[1] 5. w[3] <0. 1. 2.> v [1. 2. 3.]\n", {{"w", active("float", 4)}, {"v", active("vec3")}});
    desk.set("w", {0, 6, 0, 1.5});
    EXPECT_EQ(desk.text(), "Program G w[1] 6. w[3] <0. 1.5 2.> v [1. 2. 3.]\n");
    Desk twice("Program G w [1. 2. 3.] w[1] 5.\n", {{"w", active("float", 3)}});
    twice.set("w", {4, 6, 3});
    EXPECT_EQ(twice.text(), "Program G w [4. 2. 3.] w[1] 6.\n") << "the later value is the one that holds";
}

TEST(WriteBack, NumbersThatTheTextLacksAreAdded) {
    const Types types{{"uA", active("float")}, {"uC", active("vec4")}, {"uV", active("vec3")}};
    Desk desk("Program G uA <0., 1.> uC {.5 .5} uV [1.]\n", types);
    desk.set("uA", {.5});
    desk.set("uC", {.5, .5, .25, 1});
    desk.set("uV", {1, 0, 3});
    EXPECT_EQ(desk.text(), "Program G uA <0. 0.5, 1.> uC {.5 .5 .25} uV [1. 0. 3.]\n");
    desk.set("uC", {.5, .5, 0, .5});
    EXPECT_EQ(desk.text(), "Program G uA <0. 0.5, 1.> uC {.5 .5 0. .5} uV [1. 0. 3.]\n");
}

TEST(WriteBack, WhatHasNoPlaceIsRefusedWithAReason) {
    Desk desk("Program G uV <0. 1. 2.> uS 4.\n",
              {{"uV", active("vec3")}, {"uS", active("vec2")}, {"uExtra", with_initial(active("float"), {.5})}});
    desk.set("uV", {1, 1.5, 1});
    desk.set("uS", {4, 2});
    desk.set("uExtra", {.75});
    EXPECT_EQ(desk.text(3), desk.texts["a.glib"]);
    EXPECT_NE(desk.reasons.find("G.uV: a range sets all components to the same number"), std::string::npos);
    EXPECT_NE(desk.reasons.find("write uS [4. 2.]"), std::string::npos) << desk.reasons;
    EXPECT_NE(desk.reasons.find("G.uExtra: it is not on the Program line; add uExtra <0. 0.75 1.>"), std::string::npos)
        << desk.reasons;
    desk.set("uExtra", {.5});
    desk.set("uS", {5, 0});
    desk.set("uV", {1.5, 1.5, 1.5});
    EXPECT_EQ(desk.text(), "Program G uV <0. 1.5 2.> uS 5.\n");
}

TEST(WriteBack, AnIncludedValueIsWrittenIntoTheIncludedFile) {
    const Types types{{"uA", active("float")}};
    Desk desk(
        Texts{{"a.glib", "# a\nInclude b.glib\nProgram Two uA 1.\n"}, {"b.glib", "Program One uA <0. 1. 2.>\r\n"}},
        types);
    desk.set("uA", {.5}, 0);
    desk.set("uA", {3}, 1);
    const Texts after = desk.save();
    EXPECT_EQ(after.at("a.glib"), "# a\nInclude b.glib\nProgram Two uA 3.\n");
    EXPECT_EQ(after.at("b.glib"), "Program One uA <0. 0.5 2.>\r\n");
}

TEST(WriteBack, ATextThatIsIncludedTwiceIsWrittenOnlyWhenBothReadingsAgree) {
    const Types types{{"uA", active("float")}, {"uB", active("float")}};
    Desk desk(Texts{{"a.glib", "Include b.glib\nTranslate 1. 0. 0.\nInclude b.glib\n"},
                    {"b.glib", "Program One uA 1. uB 1.\nSphere\n"}},
              types);
    ASSERT_EQ(desk.scene.programs.size(), 2u);
    desk.set("uA", {2}, 0);
    desk.set("uB", {3}, 0);
    desk.set("uB", {3}, 1);
    EXPECT_EQ(desk.save(1).at("b.glib"), "Program One uA 1. uB 3.\nSphere\n");
    EXPECT_NE(desk.reasons.find("One.uA: its file is included more than once"), std::string::npos) << desk.reasons;
    desk.set("uA", {2}, 1);
    EXPECT_EQ(desk.save().at("b.glib"), "Program One uA 2. uB 3.\nSphere\n");
}

TEST(WriteBack, TheMarkOfALadderMoves) {
    const auto moved = [](const std::string& text, std::size_t rung) {
        Desk desk(text, {});
        desk.controls.rungs = {rung};
        return desk.text();
    };
    EXPECT_EQ(moved("Ladder F f0 <schlick> exact # <f0>\r\n", 2), "Ladder F f0 schlick <exact> # <f0>\r\n");
    EXPECT_EQ(moved("Ladder F f0 < schlick > exact", 0), "Ladder F <f0>  schlick  exact");
    EXPECT_EQ(moved("Ladder F f0 schlick exact", 1), "Ladder F f0 <schlick> exact") << "none was marked: the first";
    EXPECT_EQ(moved("Ladder F 3<16>64", 2), "Ladder F 3 16 <64>") << "a blank keeps words apart";
}

// Whatever the values: the new text says just them, and every byte that is in no number is as it was.
TEST(WriteBack, RandomValuesReadBackToTheBitAndNothingElseChanges) {
    const Types types{{"uA", active("float")}, {"uC", active("vec3")}, {"uV", active("vec4")},
                      {"uI", active("int")},   {"uU", active("uint")}, {"uD", active("double")},
                      {"uOn", active("bool")}, {"uM", active("mat2")}};
    const std::string text =
        "##OpenGL GLIB\r\n# caf\xE9\r\nProgram G \\\r\n uA <-1. 0. 1.> /* \\\n uC {1.,.5,0.} uV [0 1 2. .3]\\\n"
        "uI <0 5 10> uU 3 uD 1e-3 uOn <true> uM [1. 0. 0. 1.]";
    const std::string numbers = "0123456789.-+e";
    std::mt19937_64 random(7);
    const auto real = [&] {
        const double mantissa = std::uniform_real_distribution(-1., 1.)(random);
        return std::ldexp(mantissa, std::uniform_int_distribution(-100, 100)(random));
    };
    for (int round = 0; round < 300; ++round) {
        Desk desk(text, types);
        std::vector<double> all;
        for (Control& control : desk.controls.items)
            for (double& value : control.value) {
                if (random() % 4 == 0) continue;
                switch (control.type) {
                    case ValueType::int_:
                        value = std::uniform_int_distribution(-2147483647, 2147483647)(random);
                        break;
                    case ValueType::uint_:
                        value = static_cast<double>(random() % 4294967296u);
                        break;
                    case ValueType::bool_:
                        value = static_cast<double>(random() % 2);
                        break;
                    default:
                        value = random() % 5 == 0 ? static_cast<float>(real()) : real();
                }
            }
        Desk again(desk.text(), types);
        ASSERT_EQ(again.controls.items.size(), desk.controls.items.size());
        for (std::size_t i = 0; i < again.controls.items.size(); ++i)
            ASSERT_EQ(again.controls.items[i].value, desk.controls.items[i].value) << again.texts["a.glib"];
        const auto skeleton = [&](std::string whole) {
            for (const std::string word : {"true", "false"})
                if (const std::size_t at = whole.rfind(word); at != std::string::npos) whole.erase(at, word.size());
            std::erase_if(whole, [&](char c) { return numbers.find(c) != std::string::npos; });
            return whole;
        };
        ASSERT_EQ(skeleton(again.texts["a.glib"]), skeleton(text));
    }
}

}  // namespace
}  // namespace snell
