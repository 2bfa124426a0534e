// Choosing rungs by name, and keeping the choice when the text changes.
#include "src/plan/values/rungs.h"
#include "parser/read/parse.h"
#include "tests/std.h"

namespace snell {
namespace {

Scene scene(std::string text) {
    Sources sources;
    const FileId file = sources.add("scene.glib", std::move(text));
    return parse(file, sources).scene;
}

TEST(Rungs, AreChosenByName) {
    const Scene s = scene("Ladder FRESNEL f0 <schlick> exact\nLadder WAVES 3 8 16\n");
    Rungs rungs = marked_rungs(s);
    EXPECT_EQ(rungs, (Rungs{1, 0}));
    Diagnostics problems;
    EXPECT_TRUE(choose_rung(rungs, s, "FRESNEL=exact", problems));
    EXPECT_TRUE(choose_rung(rungs, s, "WAVES=16", problems));
    EXPECT_EQ(rungs, (Rungs{2, 2}));
    EXPECT_TRUE(problems.empty());
}

TEST(Rungs, WhatIsNotThereIsAnErrorThatSuggests) {
    const Scene s = scene("Ladder FRESNEL f0 <schlick> exact\n");
    for (const auto& [text, code, help] :
         {std::array{"FRESNELL=exact", "unknown-ladder", "did you mean 'FRESNEL'?"},
          std::array{"FRESNEL=exakt", "unknown-rung", "did you mean 'exact'?"},
          std::array{"FRESNEL=quite-another", "unknown-rung", "available: f0, schlick, exact"},
          std::array{"FRESNEL=", "unknown-rung", "available: f0, schlick, exact"},
          std::array{"FRESNEL", "bad-assignment", "write LADDER=rung"}}) {
        Rungs rungs = marked_rungs(s);
        Diagnostics problems;
        EXPECT_FALSE(choose_rung(rungs, s, text, problems)) << text;
        ASSERT_EQ(problems.errors(), 1u) << text;
        EXPECT_EQ(problems.items()[0].code, code) << text;
        EXPECT_EQ(problems.items()[0].help, help) << text;
        EXPECT_EQ(rungs, Rungs{1}) << text;
    }
}

TEST(Rungs, CarryOverByName) {
    const Scene before = scene("Ladder A x <y> z\nLadder B p q\n");
    const Scene after = scene("Ladder B q p <p2>\nLadder A z x <y>\nLadder C one\n");
    Rungs rungs = marked_rungs(after);
    carry_over(Rungs{2, 1}, before, rungs, after);
    EXPECT_EQ(rungs[1], 0u) << "A: z";
    EXPECT_EQ(rungs[0], 2u) << "B: the text marks another rung than before";
    EXPECT_EQ(rungs[2], 0u);
    const Scene without = scene("Ladder A x <y>\n");
    rungs = marked_rungs(without);
    carry_over(Rungs{2, 1}, before, rungs, without);
    EXPECT_EQ(rungs, Rungs{1}) << "the chosen rung is gone";
}

}  // namespace
}  // namespace snell
