// Ladders: what is read, what is refused, and what the programs know of them.
#include "tests/oracle/scene/print.h"
#include "tests/parser/support.h"
#include "tests/std.h"

namespace snell::test {
namespace {

const Ladder& only(const Read& r) {
    static const Ladder nothing;
    EXPECT_EQ(r.scene().ladders.size(), 1u);
    return r.scene().ladders.empty() ? nothing : r.scene().ladders[0];
}

TEST(Ladders, TheMarkedRungIsTheCurrentOne) {
    const Read r = read("Ladder FRESNEL f0 <schlick> exact\n");
    EXPECT_EQ(r.codes(), Codes{});
    const Ladder& ladder = only(r);
    EXPECT_EQ(ladder.name, "FRESNEL");
    EXPECT_EQ(ladder.rungs, (std::vector<std::string>{"f0", "schlick", "exact"}));
    EXPECT_EQ(ladder.current, 1u);
    EXPECT_FALSE(ladder.numeric());
    EXPECT_EQ(r.under(ladder.name_span), "FRESNEL");
    EXPECT_EQ(r.under(ladder.rung_spans[1]), "schlick");
    EXPECT_EQ(r.under(ladder.span), "Ladder FRESNEL f0 <schlick> exact");
}

TEST(Ladders, WithoutAMarkItIsTheFirst) { EXPECT_EQ(only(read("Ladder A x y\n")).current, 0u); }

TEST(Ladders, BlanksInTheBracketsAndSeveralLinesAreFine) {
    const Read r = read("Ladder A x \\\n  < y > # the best\n");
    EXPECT_EQ(r.codes(), Codes{});
    EXPECT_EQ(only(r).current, 1u);
}

TEST(Ladders, RungsMayBeNumbers) {
    const Read r = read("Ladder WAVELENGTHS 3 8 <16> 64\n");
    EXPECT_EQ(r.codes(), Codes{});
    EXPECT_EQ(only(r).rungs, (std::vector<std::string>{"3", "8", "16", "64"}));
    EXPECT_EQ(only(r).current, 2u);
    EXPECT_TRUE(only(r).numeric());
    EXPECT_FALSE(only(read("Ladder N 3 8 all\n")).numeric());
}

TEST(Ladders, NeedRungs) {
    EXPECT_EQ(read("Ladder A\n").diagnostics().size(), 1u);
    EXPECT_TRUE(read("Ladder A\n").scene().ladders.empty());
    EXPECT_EQ(read("Ladder A <>\n").codes(), Codes{"1:1 ladder-without-rungs"});
}

TEST(Ladders, ARungTwiceIsAnError) {
    const Read r = read("Ladder A x y <x>\n");
    EXPECT_EQ(r.codes(), Codes{"1:15 repeated-rung"});
    EXPECT_EQ(only(r).rungs.size(), 2u);
    EXPECT_EQ(only(r).current, 0u);
}

TEST(Ladders, TwoMarksAreAnErrorAndTheFirstHolds) {
    const Read r = read("Ladder A x <y> <z>\n");
    EXPECT_EQ(r.codes(), Codes{"1:17 two-current-rungs"});
    EXPECT_EQ(only(r).current, 1u);
    EXPECT_EQ(read("Ladder A <x y>\n").codes(), Codes{"1:13 two-current-rungs"});
}

TEST(Ladders, NamesAreWhatAMacroCanBeCalled) {
    for (const char* name : {"2d", "a-b", "FRESNEL.x", "float", "vec3", "main", "gl_Kind", "A__B", "A_", "defined",
                             "sampler2D", "snell_Kind"}) {
        const Read r = read(std::string("Ladder ") + name + " x y\n");
        EXPECT_EQ(r.codes(), Codes{"1:8 ladder-name"}) << name;
        EXPECT_TRUE(r.scene().ladders.empty()) << name;
    }
    for (const char* name : {"F", "_f", "Fresnel2", "vector", "material", "maths"})
        EXPECT_EQ(read(std::string("Ladder ") + name + " x y\n").codes(), Codes{}) << name;
}

TEST(Ladders, RungsArePartsOfMacros) {
    for (const char* rung : {"two-sided", "1.5", "_x", "a__b", "-3"}) {
        const Read r = read(std::string("Ladder A x ") + rung + "\n");
        EXPECT_EQ(r.codes(), Codes{"1:12 ladder-rung"}) << rung;
        EXPECT_EQ(only(r).rungs, std::vector<std::string>{"x"}) << rung;
    }
}

TEST(Ladders, TheLastOfTwoHolds) {
    const Read r = read("Ladder A x y\nLadder B x\nLadder A <z> w\n");
    EXPECT_EQ(r.codes(), Codes{"3:8 repeated-ladder"});
    ASSERT_EQ(r.scene().ladders.size(), 2u);
    EXPECT_EQ(r.scene().ladders[0].rungs, (std::vector<std::string>{"z", "w"}));
}

TEST(Ladders, TwoLaddersDefineDifferentMacros) {
    EXPECT_EQ(read("Ladder A B_C\nLadder A_B C\n").codes(), Codes{"2:8 ladder-clash"});
    EXPECT_EQ(read("Ladder A B\nLadder A_B C\n").codes(), Codes{"2:8 ladder-clash"});
    EXPECT_EQ(read("Ladder A 1 2\nLadder A_VALUE C\n").codes(), Codes{"2:8 ladder-clash"});
    EXPECT_EQ(read("Ladder A one two\nLadder A_VALUE C\n").codes(), Codes{});
}

TEST(Ladders, ProgramsKnowThoseBeforeThem) {
    const Read r = read("Program None\nLadder A x y\nProgram One\nLadder B x y\nProgram Both\n");
    ASSERT_EQ(r.scene().programs.size(), 3u);
    EXPECT_EQ(r.scene().programs[0].ladders, 0u);
    EXPECT_EQ(r.scene().programs[1].ladders, 1u);
    EXPECT_EQ(r.scene().programs[2].ladders, 2u);
}

TEST(Ladders, PrintedTheyReadTheSame) {
    const Read r = read(
        "Ladder A x <y>\nVertex a.vert\nFragment a.frag\nProgram P\nSphere\nLadder N 1 2 <4>\nProgram Q\nSphere\n"
        "Ladder LAST only\n");
    const Read again = read(print_scene(r.scene()));
    EXPECT_EQ(again.codes(), Codes{});
    EXPECT_EQ(difference(r.scene(), again.scene(), 0), "") << print_scene(r.scene());
    EXPECT_NE(dump_scene(r.scene()).find("ladder 1 Ladder N 1 2 <4>"), std::string::npos);
}

TEST(Ladders, ADifferenceIsSeen) {
    const Read a = read("Ladder A x <y>\nProgram P\n");
    EXPECT_NE(difference(a.scene(), read("Ladder A <x> y\nProgram P\n").scene(), 0), "");
    EXPECT_NE(difference(a.scene(), read("Program P\nLadder A x <y>\n").scene(), 0), "");
    EXPECT_NE(difference(a.scene(), read("Program P\n").scene(), 0), "");
}

}  // namespace
}  // namespace snell::test
