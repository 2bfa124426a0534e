// What old versions of GLSL have and later ones have not; tests/glsl draws most of it.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

TEST(GlslOld, LiftedDeclarationsKeepEveryLine) {
    const Translated t = fragment(
        "struct Outer {\n    float f;  // one\n    struct Inner {\n        int i;\n        struct { vec2 v; } deep;\n"
        "    } inner;\n#define K 2\n} outer;\nvoid main() {\n    float half(\n        float x);\n"
        "    gl_FragColor = vec4(half(outer.inner.deep.v.x));\n}\nfloat half(float x) { return .5 * x; }\n");
    EXPECT_EQ(line_of(t.text(Stage::fragment), "} outer;"), 8);
    EXPECT_EQ(line_of(t.text(Stage::fragment), "snell_FragColor = "), 12);
    EXPECT_EQ(line_of(t.text(Stage::fragment), "return .5 * x"), 14);
}

TEST(GlslOld, StructuresInStructures) {
    for (const char* text :
         {"struct A { struct B { struct C { float x; } c; } b; struct D { vec2 y; } d; } a;\n"
          "void main() { B b; D d; b.c.x = 1.; gl_FragColor = vec4(b.c.x, d.y, 1.); }\n",
          "#define INNER struct B { float x; }\nstruct A { INNER b; };\nvoid main() { A a; a.b.x = 1.; gl_FragColor = "
          "vec4(a.b.x); }\n",
          "void main() { const struct A { struct B { float x; } b; } a = A(B(.5)); gl_FragColor = vec4(a.b.x); }\n",
          "struct A { struct B { float x; } b[2], c; };\nuniform A a;\nvoid main() { gl_FragColor = vec4(a.b[1].x + "
          "a.c.x); }\n",
          // A qualifier that qualifies nothing.
          "varying struct A { float x; };\nvoid main() { A a; a.x = 1.; gl_FragColor = vec4(a.x); }\n"}) {
        SCOPED_TRACE(text);
        expect_valid({{Stage::fragment, text}}, {es320});
    }
    // What is not closed is the driver's to judge.
    for (const char* text : {"struct A { struct B { float x; } b;", "struct A { struct", "struct struct struct {{{"})
        fragment(text);
}

// Variables of structures without a name begin as zero like all others, in every scope, alone and in arrays.
TEST(GlslOld, StructuresWithoutNames) {
    const std::string text =
        "struct { float a; vec3 b; } s;\nuniform struct { vec4 a; } light;\n"
        "void main() { struct { float x; } t[2], u; gl_FragColor = vec4(s.b, s.a) + t[1].x + u.x + light.a; }\n";
    const Translated t = fragment(text);
    EXPECT_TRUE(t.has(Stage::fragment, "s = struct_of_s(0.0, vec3(0.0));"));
    EXPECT_TRUE(t.has(Stage::fragment, "t[2] = struct_of_t[2](struct_of_t(0.0), struct_of_t(0.0))"));
    EXPECT_TRUE(t.has(Stage::fragment, "u = struct_of_t(0.0)"));
    expect_valid(
        {{Stage::vertex, "uniform struct { vec4 a; } light;\nvoid main() { gl_Position = light.a * ftransform(); }\n"},
         {Stage::fragment, text}});
    for (const char* broken : {"struct {", "struct { float x;", "struct { struct { float x; }; } ;", "struct {}"})
        fragment(broken);
}

// OpenGL ES has no arrays that get their size by their use.
TEST(GlslOld, ArraysWithoutSize) {
    const std::string vertex =
        "varying vec4 c[];\nvoid main() { c[0] = c[2] = vec4(1.); gl_Position = ftransform(); }\n";
    const std::string fragment = "varying vec4 c[];\nvoid main() { gl_FragColor = c[0] + c[1]; }\n";
    const Texts texts{{Stage::vertex, vertex}, {Stage::fragment, fragment}};
    expect_valid(texts, {es300, es320});
    const Translated t = translated(texts, es300);
    EXPECT_TRUE(t.has(Stage::vertex, "vec4 c[3];"));
    EXPECT_TRUE(t.has(Stage::fragment, "vec4 c[3];"));
    EXPECT_TRUE(translated(texts).has(Stage::fragment, "vec4 c[];"));  // desktops count themselves
    expect_valid({{Stage::fragment,
                   "float w[];\nfloat f() { return w[1]; }\nfloat w[3];\n"
                   "void main() { w[2] = 1.; gl_FragColor = vec4(f()); }\n"}},
                 {es320});
    const Translated refused =
        test::fragment("uniform int n;\nfloat w[];\nvoid main() { w[n] = 1.; gl_FragColor = vec4(w[0]); }\n", es320);
    EXPECT_EQ(refused.count("array-size"), 1);
    EXPECT_EQ(refused.sources.position(0, refused.diagnostics.items().front().span.begin).line, 2);
}

TEST(GlslOld, InvariantEverything) {
    const std::string pragma = "#pragma STDGL invariant(all)\n";
    const Texts texts{{Stage::vertex, pragma + "void main() { gl_Position = ftransform(); }\n"},
                      {Stage::fragment, pragma + "void main() { gl_FragColor = vec4(1.); }\n"}};
    expect_valid(texts);
    const Translated t = translated(texts);
    EXPECT_TRUE(t.has(Stage::vertex, "#pragma STDGL"));
    EXPECT_FALSE(t.has(Stage::fragment, "#pragma"));
}

TEST(GlslOld, PrototypesInFunctions) {
    const Translated t = fragment(
        "void main() {\n    float f(in float x), y;\n    vec3 v(1.);\n    float g(float) + 1.;\n"
        "    gl_FragColor = vec4(1.);\n}\n");
    EXPECT_TRUE(t.has(Stage::fragment, "float f(in float x), y;")) << "not understood, and left alone";
    EXPECT_TRUE(t.has(Stage::fragment, "vec3 v(1.);"));
    expect_valid({{Stage::fragment,
                   "struct S { float x; };\nvoid main() {\n    { float f(const in S s, out float x); float x; "
                   "gl_FragColor = vec4(f(S(1.), x) + x); }\n}\nfloat f(const in S s, out float x) { x = 1.; return "
                   "s.x; }\n"}});
}

TEST(GlslOld, FunctionsAndVariablesOfOneName) {
    // In every order, and a macro between.
    expect_valid(
        {{Stage::fragment,
          "float f(float x) { return x; }\nconst float f = .5;\nuniform float g;\nfloat g(float x) { return g * "
          "x; }\n#define H(x) g(x) + f(x)\nvoid main() { gl_FragColor = vec4(H(f)); }\n"}});
    // Nothing changes where the language itself tells them apart.
    const Translated t = fragment(
        "float f(float f) { return f; }\nvoid main() { float x = f(1.); { float f = x; x += f; } gl_FragColor = "
        "vec4(x); "
        "}\n");
    EXPECT_FALSE(t.has(Stage::fragment, "snell_f"));
}

TEST(GlslOld, NamesOfLayoutsAreNotCaseSensitive) {
    const Translated t =
        translated({{Stage::geometry,
                     "#version 150\nlayout(TRIANGLES) in;\nlayout(Points, maX_VERTices = 50) out;\nvoid main() {}\n"}});
    EXPECT_FALSE(t.has(Stage::geometry, "max_vertices"));
    EXPECT_FALSE(t.has(Stage::geometry, "layout(triangle_strip)"));
}

TEST(GlslOld, BlocksThatNoStageGives) {
    const char* blocks =
        "#version 150\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
        "in Shade { flat int k; vec3 n[2]; } shade[];\nin vec2 st[];\nvoid main() {\n"
        "    for (int i = 0; i < 3; ++i) {\n        gl_Position = gl_in[i].gl_Position + vec4(shade[i].n[1], "
        "shade[i].k) + st[i].xyxy;\n        EmitVertex();\n    }\n}\n";
    const Texts texts = {{Stage::vertex, "void main() { gl_Position = gl_Vertex; }\n"},
                         {Stage::geometry, blocks},
                         {Stage::fragment, "void main() { gl_FragColor = vec4(1.); }\n"}};
    expect_valid(texts, {core450, core330});
    const Translated t = translated(texts);
    EXPECT_EQ(t.count("input-without-output"), 2);
    EXPECT_TRUE(t.has(Stage::geometry, "shade[3]"));
    // A block that is given stays one.
    EXPECT_TRUE(translated({{Stage::vertex,
                             "#version 150\nout B { vec3 c; } o;\nvoid main() { o.c = vec3(1.); "
                             "gl_Position = vec4(1.); }\n"},
                            {Stage::fragment,
                             "#version 150\nin B { vec3 c; } i;\nout vec4 f;\nvoid main() { f = "
                             "vec4(i.c, 1.); }\n"}})
                    .has(Stage::fragment, "in B { vec3 c; } i;"));
}

}  // namespace
}  // namespace snell::glsl::test
