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

}  // namespace
}  // namespace snell::glsl::test
