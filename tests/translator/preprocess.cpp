// Directives, macros, includes, odd characters; and that lines stay where the user wrote them.
#include "src/glsl/read/lexer.h"
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

TEST(GlslPreprocess, LinesStay) {
    const std::string body =
        "uniform float u;\nfloat g = u;\n\nvoid main()\n{\n    gl_FragColor = vec4(g, texture2D_here, 1., 1.);\n}\n";
    for (const std::string& head : {std::string(), std::string("#version 330 compatibility\n"),
                                    std::string("// hello\n\n#version 120\n#extension GL_EXT_gpu_shader4 : enable\n")})
        for (const Target& target : {core450, core330, es320}) {
            const std::string text = head + body;
            const Translated t = fragment(text, target);
            EXPECT_EQ(line_of(t.text(Stage::fragment), "texture2D_here"), line_of(text, "texture2D_here"))
                << t.text(Stage::fragment);
        }
}

TEST(GlslPreprocess, ConditionsOnTheVersionAreJudgedAsTheUserMeantThem) {
    const Translated t = fragment(
        "#version 120\n#if __VERSION__ >= 130\nin vec2 v; out vec4 c;\n#else\nvarying vec2 v;\n#define c "
        "gl_FragColor\n#endif\n"
        "void main() { c = vec4(v, 0., 1.); }\n");
    EXPECT_FALSE(t.has(Stage::fragment, "out vec4 c"));
    EXPECT_TRUE(t.has(Stage::fragment, "snell_FragColor"));
    expect_accepted(t.translation);
}

TEST(GlslPreprocess, MacrosThatHideLegacyNames) {
    expect_valid(
        {{Stage::vertex,
          "#define POS gl_Vertex\n#define XFORM(v) (gl_ModelViewProjectionMatrix * (v))\n#define OUT varying\nOUT vec3 "
          "n;\n"
          "void main() { n = gl_Normal; gl_Position = XFORM(POS); }"},
         {Stage::fragment,
          "#define SAMPLE(s, c) texture2D(s, (c).xy)\n#define HALF 1 / 2.\n#define LONG(a, \\\n  b) ((a) + "
          "(b))\nvarying vec3 n; uniform sampler2D t;\n"
          "float f(float x) { return LONG(x, HALF); }\nvoid main() { gl_FragColor = SAMPLE(t, n) * f(n.x); }"}});
}

TEST(GlslPreprocess, MacrosThatRedefineTheLanguage) {
    expect_valid({{Stage::fragment,
                   "#define texture texture2D\n#define half float\nuniform sampler2D t;\n#define CAT(a, b) a##b\n"
                   "void main() { half CAT(x, 1) = 1.; gl_FragColor = texture(t, vec2(x1)); }"}});
}

// Mesa reads on behind such a name, in search of what closes its arguments: it gets the text without macros.
TEST(GlslPreprocess, NamesOfMacrosWithParametersMayBeVariables) {
    for (const char* use : {"vec4(f)", "vec4(g(f))", "vec4(k)", "vec4(f + f(2.))"}) {
        const Translated t = fragment(
            "#define f(x) (x)\n#define g(x) (x)\n#define k f\nvoid main() { float f = 1.; "
            "gl_FragColor = " +
            std::string(use) + "; }\n");
        EXPECT_FALSE(t.has(Stage::fragment, "#define")) << use;
        expect_accepted(t.translation);
    }
    EXPECT_TRUE(
        fragment("#define f(x) (x)\nvoid main() { gl_FragColor = vec4(f(1.)); }\n").has(Stage::fragment, "#define"));
}

TEST(GlslPreprocess, OddCharacters) {
    const std::string text =
        "\xEF\xBB\xBF#version 330 compatibility\r\nvoid main()\r\n{\r\n\xC2\xA0\xC2\xA0gl_FragColor\xC2\xA0= vec4(1.); "
        "// na\xEFve\r\n}\r\n";
    const Translated t = fragment(text);
    EXPECT_EQ(t.count("odd-blank"), 1);
    expect_accepted(t.translation);
    EXPECT_EQ(fragment("\xEF\xBB\xBFvoid main() { gl_FragColor = vec4(1.); }").count("odd-blank"), 0);
    expect_valid({{Stage::fragment, "void main()\r{\r gl_FragColor = vec4(1.);\r}"}});
}

TEST(GlslPreprocess, Includes) {
    Options options;
    options.target = core450;
    options.include = [](std::string_view, std::string_view name, bool angle) -> std::optional<IncludeText> {
        if (name == "lit.glsl" && !angle)
            return IncludeText{"lit.glsl", "#include \"deep.glsl\"\nfloat lit(float x) { return deep(x) * lost; }\n"};
        if (name == "deep.glsl") return IncludeText{"deep.glsl", "float deep(float x) { return x; }\n"};
        if (name == "loop.glsl") return IncludeText{"loop.glsl", "#include \"loop.glsl\"\n"};
        if (name == "gone/../deep.glsl") return IncludeText{"deep.glsl", "float deep;\n", {}, true};
        return std::nullopt;
    };
    Translated t;
    translate_texts(
        t,
        {{Stage::fragment,
          "#version 330 compatibility\n#include \"lit.glsl\"\nvoid main() { gl_FragColor = vec4(lit(missing)); }\n"}},
        options);
    const StageOutput& out = t.translation.stages.back();
    ASSERT_EQ(out.files.size(), 3u);
    EXPECT_EQ(t.sources.name(out.files[1]), "lit.glsl");
    EXPECT_EQ(t.sources.name(out.files[2]), "deep.glsl");
    EXPECT_EQ(line_of(out.text, "missing"), 3);
    EXPECT_EQ(line_of(out.text, "lost"), 2);
    Translated loop;
    translate_texts(loop, {{Stage::fragment, "#include \"loop.glsl\"\nvoid main() {}\n"}}, options);
    EXPECT_EQ(loop.count("include-cycle"), 1);
    Translated inexact;
    translate_texts(inexact, {{Stage::fragment, "#include \"gone/../deep.glsl\"\nvoid main() {}\n"}}, options);
    EXPECT_EQ(inexact.count("file-inexact"), 1);
    Translated missing;
    translate_texts(missing,
                    {{Stage::fragment, "#if 0\n#include \"no.glsl\"\n#endif\n#include <none>\nvoid main() {}\n"}},
                    options);
    EXPECT_EQ(missing.count("missing-include"), 1);
    EXPECT_FALSE(missing.translation.ok);
}

// As C's headers: read once, though two files include it, and each other.
TEST(GlslPreprocess, IncludedFilesGuardThemselves) {
    const std::map<std::string_view, std::string> texts = {
        {"once.glsl", "#pragma once\n#include \"once.glsl\"\nfloat once(float x) { return x; }\n"},
        {"left.glsl",
         "// left\n# ifndef LEFT\n#define LEFT\n#include \"right.glsl\"\nfloat left() { return 1.; }\n#endif\n"},
        {"right.glsl", "#ifndef RIGHT\n#define RIGHT\n#include \"left.glsl\"\nfloat right() { return 2.; }\n#endif\n"},
        {"open.glsl", "uniform float uK;\nvarying vec3 vN;\n"},
        {"other.glsl", "#ifndef NOBODY\n#include \"other.glsl\"\n#endif\n"}};
    Options options;
    options.target = core450;
    options.include = [&](std::string_view, std::string_view name, bool) {
        return IncludeText{std::string(name), texts.at(name)};
    };
    Translated t;
    const std::string both = "#include \"once.glsl\"\n#include \"left.glsl\"\n";
    translate_texts(t,
                    {{Stage::fragment, both + both + "void main() { gl_FragColor = vec4(once(left()) * right()); }\n"}},
                    options);
    EXPECT_TRUE(t.diagnostics.empty());
    expect_accepted(t.translation);
    Translated other;
    translate_texts(other, {{Stage::fragment, "#include \"other.glsl\"\nvoid main() {}\n"}}, options);
    EXPECT_EQ(other.count("include-cycle"), 1);
    Translated open;
    const std::string twice = "#include \"open.glsl\"\n#include \"open.glsl\"\n";
    translate_texts(open, {{Stage::fragment, twice + "uniform float uK;\nvoid main() {}\n"}}, options);
    ASSERT_EQ(open.count("declared-twice"), 3);
    for (const Diagnostic& d : open.diagnostics.items())
        EXPECT_EQ(d.help, open.sources.name(d.span.file) == "open.glsl"
                              ? "'open.glsl' is included twice: write '#pragma once' as its first line"
                              : "");
}

TEST(GlslPreprocess, DefinesFromOutsideWin) {
    Options options;
    options.target = core450;
    options.defines = {{"FRESNEL", "2"}, {"FRESNEL_exact", "2"}, {"UNUSED", "1"}};
    Translated t;
    translate_texts(t,
                    {{Stage::fragment,
                      "void main() {\n#if FRESNEL == FRESNEL_exact\ngl_FragColor = vec4(.25);\n#else\ngl_FragColor = "
                      "vec4(.75);\n#endif\n}\n"}},
                    options);
    EXPECT_TRUE(t.has(Stage::fragment, "#define FRESNEL 2"));
    expect_accepted(t.translation);
    Translated plain;
    translate_texts(plain, {{Stage::fragment, "void main() { gl_FragColor = vec4(1.); }\n"}}, options);
    EXPECT_FALSE(plain.has(Stage::fragment, "#define"));
}

TEST(GlslPreprocess, TokensDoNotReferToTheOptions) {
    Options options;
    options.defines = {{"ROUNDS", "8"}};
    Sources sources;
    Diagnostics said;
    Unit unit;
    preprocess(unit, sources.add("a.frag", "void main() { int n = ROUNDS; }\n"), sources, options, said);
    options.defines.front().value.front() = '9';
    const auto number = std::find_if(unit.tokens.begin(), unit.tokens.end(),
                                     [](const Token& token) { return token.kind == Kind::integer; });
    ASSERT_NE(number, unit.tokens.end());
    EXPECT_EQ(number->text, "8");
}

TEST(GlslPreprocess, OnlyParenthesesProtectCommasOfArguments) {
    Sources sources;
    Diagnostics said;
    Unit unit;
    const FileId file =
        sources.add("a.frag", "#define SUM(a, b) a + b\nvoid main() { SUM(x[0, 1]); SUM(max(2., 3.), x[1]); }\n");
    preprocess(unit, file, sources, {}, said);
    std::string text;
    for (const Token& token : unit.tokens) text += token.text;
    EXPECT_EQ(text, "voidmain(){x[0+1];max(2.,3.)+x[1];}");
}

TEST(GlslPreprocess, AnotherNumberOfArgumentsIsAnError) {
    const auto told = [](const std::string& call) {
        return fragment(
                   "#define SUM(a, b) a + b\n#define ONE(a) a\n#define NONE() 1.\n#define TWICE(a) SUM(a)\n"
                   "void main() { float x[2] = float[2](1., 2.); gl_FragColor = vec4(" +
                   call + "); }\n")
            .count("macro-arguments");
    };
    for (const std::string call :
         {"SUM(1., 2., 3.)", "SUM(1.)", "SUM(x[0, 1], 2.)", "ONE(1., 2.)", "NONE(1.)", "TWICE(1.)"})
        EXPECT_EQ(told(call), 1) << call;
    for (const std::string call : {"SUM(1., max(2., 3.))", "ONE((1., 2.))", "NONE()", "vec4(1.) ONE()"})
        EXPECT_EQ(told(call), 0) << call;
}

TEST(GlslPreprocess, HostileMacrosEnd) {
    std::string bomb = "#define A0 x x x x x x x x x x\n";
    for (int n = 1; n < 30; ++n)
        bomb += "#define A" + std::to_string(n) + " A" + std::to_string(n - 1) + " A" + std::to_string(n - 1) + " A" +
                std::to_string(n - 1) + "\n";
    const Translated t = fragment(bomb + "void main() { A29; }\n");
    EXPECT_FALSE(t.translation.ok);
    EXPECT_GE(t.count("macro-too-large"), 1);
    EXPECT_TRUE(
        fragment("#define F F\n#define G(x) G(x)\nvoid main() { float F = 1., G = F; gl_FragColor = vec4(F + G); }")
            .translation.ok);
}

TEST(GlslPreprocess, BrokenConditionals) {
    EXPECT_EQ(fragment("#ifdef X\n#else\nvoid main() { gl_FragColor = vec4(1.); }\n").count("unterminated-conditional"),
              1);
    EXPECT_EQ(fragment("#endif\nvoid main() {}\n").count("stray-conditional"), 1);
    expect_valid({{Stage::fragment, "#if 1\nvoid main() { gl_FragColor = vec4(1.); }\n"}});
}

// An old habit of C, which some compilers accept: what the driver gets is what all accept.
TEST(GlslPreprocess, WordsBehindElseAndEndif) {
    const std::string text =
        "#ifdef FOO\nbroken\n#else FOO\nuniform float u;\n#endif FOO // or not\n#ifndef BAR\n#define BAR .5\n"
        "#if 0\n#else BAZ \\\n BAZ\n#endif\t/* a */ BAR /* the\nend */\r\nvoid main() { gl_FragColor = vec4(u * BAR); "
        "}\n"
        "#endif // BAR\n";
    const Translated t = fragment(text);
    ASSERT_EQ(t.count("surplus-words"), 4) << render(t.diagnostics, t.sources);
    EXPECT_EQ(t.diagnostics.items().size(), 4u);
    EXPECT_EQ(t.text(Stage::fragment).find("FOO", t.text(Stage::fragment).find("broken")), std::string::npos);
    EXPECT_EQ(line_of(t.text(Stage::fragment), "vec4(u"), line_of(text, "vec4(u"));
    const Diagnostic& first = t.diagnostics.items().front();
    ASSERT_EQ(first.fixes.size(), 1u);
    EXPECT_EQ(first.fixes.front().text, "// ");
    EXPECT_EQ(text.substr(first.fixes.front().span.begin, 4), "FOO\n");
    expect_valid({{Stage::fragment, text}});
    // Where the driver would judge otherwise, directives are left out.
    expect_valid({{Stage::fragment, "#if __VERSION__ > 100\n" + text + "#endif __VERSION__\n"}});
    EXPECT_EQ(fragment("#if 0\n#else if 1\n#endif\nvoid main() {}\n").count("surplus-words"), 0);
}

TEST(GlslPreprocess, CommentsThatTakeTheNextLine) {
    const auto warned = [](const std::string& comment, const std::string& next = "uniform float a;\n") {
        const Translated t = fragment(comment + next + "void main() { gl_FragColor = vec4(1.); }\n");
        for (const Diagnostic& d : t.diagnostics.items())
            if (d.code == "comment-continued") {
                EXPECT_EQ(t.sources.text(d.span.file).substr(d.span.begin, d.span.end - d.span.begin), "\\");
            }
        return t.count("comment-continued");
    };
    for (const std::string end : {"\n", "\r\n"}) {
        EXPECT_EQ(warned("// in C:\\textures\\" + end), 1);
        EXPECT_EQ(warned("// in C:\\\\textures\\\\" + end), 1);
        EXPECT_EQ(warned("float b; // \\" + end + "// \\" + end), 1);
        EXPECT_EQ(warned("// \\" + end, " \t" + end), 0);
        EXPECT_EQ(warned("// \\" + end, "  // \\" + end + end), 0);
        EXPECT_EQ(warned("#define F(x) ((x) \\" + end + " + \\" + end + " 1.)" + end), 0);
        EXPECT_EQ(warned("//#define F(x) ((x) \\" + end + " + 1.)" + end), 0);
        EXPECT_EQ(warned("#define F(x) ((x) /* \\" + end + " */ + 1.)" + end), 0);
        EXPECT_EQ(warned("/* // \\" + end + " */" + end), 0);
        EXPECT_EQ(warned("#define F(x) (x) // one \\" + end), 1);
    }
    EXPECT_EQ(warned("// \\"), 0);
}

// Every reader of a shader agrees on where a comment ends.
TEST(GlslPreprocess, WhatAContinuedCommentTakesIsLost) {
    const auto uniforms = [](const std::string& comment) {
        return fragment(comment + "uniform float a;\nvoid main() { gl_FragColor = vec4(1.); }\n")
            .translation.declared.size();
    };
    for (const std::string backslash : {"\\\n", "\\\r\n", "\\\\\n", "\\\\\r\n"}) {
        EXPECT_EQ(uniforms("// " + backslash), 0u);
        EXPECT_EQ(uniforms("#define A // " + backslash), 0u);
    }
    // GLSL continues no line after a backslash with a blank behind it; directives are mended, comments are not.
    EXPECT_EQ(uniforms("// \\ \n"), 1u);
    EXPECT_EQ(uniforms("#define A \\ \n .5\n"), 1u);
}

TEST(GlslPreprocess, CommentsThatNothingCloses) {
    const std::string text = "uniform float a;\n\n  /* notes\nvoid main() { gl_FragColor = vec4(1.); }\n";
    const Translated t = fragment(text);
    ASSERT_EQ(t.count("unclosed-comment"), 1);
    EXPECT_FALSE(t.translation.ok);
    EXPECT_EQ(t.diagnostics.items().front().span.begin, text.find("/*"));
    EXPECT_FALSE(t.diagnostics.items().front().help.empty());
    EXPECT_EQ(fragment("// /*\n/* // */ /**/ void main() {} /*/ */\n").count("unclosed-comment"), 0);
    EXPECT_EQ(fragment("void main() {} /*/\n").count("unclosed-comment"), 1);
}

}  // namespace
}  // namespace snell::glsl::test
