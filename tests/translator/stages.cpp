// Geometry and tessellation, what passes between stages, and stages that are missing.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

const std::string plain_vertex =
    "#version 330 compatibility\nout vec3 vN;\n"
    "void main() { vN = gl_Normal; gl_FrontColor = gl_Color; gl_TexCoord[0] = gl_MultiTexCoord0; gl_Position = "
    "gl_Vertex; }\n";

TEST(GlslStages, CoreStyleGeometryWithOldInputs) {
    const Texts texts = {
        {Stage::vertex, plain_vertex},
        {Stage::geometry,
         "#version 330 compatibility\n#extension GL_EXT_geometry_shader4: enable\n#extension GL_EXT_gpu_shader4: "
         "require\n"
         "layout(triangles) in;\nlayout(triangle_strip, max_vertices=204) out;\nin vec3 vN[3];\nout vec3 gN;\n"
         "void main() { for (int i = 0; i < gl_VerticesIn; i++) { gN = vN[i]; gl_FrontColor = gl_FrontColorIn[i];\n"
         "gl_TexCoord[0] = gl_TexCoordIn[i][0]; gl_Position = gl_ModelViewProjectionMatrix * gl_PositionIn[i]; "
         "EmitVertex(); } }\n"},
        {Stage::fragment,
         "#version 330 compatibility\nin vec3 gN;\nvoid main() { gl_FragColor = vec4(gN, 1.) * gl_Color + "
         "gl_TexCoord[0]; }\n"}};
    const Translated t = translated(texts);
    EXPECT_TRUE(t.has(Stage::geometry, "gl_in[i].gl_Position"));
    EXPECT_TRUE(t.has(Stage::geometry, "snell_in[i].snell_FrontColor"));
    EXPECT_TRUE(t.has(Stage::geometry, "snell_in[i].snell_TexCoord[0]"));
    EXPECT_FALSE(t.has(Stage::geometry, "#extension"));
    EXPECT_TRUE(t.diagnostics.items().empty());
    expect_valid(texts);
}

TEST(GlslStages, MembersOfGlIn) {
    expect_valid({{Stage::vertex, plain_vertex},
                  {Stage::geometry,
                   "#version 330 compatibility\nlayout(triangles) in; layout(points, max_vertices=3) out;\n"
                   "void main() { for (int i = 0; i < 3; ++i) { gl_FrontColor = gl_in[i].gl_FrontColor;\n"
                   "gl_TexCoord[0] = gl_in[i].gl_TexCoord[0]; gl_Position = gl_in[i].gl_Position; EmitVertex(); } }"},
                  {Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_TexCoord[0]; }"}});
}

TEST(GlslStages, OldGeometryTakesItsTopologyFromTheScene) {
    const Texts texts = {
        {Stage::vertex, "varying vec3 n; void main() { n = gl_Normal; gl_Position = gl_Vertex; }"},
        {Stage::geometry,
         "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nvarying in vec3 n[];\n"
         "varying out vec3 g;\nvoid main() { g = n[0]; gl_Position = gl_PositionIn[0]; EmitVertex(); }"},
        {Stage::fragment, "varying vec3 g; void main() { gl_FragColor = vec4(g, 1.); }"}};
    Translated t;
    Options options;
    options.target = core450;
    options.geometry_input = "gl_lines";
    options.geometry_output = "gl_line_strip";
    translate_texts(t, texts, options);
    EXPECT_TRUE(t.has(Stage::geometry, "layout(lines) in;"));
    EXPECT_TRUE(t.has(Stage::geometry, "layout(line_strip) out;"));
    EXPECT_TRUE(t.has(Stage::geometry, "max_vertices = "));
    expect_accepted(t.translation, true);
    expect_valid(texts);
}

TEST(GlslStages, OldArraysHaveTheSizeOfThePrimitive) {
    const Texts texts = {
        {Stage::vertex, "varying vec3 n; varying vec3 m; void main() { n = m = gl_Normal; gl_Position = gl_Vertex; }"},
        {Stage::geometry,
         "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nvarying in vec3 n[gl_VerticesIn];\n"
         "varying in vec3[gl_VerticesIn] m;\nvarying out vec3 g;\nvec3 kept[gl_VerticesIn + 1], one = n[0];\n"
         "void main() { kept[gl_VerticesIn] = m[1]; g = kept[gl_VerticesIn] + one; gl_Position = gl_PositionIn[0]; "
         "EmitVertex(); }"},
        {Stage::fragment, "varying vec3 g; void main() { gl_FragColor = vec4(g, 1.); }"}};
    Translated t;
    Options options;
    options.target = core450;
    options.geometry_input = "gl_lines";
    translate_texts(t, texts, options);
    EXPECT_TRUE(t.has(Stage::geometry, "in vec3 n[2];"));
    EXPECT_TRUE(t.has(Stage::geometry, "vec3 kept[2+1];"));
    expect_accepted(t.translation, true);
    expect_valid(texts);
}

TEST(GlslStages, OldArraysGoOutIfTheTextSaysSo) {
    const Texts texts = {
        {Stage::vertex, "varying vec3 n; void main() { n = gl_Normal; gl_Position = gl_Vertex; }"},
        {Stage::geometry,
         "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nvarying in vec3 n[];\nvarying out vec4 two[2];\n"
         "void main() { two[0] = vec4(n[0], 1.); two[1] = vec4(1.); gl_Position = gl_PositionIn[0]; EmitVertex(); }"},
        {Stage::fragment, "#version 120\nvarying vec4 two[2]; void main() { gl_FragColor = two[0] * two[1]; }"}};
    Translated t;
    translate_texts(t, texts, {.target = core450});
    EXPECT_TRUE(t.has(Stage::geometry, "out vec4 two[2];"));
    EXPECT_TRUE(t.diagnostics.items().empty());
    expect_accepted(t.translation, true);
    expect_valid(texts);
}

TEST(GlslStages, TessellationWithLegacyMatrices) {
    expect_valid(
        {{Stage::vertex, "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }"},
         {Stage::tess_control,
          "#version 400 compatibility\n#extension GL_ARB_tessellation_shader : enable\nuniform float uOuter;\n"
          "layout(vertices = 16) out;\nvoid main() { gl_out[gl_InvocationID].gl_Position = "
          "gl_in[gl_InvocationID].gl_Position;\n"
          "gl_TessLevelOuter[0] = uOuter; gl_TessLevelOuter[1] = 1; gl_TessLevelInner[0] = 2; }"},
         {Stage::tess_evaluation,
          "#version 400 compatibility\nlayout(quads, equal_spacing, ccw) in;\nout vec3 teN;\n"
          "void main() { teN = gl_NormalMatrix * vec3(1, 0, 0);\n"
          "gl_Position = gl_ModelViewProjectionMatrix * gl_in[0].gl_Position * gl_TessCoord.x; }"},
         {Stage::fragment, "#version 400 compatibility\nin vec3 teN;\nvoid main() { gl_FragColor = vec4(teN, 1.); }"}},
        {core450, core410, es320});
}

TEST(GlslStages, MissingStagesAreBuiltIn) {
    for (const Texts& texts :
         {Texts{{Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_TexCoord[0]; }"}},
          Texts{{Stage::vertex, "void main() { gl_FrontColor = gl_Color; gl_Position = ftransform(); }"}}}) {
        expect_valid(texts);
        expect_accepted(translated(texts).translation, true);
    }
    const Translated t = fragment("void main() { gl_FragColor = gl_Color; }");
    EXPECT_TRUE(t.has(Stage::vertex, "snell_FrontColor = snell_Color"));
}

TEST(GlslStages, InputWithoutOutputReadsZero) {
    const Texts texts = {
        {Stage::vertex, "#version 330\nin vec3 aVertex; void main() { gl_Position = vec4(aVertex, 1.); }"},
        {Stage::fragment, "#version 330\nin vec3 vLost; out vec4 c; void main() { c = vec4(vLost, 1.); }"}};
    const Translated t = translated(texts);
    EXPECT_EQ(t.count("input-without-output"), 1);
    EXPECT_TRUE(t.has(Stage::fragment, "vLost = vec3(0.0);"));
    expect_valid(texts);
}

TEST(GlslStages, VaryingsOfTwoTypes) {
    const Texts texts = {
        {Stage::vertex, "varying vec4 v; varying float f; void main() { v = gl_Vertex; f = 1.; gl_Position = v; }"},
        {Stage::fragment, "varying vec3 v; varying vec2 f; void main() { gl_FragColor = vec4(v, f.y); }"}};
    EXPECT_EQ(translated(texts).count("varying-types"), 2);
    expect_valid(texts);
}

TEST(GlslStages, UniformsOfTwoTypes) {
    const Texts texts = {
        {Stage::vertex,
         "uniform int uN; uniform vec4 uC; void main() { gl_FrontColor = uC * uN; gl_Position = ftransform(); }"},
        {Stage::fragment, "uniform float uN; uniform vec3 uC; void main() { gl_FragColor = vec4(uC * uN, 1.); }"}};
    const Translated t = translated(texts);
    EXPECT_TRUE(t.has(Stage::vertex, "uniform float uN;"));
    EXPECT_TRUE(t.has(Stage::vertex, "int(uN)"));
    EXPECT_TRUE(t.has(Stage::fragment, "uniform vec4 uC;"));
    expect_valid(texts);
}

TEST(GlslStages, FlatBothSides) {
    const Texts texts = {
        {Stage::vertex,
         "#version 330 compatibility\nflat varying vec3 c; out int n; void main() { c = gl_Normal; n = 3; gl_Position "
         "= gl_Vertex; }"},
        {Stage::fragment,
         "#version 330 compatibility\nflat varying vec3 c; in int n; void main() { gl_FragColor = vec4(c, n); }"}};
    const Translated t = translated(texts);
    EXPECT_TRUE(t.has(Stage::fragment, "flat in vec3 c;"));
    EXPECT_TRUE(t.has(Stage::fragment, "flat in int n;"));
    expect_valid(texts);
}

TEST(GlslStages, Attributes) {
    const Translated known = vertex(
        "#version 330\nlayout(location = 0) in vec3 i_position; layout(location = 1) in vec4 i_normal;\n"
        "out vec3 v; void main() { v = i_normal.xyz; gl_Position = vec4(i_position, i_normal.w); }");
    EXPECT_FALSE(known.has(Stage::vertex, "location"));
    EXPECT_TRUE(known.has(Stage::vertex, "in vec3 i_position;"));
    // A direction has w = 0, whatever OpenGL fills in.
    EXPECT_TRUE(known.has(Stage::vertex, "i_normal = vec4(snell_Normal, 0.0);"));
    const Translated located =
        vertex("#version 330\nlayout(location = 1) in vec3 q; void main() { gl_Position = vec4(q, 1.); }");
    EXPECT_TRUE(located.has(Stage::vertex, "q = snell_Normal;"));
    const Translated unknown = vertex("attribute float weight; void main() { gl_Position = gl_Vertex * weight; }");
    EXPECT_EQ(unknown.count("unknown-attribute"), 1);
    // Two names for one attribute would share a location.
    const Translated twice = vertex(
        "#version 330 compatibility\nin vec3 aNormal; void main() { gl_Position = vec4(aNormal + gl_Normal, 1.); }");
    EXPECT_TRUE(twice.has(Stage::vertex, "aNormal = snell_Normal;"));
}

TEST(GlslStages, AggregatesThatAreNotWrittenAreZero) {
    const std::string structs = "#version 150\nstruct S { vec4 a; float b; };\nstruct Own { vec4 a; float b[2]; };\n";
    const std::string vertex = structs +
                               "out S s;\nout Shade { vec4 c; } shade;\nout vec4 list[2];\n"
                               "void set(out mat2 m) { m[0] = vec2(1.); }\n"
                               "void main() { Own t; mat2 m; set(m); s.a.x = m[0].x; list[0] = t.a; "
                               "gl_Position = vec4(0.); }";
    const std::string fragment = structs +
                                 "in S s;\nin Shade { vec4 c; } shade;\nin vec4 list[2];\nOwn kept;\nout vec4 color;\n"
                                 "void main() { color = s.a + shade.c + list[1] + kept.a; }";
    const Texts texts = {{Stage::vertex, vertex}, {Stage::fragment, fragment}};
    const Translated t = translated(texts);
    EXPECT_TRUE(t.has(Stage::vertex, "Own t = Own(vec4(0.0), float[2](0.0, 0.0))"));
    EXPECT_TRUE(t.has(Stage::vertex, "s = S(vec4(0.0), 0.0);"));
    EXPECT_TRUE(t.has(Stage::vertex, "shade.c = vec4(0.0);"));
    EXPECT_TRUE(t.has(Stage::vertex, "list = vec4[2](vec4(0.0), vec4(0.0));"));
    EXPECT_TRUE(t.has(Stage::vertex, "m = mat2(0.0);"));
    EXPECT_TRUE(t.has(Stage::fragment, "kept = Own(vec4(0.0), float[2](0.0, 0.0));"));
    expect_valid(texts);
}

TEST(GlslStages, BuiltInInputsThatNobodyWrites) {
    const Texts texts = {
        {Stage::vertex, "void main() { gl_Position = ftransform(); }"},
        {Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_TexCoord[1] + gl_FogFragCoord; }"}};
    const Translated t = translated(texts);
    EXPECT_EQ(t.count("input-without-output"), 3);
    EXPECT_TRUE(t.has(Stage::vertex, "snell_FrontColor = snell_Color;"));
    EXPECT_TRUE(t.has(Stage::vertex, "snell_TexCoord = vec4[2](vec4(0.0, 0.0, 0.0, 1.0), vec4(0.0, 0.0, 0.0, 1.0));"));
    expect_valid(texts);
    expect_valid({{Stage::vertex, "void main() { gl_Position = gl_Vertex; }"},
                  {Stage::geometry,
                   "void main() { gl_FrontColor = gl_FrontColorIn[0]; gl_Position = gl_PositionIn[0]; EmitVertex(); }"},
                  {Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_TexCoord[0]; }"}});
}

// The current colour is handed on by every stage that leaves it out; said once.
TEST(GlslStages, TheColorThatNobodyWrites) {
    const Texts texts = {{Stage::vertex, "void main() { gl_Position = gl_Vertex; }"},
                         {Stage::geometry, "void main() { gl_Position = gl_PositionIn[0]; EmitVertex(); }"},
                         {Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_SecondaryColor; }"}};
    const Translated t = translated(texts);
    EXPECT_EQ(t.count("input-without-output"), 2);
    EXPECT_TRUE(t.has(Stage::vertex, "snell_FrontColor = snell_Color;"));
    EXPECT_TRUE(t.has(Stage::geometry, "snell_FrontColor = snell_in[0].snell_FrontColor;"));
    expect_valid(texts);
    const Translated without = vertex("void main() { gl_Position = gl_Vertex; }");
    EXPECT_TRUE(without.diagnostics.items().empty());
    EXPECT_TRUE(without.has(Stage::vertex, "snell_FrontColor = snell_Color;"));
    EXPECT_TRUE(without.has(Stage::fragment, "snell_FragColor = snell_FrontColor;"));
    expect_valid({{Stage::vertex, "#version 400\nin vec4 aVertex; void main() { gl_Position = aVertex; }"},
                  {Stage::tess_control,
                   "#version 400\nlayout(vertices = 3) out; void main() { gl_out[gl_InvocationID].gl_Position = "
                   "gl_in[gl_InvocationID].gl_Position; gl_TessLevelOuter[0] = 1.; }"},
                  {Stage::tess_evaluation,
                   "#version 400\nlayout(triangles) in; void main() { gl_Position = gl_in[0].gl_Position; }"},
                  {Stage::fragment, "void main() { gl_FragColor = gl_Color; }"}},
                 {core450, core410, es320});
}

TEST(GlslStages, FlatColors) {
    Options options;
    options.flat_color = true;
    Translated t;
    translate_texts(t,
                    {{Stage::vertex,
                      "void main() { gl_FrontColor = gl_Color; gl_BackColor = gl_Color; gl_TexCoord[0] = "
                      "gl_Vertex; gl_Position = gl_Vertex; }"},
                     {Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_TexCoord[0]; }"}},
                    options);
    EXPECT_TRUE(t.has(Stage::vertex, "flat out vec4 snell_FrontColor;"));
    EXPECT_TRUE(t.has(Stage::fragment, "flat in vec4 snell_BackColor;"));
    EXPECT_FALSE(t.has(Stage::fragment, "flat in vec4 snell_TexCoord"));
    expect_accepted(t.translation, true);
}

// Colours, texture coordinates, structures, arrays, blocks and whole numbers pass the stage that widens lines.
TEST(GlslStages, WideLines) {
    const Texts rich = {
        {Stage::vertex,
         "#version 330 compatibility\nstruct Inner { vec3 n; float w[2]; }; struct S { Inner inner; vec4 c; };\n"
         "out S vS; out mat3 vM; out float vA[3]; flat out int vN; flat out vec2 vF; out vec3 vUnread;\n"
         "out Named { vec3 a; flat int b; } vs; out Plain { vec2 c; };\n"
         "void main() { vS.c = gl_Color; vS.inner = Inner(gl_Normal, float[2](1., 2.)); vM = gl_NormalMatrix;\n"
         "vA = float[3](1., 2., 3.); vN = 1; vF = vec2(0.); vUnread = vec3(1.); vs.a = gl_Normal; vs.b = 2;\n"
         "c = vec2(1.); gl_FrontColor = gl_Color; gl_TexCoord[1] = gl_Vertex; gl_Position = ftransform(); }"},
        {Stage::fragment,
         "#version 330 compatibility\nstruct Inner { vec3 n; float w[2]; }; struct S { Inner inner; vec4 c; };\n"
         "in S vS; in mat3 vM; in float vA[3]; flat in int vN; flat in vec2 vF;\n"
         "in Named { vec3 a; flat int b; } fs; in Plain { vec2 c; };\nvec3 moved = vM[0];\n"
         "void main() { gl_FragColor = gl_Color + gl_TexCoord[1] + vS.c * vS.inner.w[1] + vec4(moved, vA[2]) +\n"
         "vec4(vF, vN, fs.b) + vec4(fs.a, c.x); }"}};
    for (const Texts& texts : {rich, Texts{{Stage::vertex, "void main() { gl_Position = ftransform(); }"}},
                               Texts{{Stage::fragment, "void main() { gl_FragColor = gl_Color; }"}}})
        for (const Target& target : {core450, core330, es320})
            for (const bool flat : {false, true}) {
                Options options;
                options.target = target;
                options.wide_lines = true;
                options.flat_color = flat;
                Translated t;
                translate_texts(t, texts, options);
                // OpenGL ES passes no structures of structures: vertex shaders do what this stage does.
                const bool emulated = target.es && texts.size() == rich.size();
                EXPECT_EQ(t.translation.geometry.has_value(), emulated);
                ASSERT_EQ(t.translation.stages.size(), emulated ? 2U : 3U);
                EXPECT_EQ(t.translation.stages[1].stage, emulated ? Stage::fragment : Stage::geometry);
                expect_accepted(t.translation, target.version == 450);
            }
}

TEST(GlslStages, FragColorIsTheColorOfEveryTarget) {
    Options options;
    options.color_outputs = 3;
    Translated t;
    translate_texts(t, {{Stage::fragment, "void main() { gl_FragColor = vec4(1.); if (gl_FragCoord.x > 3.) return; }"}},
                    options);
    EXPECT_TRUE(t.has(Stage::fragment, "layout(location = 2) out vec4 snell_FragColor2;"));
    EXPECT_TRUE(t.has(Stage::fragment, "snell_main(); snell_FragColor1 = snell_FragColor;"));
    expect_accepted(t.translation);
    Translated own;
    translate_texts(own, {{Stage::fragment, "#version 330\nout vec4 c; void main() { c = vec4(1.); }"}}, options);
    EXPECT_TRUE(own.has(Stage::fragment, "layout(location = 1) out vec4 snell_Unwritten1;"));
    EXPECT_TRUE(own.has(Stage::fragment, "snell_Unwritten1 = vec4(0.0);"));
    EXPECT_FALSE(own.has(Stage::fragment, "location = 0"));
}

// What has no value would have one that another program left behind.
TEST(GlslStages, WhatIsNeverSetIsZero) {
    Translated t;
    translate_texts(
        t,
        {{Stage::vertex,
          "out vec2 vA; out vec3 vB; out float vC; void main() { if (gl_Vertex.x > 0.) vB = vec3(1.); vC = 1.; "
          "gl_Position = gl_Vertex; }"},
         {Stage::fragment,
          "in vec2 vA; in vec3 vB; in float vC; void main() { vec4 c; int n, m = 2; for (int i = 0; i < 2; ++i) "
          "n += m; gl_FragColor = c + vec4(vA + vC, vB.xy) * float(n); }"}},
        {});
    EXPECT_TRUE(t.has(Stage::vertex, "vA = vec2(0.0);"));
    EXPECT_TRUE(t.has(Stage::vertex, "vB = vec3(0.0);"));
    EXPECT_FALSE(t.has(Stage::vertex, "vC = 0.0;")) << "it is always set";
    EXPECT_TRUE(t.has(Stage::fragment, "vec4 c = vec4(0.0);"));
    EXPECT_TRUE(t.has(Stage::fragment, "int n = 0, m = 2;"));
    expect_accepted(t.translation, true);
    Translated none;
    translate_texts(none, {{Stage::fragment, "void main() { }"}}, {});
    EXPECT_TRUE(none.has(Stage::fragment, "snell_Unwritten0 = vec4(0.0);"));
}

TEST(GlslStages, DroppedBindingsAreDefaults) {
    const std::string text =
        "#version 420\nlayout(binding = 5) uniform sampler2D uT; layout(binding = 2) uniform sampler2D uA[2];\n"
        "out vec4 c; void main() { c = texture(uT, vec2(0.)) + texture(uA[1], vec2(0.)); }";
    const Translated old = fragment(text, core330);
    EXPECT_FALSE(old.has(Stage::fragment, "binding"));
    EXPECT_TRUE(old.uniform_default("uT", {5}));
    EXPECT_TRUE(old.uniform_default("uA", {2, 3}));
    const Translated now = fragment(text);
    EXPECT_TRUE(now.has(Stage::fragment, "layout(binding = 5)"));
    EXPECT_TRUE(now.translation.defaults.empty());
}

TEST(GlslStages, PointSizesOnOpenGlEs) {
    const Translated t = vertex("void main() { gl_Position = gl_Vertex; if (gl_Vertex.x > 0.) return; }", es320);
    EXPECT_TRUE(t.has(Stage::vertex, "snell_main(); gl_PointSize = snell_PointSize;"));
    EXPECT_TRUE(vertex("void main() { gl_Position = gl_Vertex; gl_PointSize = 3.; }", es320)
                    .has(Stage::vertex, "if (snell_FixedPointSize > 0.0) gl_PointSize = snell_FixedPointSize;"));
    EXPECT_FALSE(vertex("void main() { gl_Position = gl_Vertex; }").has(Stage::vertex, "PointSize"));
}

TEST(GlslStages, DirectionsMixedUp) {
    const Texts texts = {
        {Stage::vertex,
         "#version 330 compatibility\nin vec3 vB; out vec3 vN; void main() { vB = gl_Normal; vN = vB; gl_Position = "
         "gl_Vertex; }"},
        {Stage::fragment,
         "#version 330 compatibility\nout vec3 vN; in vec3 vB; void main() { gl_FragColor = vec4(vN + vB, 1.); }"}};
    EXPECT_EQ(translated(texts).count("direction"), 2);
    expect_valid(texts, {core450, core330, es300});
}

TEST(GlslStages, BlocksAreSingleVariablesInEs30) {
    const std::string vertex =
        "#version 330\nout Shading {\n  vec3 normal, color;\n  flat int which; float weights[2];\n} vOut;\n"
        "void main() { vOut.normal = vOut.color = vec3(1.); vOut.which = 1; vOut.weights[0] = vOut.weights[1] = .5; "
        "gl_Position = vec4(0.); }";
    const std::string block = "#version 330\nin Shading { vec3 normal, color; flat int which; float weights[2]; }";
    const std::string named =
        " vIn;\nout vec4 c;\nvoid main() { vec3 normal = vIn.normal; "
        "c = vec4(normal + vIn.color, vIn.weights[vIn.which]); }";
    const std::string plain = ";\nout vec4 c;\nvoid main() { c = vec4(normal + color, weights[which]); }";
    for (const std::string& fragment : {block + named, block + plain}) {
        const Texts texts = {{Stage::vertex, vertex}, {Stage::fragment, fragment}};
        expect_valid(texts, {core450, core330, es320, es300});
        EXPECT_TRUE(translated(texts).has(Stage::vertex, "out Shading {"));
        EXPECT_FALSE(translated(texts, es300).has(Stage::vertex, "Shading {"));
    }
}

TEST(GlslStages, VaryingArraysOfOldGeometryComeIn) {
    expect_valid({{Stage::vertex, "varying vec3 vN; void main() { vN = gl_Normal; gl_Position = gl_Vertex; }"},
                  {Stage::geometry,
                   "varying vec3 vN[3]; varying vec3 gN; void main() { gN = vN[0]; gl_Position = gl_PositionIn[0]; "
                   "EmitVertex(); }"},
                  {Stage::fragment, "varying vec3 gN; void main() { gl_FragColor = vec4(gN, 1.); }"}});
}

TEST(GlslStages, InputArraysFitThePrimitive) {
    const Texts texts = {
        {Stage::vertex,
         "#version 330\nin vec3 aVertex; out vec3 v; void main() { v = aVertex; gl_Position = vec4(v, 1.); }"},
        {Stage::geometry,
         "#version 330\nlayout(points) in; layout(points, max_vertices = 1) out; in vec3 v[3]; out vec3 g;\n"
         "void main() { g = v[0]; gl_Position = gl_in[0].gl_Position; EmitVertex(); }"},
        {Stage::fragment, "#version 330\nin vec3 g; out vec4 c; void main() { c = vec4(g, 1.); }"}};
    EXPECT_EQ(translated(texts).count("input-array-size"), 1);
    expect_valid(texts);
}

TEST(GlslStages, OpenGlEs30HasTwoStages) {
    const Translated t =
        translated({{Stage::vertex, plain_vertex}, {Stage::geometry, "layout(points) in; void main() {}"}}, es300);
    EXPECT_FALSE(t.translation.ok);
    EXPECT_EQ(t.count("unsupported-stage"), 1);
}

}  // namespace
}  // namespace snell::glsl::test
