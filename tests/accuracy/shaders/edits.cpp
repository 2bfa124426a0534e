// Cheaper changes of shaders: for each kind the exact edit, and what must be left alone.
#include "src/accuracy/found/change.h"
#include "src/accuracy/found/shaders/shader.h"
#include "tests/accuracy/shaders/help.h"

namespace snell::accuracy::test {
namespace {

using enum ChangeKind;
using Lines = std::vector<std::string>;

std::string in_main(const std::string& statements, const std::string& ahead = "") {
    return "varying vec3 vN, vP;\nvarying vec2 vST;\nuniform float uA, uB;\nuniform int uSteps;\nuniform vec3 "
           "uLight;\n" +
           ahead + "void main() {\n    vec3 color = vec3(0.);\n" + statements +
           "\n    gl_FragColor = vec4(color, 1.);\n}\n";
}

class Rounds : public FoundShaders {
protected:
    Lines lines(const std::string& statements, const std::string& ahead = "") {
        return shaders(in_main(statements, ahead)).lines(fewer_rounds);
    }
};

TEST_F(Rounds, ANumberBoundsTheLoop) {
    EXPECT_EQ(lines("for (int i = 0; i < 64; i++) color += vN;"), (Lines{"i < 64 → i < 32", "i < 64 → i < 16"}));
    EXPECT_EQ(lines("for (int i = 1; i <= 6; ++i) color += vN;"), (Lines{"i <= 6 → i <= 3", "i <= 6 → i <= 1"}));
    EXPECT_EQ(lines("for (float t = 0.; t < 2.; t += .1) color += vN;"),
              (Lines{"t < 2. → t < 1.", "t < 2. → t < 0.5"}));
    EXPECT_EQ(lines("for (int i = 10; i < 20; i += 2) color += vN;"), (Lines{"i < 20 → i < 14", "i < 20 → i < 12"}));
    EXPECT_EQ(lines("for (int i = 0; 8 > i; i++) color += vN;"), (Lines{"8 > i → 4 > i", "8 > i → 2 > i"}));
    EXPECT_EQ(lines("int i; for (i = 0; i < 8 && color.x < 1.; i++) color += vN;"),
              (Lines{"i < 8 → i < 4", "i < 8 → i < 2"}));
    EXPECT_EQ(lines("for (int i = 0; i < 1; i++) color += vN;"), Lines{}) << "one round is the least";
    EXPECT_EQ(lines("for (int i = 0; i < 3; i++) color += vN;"), Lines{"i < 3 → i < 1"});
    EXPECT_EQ(lines("for (int i = 0; i != 8; i += 2) color += vN;"), Lines{}) << "it would never end";
}

TEST_F(Rounds, WhatTheRungNeverRunsIsNotOffered) {
    const auto looping = [](const std::string& name, const std::string& rounds) {
        return "float " + name + "(float c) {\n    float s = 0.;\n    for (int i = 0; i < " + rounds +
               "; i++) s += c * vN.x;\n    return s;\n}\n";
    };
    const std::string functions = looping("exact", "64") + looping("helper", "50") + looping("schlick", "32") +
                                  "float other(float c) { return helper(c); }\n";
    for (const std::string choice :
         {"#if FRESNEL == FRESNEL_exact\ncolor.x = exact(vN.z) + other(1.);\n#else\ncolor.x = schlick(vN.z);\n#endif",
          "if (FRESNEL == FRESNEL_exact) color.x = exact(vN.z) + other(1.); else color.x = schlick(vN.z);",
          "color.x = FRESNEL != FRESNEL_exact ? schlick(vN.z) : exact(vN.z) + other(1.);"})
        for (const auto& [ladder, rounds] : {std::pair("Ladder FRESNEL <schlick> exact", std::vector{"32"}),
                                             {"Ladder FRESNEL schlick <exact>", std::vector{"64", "50"}}}) {
            Found& found = shaders(in_main(choice, functions), "", ladder);
            found.changes = find_changes(found.plan, *found.files, found.sources);
            std::set<std::string> changed, wanted;
            for (const char* round : rounds) wanted.insert("i < " + std::string(round));
            for (const Change* change : found.of(fewer_rounds)) changed.insert(change->before);
            EXPECT_EQ(changed, wanted) << ladder << "\n" << choice;
        }
}

TEST_F(Rounds, ALoopThatCountsDownBeginsLower) {
    Found& found = shaders(in_main("for (int i = 32; i > 0; --i) color += vN;"));
    ASSERT_EQ(found.of(fewer_rounds).size(), 2U);
    EXPECT_NE(found.changed(*found.of(fewer_rounds)[0], "a.frag").find("int i = 16; i > 0"), std::string::npos);
    EXPECT_EQ(found.lines(fewer_rounds), (Lines{"i = 32 → i = 16", "i = 32 → i = 8"})) << "what changes is shown";
    EXPECT_EQ(
        found_->sources.text(found.of(fewer_rounds)[0]->where.file).substr(found.of(fewer_rounds)[0]->where.begin, 6),
        "i = 32");
    EXPECT_EQ(lines("int i; for (i = 8; i > 0; i--) color += vN;"), (Lines{"i = 8 → i = 4", "i = 8 → i = 2"}));
}

class Levels : public FoundShaders {
protected:
    // With these statements in the control shader.
    Found& control(const std::string& levels) {
        return scene(
            "Vertex a.vert\nTessControl a.tcs\nTessEvaluation a.tes\nFragment a.frag\nProgram P uLevel <1. 4. 9.>\n"
            "NumPatchVertices 3\nglBegin gl_patches\nglVertex 0 0\nglVertex 1 0\nglVertex 0 1\nglEnd\n",
            {{"a.vert", "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n"},
             {"a.tcs", "#version 400 compatibility\nlayout(vertices = 3) out;\nuniform float uLevel;\nvoid main() {\n" +
                           levels +
                           "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n}\n"},
             {"a.tes",
              "#version 400 compatibility\nlayout(triangles) in;\nvoid main() { gl_Position = "
              "gl_in[0].gl_Position * gl_TessCoord.x; }\n"},
             {"a.frag", "#version 400 compatibility\nvoid main() { gl_FragColor = vec4(1.); }\n"}});
    }
};

TEST_F(Levels, OfTessellationShrinkTogether) {
    Found& found = control(
        "    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = uLevel;\n"
        "    gl_TessLevelOuter[2] = uLevel + 1.;\n    gl_TessLevelInner[0] = 8.; // inside\n");
    ASSERT_EQ(found.of(lower_levels).size(), 3U);
    const std::string half = found.changed(*found.of(lower_levels)[1], "a.tcs");
    for (const std::string_view line :
         {"= gl_TessLevelOuter[1] = 0.5*uLevel;", "gl_TessLevelOuter[2] = 0.5*(uLevel + 1.);",
          "gl_TessLevelInner[0] = 0.5*8.; // inside"})
        EXPECT_NE(half.find(line), std::string::npos) << half;
    EXPECT_EQ(translation_errors(found, found.of(lower_levels)), "");
}

// What is read of another level is that share of it already.
TEST_F(Levels, AreNotMultipliedTwice) {
    const std::string outer =
        "    gl_TessLevelOuter[0] = uLevel;\n    gl_TessLevelOuter[1] = uLevel;\n    gl_TessLevelOuter[2] = uLevel;\n";
    for (const std::string copy :
         {"gl_TessLevelInner[0] = gl_TessLevelOuter[2];", "gl_TessLevelInner[0] = (gl_TessLevelOuter[2]);"}) {
        Found& found = control(outer + "    " + copy + "\n");
        ASSERT_EQ(found.of(lower_levels).size(), 3U) << copy;
        const std::string half = found.changed(*found.of(lower_levels)[1], "a.tcs");
        EXPECT_NE(half.find("gl_TessLevelOuter[2] = 0.5*uLevel;"), std::string::npos) << half;
        EXPECT_NE(half.find(copy), std::string::npos) << half;
    }
    for (const std::string mixed :
         {"gl_TessLevelInner[0] = max(gl_TessLevelOuter[1], 2.);", "gl_TessLevelInner[0] = .5 * gl_TessLevelOuter[1];",
          "float most = gl_TessLevelOuter[1]; gl_TessLevelInner[0] = most;",
          "gl_TessLevelInner[0] = 1.; gl_TessLevelInner[0] += uLevel;"})
        EXPECT_TRUE(control(outer + "    " + mixed + "\n").of(lower_levels).empty()) << mixed;
}

TEST_F(Rounds, AConstantIsChangedWhereItIsDefined) {
    EXPECT_EQ(lines("for (int i = 0; i < N; i++) color += vN / float(N);", "const int N = 64;\n"),
              (Lines{"N = 64 → N = 32", "N = 64 → N = 16"}));
    EXPECT_EQ(lines("for (int i = 0; i < STEPS; i++) color += vN / float(STEPS);", "#define STEPS 40 // many\n"),
              (Lines{"#define STEPS 40 → #define STEPS 20", "#define STEPS 40 → #define STEPS 10"}));
    EXPECT_EQ(lines("for (int i = 0; i < N; i++) color += w[i] * vN;",
                    "#version 330 compatibility\nconst int N = 4;\nconst float w[N] = float[N](1., 2., 3., 4.);\n"),
              (Lines{"i < N → i < N/2", "i < N → i < N/4"}))
        << "an array has as many elements";
    EXPECT_EQ(lines("for (int i = 0; i < STEPS; i++) color += vN;",
                    "#ifdef X\n#define STEPS 40\n#else\n#define STEPS 8\n#endif\n"),
              (Lines{"#define STEPS 8 → #define STEPS 4", "#define STEPS 8 → #define STEPS 2"}))
        << "the definition that counts";
    EXPECT_EQ(
        lines("for (int i = 0; i < STEPS; i++) color += w[i] * vN;",
              "#version 330 compatibility\n#define STEPS 4\nconst float w[STEPS] = float[STEPS](1., 2., 3., 4.);\n"),
        (Lines{"STEPS → STEPS/2", "STEPS → STEPS/4"}))
        << "an array has as many elements";
    EXPECT_EQ(lines("for (int i = 0; i < STEPS; i++) color += vN;", "#define STEPS 1\n"), Lines{});
}

TEST_F(Rounds, AMacroThatIsMoreThanTheNumberStays) {
    EXPECT_EQ(lines("LOOP { color += vN; }", "#define LOOP for (int i = 0; i < 32; i++)\n"), Lines{});
    EXPECT_EQ(lines("for (int i = 0; i < TO color += vN;", "#define TO 32; i++)\n"), Lines{});
    EXPECT_EQ(lines("for (int i = 0; i < STEPS; i++) color += vN;", "#define STEPS ((32))\n"),
              (Lines{"STEPS → STEPS/2", "STEPS → STEPS/4"}));
}

// What is undefined is 0 on some drivers.
TEST_F(Rounds, EveryElementIsWritten) {
    EXPECT_EQ(lines("float a[8]; for (int i = 0; i < 8; i++) a[i] = 1.; color += a[3];"), Lines{});
    EXPECT_EQ(lines("float a[8]; for (int i = 0; i < 8; i++) { int k = 7 - i; a[k] = 1.; }"), Lines{});
    EXPECT_EQ(lines("float a[8]; int n = 0; for (int i = 0; i < 8; i++) a[n++] = 1.;"), Lines{});
    EXPECT_EQ(lines("float a[8]; for (int i = 0; i < 8; i++) set(a[i]);", "void set(out float x) { x = 1.; }\n"),
              Lines{});
    EXPECT_EQ(lines("mat3 m; for (int i = 0; i < 3; i++) for (int j = 0; j < 3; j++) m[i][j] = 1.; color = m * vN;"),
              Lines{});
    EXPECT_EQ(lines("float a[9]; for (int i = 0; i < N; i++) a[i] = 1.; for (int i = 0; i < N; i++) color += vN;",
                    "const int N = 8;\n"),
              (Lines{"i < N → i < N/2", "i < N → i < N/4"}))
        << "the other loop alone";
    EXPECT_EQ(lines("float a[8]; for (int i = 0; i < 8; i++) color += a[i];"),
              (Lines{"i < 8 → i < 4", "i < 8 → i < 2"}))
        << "reading needs no round";
}

TEST_F(Rounds, AUniformIsDividedWhereverTheFunctionReadsIt) {
    EXPECT_EQ(lines("for (int i = 0; i < uSteps; i++) color += vN;"),
              (Lines{"i < uSteps → i < (uSteps+1)/2", "i < uSteps → i < (uSteps+3)/4"}));
    Found& found = shaders(in_main("for (int i = 0; i < uSteps; i++) color += vN / float(uSteps);"));
    ASSERT_EQ(found.of(fewer_rounds).size(), 2U);
    EXPECT_NE(found.changed(*found.of(fewer_rounds)[0], "a.frag")
                  .find("for (int i = 0; i < (uSteps+1)/2; i++) color += vN / float(((uSteps+1)/2));"),
              std::string::npos);
    EXPECT_EQ(lines("for (float t = 0.; t < uA + 1.; t += .01) color += vN;").front(),
              "t < uA + 1. → t < .5*(uA + 1.)");
}

TEST_F(Rounds, ALocalIsChangedWhereItBegins) {
    EXPECT_EQ(lines("int n = 1 << uSteps; float d = 1. / float(n); for (int i = 0; i < n; i++) color += d * vN;"),
              (Lines{"n = 1 << uSteps → n = ((1 << uSteps)+1)/2", "n = 1 << uSteps → n = ((1 << uSteps)+3)/4"}));
    EXPECT_EQ(lines("int n = 9; float d = 1. / float(n); for (int i = 0; i < n; i++) color += d * vN;"),
              (Lines{"n = 9 → n = 4", "n = 9 → n = 2"}));
    EXPECT_EQ(lines("int n = 1; for (int i = 0; i < n; i++) color += vN;"), Lines{}) << "one round stays";
    EXPECT_EQ(lines("int n = uSteps; n += 2; for (int i = 0; i < n; i++) color += vN;"),
              (Lines{"i < n → i < (n+1)/2", "i < n → i < (n+3)/4"}))
        << "where it is assigned again, the loop's own bound changes";
}

TEST_F(Rounds, AMeanOfADefinedNumberStaysAMean) {
    const auto text = [&](const std::string& body, const std::string& ahead) {
        Found& found = shaders(in_main(body, ahead));
        return found.of(fewer_rounds).empty() ? std::string() : found.changed(*found.of(fewer_rounds)[0], "a.frag");
    };
    const std::string loop = "vec3 s = vec3(0.); for (int i = 0; i < K; i++) s += vN / 16.; color = s;";
    EXPECT_NE(text(loop, "const int K = 16;\n").find("s += vN / 8.;"), std::string::npos);
    EXPECT_NE(text(loop, "#define K 16\n").find("s += vN / 8.;"), std::string::npos);
    EXPECT_NE(text("int K = 16; vec3 s = vec3(0.); for (int i = 0; i < K; i++) s += vN; s /= 16.; color = s;", "")
                  .find("s /= 8.;"),
              std::string::npos);
}

// A triangle of one vertex is none.
TEST_F(Rounds, VerticesOfAPrimitiveStay) {
    EXPECT_EQ(lines("for (int i = 0; i < 3; i++) { color += vN; EmitVertex(); }", "void EmitVertex() {}\n"), Lines{});
}

// A slider at 1 leaves one round, not none.
TEST_F(Rounds, AShareOfAnUnknownNumberIsRoundedUp) {
    EXPECT_EQ(lines("for (uint i = 0u; i < uCount; i++) color += vN;", "uniform uint uCount;\n"),
              (Lines{"i < uCount → i < (uCount+1u)/2u", "i < uCount → i < (uCount+3u)/4u"}));
}

TEST_F(Rounds, AMeanStaysAMean) {
    Found& found = shaders(in_main("for (int i = 0; i < 16; i++) color += vN;\ncolor /= 16.;"));
    ASSERT_EQ(found.of(fewer_rounds).size(), 2U);
    const std::string half = found.changed(*found.of(fewer_rounds)[0], "a.frag");
    EXPECT_NE(half.find("i < 8;"), std::string::npos);
    EXPECT_NE(half.find("color /= 8.;"), std::string::npos) << half;
}

// What follows the rounds is what divides the loop's own sum, and nothing else.
TEST_F(Rounds, OtherDivisorsOfTheSameValueStay) {
    const auto half = [&](const std::string& statements) {
        Found& found = shaders(in_main(statements));
        return found.of(fewer_rounds).empty() ? std::string() : found.changed(*found.of(fewer_rounds)[0], "a.frag");
    };
    const std::string loop = "for (int i = 0; i < 4; i++) color += vN;\n";
    for (const char* mean : {"color = color / 4.;", "color *= 1. / 4.;", "color = vP * (color / 4.);",
                             "color.xy /= 4.;", "color = (color * 2.) / 4.;"}) {
        const std::string text = half(loop + mean);
        EXPECT_EQ(text.find("4."), std::string::npos) << text;
        EXPECT_NE(text.find("2."), std::string::npos) << text;
    }
    EXPECT_NE(half("for (int i = 0; i < 4; i++) color += vN / 4.;").find("vN / 2."), std::string::npos);
    for (const char* other :
         {"color = floor(color * 4.) / 4.;", "color = vP / 4.;", "color = vN; color /= 4.;", "color += vN / 4.;",
          "for (int k = 0; k < 2; k++) color += vP * (1. / 4.);", "color = vec3(4.);", "vec3 d = vN; d /= 4.;"}) {
        const std::string text = half(loop + other);
        EXPECT_NE(text.find("i < 2;"), std::string::npos) << text;
        EXPECT_NE(text.find(other), std::string::npos) << text;
    }
    EXPECT_NE(half("color = vN / 4.;\n" + loop).find("color = vN / 4.;"), std::string::npos);
}

// The first edit is on the line of the change, and each other one on its own.
TEST_F(Rounds, EveryEditIsPrintedWithItsPlace) {
    Found& found = shaders(in_main("for (int i = 0; i < 16; i++) color += vN;\ncolor /= 16.;"));
    ASSERT_FALSE(found.of(fewer_rounds).empty());
    const std::string line = change_line(*found.of(fewer_rounds)[0], found.sources);
    EXPECT_NE(line.find("i < 16 → i < 8\n    and "), std::string::npos) << line;
    EXPECT_NE(line.find(": 16. → 8."), std::string::npos) << line;
}

TEST_F(Rounds, CallsDecideOnTheRoundsOfLibraryFunctions) {
    const Lines found = lines("color += snellFractalNoise(vP, 6);", "#include <snell/noise.glsl>\n");
    EXPECT_EQ(found, (Lines{"snellFractalNoise(vP, 6) → snellFractalNoise(vP, 3)",
                            "snellFractalNoise(vP, 6) → snellFractalNoise(vP, 1)"}));
    const Lines handed = lines("color += g(8);",
                               "float f(int n) { float s = 0.; for (int i = 0; i < n; i++) s += vN.x; return s; }\n"
                               "float g(int m) { return f(m); }\n");
    EXPECT_NE(std::find(handed.begin(), handed.end(), "g(8) → g(4)"), handed.end());
}

TEST_F(FoundShaders, TermsOfSumsAreLeftOut) {
    EXPECT_EQ(shaders(in_main("color = uLight * uA + normalize(vN) - vP * vP;")).lines(without_term),
              (Lines{"uLight * uA + normalize(vN) - vP * vP → normalize(vN) - vP * vP",
                     "uLight * uA + normalize(vN) - vP * vP → uLight * uA - vP * vP",
                     "uLight * uA + normalize(vN) - vP * vP → uLight * uA + normalize(vN)"}));
    EXPECT_EQ(shaders(in_main("color = vN * vN - vP * vP;")).lines(without_term),
              (Lines{"vN * vN - vP * vP → - vP * vP", "vN * vN - vP * vP → vN * vN"}));
    Found& returned = shaders(
        "varying vec3 vN;\nfloat f() { return(sin(vN.x)) + cos(vN.y); }\n"
        "void main() { gl_FragColor = vec4(f()); }\n");
    const Change* left = returned.find(without_term, "sin", "cos(vN.y)");
    ASSERT_NE(left, nullptr);
    EXPECT_NE(returned.changed(*left, "a.frag").find("{ return cos(vN.y); }"), std::string::npos);
    EXPECT_EQ(shaders(in_main("color = 1. + sin(vN);")).lines(without_term), Lines{})
        << "a number alone has another type, and costs nothing";
    EXPECT_EQ(shaders(in_main("color = uA * (vN * vP + sin(vN));")).lines(without_term).size(), 2U);
    EXPECT_EQ(shaders(in_main("color = clamp(sin(vN) + cos(vP), 0., 1.);")).lines(without_term).size(), 2U);
    EXPECT_EQ(shaders(in_main("int n = 1 + uSteps; color = vec3(float(n));")).lines(without_term), Lines{});
}

// Work on a local is only saved if nothing else reads it.
TEST_F(FoundShaders, ATermSavesALocalThatNothingElseReads) {
    const std::string_view lookup = "vec4 n = sin(vN.xyzx); ";
    EXPECT_EQ(shaders(in_main(std::string(lookup) + "color = vec3(n.x + n.y + vN.x);")).lines(without_term), Lines{});
    EXPECT_EQ(shaders(in_main(std::string(lookup) + "color = vec3(n.x + vN.x);")).lines(without_term),
              (Lines{"n.x + vN.x → vN.x"}));
}

TEST_F(FoundShaders, StatementsThatAddAreLeftOut) {
    Found& found = shaders(in_main("color = vN;\n    color += sin(vP);\n    if (uA > 0.)\n        color -= cos(vP);"));
    ASSERT_EQ(found.of(without_term).size(), 2U);
    EXPECT_NE(found.changed(*found.of(without_term)[0], "a.frag").find("color = vN;\n    \n    if"), std::string::npos);
    EXPECT_NE(found.changed(*found.of(without_term)[1], "a.frag").find("if (uA > 0.)\n        ;\n"), std::string::npos);
}

TEST_F(FoundShaders, StatementsThatAddToNothingStay) {
    EXPECT_EQ(shaders(in_main("vec3 r; r.x = 0.; r += sin(vP); color = r;")).lines(without_term), Lines{});
    EXPECT_EQ(shaders(in_main("vec3 r; r = vec3(0.); r += sin(vP); color = r;")).lines(without_term),
              Lines{"r += sin(vP); → "});
}

TEST_F(FoundShaders, LoopsMustEnd) {
    EXPECT_EQ(shaders(in_main("float t = 0.;\nwhile (t < 9.) { t += .1 + abs(vN.x); color = color + vN * t; }"))
                  .lines(without_term),
              Lines{});
    EXPECT_EQ(
        shaders(in_main("float t = 0.;\nfor (int i = 0; i < 9 && t < 3.; i++) t += .1 + abs(vN.x);\ncolor = vec3(t);"))
            .lines(without_term),
        Lines{});
}

TEST_F(FoundShaders, FunctionsThatMayEndALoopStay) {
    EXPECT_EQ(shaders(in_main("float t = 0.;\nwhile (exp(-t) > .00001) t += .5;\ncolor = vec3(t);")).lines(polynomial),
              Lines{})
        << "the polynomial never gets as small";
    EXPECT_EQ(shaders(in_main("for (int i = 0; i < 9; i++) color += exp(-vP * vP);")).lines(polynomial).size(), 1U);
}

TEST_F(FoundShaders, BlendsBecomeEitherSide) {
    EXPECT_EQ(shaders(in_main("color = mix(vN, vP * uA, uB);")).lines(without_term),
              (Lines{"mix(vN, vP * uA, uB) → vN", "mix(vN, vP * uA, uB) → (vP * uA)"}));
}

constexpr std::string_view sampled =
    "uniform sampler2D uTexUnit;\nvarying vec2 vST;\nvoid main() {\n    gl_FragColor = texture2D(uTexUnit, vST);\n}\n";

// A bitmap of 2 by 1 pixels: (51, 102, 153) and (255, 0, 51).
std::string bitmap() {
    const auto little = [](std::uint32_t n, int bytes) {
        std::string text;
        for (int k = 0; k < bytes; ++k) text += static_cast<char>(n >> 8 * k & 255);
        return text;
    };
    return "BM" + little(62, 4) + little(0, 4) + little(54, 4) + little(40, 4) + little(2, 4) + little(1, 4) +
           little(1, 2) + little(24, 2) + little(0, 4) + little(8, 4) + little(2835, 4) + little(2835, 4) +
           little(0, 4) + little(0, 4) + std::string("\x99\x66\x33\x33\x00\xff\x00\x00", 8);
}

TEST_F(FoundShaders, LookupsBecomeTheMeanOfTheTexture) {
    const std::vector<File> files{{"two.bmp", bitmap()}};
    EXPECT_EQ(shaders(sampled, "uTexUnit 5", "Texture2D 5 two.bmp", files).lines(lookup_mean),
              Lines{"texture2D(uTexUnit, vST) → vec4(0.6, 0.2, 0.4, 1.)"});
    // Encoded: light is the mean of .0331 and 1; .1329 and 0; .3185 and .0331.
    EXPECT_EQ(shaders(sampled, "uTexUnit 5", "Texture2D 5 two.bmp srgb", files).lines(lookup_mean),
              Lines{"texture2D(uTexUnit, vST) → vec4(0.5166, 0.06643, 0.1758, 1.)"});
    EXPECT_EQ(shaders(sampled, "uTexUnit 5", "Texture2D 5 64 64").lines(lookup_mean), Lines{})
        << "its texels are not known before it is drawn";
    EXPECT_EQ(shaders("uniform sampler2D uTexUnit;\nvarying vec2 vST;\n"
                      "vec3 seen(sampler2D s, vec2 st) { return texture2D(s, st).rgb; }\n"
                      "void main() {\n    gl_FragColor = vec4(seen(uTexUnit, vST), 1.);\n}\n",
                      "uTexUnit 5", "Texture2D 5 two.bmp", files)
                  .lines(lookup_mean),
              Lines{"texture2D(s, st) → vec4(0.6, 0.2, 0.4, 1.)"})
        << "a parameter is what all calls hand on";
}

TEST_F(FoundShaders, MacrosAndOtherTextsAreLeftAlone) {
    EXPECT_EQ(shaders(in_main("color = BOTH(vN, vP);", "#define BOTH(a, b) (sin(a) + cos(b))\n")).lines(without_term),
              Lines{});
    EXPECT_EQ(shaders(in_main("color = sin(vN)\n#ifdef X\n * 2.\n#endif\n + cos(vP);")).lines(without_term), Lines{})
        << "a directive is within";
    for (const Change& change :
         shaders(in_main("color = vec3(snellFractalNoise(vP, 6));", "#include <snell/noise.glsl>\n")).changes)
        for (const Edit& edit : change.edits) EXPECT_NE(found_->sources.name(edit.span.file), "snell/noise.glsl");
}

TEST_F(FoundShaders, IncludedFilesOfTheAuthorAreEditedOnce) {
    const std::vector<File> files{{"light.glsl", "vec3 light(vec3 n) { return sin(n) + cos(n); }\n"},
                                  {"b.frag", in_main("color = light(vP);", "#include \"light.glsl\"\n")}};
    Found& found = shaders(in_main("color = light(vN);", "#include \"light.glsl\"\n"), "",
                           "Vertex a.vert\nFragment b.frag\nProgram B\nSphere 1.\n", files);
    EXPECT_EQ(found.lines(without_term), (Lines{"sin(n) + cos(n) → cos(n)", "sin(n) + cos(n) → sin(n)"}))
        << "both programs have the same file";
}

TEST_F(FoundShaders, ProgramsThatDrawNothingAreLeftAlone) {
    EXPECT_TRUE(scene("Vertex a.vert\nFragment a.frag\nProgram A\n",
                      {{"a.vert", "void main() { gl_Position = ftransform(); }\n"},
                       {"a.frag", "void main() { gl_FragColor = sin(gl_FragCoord) + cos(gl_FragCoord); }\n"}})
                    .changes.empty());
}

TEST_F(FoundShaders, ThereIsALimit) {
    std::string many;
    for (int i = 0; i < 400; ++i) many += "color += sin(vN * " + std::to_string(i) + ".);\n";
    many += "for (int i = 0; i < 64; i++) color += vN;\n";
    Found& found = shaders(in_main(many));
    EXPECT_LE(found.changes.size(), 200U);
    EXPECT_GE(found.changes.size(), 190U);
    EXPECT_EQ(found.of(fewer_rounds).size(), 2U) << "kinds with few changes keep them";
}

class ExpressionMeans : public FoundShaders {};

TEST_F(ExpressionMeans, OfDeepTreesOfCallsAreFoundAtOnce) {
    std::string text = "varying vec3 vP;\nfloat f0(float x) { return sin(x); }\n";
    for (int depth = 1; depth < 4; ++depth) {
        const std::string below = "f" + std::to_string(depth - 1);
        text += "float f" + std::to_string(depth) + "(float x) {\n    float s = 0.;\n";
        for (int i = 0; i < 24; ++i) text += "    s += " + below + "(x) * " + below + "(x + 1.);\n";
        text += "    return s;\n}\n";
    }
    text += "float f4(float x) { return f3(x); }\n";
    text += "void main() {\n    float a = f3(vP.x);\n    float b = f4(vP.x);\n    gl_FragColor = vec4(a + b);\n}\n";
    const std::clock_t start = std::clock();
    Found& found = shaders(text);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 2);
    EXPECT_NE(found.find(expression_mean, "f3(vP.x)"), nullptr);
    EXPECT_EQ(found.find(expression_mean, "f4(vP.x)"), nullptr) << "too deep to be sure of it";
}

// What main adds up is declared ahead of the function, so main must come after it.
TEST_F(ExpressionMeans, AreOfMainAndOfWhatIsAheadOfIt) {
    const std::string body = "{ float s = exp(x); return s; }\n";
    const std::string main = "void main() { gl_FragColor = vec4(wave(vP.x)); }\n";
    EXPECT_NE(shaders("varying vec3 vP;\nfloat wave(float x) " + body + main).find(expression_mean, "exp(x)"), nullptr);
    EXPECT_EQ(shaders("varying vec3 vP;\nfloat wave(float x);\n" + main + "float wave(float x) " + body)
                  .find(expression_mean, "exp(x)"),
              nullptr);
}

// One text for what is drawn into a texture and for what is seen: an edit changes both.
TEST_F(ExpressionMeans, AreNotOfTextsThatDrawIntoTextures) {
    const std::vector<File> files{
        {"a.vert", "varying vec3 vP;\nvoid main() { vP = gl_Vertex.xyz; gl_Position = ftransform(); }\n"},
        {"a.frag", "varying vec3 vP;\nvoid main() {\n    float s = exp(vP.x);\n    gl_FragColor = vec4(s);\n}\n"}};
    const std::string drawn = "Vertex a.vert\nFragment a.frag\nProgram ",
                      cube = "CubeMap 6 16\nRenderToCube 6 0. 0. 0.\n";
    EXPECT_NE(scene(drawn + "Seen\nSphere 1.\n", files).find(expression_mean, "exp(vP.x)"), nullptr);
    const std::string both = cube + drawn + "Around\nBox 9. 9. 9.\nRenderToTexture\n" + drawn + "Seen\nSphere 1.\n";
    EXPECT_EQ(scene(both, files).find(expression_mean, "exp(vP.x)"), nullptr);
}

// ---- Where polynomials are put, and what moves to the vertex shader.

std::string shader(const std::string& statement) {
    return "// A comment stays.\n#version 120\n#extension GL_EXT_gpu_shader4 : enable\nvarying vec3 vN;\nuniform float "
           "uShine;\n\nvoid main()\n{\n    " +
           statement + "\n}\n";
}

TEST_F(FoundShaders, AFunctionIsAddedAheadOfTheOneThatCallsIt) {
    Found& found = shaders(shader("gl_FragColor = vec4(pow(max(vN.x, 0.), 5.));"));
    EXPECT_EQ(found.lines(polynomial).size(), 1U);
    const Change* change = found.find(polynomial, "pow(max(vN.x, 0.), 5.)");
    ASSERT_NE(change, nullptr);
    const std::string text = found.changed(*change, "a.frag");
    const std::size_t at = shader("").find("void main");
    const std::string name = "foundPow_" + std::to_string(shader("gl_FragColor = vec4(").find("vec4(") + 5);
    EXPECT_EQ(text.substr(at, text.find("void main") - at),
              "// pow(x, 5) by multiplications: exact\nfloat " + name +
                  "(float x) { float x2 = x * x; float x4 = x2 * x2; return x * x4; }\n");
    EXPECT_NE(text.find("vec4(" + name + "(max(vN.x, 0.)));"), std::string::npos) << text;
    EXPECT_EQ(translation_errors(found, {change}), "");
}

TEST_F(FoundShaders, AllCallsOfAFunctionAreOneChangeToo) {
    Found& found = shaders(shader("gl_FragColor = vec4(sin(vN) * cos(vN.x), pow(vN.y, uShine));"));
    const std::vector<const Change*> all = found.of(polynomial);
    ASSERT_EQ(all.size(), 4U) << "three calls, and all of them";
    std::size_t most = 0;
    for (const Change* change : all) {
        most = std::max(most, change->edits.size());
        EXPECT_EQ(translation_errors(found, {change}), "");
    }
    EXPECT_EQ(most, 4U) << "one place ahead of main, three calls";
}

TEST_F(FoundShaders, CallsWithoutAPolynomialStay) {
    EXPECT_EQ(shaders(shader("gl_FragColor = vec4(tan(vN), sqrt(vN.x) + sin(.5));")).lines(polynomial), Lines{});
}

// ---- the vertex shader --------------------------------------------------------------------------------------

TEST_F(FoundShaders, WorkOnVaryingsMovesToTheVertexShader) {
    Found& found = shaders(
        "varying vec3 vN, vP;\nuniform vec3 uLight;\nvoid main() {\n    vec3 L = normalize(uLight - vP);\n"
        "    gl_FragColor = vec4(max(dot(vN, L), 0.));\n}\n");
    ASSERT_EQ(found.of(per_vertex).size(), 3U) << "two expressions, and both together";
    const Change* change = nullptr;
    for (const Change* each : found.of(per_vertex))
        if (each->before == "vec4(max(dot(vN, L), 0.))") change = each;
    ASSERT_NE(change, nullptr);
    EXPECT_TRUE(found.changed(*change, "a.vert").starts_with("varying vec3 vN, vP;\nvarying vec2 vST;\nvarying "));
    const std::string vert = found.changed(*change, "a.vert"), name = change->after;
    EXPECT_TRUE(name.starts_with("vFound_"));
    EXPECT_NE(vert.find("varying vec4 " + name + ";\n"), std::string::npos) << vert;
    EXPECT_NE(vert.find("= vec4(max(dot(vN, normalize(uLight - vP)), 0.));\n}"), std::string::npos) << vert;
    EXPECT_NE(vert.find("uniform vec3 uLight;\nvoid main"), std::string::npos) << vert;
    for (const Change* each : found.of(per_vertex)) EXPECT_EQ(translation_errors(found, {each}), "");
}

TEST_F(FoundShaders, WorkOnUniformsMovesToo) {
    Found& found =
        shaders("varying vec3 vN;\nuniform float uA;\nvoid main() { gl_FragColor = vec4(sin(uA) * vN, 1.); }\n");
    EXPECT_EQ(found.of(per_vertex).size() + found.of(per_frame).size(), 1U);
    const Found& alone = shaders(
        "varying vec3 vN;\nuniform float uA;\nvoid main() { vec3 c = vN; c *= sin(uA); gl_FragColor = vec4(c, 1.); "
        "}\n");
    ASSERT_EQ(alone.of(per_frame).size(), 1U);
    EXPECT_EQ(translation_errors(alone, alone.of(per_frame)), "");
}

TEST_F(FoundShaders, WorkStaysWhereItCannotMove) {
    const auto moved = [&](const std::string& fragment, const std::string& state = "") {
        const Found& found = shaders(fragment, "", state);
        return found.of(per_vertex).size() + found.of(per_frame).size();
    };
    const std::string work = "gl_FragColor = vec4(normalize(vN), 1.); }\n";
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { " + work), 1U);
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { " + work, "Vertex a.vert\nFragment a.frag\nProgram B\nSphere 1."),
              0U)
        << "another program has the vertex shader, too";
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { gl_FragColor = vec4(dFdx(normalize(vN)).x) + gl_FragCoord; }\n"),
              1U)
        << "only what is within the derivative";
    EXPECT_EQ(moved("varying vec3 vM;\nvoid main() { gl_FragColor = vec4(normalize(vM), 1.); }\n"), 0U)
        << "nothing writes it";
    EXPECT_EQ(
        moved("varying vec3 vN;\nvoid main() { vec3 n = vN; n.x = 2.; gl_FragColor = vec4(normalize(n), 1.); }\n"), 0U)
        << "the variable changes";
}

}  // namespace
}  // namespace snell::accuracy::test
