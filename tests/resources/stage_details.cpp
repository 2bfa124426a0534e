// Details of geometry and tessellation stages that drivers do in ways of their own: the same pixels with the driver's
// stages and without them, in OpenGL and OpenGL ES.
#include "tests/resources/without_stages.h"

namespace snell::test {
namespace {

class StageDetails : public Stages, public testing::WithParamInterface<ContextRequest> {
protected:
    StageDetails() {
        request = GetParam();
        folder.write("s.vert", "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n");
    }

    void write(const char* file, std::string_view text) {
        folder.write(file, "#version 400 compatibility\n" + std::string(text));
    }

    // The same picture both ways, which is that of the driver's stages.
    Picture picture(const std::string& scene) {
        compare([&] { return open(scene); });
        return draw(scene);
    }

    static constexpr std::string_view two_patches =
        "NumPatchVertices 3\nglBegin gl_patches\nglVertex -1 -1 0\nglVertex 0 -1 0\nglVertex -1 1 0\n"
        "glVertex 0 -1 0\nglVertex 1 -1 0\nglVertex 1 1 0\nglEnd\n";
    static constexpr std::string_view linear =
        "layout(triangles) in;\nvoid main() { gl_Position = mat3x4(gl_in[0].gl_Position, gl_in[1].gl_Position, "
        "gl_in[2].gl_Position) * gl_TessCoord; }\n";
};
INSTANTIATE_TEST_SUITE_P(Contexts, StageDetails,
                         testing::Values(ContextRequest{45, false, false, true}, ContextRequest{32, true, false, true}),
                         context_name);

TEST_P(StageDetails, NumbersThatNoGeometryShaderGivesAreZero) {
    write("s.geom",
          "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nvoid main() {\n"
          "    for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; EmitVertex(); }\n}\n");
    write("s.frag", "void main() { gl_FragColor = vec4(gl_PrimitiveID == 0, gl_PrimitiveID != 0, 0., 1.); }\n");
    const Picture all = picture("Vertex s.vert\nGeometry s.geom\nFragment s.frag\nProgram P\nQuadXY 0. 1. 4 4\n");
    EXPECT_EQ(all.count({255, 0, 0, 255}), 64 * 64);
}

TEST_P(StageDetails, EachInvocationChoosesALevel) {
    write("s.tcs",
          "layout(vertices = 3) out;\nvoid main() {\n    int i = gl_InvocationID;\n"
          "    gl_out[gl_InvocationID].gl_Position = gl_in[i].gl_Position;\n    gl_TessLevelOuter[i] = 1.;\n"
          "    gl_TessLevelOuter[i] *= 2.;\n    gl_TessLevelInner[uint(i) / 2] = gl_TessLevelOuter[i] += 1.;\n}\n");
    write("s.tes",
          "layout(triangles) in; out vec3 c;\nvoid main() {\n"
          "    c = vec3(gl_TessLevelOuter[0], gl_TessLevelOuter[2], gl_TessLevelInner[0]) / 4.;\n"
          "    gl_Position = mat3x4(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position) * gl_TessCoord;\n"
          "}\n");
    write("s.frag", "in vec3 c;\nvoid main() { gl_FragColor = vec4(c, 1.); }\n");
    const Picture half =
        picture("Vertex s.vert\nTessControl s.tcs\nTessEvaluation s.tes\nFragment s.frag\nProgram P\n" +
                std::string(two_patches));
    EXPECT_EQ(half.count({191, 191, 191, 255}), 64 * 64 / 2);
}

TEST_P(StageDetails, FragmentsHaveTheNumberOfTheirPatch) {
    write("s.tcs",
          "layout(vertices = 3) out;\nvoid main() {\n"
          "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
          "    for (int i = 0; i < 3; ++i) gl_TessLevelOuter[i] = 3.;\n    gl_TessLevelInner[0] = 3.;\n}\n");
    write("s.tes", linear);
    write("s.frag", "void main() { gl_FragColor = vec4(float(gl_PrimitiveID) / 2., 1., 0., 1.); }\n");
    const Picture both =
        picture("Vertex s.vert\nTessControl s.tcs\nTessEvaluation s.tes\nFragment s.frag\nProgram P\n" +
                std::string(two_patches));
    EXPECT_EQ(both.count({0, 255, 0, 255}), 64 * 64 / 4);
    EXPECT_EQ(both.count({128, 255, 0, 255}), 64 * 64 / 4);
}

}  // namespace
}  // namespace snell::test
