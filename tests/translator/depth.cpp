// When the planes that depth is measured between may be moved: only where no shader could tell.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

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
