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

TEST_P(StageDetails, RedeclarationsAndOldSizesOfArrays) {
    write("s.vert",
          "out vec4 a, b;\ninvariant a, gl_Position;\nprecise b, gl_Position;\ninvariant gl_PointSize;\n"
          "void main() { a = b = vec4(.5); gl_PointSize = 1.; gl_Position = gl_Vertex; }\n");
    write("s.frag", "in vec4 c;\nvoid main() { gl_FragColor = c; }\n");
    write("s.geom",
          "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nin vec4 a[], b[];\n"
          "invariant gl_Position;\nprecise gl_Position;\nout vec4 c;\ninvariant centroid out vec4 d;\nprecise c;\n"
          "void main() {\n"
          "    for (int i = 0; i < 3; ++i) { c = d = a[i] + b[i]; gl_Position = gl_in[i].gl_Position; EmitVertex(); }\n"
          "}\n");
    const std::string scene = "Vertex s.vert\nGeometry s.geom\nFragment s.frag\nProgram P\nQuadXY 0. 1. 4 4\n";
    EXPECT_EQ(picture(scene).count({255, 255, 255, 255}), 64 * 64);

    folder.write("s.geom",
                 "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nvarying in vec4 a[gl_VerticesIn];\n"
                 "varying in vec4 b[gl_VerticesIn];\nvarying out vec4 c;\ninvariant gl_Position;\nvoid main() {\n"
                 "    for (int i = 0; i < gl_VerticesIn; ++i) {\n        c = a[i] + b[i];\n"
                 "        gl_Position = gl_PositionIn[i];\n        EmitVertex();\n    }\n}\n");
    EXPECT_EQ(
        picture("GeometryInput gl_triangles\nGeometryOutput gl_triangle_strip\n" + scene).count({255, 255, 255, 255}),
        64 * 64);
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

// Vertices whose w differ, by what stands on the screen.
TEST_P(StageDetails, NoPerspectiveIsLinearOnTheScreen) {
    folder.write(
        "v.vert",
        "#version 400 compatibility\nstruct Pair { vec2 a; float b[2]; };\n"
        "noperspective out vec2 plain; noperspective out mat2 turned; noperspective out vec2 list[2];\n"
        "noperspective out Pair pair; noperspective out vec2 unread;\n"
        "out Both { noperspective vec2 flatly; vec2 smoothly; } both;\nvoid main() {\n"
        "    vec2 p = gl_Vertex.xy * .5 + .5; plain = unread = both.flatly = both.smoothly = p;\n"
        "    turned = mat2(p, p.yx); list[0] = list[1] = p; pair = Pair(p, float[2](p.x, p.y));\n"
        "    float w = 2. + gl_Vertex.x + .5 * gl_Vertex.y;\n    gl_Position = vec4(gl_Vertex.xyz * w, w);\n}\n");
    write("v.frag",
          "struct Pair { vec2 a; float b[2]; };\n"
          "noperspective in vec2 plain; noperspective in mat2 turned; noperspective in vec2 list[2];\n"
          "noperspective in Pair pair; in Both { noperspective vec2 flatly; vec2 smoothly; } both;\n"
          "bool fits(vec2 a) { return distance(a, gl_FragCoord.xy / 64.) < .001; }\nvoid main() {\n"
          "    bool all = fits(plain) && fits(turned[0]) && fits(turned[1].yx) && fits(list[1]) && fits(pair.a);\n"
          "    all = all && fits(vec2(pair.b[0], pair.b[1])) && fits(both.flatly);\n"
          "    gl_FragColor = vec4(all, fits(both.smoothly), 0., 1.);\n}\n");
    const Picture alone = draw("Vertex v.vert\nFragment v.frag\nProgram P\nQuadXY 0. 1.\n");
    EXPECT_GT(alone.count({255, 0, 0, 255}), 64 * 64 - 300) << "the rest is near a corner";
    EXPECT_EQ(alone.count({255, 0, 0, 255}) + alone.count({255, 255, 0, 255}), 64 * 64);

    write("s.geom",
          "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out; noperspective out vec2 place;\n"
          "void main() {\n    for (int i = 0; i < 3; ++i) {\n        vec2 p = gl_in[i].gl_Position.xy; place = p * .5 "
          "+ .5;\n"
          "        gl_Position = vec4(gl_in[i].gl_Position.xyz, 1.) * (2. + p.x); EmitVertex();\n    }\n}\n");
    write("s.tcs",
          "layout(vertices = 3) out;\nvoid main() {\n"
          "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
          "    gl_TessLevelOuter = float[4](2., 2., 2., 2.); gl_TessLevelInner[0] = 2.;\n}\n");
    write("s.tes",
          "layout(triangles) in; noperspective out vec2 place;\nvoid main() { vec4 p = mat3x4(gl_in[0].gl_Position, "
          "gl_in[1].gl_Position, gl_in[2].gl_Position) * gl_TessCoord; place = p.xy * .5 + .5; gl_Position = p * (2. + "
          "p.x); }\n");
    write("s.frag",
          "noperspective in vec2 place;\nvoid main() { gl_FragColor = vec4(distance(place, gl_FragCoord.xy / 64.) < "
          ".001, 0., 0., 1.); }\n");
    const Picture emitted = picture("Vertex s.vert\nGeometry s.geom\nFragment s.frag\nProgram P\nQuadXY 0. 1. 3 3\n");
    EXPECT_EQ(emitted.count({255, 0, 0, 255}), 64 * 64);
    const Picture divided =
        picture("Vertex s.vert\nTessControl s.tcs\nTessEvaluation s.tes\nFragment s.frag\nProgram P\n" +
                std::string(two_patches));
    EXPECT_EQ(divided.count({255, 0, 0, 255}), 64 * 64 / 2);
}

// Lines wider than the driver draws are, too.
TEST_P(StageDetails, NoPerspectiveIsLinearAlongWidenedLines) {
    caps.max_line_width = 1;
    write("w.vert",
          "noperspective out float along; out float deep; out Both { noperspective vec2 list[2]; } both;\n"
          "void main() {\n    along = deep = gl_Vertex.x * .5 + .5; both.list[1] = vec2(along);\n"
          "    float w = 2. + gl_Vertex.x; gl_Position = vec4(gl_Vertex.xyz * w, w);\n}\n");
    write("w.frag",
          "noperspective in float along; in float deep; in Both { noperspective vec2 list[2]; } both;\n"
          "void main() {\n    float x = gl_FragCoord.x / 64.;\n"
          "    bool fits = abs(along - x) < .001 && distance(both.list[1], vec2(x)) < .001;\n"
          "    gl_FragColor = vec4(fits, abs(deep - x) > .1, 0., 1.);\n}\n");
    const auto document = open(
        "Vertex w.vert\nFragment w.frag\nLineWidth 9\nProgram P\nglBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 "
        "0\nglEnd\n");
    expect_clean(*document);
    const Picture line = draw(*document);
    EXPECT_EQ(line.count({255, 0, 0, 255}) + line.count({255, 255, 0, 255}), 9 * 64);
    EXPECT_GT(line.count({255, 255, 0, 255}), 9 * 30) << "the other varying has perspective";
}

// OpenGL ES 3.2 has no sizes of points behind these stages, and no patches without a control shader.
TEST_P(StageDetails, PointsHaveTheirSize) {
    const std::string points = "PointSize 8\nglBegin gl_points\nglVertex -.5 0 0\nglVertex .5 0 0\nglEnd\n";
    write("s.geom",
          "layout(points) in; layout(points, max_vertices = 1) out;\n"
          "void main() { gl_Position = gl_in[0].gl_Position; EmitVertex(); }\n");
    write("own.geom",
          "layout(points) in; layout(points, max_vertices = 1) out;\nvoid main() { gl_Position = "
          "gl_in[0].gl_Position; gl_PointSize = 6. + 2. * gl_Position.x; EmitVertex(); }\n");
    write("s.frag", "void main() { gl_FragColor = vec4(1., 0., 0., 1.); }\n");
    const std::string program = "Vertex s.vert\nFragment s.frag\nGeometry ";
    EXPECT_EQ(picture(program + "s.geom\nProgram P\n" + points).count({255, 0, 0, 255}), 2 * 64);
    EXPECT_EQ(picture(program + "own.geom\nPointSizeMode 1\nProgram P\n" + points).count({255, 0, 0, 255}),
              5 * 5 + 7 * 7);
    write("s.tes",
          "layout(isolines, point_mode) in;\n"
          "void main() { gl_Position = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x); }\n");
    const Picture two = picture(
        "Vertex s.vert\nTessEvaluation s.tes\nFragment s.frag\nPointSize 8\nProgram P\nNumPatchVertices 2\n"
        "glBegin gl_patches\nglVertex -.5 0 0\nglVertex .5 0 0\nglEnd\n");
    EXPECT_EQ(two.count({255, 0, 0, 255}), 2 * 64);
}

// Which OpenGL ES does not pass itself.
TEST_P(StageDetails, StructuresOfArraysPass) {
    const std::string pair = "struct Inner { float c; uint d; }; struct Pair { int n; float b[2]; Inner inner; };\n";
    write("v.vert", pair +
                        "flat out Pair whole; out Both { flat Pair part; } both;\nvoid main() {\n"
                        "    whole = Pair(-7, float[2](.25, -.5), Inner(.75, 9u)); both.part = whole;\n"
                        "    gl_Position = gl_Vertex;\n}\n");
    write("v.geom", "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n" + pair +
                        "flat in Pair whole[]; in Both { flat Pair part; } both[]; flat out Pair emitted;\n"
                        "void main() {\n    for (int i = 0; i < 3; ++i) {\n        emitted = whole[i];\n"
                        "        gl_Position = gl_in[i].gl_Position; EmitVertex();\n    }\n}\n");
    const std::string is = "bool is(Pair p) { return p == Pair(-7, float[2](.25, -.5), Inner(.75, 9u)); }\n";
    write("v.frag", pair + is +
                        "flat in Pair whole; in Both { flat Pair part; } both;\n"
                        "void main() { gl_FragColor = vec4(is(whole) && is(both.part), 0., 0., 1.); }\n");
    write("g.frag", pair + is +
                        "flat in Pair emitted;\n"
                        "void main() { gl_FragColor = vec4(is(emitted), 0., 0., 1.); }\n");
    const Picture direct = draw("Vertex v.vert\nFragment v.frag\nProgram P\nQuadXY 0. 1.\n");
    EXPECT_EQ(direct.count({255, 0, 0, 255}), 64 * 64);
    const Picture emitted = picture("Vertex v.vert\nGeometry v.geom\nFragment g.frag\nProgram P\nQuadXY 0. 1.\n");
    EXPECT_EQ(emitted.count({255, 0, 0, 255}), 64 * 64);
}

// Nor this.
TEST_P(StageDetails, ArraysOfArraysPass) {
    write("a.vert",
          "const int N = 3; out vec2 many[2][N]; flat out ivec2 whole[2][2];\nvoid main() {\n"
          "    for (int i = 0; i < 2; ++i) for (int k = 0; k < N; ++k) many[i][k] = gl_Vertex.xy * float(3 * i + k);\n"
          "    for (int i = 0; i < 4; ++i) whole[i / 2][i % 2] = ivec2(-i, i * i);\n    gl_Position = gl_Vertex;\n}\n");
    write("a.frag",
          "const int N = 3; in vec2 many[2][N]; flat in ivec2 whole[2][2];\nvoid main() {\n    bool fits = true;\n"
          "    for (int i = 0; i < 6; ++i) fits = fits && distance(many[i / N][i % N], many[0][1] * float(i)) < 1e-4;\n"
          "    for (int i = 0; i < 4; ++i) fits = fits && whole[i / 2][i % 2] == ivec2(-i, i * i);\n"
          "    gl_FragColor = vec4(fits, length(many[0][1]) > 0. ? 0. : 1., 0., 1.);\n}\n");
    const auto document = open("Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0. 1.\n");
    expect_clean(*document);
    EXPECT_EQ(draw(*document).count({255, 0, 0, 255}), 64 * 64);
}

// What there is without layers and streams.
TEST_P(StageDetails, TheFirstLayerAndStreamAreOrdinary) {
    write("s.geom",
          "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\nvoid main() {\n    gl_Layer = 0;\n"
          "    gl_ViewportIndex = 0;\n"
          "    for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; EmitStreamVertex(0); }\n"
          "    EndStreamPrimitive(0);\n}\n");
    write("c.geom",
          "#define S 0\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out; const int first = 0;\n"
          "void main() {\n    const int own = first * 2;\n"
          "    for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; EmitStreamVertex( own ); }\n"
          "    EndStreamPrimitive(first + S);\n}\n");
    write("s.frag", "void main() { gl_FragColor = vec4(1., 0., 0., 1.); }\n");
    const Picture constant = picture("Vertex s.vert\nGeometry c.geom\nFragment s.frag\nProgram P\nQuadXY 0. 1.\n");
    EXPECT_EQ(constant.count({255, 0, 0, 255}), 64 * 64);
    const Picture all = picture("Vertex s.vert\nGeometry s.geom\nFragment s.frag\nProgram P\nQuadXY 0. 1.\n");
    EXPECT_EQ(all.count({255, 0, 0, 255}), 64 * 64);
}

// More numbers than transform feedback captures of one vertex. The names are those of the other stages, too.
TEST_P(StageDetails, OutputsThatNoBufferTakes) {
    write("l.vert",
          "out Pair { vec4 many[12]; } given; out vec3 shade; flat out int number;\nvoid main() {\n"
          "    for (int i = 0; i < 12; ++i) given.many[i] = gl_Vertex * float(i);\n"
          "    shade = gl_Vertex.xyz; number = gl_VertexID;\n    gl_Position = gl_Vertex;\n}\n");
    for (const char* output : {"triangle_strip", "points"}) {
        SCOPED_TRACE(output);
        write(
            "l.geom",
            "layout(triangles, invocations = 2) in; layout(" + std::string(output) +
                ", max_vertices = 7) out;\nin Pair { vec4 many[12]; } given[]; in vec3 shade[]; flat in int number[];\n"
                "out Given { vec4 many[12]; noperspective vec2 there; } give; out vec3 shine; flat out ivec3 whole;\n"
                "uniform float uSize;\nvoid corner(int i) {\n    int k = i % 3;\n"
                "    for (int n = 0; n < 12; ++n) give.many[n] = given[k].many[n] + float(i);\n"
                "    shine = shade[k] + float(gl_InvocationID) * .3; whole = ivec3(number[k], i, gl_PrimitiveIDIn);\n"
                "    gl_Position = vec4(gl_in[k].gl_Position.xy * uSize + vec2(i, -i) * .05, 0., 1.);\n"
                "    gl_Position *= 1.5 + gl_Position.x * .5; give.there = gl_Position.xy; gl_PrimitiveID = i;\n" +
                (std::string(output) == "points" ? "    gl_PointSize = 5.;\n" : "") +
                "    EmitVertex();\n}\nvoid main() {\n    for (int i = 0; i < 4 + gl_PrimitiveIDIn % 4; ++i) {\n"
                "        corner(i); if (i == 3) EndPrimitive();\n    }\n}\n");
        write(
            "l.frag",
            "in Given { vec4 many[12]; noperspective vec2 there; } take; in vec3 shine; flat in ivec3 whole;\n"
            "void main() {\n    vec3 c = shine + take.there.xyy + vec3(whole % 5) * .2 + float(gl_PrimitiveID) * .1;\n"
            "    for (int i = 0; i < 12; ++i) c += take.many[i].xyz * .1;\n"
            "    gl_FragColor = vec4(fract(c) * (gl_FrontFacing ? 1. : .5), 1.);\n}\n");
        const Picture drawn = picture(
            "Ortho -1 1 -1 1\nVertex l.vert\nGeometry l.geom\nFragment l.frag\nPointSizeMode 1\n"
            "Program P uSize .8\nQuadXY 0. 1. 3 3\n");
        EXPECT_LT(drawn.count({18, 27, 33, 255}), 64 * 64 - 100);
        EXPECT_LT(drawn.count({0, 0, 0, 0}), 64 * 64 - 100);
    }
}

// What is declared behind main gets its value before main is run, here as well.
TEST_P(StageDetails, MainIsCalledByOthers) {
    write("s.tes",
          "layout(isolines, point_mode) in; noperspective out vec3 c; float late = gl_TessCoord.x; void set();\n"
          "void main() { set(); gl_Position = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x); }\n"
          "out vec2 unset[2]; flat out int n;\nvoid set() { c = vec3(late, 0., 0.); if (late > 2.) n = 1; }\n");
    write("s.frag",
          "noperspective in vec3 c; in vec2 unset[2]; flat in int n;\n"
          "void main() { gl_FragColor = vec4(c.x, float(n) + unset[1].x, 0., 1.); }\n");
    const Picture two = picture(
        "Vertex s.vert\nTessEvaluation s.tes\nFragment s.frag\nPointSize 8\nProgram P\nNumPatchVertices 2\n"
        "glBegin gl_patches\nglVertex -.5 0 0\nglVertex .5 0 0\nglEnd\n");
    EXPECT_EQ(two.count({255, 0, 0, 255}), 64);
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
