// What the translator says of the uniforms that a program declares.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

std::string uses_of(const Texts& texts) {
    std::string line;
    for (const DeclaredUniform& d : translated(texts).translation.declared)
        line += (line.empty() ? "" : " ") + d.name + (d.used ? "+" : "-");
    return line;
}

struct Row {
    std::string uses, text;  // `uses`: each uniform with + (used) or -
};

class FragmentUses : public testing::TestWithParam<Row> {};

TEST_P(FragmentUses, AreAsTheTextSays) {
    EXPECT_EQ(uses_of({{Stage::fragment, GetParam().text}}), GetParam().uses) << GetParam().text;
}

std::string in_main(const std::string& declarations, const std::string& body) {
    return "#version 120\n" + declarations + "\nvoid main() { " + body + " }\n";
}

const std::string a = "uniform float uA; uniform float uB;", color = "gl_FragColor = vec4(1.);";

const Row rows[] = {
    // Never named where code runs.
    {"uA- uB-", in_main(a, color)},
    {"uA- uB+", in_main(a + "float f() { return uA; }", "gl_FragColor = vec4(uB);")},
    {"uA- uB-", in_main(a + "float f() { return uA; } float g() { return f() + uB; }", color)},
    {"uA+ uB-", in_main(a + "float f() { return uA; } float g() { return f(); }", "gl_FragColor = vec4(g());")},
    {"uA- uB-", in_main(a, "float uA = 1., uB = 2.; gl_FragColor = vec4(uA, uB, 1., 1.);")},
    {"uA- uB-", in_main(a + "float f() { return uA; } float f(float x) { return uB; }", color)},
    {"uA+ uB+", in_main(a + "float f() { return uA; } float f(float x) { return uB; }", "gl_FragColor = vec4(f());")},
    // Named where code runs, whether it has an effect or not.
    {"uA+ uB+", in_main(a, "float x = uA; x = 1. + 0. * uB; gl_FragColor = vec4(x);")},
    {"uA+ uB+", in_main(a, "gl_FragColor = vec4(uB); return; gl_FragColor = vec4(uA);")},
    {"uA+ uB+",
     in_main(a + "const float k = 2.; float g = uA * k;", "gl_FragColor = vec4(g, uB > .5 ? 1. : 0., 0., 1.);")},
    {"uL+ uC+", in_main("struct L { vec3 d; float i; }; uniform L uL; uniform vec3 uC[3];",
                        "gl_FragColor = vec4(uL.d * uL.i + uC[2], 1.);")},
};
INSTANTIATE_TEST_SUITE_P(Rows, FragmentUses, testing::ValuesIn(rows));

TEST(Uses, OfAllStages) {
    EXPECT_EQ(uses_of({{Stage::vertex, "uniform float uA, uB, uC; void main() { gl_Position = ftransform() * uA; }"},
                       {Stage::fragment, "uniform float uB, uC; void main() { gl_FragColor = vec4(uB); }"}}),
              "uA+ uB+ uC-");
}

TEST(Uses, OfStructuresThatHoldThemselves) {
    EXPECT_EQ(uses_of({{Stage::fragment,
                        in_main("struct S { float f; S s; }; uniform S uS;", "gl_FragColor = vec4(uS.f);")}}),
              "uS+");
}

TEST(Uses, SayTypeSizeAndInitialValue) {
    const auto declared =
        fragment(
            "#version 330\nuniform vec3 uV = vec3(1., 2., 3.); uniform float uF[3]; uniform B { vec2 m; } "
            "b; out vec4 c; void main() { c = vec4(uV, uF[1] + b.m.x); }")
            .translation.declared;
    ASSERT_EQ(declared.size(), 3u);
    EXPECT_EQ(declared[0].name + declared[0].glsl_type, "uVvec3");
    EXPECT_EQ(declared[0].initial, (std::vector<double>{1, 2, 3}));
    EXPECT_TRUE(declared[0].simple);
    EXPECT_EQ(declared[1].array_size, 3);
    EXPECT_FALSE(declared[1].simple);
    EXPECT_EQ(declared[2].name, "B.m");
    EXPECT_FALSE(declared[2].simple);
}

// ---- When the planes that depth is measured between may be moved: only where no shader could tell.

bool plain(const std::string& vertex_body, const std::string& fragment_body = "gl_FragColor = vec4(1.);") {
    return translated({{Stage::vertex, "uniform float uK;\nvoid main() { " + vertex_body + " }"},
                       {Stage::fragment, "void main() { " + fragment_body + " }"}})
        .translation.plain_depth;
}

TEST(PlainDepth, OfVerticesThatAreOnlyMultiplied) {
    EXPECT_TRUE(plain("gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;"));
    EXPECT_TRUE(plain("gl_Position = ftransform();"));
    EXPECT_TRUE(plain("gl_Position = gl_ProjectionMatrix * gl_ModelViewMatrix * gl_Vertex;"));
    EXPECT_TRUE(plain("vec3 e = (gl_ModelViewMatrix * gl_Vertex).xyz;\ngl_Position = ftransform();"));
    EXPECT_TRUE(plain("gl_Position = ftransform();", "gl_FragColor = vec4(gl_FragCoord.xy, gl_FragCoord.x, 1.);"));
    EXPECT_TRUE(fragment("void main() { gl_FragColor = vec4(1.); }").translation.plain_depth) << "the built-in stage";
}

TEST(PlainDepth, NotOfOthers) {
    EXPECT_FALSE(plain("gl_Position = gl_ModelViewProjectionMatrix * (gl_Vertex + vec4(uK));"));
    EXPECT_FALSE(plain("vec4 v = gl_Vertex; v.z += uK; gl_Position = gl_ModelViewProjectionMatrix * v;"));
    EXPECT_FALSE(plain("gl_Position = ftransform(); gl_Position.x += uK;"));
    EXPECT_FALSE(plain("if (uK > 0.) gl_Position = ftransform(); else gl_Position = gl_Vertex;"));
    EXPECT_FALSE(plain("gl_Position = ftransform(); float f = gl_ProjectionMatrix[2][2];"));
    EXPECT_FALSE(plain("gl_Position = ftransform();", "gl_FragColor = vec4(gl_FragCoord.z);"));
    EXPECT_FALSE(plain("gl_Position = ftransform();", "vec4 c = gl_FragCoord; gl_FragColor = c;"));
    EXPECT_FALSE(plain("gl_Position = ftransform();", "gl_FragDepth = .5; gl_FragColor = vec4(1.);"));
    EXPECT_FALSE(plain("gl_Position = ftransform();", "gl_FragColor = gl_ModelViewProjectionMatrix[0];"));
    EXPECT_FALSE(plain("gl_Position = gl_Vertex;"));
}

std::string placed(const std::string& vertex,
                   const std::string& fragment = "void main() { gl_FragColor = vec4(1.); }") {
    return translated({{Stage::vertex, vertex}, {Stage::fragment, fragment}}).translation.placed_by;
}

TEST(PlacedBy, TheMatrixThatTheVertexIsMultipliedBy) {
    const std::string whole = "gl_ModelViewProjectionMatrix";
    EXPECT_EQ(placed("void main() { gl_Position = ftransform(); }"), whole);
    EXPECT_EQ(placed("void main() { gl_Position = gl_ProjectionMatrix * gl_ModelViewMatrix * gl_Vertex; }"), whole);
    EXPECT_EQ(placed("void main() { gl_Position = ftransform(); }",
                     "void main() { gl_FragDepth = .5; gl_FragColor = vec4(1.); }"),
              whole)
        << "fragments place nothing";
    const std::string inputs = "#version 330\nuniform mat4 PVM;\nin vec4 position;\nin vec3 aPosition;\n";
    EXPECT_EQ(placed(inputs + "void main() { gl_Position = PVM * position; }"), "PVM");
    EXPECT_EQ(placed(inputs + "void main() { gl_Position = PVM * vec4(aPosition, 1.0); }"), "PVM");
    EXPECT_EQ(placed("#version 330\nuniform mat4 uModelViewProjectionMatrix;\nin vec4 aVertex;\n"
                     "void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }"),
              "uModelViewProjectionMatrix");
}

TEST(PlacedBy, NothingElse) {
    const std::string inputs =
        "#version 330\nuniform mat4 PVM, mine;\nuniform vec4 vertex;\nin vec4 position;\nin vec4 normal;\n";
    for (const char* body :
         {"gl_Position = mine * position;", "gl_Position = PVM * normal;", "gl_Position = PVM * vertex;",
          "gl_Position = PVM * position + vertex;", "gl_Position = PVM * position; gl_Position.x += 1.;",
          "vec4 position = vertex; gl_Position = PVM * position;", "mat4 PVM = mine; gl_Position = PVM * position;",
          "gl_Position = PVM * vec4(position.xyz, 2.);", "gl_Position = position;"})
        EXPECT_EQ(placed(inputs + "void main() { " + body + " }"), "") << body;
    EXPECT_EQ(placed("#version 330\nuniform mat4 PVM;\nin vec4 position;\nvoid main() { position.x += 1.; "
                     "gl_Position = PVM * position; }"),
              "");
    EXPECT_EQ(placed("#version 430 compatibility\nlayout(std430, binding = 0) buffer Out { float seen; };\n"
                     "void main() { seen = 1.; gl_Position = ftransform(); }"),
              "")
        << "its vertices are counted, wherever they are";
}

}  // namespace
}  // namespace snell::glsl::test
