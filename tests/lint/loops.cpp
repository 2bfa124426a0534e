// Loops that go on and on: told where their rounds are known, and only there.
#include "parser/text/ranges.h"
#include "tests/lint/help.h"

namespace snell::lint {
namespace {

bool told(const Linted& linted) { return linted.has(Rule::many_rounds); }

TEST(LintLoops, TooManyRounds) {
    for (const char* loop :
         {"for (int i = 0; i < 70000; ++i) x += 1.;", "for (int i = 0; i <= 65535; i++) { x += 1.; }",
          "for (int i = 140000; i > 0; i -= 2) x += 1.;", "for (float f = 0.; f < 7000.; f += .1) x += f;",
          "for (int i = -40000; i < 40000; i += 1) x += 1.;", "int i; for (i = 0; i < 70000; ++i) x += 1.;",
          "for (int i = 0; i < 70000; ++i) x += float(i);", "int i = 0; while (i < 70000) { x += 1.; ++i; }",
          "int i = 70000; while (i > 0) { i -= 1; x += float(i); }",
          "int i = 0; do { x += 1.; i++; } while (i < 70000);", "int i = 0; do ++i; while (i <= 65535);",
          "int i = 0; for (; i < 140000;) { ++i; x += 1.; ++i; }"}) {
        const Linted bad = looping(loop);
        EXPECT_TRUE(told(bad)) << loop << bad.text();
        EXPECT_EQ(bad.at("many-rounds").size(), 1U);
    }
    const Linted bad = looping("for (int i = 0; i < 70000; ++i) x += 1.;");
    EXPECT_EQ(bad.at("many-rounds").front(), "for (int i = 0; i < 70000; ++i)");
    EXPECT_NE(bad.text().find("at least 70001 times"), std::string::npos) << bad.text();
}

TEST(LintLoops, LoopsInLoopsAndOneAfterTheOther) {
    EXPECT_TRUE(told(looping("for (int i = 0; i < 300; ++i) for (int k = 0; k < 300; ++k) x += 1.;")));
    EXPECT_FALSE(told(looping("for (int i = 0; i < 200; ++i) for (int k = 0; k < 300; ++k) x += 1.;")));
    const std::string one = "for (int i = 0; i < 40000; ++i) x += 1.;";
    EXPECT_FALSE(told(looping(one)));
    EXPECT_TRUE(told(looping(one + "\n" + one)));
    EXPECT_TRUE(told(looping("for (int i = 0; i < 300; ++i) x += far(x);", "",
                             "float far(float y) { for (int k = 0; k < 300; ++k) y += 1.; return y; }\n")));
    EXPECT_TRUE(
        told(looping("for (int i = 0; i < n; ++i) for (int k = 0; k < n; ++k) x += 1.;", "", "const int n = 300;\n")));
    for (const std::string kind : {"const int", "int"}) {
        const std::string square = "for (int i = 0; i < n; ++i) for (int k = 0; k < n; ++k) x += 1.;";
        EXPECT_TRUE(told(looping(kind + " n = 300; " + square))) << kind;
        EXPECT_FALSE(told(looping(kind + " n = 200; " + square))) << kind;
    }
    EXPECT_FALSE(
        told(looping("int n = 300; for (int i = 0; i < n; ++i) { for (int k = 0; k < n; ++k) x += 1.; n = uM; }")));
}

// Bounds that the counters of the loops around set: the sum is that of a triangle.
TEST(LintLoops, LoopsInLoopsThatGrowOrShrink) {
    struct Row {
        const char *outer, *inner;
        bool told;
    };
    for (const auto& [outer, inner, expected] :
         {Row{"i < 400; ++i", "int k = 0; k < i; ++k", true},
          {"i < 350; ++i", "int k = 0; k < i; ++k", false},
          {"i < 400; ++i", "int k = i; k < 400; ++k", true},
          {"i < 350; ++i", "int k = i; k < 350; ++k", false},
          {"i < 400; ++i", "int k = i + 1; k <= 400; ++k", true},
          {"i < 400; ++i", "int k = 400 - i; k > 0; --k", true},
          {"i < 400; i += 2", "int k = 0; k < i; ++k", false},
          {"i < 400; ++i", "int k = 0; k < i; k += 2", false},
          {"i < uN; ++i", "int k = 0; k <= i; ++k", true},
          {"i < uN - 50; ++i", "int k = 0; k <= i; ++k", false},
          {"i < 90; ++i", "int k = 0; k < i; ++k) for (int m = 0; m < k; ++m", true},
          {"i < 70; ++i", "int k = 0; k < i; ++k) for (int m = 0; m < k; ++m", false},
          {"i < 400; ++i", "int k = 0; k < 1000 * (i % 2); ++k", true},
          {"i < 100; ++i", "int k = 99; k <= i; ++k) for (int m = 0; m < 700; ++m", false},
          {"i < 50; ++i", "int k = 0; k < i; ++k) for (int m = k; m < 3; ++m) for (int n = 0; n < 100; ++n", false},
          {"i < 400; ++i", "int k = i; k != 7; ++k", false},
          {"i < 400; i += uM", "int k = 0; k < i; ++k", false}}) {
        const std::string loop = std::string("for (int i = 0; ") + outer + ") for (" + inner + ") x += 1.;";
        EXPECT_EQ(told(looping(loop, "uN <1 10 400>")), expected) << loop;
    }
    EXPECT_FALSE(told(looping("for (int i = 0; i < 400; ++i) for (int k = 0; k < i; ++k) if (x > uX) break;")));
    EXPECT_TRUE(told(looping("for (int i = 0; i < 400; ++i) { int k = 0; while (k < i) { ++k; x += 1.; } }")));
}

TEST(LintLoops, BoundsThatTheSceneSets) {
    const std::string loop = "for (int i = 0; i < uN; ++i) x += 1.;";
    EXPECT_TRUE(told(looping(loop, "uN 70000")));
    EXPECT_FALSE(told(looping(loop, "uN 60000")));
    EXPECT_TRUE(told(looping(loop, "uN <1 10 100000>"))) << "the slider goes there";
    EXPECT_FALSE(told(looping(loop, "uN <1 10 1000>")));
    EXPECT_FALSE(told(looping(loop))) << "nothing is known";
    const std::string square = "for (int i = 0; i < uN; ++i) for (int k = 0; k < uN; ++k) x += 1.;";
    EXPECT_TRUE(told(looping(square, "uN <1 10 300>")));
    EXPECT_FALSE(told(looping(square, "uN <1 10 200>")));
}

TEST(LintLoops, StepsThatTheSceneSets) {
    struct Row {
        const char *loop, *values, *told;  // "": nothing
    };
    const char *const up = "for (float t = 0.; t < 1.; t += uX) x += t;",
                      *const down = "for (float t = 9.; t > 0.; t -= .5 * uX) x += t;";
    for (const auto& [loop, values, expected] :
         {Row{up, "uX 0.", "go round for ever"}, Row{up, "uX -.1", "go round for ever"}, Row{up, "uX .01", ""},
          Row{up, "uX 1e-9", "go round more than a million"}, Row{up, "uX 1e-5", "go round at least 99903 times"},
          Row{up, "", ""},
          // At the end of a slider, or within.
          Row{up, "uX <0. .1 1.>", "may go round for ever"}, Row{up, "uX <-1. .1 1.>", "may go round for ever"},
          Row{up, "uX <.01 .1 1.>", ""}, Row{up, "uX <-1. -.5 -.1>", "may go round for ever"},
          Row{up, "uX <1e-6 .1 1.>", "may go round at least 990523 times"},
          Row{down, "uX <0. .1 1.>", "may go round for ever"}, Row{down, "uX 0.", "go round for ever"},
          Row{down, "uX .01", ""},
          Row{"for (int i = 0; i < 9; i += uN) x += 1.;", "uN <0 1 5>", "may go round for ever"},
          Row{"float t = 0.; while (t < 1.) { x += t; t += uX; }", "uX 0.", "go round for ever"},
          // It vanishes next to the bound.
          Row{"for (float t = 99999.; t < 1e5; t += uX) x += t;", "uX .001", "go round for ever"},
          // What sets it is not known, or keeps it from being 0.
          Row{"for (float t = 0.; t < 1.; t += max(uX, .01)) x += t;", "uX <0. .1 1.>", ""},
          Row{"for (float t = .1; t < 1.; t += t * uX) x += t;", "uX 0.", ""},
          Row{"float d = uX; for (float t = 0.; t < 1.; t += d) { d = .1; x += t; }", "uX 0.", ""},
          Row{"if (uX > 0.) for (float t = 0.; t < 1.; t += uX) x += t;", "uX <0. .1 1.>", ""},
          Row{"for (float t = 0.; t < 1.; t += uX) if (uX == 0.) break;", "uX 0.", ""},
          // A branch may have set another one.
          Row{"float d = uX; if (vN.x < 2.) d = .1; for (float t = 0.; t < 1.; t += d) x += t;", "uX <0. 0. 1.>", ""},
          Row{"float d = uX; if (vN.x > 0.) d += .1; for (float t = 0.; t < 1.; t += d) x += t;", "uX <-1. -.1 1.>",
              ""},
          Row{"float d = vN.x > 0. ? uX : .1; for (float t = 0.; t < 1.; t += d) x += t;", "uX <0. 0. 1.>", ""},
          Row{"for (float t = 0.; t < 1.; t += step(x)) x += t;", "uX <0. 0. 1.>", ""},
          Row{"float d = uX; if (vN.x < 2.) x = .1; for (float t = 0.; t < 1.; t += d) x += t;", "uX <0. 0. 1.>",
              "may go round for ever"},
          // Written in another way.
          Row{"for (float t = 0.; t < 1.; t = t + uX) x += t;", "uX <0. .1 1.>", "may go round for ever"},
          Row{"for (float t = 0.; t < 1.; t = uX + t) x += t;", "uX 0.", "go round for ever"},
          Row{"for (float t = 1.; t > 0.; t = uX - t) x += t;", "uX 0.", ""},
          Row{"for (float t = 0.; 1. > t; t += uX) x += t;", "uX <0. .1 1.>", "may go round for ever"},
          Row{"for (float t = 0.; (1. > t); t += uX) x += t;", "uX <0. .1 1.>", "may go round for ever"},
          Row{"for (int i = 0; uN > i; i--) x += 1.;", "uN 4", "go round for ever"},
          Row{"for (int i = 0; uN > i; i++) x += 1.;", "uN <1 4 8>", ""},
          // At one of the slider's values, and at others not.
          Row{"for (int i = 0; i < uN;) x += uX;", "uN <0 1 4>", "may go round for ever"},
          Row{"for (int i = 0; i < uN;) x += uX;", "uN <0 0 4>", "may go round for ever"},
          Row{"for (int i = 0; i < uN;) x += uX;", "uN <1 4 8>", "go round for ever"},
          Row{"for (int i = 0; i < uN;) x += uX;", "uN <-4 -1 0>", ""},
          Row{"for (int i = uN; i < 4;) x += uX;", "uN <0 1 4>", "may go round for ever"},
          Row{"for (int i = 4; i > uN; ++i) x += uX;", "uN <0 4 4>", "may go round for ever"},
          Row{"for (float t = uX; t < 1.; t += float(uN)) x += t;", "uN <0 1 4> uX <0. .5 1.>",
              "may go round for ever"},
          Row{"for (float t = 0.; t < uX; t += float(uN)) x += t;", "uN <0 1 4> uX <0. .5 1.>",
              "may go round for ever"},
          Row{"for (float t = 0.; t < uX; t += .1 * uX) x += t;", "uX <0. .5 1.>", ""},
          Row{"for (float t = 0.; t < uX; t += .1) x += t;", "uX <0. .5 1.>", ""},
          Row{"for (int i = uN; i < uN;) x += uX;", "uN <0 1 4>", ""},
          Row{"for (int i = 0; i < uN;) if (x > uX) break;", "uN <0 1 4>", ""},
          Row{"if (uN < 1) for (int i = 0; i < uN;) x += uX;", "uN <0 1 4>", ""},
          // Factors and shifts.
          Row{"for (float t = 1.; t < 9.; t *= uX) x += t;", "uX 1.", "go round for ever"},
          Row{"for (float t = 1.; t < 9.; t *= uX) x += t;", "uX <1. 2. 3.>", "may go round for ever"},
          Row{"for (float t = 1.; t < 9.; t *= uX) x += t;", "uX <1.1 2. 3.>", ""},
          Row{"for (int i = 1; i < 9; i *= uN + 1) x += 1.;", "uN <0 1 4>", "may go round for ever"},
          Row{"for (int i = 1; i < 9; i = i * (uN + 1)) x += 1.;", "uN <1 2 4>", ""},
          Row{"for (int i = 1; i < 9; i <<= uN) x += 1.;", "uN <0 1 4>", "may go round for ever"},
          Row{"for (int i = 1; i < 9; i <<= uN) x += 1.;", "uN <1 2 4>", ""},
          Row{"for (int i = 8; i >= 0; i >>= 1) x += 1.;", "", "go round for ever"},
          Row{"for (int i = 8; i > 0; i >>= 1) x += 1.;", "", ""}}) {
        const Linted linted =
            looping(loop, values, "varying vec3 vN;\nfloat step(float y) { if (y > 9.) return uX; return .1; }\n");
        EXPECT_EQ(told(linted), *expected != '\0') << loop << values << linted.text();
        EXPECT_NE(linted.text().find(*expected == '\0' ? "" : std::string(" this shader ") + expected),
                  std::string::npos)
            << loop << values << linted.text();
    }
}

// The outer loop's rounds are unknown, as the inner one changes its counter, and yet it has one.
TEST(LintLoops, AStepOfAnotherLoopsCounter) {
    struct Row {
        const char *outer, *inner, *values, *told;  // "": nothing
    };
    for (const auto& [outer, inner, values, expected] :
         {Row{"int i = 0; i < 10; i++", "int j = 0; j < 10; i++", "", "go round for ever"},
          Row{"int i = 0; i < uN; i++", "int j = 0; j < uN; i++", "uN <1 2 4>", "go round for ever"},
          Row{"int i = 0; i < uN; i++", "int j = 0; j < uN; i++", "uN <0 1 4>", "may go round for ever"},
          Row{"int i = 0; i < uN; i++", "int j = 0; j < uN; i++", "uN 4", "go round for ever"},
          Row{"int i = 0; i < 10; i++", "int j = 0; j < 10; j++, i++", "", ""},
          Row{"int i = 20; i < 10; i++", "int j = 0; j < 10; i++", "", ""},
          Row{"int i = uM; i < 10; i++", "int j = 0; j < 10; i++", "", ""},
          Row{"int i = 0; i < 10; i++", "int j = 0; j < i; i++", "", ""},
          Row{"int i = 0; i < 10; i++", "int j = 0; j < i + 1;", "", "go round for ever"},
          Row{"int i = 0; i < uN; i++", "int j = 0; j < 10; i++", "uN <-4 -2 0>", ""}}) {
        const std::string loop = std::string("for (") + outer + ") for (" + inner + ")";
        const Linted linted = looping(loop + " x += 1.;", values);
        EXPECT_EQ(told(linted), *expected != '\0') << loop << values << linted.text();
        if (*expected == '\0') continue;
        EXPECT_NE(linted.text().find(std::string(" this shader ") + expected), std::string::npos) << linted.text();
        EXPECT_NE(linted.text().find("no round changes 'j'"), std::string::npos) << linted.text();
        EXPECT_EQ(linted.at("many-rounds"), std::vector{std::string("for (") + inner + ")"});
    }
    EXPECT_FALSE(
        told(looping("int i = 0; while (i < 10) { if (x > uX) ++i; if (i > 3) break; while (true) x += 1.; }")));
}

TEST(LintLoops, LoopsThatCountWithin) {
    EXPECT_TRUE(told(looping("int i = 0; while (i < uN) { x += 1.; ++i; }", "uN <1 10 100000>")));
    EXPECT_TRUE(told(looping("int i = 0; do { for (int k = 0; k < 300; ++k) x += 1.; ++i; } while (i < 300);")));
    EXPECT_FALSE(told(looping("int i = 0; do { x += 1.; ++i; } while (i < 60000);")));
    EXPECT_FALSE(told(looping("int i = 0; while (i < 60000) { x += 1.; ++i; }")));
}

TEST(LintLoops, ABreakLeavesItsOwnLoopAlone) {
    EXPECT_TRUE(told(looping("while (true) { for (int k = 0; k < 3; ++k) { if (x > uX) break; x += 1.; } }")));
    EXPECT_TRUE(told(looping("for (;;) { int k = 0; do { if (x > uX) break; } while (k < uM); }")));
    EXPECT_TRUE(told(looping("for (int i = 0; i < 70000; ++i) switch (uM) { case 1: x += 1.; break; }")));
    EXPECT_FALSE(told(looping("while (true) { for (int k = 0; k < 3; ++k) x += 1.; if (x > uX) break; }")));
    EXPECT_FALSE(told(looping("while (true) for (int k = 0; k < 3; ++k) if (x > uX) discard;")));
}

TEST(LintLoops, WithoutAnEnd) {
    EXPECT_TRUE(told(looping("do x += 1.; while (true);")));
    EXPECT_TRUE(told(looping("while (true) x += 1.;")));
    EXPECT_TRUE(told(looping("for (;;) { x += 1.; }")));
    EXPECT_TRUE(told(looping("for (int i = 0; true; ++i) x += 1.;")));
    // They begin, and do not come nearer to their end.
    for (const char* loop : {"for (int i = 0; i < 10; --i) x += 1.;", "for (int i = 0; i < 10;) x += 1.;",
                             "for (float f = 1.; f > 0.; f += .1) x += f;", "int i = 0; while (i < 10) x += uX;",
                             "int i = 0; do { --i; } while (i < 70000);", "for (uint i = 3u; i >= 0u; --i) x += 1.;"})
        EXPECT_NE(looping(loop).text().find("for ever"), std::string::npos) << loop << looping(loop).text();
    // What becomes of the variable is computed as the shader would, overflow and rounding included.
    for (const char* loop :
         {"for (int i = 1; i < 100; i *= 2) { i = 1; }", "for (int i = 1; i != 100; i *= 2) x += 1.;",
          "for (float f = 1.; f >= 0.; f *= .5) x += f;", "for (int i = 0; i < 10; ++i) { x += 1.; i = 0; }",
          "int i = 0; while (i == 0) x += 1.;", "for (int i = 0; i < 10; i /= 2) { if (x > uX) continue; x += 1.; }",
          "float f = 16777216.; while (f < 20000000.) { f += 1.; x += f; }",
          "int i = 3; do { i -= 3; i += 3; } while (i > 0);", "for (uint i = 1u; i > 0u; i *= 65537u) x += 1.;"})
        EXPECT_NE(looping(loop).text().find("for ever"), std::string::npos) << loop << looping(loop).text();
    for (const char* loop : {"do x += 1.; while (1 > 0);", "bool go = true; while (go) x += 1.;", "while (GO) x += 1.;",
                             "for (bool b = true; b;) x += 1.;"})
        EXPECT_NE(looping(loop, "", "const bool GO = true;\n").text().find("for ever"), std::string::npos) << loop;
    EXPECT_NE(looping("for (float f = 0.; f != 1.; f += .1) x += f;").text().find("more than a million"),
              std::string::npos)
        << "ten tenths are not one";
    const auto endless = [](const std::string& loop) {
        return ranges::any_of(looping(loop).found.items(), never_ends);
    };
    EXPECT_TRUE(endless("while (true) x += 1.;"));
    EXPECT_FALSE(endless("for (int i = 0; i < 70000; ++i) x += 1.;"));
    for (const char* loop : {"for (int i = 3; i >= 0; --i) x += 1.;", "for (uint i = 3u; i > 0u; --i) x += 1.;",
                             "for (uint i = 3u; i >= 0u; --i) { if (x > uX) break; x += 1.; }"})
        EXPECT_FALSE(endless(loop)) << loop;
    EXPECT_NE(looping("while (true) x += 1.;").text().find("for ever"), std::string::npos);
}

// Only what is certain is told: neither what excludes each other nor what may run once is added up.
TEST(LintLoops, WhatMayNotRunIsJudgedByItself) {
    const std::string march =
        "float march(float y) { for (int k = 0; k < 40000; ++k) y += 1.; return y; }\n"
        "void kill() { discard; }\nvoid end() { kill(); }\n";
    for (const char* some :
         {"for (int i = 0; i < 300; ++i) { if (i == 5) for (int k = 0; k < 1000; ++k) x += 1.; }",
          "if (uX > 0.) for (int i = 0; i < 50000; ++i) x += 1.; else for (int i = 0; i < 50000; ++i) x += 2.;",
          "for (int i = 0; i < 40000; ++i) x += 1.; if (uX > 0.) for (int i = 0; i < 40000; ++i) x += 2.;",
          "for (int i = 0; i < 300; ++i) { if (i < 299) continue; for (int k = 0; k < 300; ++k) x += 1.; }",
          "x = uX > .9 ? march(1.) : march(2.);", "for (int i = 0; i < 65535; ++i) x += 1.;",
          "while (true) { x += .1; if (x > 3.) kill(); }", "while (true) { x += .1; if (x > 3.) end(); }",
          "bool go = true; while (go) { x += 1.; if (x > uX) go = false; }", "bool go = false; while (go) x += 1.;"})
        EXPECT_FALSE(told(looping(some, "", march))) << some << looping(some, "", march).text();
    EXPECT_TRUE(told(looping("if (uX > 0.) for (int i = 0; i < 70000; ++i) x += 1.;")));
    EXPECT_TRUE(told(looping("x += march(1.); x += march(2.);", "", march)));
}

TEST(LintLoops, WhatMayEndEarlierIsNotKnown) {
    for (const char* loop : {"while (true) { x += 1.; if (x > uX) break; }",
                             "if (false) while (true) x += 1.;",
                             "if (uX > 5.) { for (int i = 0; i < 10; i--) x += 1.; }",
                             "if (uX < 5.) x += 1.; else while (true) x += 1.;",
                             "if (uX < 5.) return; while (true) x += 1.;",
                             "for (int i = uM; i < uN; ++i) while (true) x += 1.;",
                             "for (int i = 0; i < 100000; ++i) { x += uX; if (x > 3.) break; }",
                             "for (int i = 0; i < 100000; ++i) { x += uX; if (x > 3.) discard; }",
                             "for (int i = 0; i < 100000; ++i) { ++i; i *= 2; }",
                             "for (int i = 0; i < 100000; ++i) { if (x > uX) i = 100000; else x += 1.; }",
                             "for (int i = 0; i < 100000; i += uM) x += 1.;",
                             "for (int i = 1; i < 1000000000; i *= 2) x += 1.;",
                             "for (int i = 1; i > 0; i *= 2) x += 1.;",
                             "for (float f = 1.; f > 0.; f *= .5) x += f;",
                             "for (float f = 0.; f != 1.; f += .125) x += f;",
                             "for (int i = 0; i != 40; i += 4) x += 1.;",
                             "int n = 100000; for (int i = 0; i < n; ++i) n /= 10;",
                             "int n = 10; while (0 < n) n -= 1;",
                             "for (int i = uM; i < uN; ++i) x += 1.;",
                             "while (x < uX) x += 1.;",
                             "do x += 1.; while (x < uX);",
                             "for (int i = 0; i < 8; ++i) for (int k = 0; k < 8; ++k) x += 1.;",
                             "int i = 0; while (i < 70000) { if (x > uX) ++i; x += 1.; }",
                             "int i = 0; while (i < 70000) { if (x > uX) continue; ++i; }",
                             "int i = 0; while (i < 70000) { ++i; if (x > uX) break; }",
                             "int i = 0; do { ++i; if (x > uX) return; } while (i < 70000);",
                             "int i = 0; do { ++i; i = i * 2; } while (i < 70000);",
                             "int i = 20; while (i < 10) x += 1.;",
                             "for (int i = 20; i < 10; --i) x += 1.;",
                             "for (int i = 0; i < 10;) { i = uM; x += 1.; }",
                             "for (int i = uM; i < 10; --i) x += 1.;",
                             "int i = 0; while (i < 70000) { for (int k = 0; k < uM; ++k) ++i; }",
                             "do { x += 1.; if (x > uX) break; } while (true);",
                             "for (int i = 0; i > 100000; ++i) x += 1.;",
                             "for (float f = 0.; f < 1.; f += .01) x += f;"})
        EXPECT_FALSE(told(looping(loop))) << loop << looping(loop).text();
}

}  // namespace
}  // namespace snell::lint
