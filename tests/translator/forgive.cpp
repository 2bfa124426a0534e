// What one vendor's compiler lets pass, and names that newer versions took for themselves.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

const std::vector<Target> everywhere = {core450, core410, core330, es320, es300};

TEST(GlslForgive, GlobalsFromUniformsMoveIntoMain) {
    const std::string text =
        "#version 330 compatibility\nuniform float uB;\nconst vec3 L = vec3(5., uB, 0.);\nfloat twice = uB * 2.;\n"
        "const float d = length(L) + twice;\nconst float PI = 3.14;\nvec3 use() { return L * d; }\n"
        "void main() { gl_FragColor = vec4(use() * PI, 1.); }\n";
    const Translated t = fragment(text);
    const std::string& out = t.text(Stage::fragment);
    EXPECT_NE(out.find("void main() { \n#line 3 0\nL = vec3(5., uB, 0.);\n#line 8 0\n \n#line 4 0\ntwice = uB * 2.;\n"
                       "#line 8 0\n \n#line 5 0\nd = length(L) + twice;\n#line 8 0\n snell_FragColor"),
              std::string::npos)
        << out;
    EXPECT_TRUE(t.has(Stage::fragment, "const float PI = 3.14;"));
    EXPECT_EQ(t.count("const-not-constant"), 2);
    expect_valid({{Stage::fragment, text}}, everywhere);
}

TEST(GlslForgive, IntWhereFloatIsDue) {
    const std::string text =
        "#version 330 compatibility\nuniform int uN; uniform bool uB;\nfloat one() { return 1; }\nfloat half_of(float "
        "x) { return x / 2; }\n"
        "float n(int i) { return i; }\nvoid main() { float a = 1, b = uN; a = 2; a += uN; a = uB ? 1 : .5; vec3 v = "
        "vec3(1, 2, 3) * 2;\n"
        "a = pow(2, 3) + mod(uN, 2) + max(a, 0) + clamp(a, 0, 1) + mix(0, 1, a) + smoothstep(0, 1, a) + half_of(3) + "
        "n(2);\n"
        "if (a > 0 && v.x == 1) a = -1; float t[3] = float[3](1, 2, 3); gl_FragColor = vec4(v * uN, a + t[1] + one()); "
        "}\n";
    expect_valid({{Stage::fragment, text}}, everywhere);
    // Where the target converts by itself the text stays.
    EXPECT_TRUE(fragment(text).has(Stage::fragment, "float one() { return 1; }"));
    EXPECT_TRUE(fragment(text, core330).has(Stage::fragment, "float one() { return 1.0; }"));
}

TEST(GlslForgive, OtherConversions) {
    const std::string text =
        "uniform int uI; uniform float uF; uniform bool uB;\nint f(int n) { return n * 1.5; }\nvoid main() { int i = "
        "uF; i = floor(uF);\n"
        "if (uI) i = 2; if (!uI && uF) i = f(2.5); float k = uB * 2.; bool b = 1; if (uB == 1) k = (float) i / 2.;\n"
        "float a[4]; a[uF] = 1.; gl_FragColor = vec4(k, i, a[0], 1.); }\n";
    const Translated t = fragment(text);
    EXPECT_GE(t.count("float-to-int"), 1);
    EXPECT_GE(t.count("number-as-bool"), 1);
    EXPECT_GE(t.count("bool-as-number"), 1);
    EXPECT_EQ(t.count("c-cast"), 1);
    expect_valid({{Stage::fragment, text}}, everywhere);
}

TEST(GlslForgive, AnAssignmentAsAConditionIsNamed) {
    const auto said = [](const std::string& condition) {
        const Translated t =
            fragment("void main() { float d = 1.; if (" + condition + ") d = 2.; gl_FragColor = vec4(d); }");
        return std::ranges::any_of(t.diagnostics.items(),
                                   [](const Diagnostic& d) { return d.message.ends_with("'==' compares"); });
    };
    EXPECT_TRUE(said("d = .5"));
    EXPECT_FALSE(said("d"));
}

TEST(GlslForgive, QualifiersThatMeanNothing) {
    const Texts texts = {{Stage::vertex,
                          "#version 330 compatibility\nout const vec3 a; varying const float b; flat varying vec3 c;\n"
                          "void main() { a = gl_Normal; b = 1.; c = a; gl_Position = gl_Vertex; }"},
                         {Stage::fragment,
                          "#version 330 compatibility\nin vec3 a; varying const float b; flat varying vec3 c;\n"
                          "void main() { gl_FragColor = vec4(a * b + c, 1.); }"}};
    EXPECT_EQ(translated(texts).count("const-interface"), 3);
    expect_valid(texts, everywhere);
}

TEST(GlslForgive, WordsOfOtherLanguagesAreReadPast) {
    for (const std::string word : {"static", "inline", "extern", "public"}) {
        const Translated t = fragment(
            word + " float twice(float x) { return 2. * x; }\nvoid main() { gl_FragColor = vec4(twice(.2)); }");
        EXPECT_FALSE(t.has(Stage::fragment, word));
        expect_accepted(t.translation);
    }
}

// Uniforms must agree in their precision across stages.
TEST(GlslForgive, OpenGlEsHasOnePrecision) {
    const Translated t = fragment(
        "precision mediump float;\nuniform lowp float a;\nuniform mediump vec3 b;\nuniform highp float c;\n"
        "void main() { gl_FragColor = vec4(a * b, c); }",
        es320);
    EXPECT_FALSE(t.has(Stage::fragment, "lowp") || t.has(Stage::fragment, "mediump")) << t.text(Stage::fragment);
}

TEST(GlslForgive, ArrayInitialisersOfC) {
    expect_valid({{Stage::fragment,
                   "#version 330 compatibility\nfloat a[3] = {1., 2, 3.}; const vec2 b[2] = {vec2(1.), vec2(2.)};\n"
                   "uniform float uX; float c[2] = { uX, 1. };\n"
                   "void main() { float d[2] = {1., 2.}; gl_FragColor = vec4(a[0], b[1].x, c[0], d[1]); }"}},
                 everywhere);
}

TEST(GlslForgive, ReservedWordsAsNames) {
    const Texts texts = {{Stage::fragment,
                          "uniform float sample; uniform sampler2D texture;\nvoid main() { float input = 1., filter = "
                          "sample, half = 2.;\n"
                          "float smooth = input * filter, common = smooth, buffer = half, active = 1., patch = 2.;\n"
                          "gl_FragColor = texture2D(texture, vec2(common, buffer)) * active * patch; }"}};
    const Translated t = translated(texts);
    ASSERT_FALSE(t.translation.renamed.empty());
    bool sampler = false;
    for (const RenamedUniform& r : t.translation.renamed)
        sampler = sampler || (r.name == "texture" && r.shader_name == "snell_texture");
    EXPECT_TRUE(sampler);
    expect_valid(texts, everywhere);
}

TEST(GlslForgive, KeywordsStayKeywords) {
    const std::string text =
        "#version 420\nsmooth in vec3 a; sample in vec3 b; layout(std140, row_major) uniform B { mat4 m; };\n"
        "precise out vec4 c; void main() { c = m * vec4(a + b, 1.); }";
    const Translated t = translated({{Stage::vertex,
                                      "#version 420\nin vec3 aVertex; out vec3 a; sample out vec3 b;\n"
                                      "void main() { a = b = aVertex; gl_Position = vec4(a, 1.); }"},
                                     {Stage::fragment, text}});
    EXPECT_TRUE(t.has(Stage::fragment, "smooth in vec3 a; sample in vec3 b; layout(std140, row_major) uniform B"));
}

TEST(GlslForgive, NumbersOfOtherLanguages) {
    const Translated t = fragment("void main() { gl_FragColor = vec4(1.0f, .5f, 1f, 2.h); }");
    EXPECT_TRUE(t.has(Stage::fragment, "vec4(1.0f, .5f, 1.0, 2.)"));
}

TEST(GlslForgive, OtherShadingLanguages) {
    expect_valid(
        {{Stage::fragment,
          "uniform sampler2D t; varying vec2 s;\nvoid main() { float3 c = lerp(float3(1., 0., 0.), saturate(vec3(s, "
          "1.)), frac(s.x));\n"
          "gl_FragColor = vec4(c * tex2D(t, s).rgb, 1.); }"},
         {Stage::vertex, "varying vec2 s; void main() { s = gl_MultiTexCoord0.st; gl_Position = ftransform(); }"}},
        everywhere);
}

TEST(GlslForgive, AssignedInputsAreCopies) {
    const Texts texts = {
        {Stage::vertex, "varying vec3 n; void main() { gl_Vertex.x += 1.; n = gl_Normal; gl_Position = gl_Vertex; }"},
        {Stage::fragment,
         "varying vec3 n; uniform float u; void main() { n = normalize(n); u = 2.; gl_FragColor = vec4(n * u, 1.); }"}};
    EXPECT_EQ(translated(texts).count("assigned-input"), 3);
    expect_valid(texts, everywhere);
}

TEST(GlslForgive, CalledAboveItsDefinition) {
    const std::string text = "void main() { gl_FragColor = vec4(later(2.)); }\nfloat later(float x) { return x; }\n";
    EXPECT_EQ(fragment(text).count("used-before-definition"), 1);
    expect_valid({{Stage::fragment, text}}, everywhere);
}

TEST(GlslForgive, DoublesWhereThereAreNone) {
    const std::string text =
        "#version 400\nuniform double d; out vec4 c; void main() { dvec3 v = dvec3(d, 1.0lf, 2.); c = vec4(v, 1.); }";
    EXPECT_TRUE(fragment(text).has(Stage::fragment, "uniform double d;"));
    EXPECT_EQ(fragment(text, es320).count("no-double"), 1);
    expect_valid({{Stage::fragment, text}}, everywhere);
}

TEST(GlslForgive, SlipsThatAreErrorsEverywhereStay) {
    const Translated t = fragment("uniform vec3 u; void main() { vec4 c = u; gl_FragColor = c; }");
    EXPECT_TRUE(t.has(Stage::fragment, "vec4 c = u;"));
}

TEST(GlslForgive, WhatCrashesADriverNeverReachesIt) {
    const Translated t = fragment("void main() { vec4 a = 2[1](vec4(1.)); float b = 3.(1.); gl_FragColor = a; }");
    EXPECT_FALSE(t.translation.ok);
    EXPECT_EQ(t.count("not-a-function"), 2);
    EXPECT_TRUE(fragment("void main() { float a[2] = float[2](1., 2.); gl_FragColor = vec4[1](vec4(a[0]))[0]; }")
                    .translation.ok);
}

TEST(GlslForgive, UniformInitialisers) {
    const std::string text =
        "#version 330 compatibility\nuniform float a = .5, b = 2; uniform vec3 c = vec3(1, .5, 0) * 2.; uniform float "
        "t[2] = float[](1., 2.);\n"
        "uniform mat2 m = mat2(3.); void main() { gl_FragColor = vec4(c * a * b, t[1] + m[0][0]); }";
    const Translated t = fragment(text);
    EXPECT_TRUE(t.uniform_default("a", {.5}));
    EXPECT_TRUE(t.uniform_default("b", {2}));
    EXPECT_TRUE(t.uniform_default("c", {2, 1, 0}));
    EXPECT_TRUE(t.uniform_default("t", {1, 2}));
    EXPECT_TRUE(t.uniform_default("m", {3, 0, 0, 3}));
    EXPECT_FALSE(fragment(text, es320).has(Stage::fragment, "= .5"));
    expect_valid({{Stage::fragment, text}}, everywhere);
}

TEST(GlslForgive, AlphaIsKnownOnlyWhereItIsOne) {
    const auto uses_alpha = [](const std::string& body) {
        return fragment("uniform vec4 u; void main() { " + body + " }").translation.uses_alpha;
    };
    EXPECT_FALSE(uses_alpha("gl_FragColor = vec4(u.rgb, 1.);"));
    EXPECT_FALSE(uses_alpha("gl_FragColor = vec4(1);"));
    EXPECT_FALSE(
        uses_alpha("if (u.x > 0.) gl_FragColor = vec4(1., 0., 0., 1.); else gl_FragColor = vec4(u.rgb, 1); "
                   "gl_FragColor.rgb *= .5;"));
    EXPECT_TRUE(uses_alpha("gl_FragColor = u;"));
    EXPECT_TRUE(uses_alpha("gl_FragColor = vec4(u.rgb, .5);"));
    EXPECT_TRUE(uses_alpha("gl_FragColor = vec4(u.rgb, 1.) * .5;"));
    EXPECT_TRUE(uses_alpha("gl_FragColor.rgb = u.rgb;"));
}

}  // namespace
}  // namespace snell::glsl::test
