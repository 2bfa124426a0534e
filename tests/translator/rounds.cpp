// Which loops count their rounds for OpenGL ES, so that no browser stands still.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

struct Loops {
    const char* body;  // of main
    // What a counting loop adds in each round; 0: none counts; -1: several do.
    int counts;
    const char* before = "";
    bool lasts = false;  // there are thousands of rounds, which are known
};

class Rounds : public testing::TestWithParam<Loops> {};

TEST_P(Rounds, AreCountedWhereNothingShowsThatTheyAreFew) {
    const auto& [body, counts, before, lasts] = GetParam();
    SCOPED_TRACE(body);
    const std::string text = "uniform int uN;\nuniform float uX;\n" + std::string(before) +
                             "void main() { float x = uX; int n = uN; " + body +
                             " gl_FragColor = vec4(x + float(n)); }\n";
    for (const Target& target : {es300, es320}) {
        const Translated t = fragment(text, target);
        EXPECT_EQ(!t.translation.long_loops.empty(), counts != 0 || lasts);
        EXPECT_EQ(t.has(Stage::fragment, "snell_Rounds"), counts != 0);
        if (counts > 0) {
            EXPECT_TRUE(t.has(Stage::fragment, "snell_round(" + std::to_string(counts) + ") < 262144"))
                << t.text(Stage::fragment);
        }
    }
    // Drivers of desktops end loops themselves, or nobody does.
    const Translated desktop = fragment(text, core450);
    EXPECT_EQ(!desktop.translation.long_loops.empty(), counts != 0 || lasts);
    EXPECT_FALSE(desktop.has(Stage::fragment, "snell_round"));
    expect_valid({{Stage::fragment, text}}, {es300, es320});
}

INSTANTIATE_TEST_SUITE_P(
    Rows, Rounds,
    testing::Values(
        Loops{"for (int i = 0; i < 8; ++i) x += 1.;", 0}, Loops{"for (int i = 8; i >= 0; i -= 2) x += 1.;", 0},
        Loops{"for (uint i = 0u; i < 8u; i++) { if (x > 3.) continue; x += 1.; if (x > 9.) break; }", 0},
        Loops{"for (float t = 0.; t < 1.; t += .01) x += t;", 0}, Loops{"int i; for (i = 1; i <= 70; i++) x += 1.;", 0},
        Loops{"for (int i = 0; i < N; ++i) x += 1.;", 0, "#define N 12\n"},
        Loops{"for (int i = 0; i < N * 2; ++i) x += 1.;", 0, "const int N = 3 * 4;\n"},
        Loops{"for (int i = 0; i < 250; ++i) for (int k = 0; k < 250; ++k) x += 1.;", 0, "", true},
        Loops{"for (int i = 0; i < 250; ++i) x = f(x);", 0,
              "float f(float x) { for (int i = 0; i < 250; ++i) x += 1.; return x; }\n", true},
        Loops{"for (int i = n; i < n + 16; ++i) x += 1.;", 0},
        Loops{"for (int i = 0; i < 6 && x < 9.; ++i) x += 1.;", 0},
        Loops{"for (int i = 0; (x < 9. && (i < 6)); ++i) x += 1.;", 0},
        Loops{"for (float t = 0.; t < 9.; t += max(uX, .1)) x += t;", 0},
        Loops{"for (float t = 9.; t > 0.; t -= .5 * max(uX, .1)) x += t;", 0},
        Loops{"for (int i = 0; 6 > i; i = i + 1) x += 1.;", 0},
        Loops{"for (int i = 9; (0 <= i); i = i - 2) x += 1.;", 0},
        // Nothing ends them.
        Loops{"while (true) x += 1.;", 1}, Loops{"while (true) { x += 1.; if (x < 0.) break; }", 1},
        Loops{"for (;;) { x += 1.; if (x < 0.) break; }", 1}, Loops{"do x += 1.; while (x > 0.);", 1},
        Loops{"for (int i = 0; i < 10; ) { x += 1.; if (x < 0.) break; }", 1},
        Loops{"while (bool b = x < 9.) x += 1.;", 1}, Loops{"while (bool b = x < 9.) { x += 1.; }", 1},
        Loops{"while (n++ < 9) ;", 1}, Loops{"float min = 1.; while (x < min) x += min;", 1},
        // The counter is not only counted.
        Loops{"for (int i = 0; i < 10; ++i) i -= n;", 1},
        Loops{"for (int i = 0; i < 10; ++i) back(i);", 1, "void back(inout int i) { --i; }\n"},
        Loops{"for (int i = 0; i < 10; --i) x += 1.;", 1}, Loops{"for (int i = 0; i < 10; i *= 2) x += 1.;", 1},
        Loops{"for (int i = 0; 6 > i; i = i - 1) x += 1.;", 1}, Loops{"for (int i = 9; 6 > n; ++i) x += 1.;", 1},
        Loops{"for (int i = 0; i < 6; i = 2 - i) x += 1.;", 1}, Loops{"for (int i = 0; i < 6; i <<= 1) x += 1.;", 1},
        Loops{"for (float t = 1e8; t < 1.00001e8; t += 1.) x += 1.;", 1},
        Loops{"for (int i = n; i < n + 16; ++i) ++n;", 1}, Loops{"for (int i = 0; i < 6 || x < 9.; ++i) x += 1.;", 1},
        Loops{"for (float t = x; t < x + 16.; ++t) n++;", 1},
        // Nobody knows how far it counts, or very far.
        Loops{"for (int i = 0; i < uN; ++i) x += 1.;", 1}, Loops{"for (int i = n; i < 10; ++i) x += 1.;", 1},
        Loops{"for (float t = 0.; t < 10.; t += uX) x += t;", 1},
        Loops{"for (int i = 0; i < 70000; ++i) x += 1.;", 0, "", true},
        Loops{"for (int i = 0; i < 270000; ++i) x += 1.;", 1},
        Loops{"for (float t = 0.; t < 10.; t += .00001) x += t;", 1},
        Loops{"for (float t = 0.; t < 10.; t += min(uX, .1)) x += t;", 1},
        Loops{"for (float t = 0.; t < 10.; t -= max(uX, .1)) x += t;", 1},
        Loops{"for (float t = 0.; t < 1e9; t += max(uX, .1)) x += t;", 1},
        Loops{"for (int i = 0; i < 600; ++i) for (int k = 0; k < 600; ++k) x += 1.;", 602},
        Loops{"for (int i = 0; i < 600; ++i) x = f(x);", 602,
              "float f(float x) { for (int i = 0; i < 600; ++i) x += 1.; return x; }\n"},
        Loops{"while (x < 1.) for (int k = 0; k < 5; ++k) x += .1;", 7},
        Loops{"while (x < 1.) while (x < 1.) x += 1.;", -1},
        // What nobody calls.
        Loops{"x += 1.;", 0, "float f(float x) { while (true) x += 1.; return x; }\n"}));

// A picture of fewer pixels has as many vertices.
TEST(GlslRounds, ThoseOfVerticesAreAskedAboutOnlyWhereTheyCount) {
    const std::string text =
        "uniform int uN;\nvoid main() { float x = 0.; for (int i = 0; i < uN; ++i) x += .1; gl_Position = vec4(x); }\n";
    EXPECT_FALSE(vertex(text, es300).translation.long_loops.empty());
    EXPECT_TRUE(vertex(text, core450).translation.long_loops.empty());
}

// A settled uniform is a number of the text.
TEST(GlslRounds, ASettledBoundIsKnown) {
    Options options;
    options.target = es300;
    for (const double value : {12., 1e6}) {
        options.settle = [&](std::span<const DeclaredUniform>) { return std::vector<Settled>{{"uN", {value}}}; };
        Translated t;
        translate_texts(t,
                        {{Stage::fragment,
                          "uniform int uN;\nvoid main() { float x = 0.; for (int i = 0; i < uN; ++i) x += .1; "
                          "gl_FragColor = vec4(x); }\n"}},
                        options);
        EXPECT_EQ(t.translation.settled.size(), 1u);
        EXPECT_EQ(!t.translation.long_loops.empty(), value > 1e5) << t.text(Stage::fragment);
    }
}

struct Bounded {
    const char* body;  // of main
    double up_to;      // what the uniforms may be
    std::vector<std::string> bounds = {};
    const char* before = "";
};

class RoundsByUniforms : public testing::TestWithParam<Bounded> {};

TEST_P(RoundsByUniforms, AreFewUpToAValue) {
    const auto& [body, up_to, bounds, before] = GetParam();
    SCOPED_TRACE(body);
    const std::string text = "uniform int uN;\nuniform uint uU;\nuniform float uX;\n" + std::string(before) +
                             "void main() { float x = uX; int n = uN; " + body + " gl_FragColor = vec4(x); }\n";
    const Translated t = fragment(text, es300);
    ASSERT_EQ(t.translation.long_loops.size(), 1u);
    const LongLoops& found = t.translation.long_loops.front();
    EXPECT_EQ(found.up_to, up_to);
    EXPECT_EQ(found.bounds, bounds);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, RoundsByUniforms,
    testing::Values(Bounded{"for (int i = 0; i < uN; ++i) x += 1.;", 256, {"uN"}},
                    Bounded{"for (uint i = 0u; i < uU; ++i) x += 1.;", 256, {"uU"}},
                    Bounded{"for (int i = uN; i >= 0; i -= 4) x += 1.;", 512, {"uN"}},
                    Bounded{"for (float t = 0.; t < uX; t += .01) x += 1.;", 4, {"uX"}},
                    Bounded{"for (int i = 0; i < uN; ++i) for (int k = -uN; k <= uN; ++k) x += 1.;", 8, {"uN"}},
                    Bounded{"for (int i = 0; i < uN; ++i) for (float t = 0.; t < uX; ++t) x += 1.;", 16, {"uN", "uX"}},
                    Bounded{"for (int i = 0; i < n; ++i) x += 1.;", 256, {"uN"}},
                    Bounded{"int most = int(uX * 10.) + 1; for (int i = 0; i < most; ++i) x += 1.;", 32, {"uX"}},
                    Bounded{"for (int i = 0; i < 2 * (uN - 1); ++i) x += 1.;", 128, {"uN"}},
                    Bounded{"for (int i = 0; i < uN; ++i) { if (x > 9.) break; x += f(x); }",
                            16,
                            {"uN"},
                            "float f(float x) { for (int k = 0; k < uN; ++k) x += 1.; return x; }\n"},
                    Bounded{"for (int i = 0; i < max(uN, 10); ++i) x += 1.;", 256, {"uN"}},
                    // Whatever they are.
                    Bounded{"while (x < uX) x += 1.;", -1}, Bounded{"for (float t = 0.; t < 9.; t += uX) x += 1.;", -1},
                    Bounded{"for (int i = 0; i < n; ++i) ++n;", -1},
                    Bounded{"for (int i = 0; i < uN; i += uN) x += 1.;", -1},
                    Bounded{"for (uint i = 0u; i < uint(uN); ++i) x += 1.;", -1},
                    Bounded{"for (uint i = 0u; i < uU - 1u; ++i) x += 1.;", -1},
                    Bounded{"for (int i = 0; i < 9000; ++i) x += uX;", -1},
                    Bounded{"for (int i = 0; i < uN; ++i) while (x < 9.) x += uX;", -1},
                    Bounded{"for (int i = 0; i < int(1. / uX); ++i) x += 1.;", -1}));

TEST(GlslRounds, ABoundThatIsClampedIsKnown) {
    const auto counts = [](const std::string& bound) {
        return !fragment("uniform int uN;\nvoid main() { float x = 0.; for (int i = 0; i < " + bound +
                             "; ++i) x += .1; gl_FragColor = vec4(x); }\n",
                         es300)
                    .translation.long_loops.empty();
    };
    EXPECT_FALSE(counts("min(uN, 100)"));
    EXPECT_FALSE(counts("clamp(uN, 1, 100)"));
    EXPECT_TRUE(counts("min(uN, 5000)"));
    EXPECT_TRUE(counts("max(uN, 100)"));
}

}  // namespace
}  // namespace snell::glsl::test
