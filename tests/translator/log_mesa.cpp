// Logs that Mesa 22.3 wrote for the shaders given here, explained.
#include <gtest/gtest.h>

#include "tests/translator/log_help.h"

namespace snell::glsl {
namespace {

using test::Program;

TEST(MesaLog, FoldsWhatFollowsFromOneUndeclaredName) {
    Program p;
    p.fragment(
        "#version 330 core\n"
        "uniform vec3 uLightColor;\n"
        "in vec3 vNormal;\n"
        "out vec4 color;\n"
        "void main() {\n"
        "\tfloat d = dot(   vNormal, vNorml);\n"
        "\t\tvec3 c = uLightColour * vNorml;\n"
        "    color = vec4(c*d, 1.) + vNorml;\n"
        "}\n");
    p.explain(
        "0:6(26): error: `vNorml' undeclared\n"
        "0:6(12): error: no matching function for call to `dot(vec3, error)'; candidates are:\n"
        "0:6(12): error:    float dot(float, float)\n"
        "0:6(12): error:    float dot(vec2, vec2)\n"
        "0:7(11): error: `uLightColour' undeclared\n"
        "0:7(26): error: `vNorml' undeclared\n"
        "0:7(11): error: operands to arithmetic operators must be numeric\n"
        "0:8(15): warning: `c' used uninitialized\n"
        "0:8(17): warning: `d' used uninitialized\n"
        "0:8(26): error: `vNorml' undeclared\n"
        "0:8(10): error: operands to arithmetic operators must be numeric\n");
    ASSERT_EQ(p.diagnostics.items().size(), 2u);
    EXPECT_EQ(p.code(0), "glsl-undeclared");
    EXPECT_EQ(p.message(0), "'vNorml' is not declared (fragment shader of 'Demo')");
    EXPECT_EQ(p.place(0), "demo.frag:6:28 vNorml");
    EXPECT_EQ(p.help(0), "did you mean 'vNormal'?");
    EXPECT_EQ(p.note(0, 0), "demo.frag:3:9 vNormal: declared here");
    EXPECT_TRUE(p.has_note(0, "and 5 more"));
    EXPECT_EQ(p.place(1), "demo.frag:7:12 uLightColour");
    EXPECT_EQ(p.note(1, 0), "demo.frag:2:14 uLightColor: this uniform is declared but never used");
}

// An attribute is not what another shader lacks.
TEST(MesaLog, AttributesAreOfTheVertexShader) {
    for (const std::string name : {"aVertex", "gl_Vertex", "aTexCoord3", "aOwn"}) {
        Program p;
        p.vertex("in vec4 aOwn;\nvoid main() { gl_Position = aOwn; }\n");
        p.fragment("out vec4 color;\nvoid main() { color = " + name + "; }\n");
        p.explain("0:2(23): error: `" + name + "' undeclared\n");
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.help(0), "only the vertex shader has attributes: hand '" + name + "' on in a varying of its own");
    }
}

TEST(MesaLog, MissingSemicolonOnTheLineBefore) {
    Program p;
    p.fragment(
        "#version 330 core\n"
        "out vec4 color;\n"
        "void main() {\n"
        "    float x = 1.0   // half\n"
        "    vec3 y = vec3(x);\n"
        "    color = vec4(y, 1.);\n"
        "}\n");
    p.explain("0:5(2): error: syntax error, unexpected BASIC_TYPE_TOK, expecting ',' or ';'\n");
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.message(0), "unexpected 'vec3', expecting ',' or ';' (fragment shader of 'Demo')");
    EXPECT_EQ(p.place(0), "demo.frag:5:5 vec3");
    EXPECT_EQ(p.help(0), "line 4 seems to lack a ';' at its end");
    EXPECT_EQ(p.note(0, 0), "demo.frag:4:17 0: a ';' is missing after this");
}

TEST(MesaLog, VectorSizes) {
    Program p;
    p.fragment(
        "in vec4 vP;\n"
        "vec3 f() { return vP; }\n"
        "void main() {\n"
        "    vec3 q;\n"
        "    q = vP * 2.;\n"
        "    q = vec3(1.) + vP;\n"
        "    vec4 r = q;\n"
        "}\n");
    p.explain(
        "0:2(12): error: `return' with wrong type vec4, in function `f' returning vec3\n"
        "0:5(2): error: value of type vec4 cannot be assigned to variable of type vec3\n"
        "0:6(6): error: vector size mismatch for arithmetic operator\n"
        "0:7(2): error: initializer of type vec3 cannot be assigned to variable of type vec4\n");
    ASSERT_EQ(p.diagnostics.items().size(), 4u);
    EXPECT_EQ(p.message(0), "this returns a 'vec4' from a function of type 'vec3' (fragment shader of 'Demo')");
    EXPECT_EQ(p.help(1), "take 3 of its components: write '.xyz' after the vec4");
    EXPECT_EQ(p.place(1), "demo.frag:5:5 q");
    EXPECT_EQ(p.code(2), "glsl-type");
    EXPECT_EQ(p.place(2), "demo.frag:6:9 vec3");
    EXPECT_NE(p.help(2).find(".xyz"), std::string::npos);
    EXPECT_EQ(p.help(3), "give the missing component: vec4(…, 1.)");
}

TEST(MesaLog, WrongArgumentsOfABuiltIn) {
    Program p;
    p.fragment("void main() {\n    vec3 q;\n    float z = mix(q, 1.);\n    float d = dot(q, q.xy);\n}\n");
    p.explain(
        "0:3(12): error: no matching function for call to `mix(vec3, float)'; candidates are:\n"
        "0:3(12): error:    float mix(float, float, float)\n"
        "0:4(12): error: no matching function for call to `dot(vec3, vec2)'; candidates are:\n"
        "0:4(12): error:    float dot(float, float)\n");
    ASSERT_EQ(p.diagnostics.items().size(), 2u);
    EXPECT_EQ(p.message(0), "no function 'mix' takes (vec3, float) (fragment shader of 'Demo')");
    EXPECT_EQ(p.help(0), "mix(a, b, t) takes 3 arguments");
    EXPECT_EQ(p.place(0), "demo.frag:3:15 mix");
    EXPECT_EQ(p.help(1), "dot(a, b) wants arguments of matching sizes");
}

TEST(MesaLog, EndOfFilePointsAtTheBraceLeftOpen) {
    Program p;
    p.fragment(
        "out vec4 color;\nvoid main() {\n    float x = 1.0;\n    if (x > 0.) {\n        x = 2.;\n    color = "
        "vec4(x);\n}\n");
    p.explain("0:8(1): error: syntax error, unexpected end of file\n");
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.place(0), "demo.frag:4:17 {");
    EXPECT_EQ(p.message(0), "this '{' is never closed (fragment shader of 'Demo')");
    EXPECT_EQ(p.note(0, 0), "demo.frag:7:1 }: the text ends here");
}

TEST(MesaLog, SurplusBrace) {
    Program p;
    p.fragment("void main() {\n    gl_FragColor = vec4(1.);\n} }\n");
    p.explain("0:3(3): error: syntax error, unexpected '}', expecting end of file\n");
    EXPECT_EQ(p.place(0), "demo.frag:3:3 }");
    EXPECT_EQ(p.help(0), "there are more '}' than '{'");
}

TEST(MesaLog, PreprocessorErrorsKeepTheirLine) {
    Program p;
    p.fragment("#ifdef X\n#define F(a) a\nvoid main() {\n    float x = F(1.0, 2);\n}\n");
    p.explain(
        "0:4(15): preprocessor error: Error: macro F invoked with 2 arguments (expected 1)\n"
        "0:1(1): preprocessor error: Unterminated #if\n\n");
    ASSERT_EQ(p.diagnostics.items().size(), 2u);
    EXPECT_EQ(p.place(0), "demo.frag:4:15 F");
    EXPECT_EQ(p.message(0), "macro F invoked with 2 arguments (expected 1) (fragment shader of 'Demo')");
    EXPECT_EQ(p.message(1), "an #if, #ifdef or #ifndef has no #endif (fragment shader of 'Demo')");
    EXPECT_EQ(p.line(1), 1);
}

TEST(MesaLog, UnknownTypes) {
    Program p;
    p.fragment("void main() {\n    half4 a;\n    vex3 b;\n}\n");
    p.explain("0:2(8): error: syntax error, unexpected NEW_IDENTIFIER, expecting ',' or ';'\n");
    EXPECT_EQ(p.message(0), "'half4' is not a type (fragment shader of 'Demo')");
    EXPECT_EQ(p.help(0), "did you mean 'vec4'?");
    EXPECT_EQ(p.place(0), "demo.frag:2:5 half4");
}

TEST(MesaLog, SourceStringsLeadToIncludedFiles) {
    Program p;
    p.fragment("#include \"light.glsl\"\nvoid main() { gl_FragColor = lit(vec3(1.)); }\n",
               "#version 330 core\n#line 1 1\nvec4 lit(vec3 n)\n{ return vec4(n * strenght, 1.); }\n#line 2 0\nvoid "
               "main() { }\n",
               {{"light.glsl", "vec4 lit(vec3 n)\n{ return vec4(n * strenght, 1.); }\n"}});
    p.explain("1:2(19): error: `strenght' undeclared\n");
    EXPECT_EQ(p.place(0), "light.glsl:2:19 strenght");
}

TEST(MesaLog, TheTranslationsNamesBecomeTheUsersAgain) {
    Program p;
    p.vertex("varying vec3 N;\nvoid main() {\n    vec3 p = gl_Vertex;  N = gl_NormalMatrix * gl_Normal;\n}\n",
             "#version 330 core\nin vec4 snell_Vertex;\n#line 3 0\n    vec3 p = snell_Vertex;  N = snell_NormalMatrix "
             "* snell_Normal;\n");
    p.explain("0:3(14): error: could not convert `snell_Vertex' by snell_NormalMatrix\n", Stage::vertex);
    EXPECT_EQ(p.message(0), "could not convert 'gl_Vertex' by gl_NormalMatrix (vertex shader of 'Demo')");
    // Columns are of the translation, where "snell_Normal" stands further right.
    Program q;
    q.vertex("void main() {\n    vec3 a = gl_Normal + gl_Vertex + gl_Normal;\n}\n",
             "#version 330 core\n#line 2 0\n    vec3 a = snell_Normal + snell_Vertex + snell_Normal;\n");
    q.explain("0:2(41): error: vector size mismatch for arithmetic operator\n", Stage::vertex);
    EXPECT_EQ(q.place(0), "demo.vert:2:38 gl_Normal");
}

TEST(MesaLog, OldTextureNamesInCalls) {
    Program p;
    p.fragment("uniform sampler2D t;\nvoid main() {\n    gl_FragColor = texture2D(t, vec3(0.));\n}\n",
               "#version 330 core\n#line 3 0\n    snell_FragColor = texture(t, vec3(0.));\n");
    p.explain(
        "0:3(20): error: no matching function for call to `texture(sampler2D, vec3)'; candidates are:\n"
        "0:3(20): error:    vec4 texture(sampler1D, float)\n");
    EXPECT_EQ(p.message(0), "no function 'texture2D' takes (sampler2D, vec3) (fragment shader of 'Demo')");
    EXPECT_EQ(p.place(0), "demo.frag:3:20 texture2D");
}

TEST(MesaLink, MissingMain) {
    Program p;
    p.vertex("void main() { }\n");
    p.fragment("out vec4 c;\nvoid Main() { c = vec4(1.); }\n");
    p.explain_link("error: fragment shader lacks `main'\n");
    EXPECT_EQ(p.code(0), "glsl-no-main");
    EXPECT_EQ(p.place(0), "demo.frag:2:6 Main");
    EXPECT_EQ(p.help(0), "did you mean 'main' instead of 'Main'?");
}

TEST(MesaLink, NamesThatDifferByCase) {
    Program p;
    p.vertex("out vec3 vnormal;\nvoid main() { vnormal = vec3(1.); }\n");
    p.fragment("in vec3 vNormal;\nvoid main() { }\n");
    p.explain_link(
        "warning: fragment shader varying vNormal not written by vertex shader\n"
        ".warning: fragment shader varying vNormal not written by vertex shader\n.");
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.diagnostics.items()[0].severity, Severity::warning);
    EXPECT_EQ(p.place(0), "demo.frag:1:9 vNormal");
    EXPECT_EQ(p.help(0), "the vertex shader calls it 'vnormal': the names must agree, capitals included");
    EXPECT_EQ(p.note(0, 0), "demo.vert:1:10 vnormal: the output is declared here");
}

TEST(MesaLink, TypesThatDiffer) {
    Program p;
    p.vertex("out vec2 vST;\nvoid main() { }\n");
    p.fragment("in vec3 vST;\nvoid main() { }\n");
    p.explain_link(
        "error: vertex shader output `vST' declared as type `vec2', but fragment shader input declared as "
        "type `vec3'\n");
    EXPECT_EQ(p.code(0), "glsl-interface");
    EXPECT_EQ(p.place(0), "demo.frag:1:9 vST");
    EXPECT_EQ(p.note(0, 0), "demo.vert:1:10 vST: the vertex shader declares 'vec2' here");
}

TEST(MesaLink, NothingToSayOfShadersThatDidNotCompile) {
    Program p;
    p.fragment("void main() { }\n");
    p.explain_link("error: linking with uncompiled/unspecialized shader");
    EXPECT_TRUE(p.diagnostics.empty());
}

TEST(Log, LinesThatLeadNowherePointAtTheScene) {
    Program p;
    p.fragment("void main() { }\n");
    p.explain("7:3(1): error: `x' undeclared\n");
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.diagnostics.items()[0].span, p.where);
}

TEST(Log, UnknownFormatsAreShownAsTheyAre) {
    Program p;
    p.fragment("void main() { }\n");
    p.explain("The compiler gave up.\n");
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.message(0), "the compiler gave up (fragment shader of 'Demo')");
}

TEST(Log, AnyBytesAreSurvived) {
    std::uint32_t seed = 1;
    const std::string alphabet = "0123:() '`\"\n\t.,;{}ERORerrowarning#CvNorml\xff";
    for (int round = 0; round < 3000; ++round) {
        std::string log = round % 2 ? "0:2(" : "ERROR: 0:1: ";
        for (int i = 0; i < 60; ++i) {
            seed = seed * 1664525u + 1013904223u;
            log += alphabet[(seed >> 16) % alphabet.size()];
        }
        Program p;
        p.fragment(round % 3 ? "void main() {\n  vNorml = 1 /* \n" : "");
        p.explain(log);
        p.explain_link(log);
        for (const Diagnostic& d : p.diagnostics.items()) EXPECT_FALSE(d.message.empty());
    }
}

}  // namespace
}  // namespace snell::glsl
