// The names of gstap.h, which glman put ahead of every shader.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

const std::vector<std::pair<std::string, std::string>> matrices = {
    {"uModelViewMatrix", "gl_ModelViewMatrix"},
    {"uProjectionMatrix", "gl_ProjectionMatrix"},
    {"uModelViewProjectionMatrix", "gl_ModelViewProjectionMatrix"},
    {"uNormalMatrix", "gl_NormalMatrix"},
    {"uModelViewMatrixInverse", "gl_ModelViewMatrixInverse"},
};

std::string all_matrices(bool gstap) {
    std::string sum = "0.";
    for (const auto& [ours, theirs] : matrices) sum += " + " + (gstap ? ours : theirs) + "[2][1]";
    return sum;
}

// Every attribute and matrix at once.
std::string vertex_text(bool gstap) {
    std::string text = "void main() {\n    vec4 sum = " + std::string(gstap ? "aVertex" : "gl_Vertex") + " + vec4(" +
                       (gstap ? "aNormal" : "gl_Normal") + ", " + all_matrices(gstap) + ") + " +
                       (gstap ? "aColor" : "gl_Color") + ";\n";
    for (char n = '0'; n < '8'; ++n)
        text += std::string("    sum += ") + (gstap ? "aTexCoord" : "gl_MultiTexCoord") + n + ";\n";
    return text + "    gl_Position = sum;\n}\n";
}

std::string fragment_text(bool gstap) { return "void main() { gl_FragColor = vec4(" + all_matrices(gstap) + "); }\n"; }

TEST(GlslGstap, MeansTheBuiltInVariablesInEveryDialect) {
    const Target es100{300, true, false};
    for (const char* version : {"", "#version 120\n", "#version 330\n", "#version 330 core\n",
                                "#version 330 compatibility\n", "#version 400 compatibility\n", "#version 300 es\n"})
        for (const Target& target : {core450, core330, es100}) {
            SCOPED_TRACE(version);
            const auto both = [&](bool gstap) {
                return translated(
                    {{Stage::vertex, version + vertex_text(gstap)}, {Stage::fragment, version + fragment_text(gstap)}},
                    target);
            };
            const Translated ours = both(true), theirs = both(false);
            EXPECT_TRUE(ours.diagnostics.empty());
            EXPECT_EQ(ours.text(Stage::vertex), theirs.text(Stage::vertex));
            EXPECT_EQ(ours.text(Stage::fragment), theirs.text(Stage::fragment));
        }
    expect_valid({{Stage::vertex, vertex_text(true)}, {Stage::fragment, fragment_text(true)}});
}

TEST(GlslGstap, MatricesAreInEveryStage) {
    for (const char* word : {"triangles", "lines"}) {
        const std::string text = std::string("layout(") + word +
                                 ") in;\nlayout(triangle_strip, max_vertices = 3) out;\nvoid main() {\n"
                                 "    gl_Position = uModelViewProjectionMatrix * gl_in[0].gl_Position;\n"
                                 "    EmitVertex();\n}\n";
        const Translated t = translated({{Stage::geometry, text}});
        EXPECT_TRUE(t.has(Stage::geometry, "snell_ModelViewProjectionMatrix * gl_in[0].gl_Position"));
    }
    const Translated t = translated(
        {{Stage::tess_control,
          "layout(vertices = 3) out;\nvoid main() { gl_TessLevelInner[0] = uProjectionMatrix[0][0]; }\n"},
         {Stage::tess_evaluation,
          "layout(triangles) in;\nvoid main() { gl_Position = uModelViewMatrix * gl_in[0].gl_Position; }\n"}});
    EXPECT_TRUE(t.has(Stage::tess_control, "snell_ProjectionMatrix[0][0]"));
    EXPECT_TRUE(t.has(Stage::tess_evaluation, "snell_ModelViewMatrix * gl_in[0]"));
    // Attributes mean nothing behind the vertex stage.
    EXPECT_TRUE(fragment("void main() { gl_FragColor = aColor; }\n").has(Stage::fragment, "= aColor;"));
}

TEST(GlslGstap, AnOwnDeclarationWins) {
    for (const char* own :
         {"uniform mat4 uModelViewMatrix;", "const mat4 uModelViewMatrix = mat4(1.);", "in mat4 uModelViewMatrix;",
          "uniform Matrices { mat4 uModelViewMatrix; };", "struct S { mat4 m; }; uniform S uModelViewMatrix;",
          "float uModelViewMatrix = 1.;", "uniform mat4 uOther, uModelViewMatrix;", "#define uModelViewMatrix mat4(2.)",
          "mat4 uModelViewMatrix() { return mat4(1.); }"}) {
        SCOPED_TRACE(own);
        const std::string call = std::string_view(own).ends_with("}") && std::string_view(own).starts_with("mat4")
                                     ? "uModelViewMatrix()"
                                     : "uModelViewMatrix";
        const Translated t = vertex(std::string("#version 150\n") + own + "\nvoid main() { gl_Position = vec4((" +
                                    call + " * mat4(1.))[0]); }\n");
        EXPECT_FALSE(t.has(Stage::vertex, "snell_ModelViewMatrix"));
    }
    EXPECT_FALSE(vertex("struct S { vec4 aVertex; };\nvoid main() { S s; s.aVertex = vec4(1.); gl_Position = "
                        "s.aVertex; }\n")
                     .has(Stage::vertex, "snell_Vertex"));
}

TEST(GlslGstap, ALocalVariableWinsWhereItIsInScope) {
    const Translated t = vertex(
        "vec4 f(vec4 aVertex) { return aVertex; }\nvec4 g() { vec3 aNormal = vec3(1.); return vec4(aNormal, 0.); }\n"
        "void main() {\n    for (int aColor = 0; aColor < 2; ++aColor) {}\n"
        "    { mat4 uModelViewMatrix = uModelViewMatrix * 2.; gl_Position = uModelViewMatrix[0]; }\n"
        "    gl_Position += f(aVertex) + g() + vec4(aNormal, 1.) + aColor + uModelViewMatrix[1];\n}\n");
    EXPECT_TRUE(t.has(Stage::vertex, "vec4 f(vec4 aVertex) { return aVertex; }"));
    EXPECT_TRUE(t.has(Stage::vertex, "return vec4(aNormal, 0.);"));
    EXPECT_TRUE(t.has(Stage::vertex, "++aColor"));
    EXPECT_TRUE(
        t.has(Stage::vertex, "mat4 uModelViewMatrix = snell_ModelViewMatrix * 2.; gl_Position = uModelViewMatrix[0];"));
    EXPECT_TRUE(t.has(Stage::vertex,
                      "f(snell_Vertex) + g() + vec4(snell_Normal, 1.) + snell_Color + snell_ModelViewMatrix[1]"));
}

// A declaration in one stage says nothing of another.
TEST(GlslGstap, StagesMayDifferInWhatTheyDeclare) {
    expect_valid({{Stage::vertex,
                   "uniform mat4 uModelViewMatrix;\nattribute vec4 aVertex;\n"
                   "void main() { gl_Position = uModelViewMatrix * aVertex + aColor; }\n"},
                  {Stage::fragment, "void main() { gl_FragColor = uModelViewMatrix[0]; }\n"}});
}

TEST(GlslGstap, MacrosOfTheNamesAndOverThem) {
    Options options;
    options.target = core450;
    options.include = [](std::string_view, std::string_view name, bool) -> std::optional<IncludeText> {
        if (name != "there/gstap.h") return std::nullopt;
        return IncludeText{"there/gstap.h",
                           "#ifndef GSTAP_H\n#define GSTAP_H\n#define uModelViewMatrix "
                           "gl_ModelViewMatrix\n#define aVertex gl_Vertex\n#endif\n"};
    };
    const std::string main = "#define POSITION uModelViewMatrix * aVertex\nvoid main() { gl_Position = POSITION; }\n";
    for (const char* include : {"", "#include \"gstap.h\"\n", "#include <gstap.h>\n", "#include \"there/gstap.h\"\n"}) {
        SCOPED_TRACE(include);
        Translated t;
        translate_texts(t, {{Stage::vertex, include + main}}, options);
        EXPECT_TRUE(t.translation.ok && t.diagnostics.empty());
        EXPECT_TRUE(t.has(Stage::vertex, "snell_ModelViewMatrix * snell_Vertex"));
    }
    Translated other;
    translate_texts(other, {{Stage::vertex, "#include \"Gstap.hpp\"\n" + main}}, options);
    EXPECT_EQ(other.count("missing-include"), 1);
}

TEST(GlslGstap, LinesStayWhereTheyWere) {
    const auto with = [](const std::string& before) {
        return translated({{Stage::vertex, before + "\n\nvoid main() { gl_Position = aVertex; }\n"},
                           {Stage::fragment, "void main() { gl_FragColor = vec4(1.); }\n"}});
    };
    const std::string written = "\n\nvoid main() { gl_Position = snell_Vertex; }\n";
    EXPECT_TRUE(with("").has(Stage::vertex, "#line 1 0\n" + written));
    EXPECT_TRUE(with("#include \"gstap.h\"").has(Stage::vertex, "#line 2 0" + written));
}

TEST(GlslGstap, MessagesSayTheNameThatWasWritten) {
    const Translated t = vertex("void main() { aVertex.z = 0.; gl_Position = aVertex; }\n");
    ASSERT_EQ(t.count("assigned-input"), 1);
    EXPECT_NE(t.diagnostics.items().front().message.find("'aVertex'"), std::string::npos);
    const Span span = t.diagnostics.items().front().span;
    EXPECT_EQ(span.end - span.begin, 7U);

    Translated wrong = vertex("void main() {\n    gl_Position = uNormalMatrix * aVertex;\n}\n");
    Diagnostics said;
    explain_log("0:2(19): error: `snell_NormalMatrix' and `snell_Vertex' do not fit", wrong.translation,
                &wrong.translation.stages.front(), {}, "P", wrong.sources, said);
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said.items().front().message.find("uNormalMatrix"), std::string::npos) << said.items().front().message;
    EXPECT_NE(said.items().front().message.find("aVertex"), std::string::npos);
}

}  // namespace
}  // namespace snell::glsl::test
