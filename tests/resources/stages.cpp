// Geometry stages where the context has none, against the driver's own: the same pixels.
#include "src/runtime/resources/stages.h"
#include "parser/text/ranges.h"
#include "src/app/window/session.h"
#include "tests/resources/without_stages.h"

namespace snell::test {
namespace {

std::string number(int n) { return std::to_string(n); }

// A geometry shader that nobody wrote, with what its neighbours need. The stages share names on purpose.
class RandomStages {
public:
    RandomStages(unsigned seed, bool es) : random_(seed), es_(es) {}

    // The scene; its shaders are written into the folder.
    std::string scene(Folder& folder) {
        struct Kind {
            std::string begin, input;
            int corners;
        };
        static const Kind kinds[] = {{"gl_points", "points", 1},
                                     {"gl_lines", "lines", 2},
                                     {"gl_line_strip", "lines", 2},
                                     {"gl_line_loop", "lines", 2},
                                     {"gl_triangles", "triangles", 3},
                                     {"gl_triangle_strip", "triangles", 3},
                                     {"gl_triangle_fan", "triangles", 3},
                                     {"gl_lines_adjacency", "lines_adjacency", 4},
                                     {"gl_line_strip_adjacency", "lines_adjacency", 4},
                                     {"gl_triangles_adjacency", "triangles_adjacency", 6},
                                     {"gl_triangle_strip_adjacency", "triangles_adjacency", 6}};
        const Kind& kind = kinds[below(std::size(kinds))];
        folder.write("s.vert", vertex());
        folder.write("s.geom", geometry(kind.input, kind.corners));
        folder.write("s.frag", fragment());
        std::string scene = "Ortho -1 1 -1 1\nVertex s.vert\nGeometry s.geom\nFragment s.frag\nProgram P uTwist .4\n";
        if (below(3) == 0) scene += "CullFace back\n";
        for (int draw = 0; draw < 2; ++draw) {
            scene += "glBegin " + kind.begin + "\n";
            for (int i = 0, all = 6 + below(12); i < all; ++i) {
                if (colored_) scene += "glColor " + real(0) + " " + real(0) + " " + real(0) + " 1.\n";
                scene += "glVertex " + real(-1) + " " + real(-1) + " " + real(-1) + "\n";
            }
            scene += "glEnd\nTranslate .1 .05 0\n";
        }
        return scene;
    }

private:
    int below(std::size_t n) { return static_cast<int>(random_() % n); }
    std::string real(double from) { return std::to_string(std::uniform_real_distribution<double>(from, 1)(random_)); }

    std::string vertex() const {
        return std::string("#version 400 compatibility\nuniform float uTwist;\n") +
               (block_ ? "out Pair { vec2 t; float w[2]; } given;\n" : "out vec2 t; out float w[2];\n") +
               "out vec3 shade; flat out int number;\nfloat x = .25, seed;\nconst int count = 2;\n"
               "struct Light { vec3 a; float b; };\nfloat mixed(float a) { return a * x; }\n"
               "void main() {\n    Light light = Light(vec3(x), seed);\n    x += gl_Vertex.x;\n    seed += 1.;\n"
               "    shade = " +
               (colored_ ? "gl_Color.rgb" : "fract(gl_Vertex.zyx * 3.)") +
               " + light.a * .1;\n"
               "    number = gl_VertexID;\n    " +
               (block_ ? "given.t" : "t") +
               " = vec2(mixed(x), seed * uTwist);\n"
               "    for (int i = 0; i < count; ++i) " +
               (block_ ? "given.w" : "w") + "[i] = float(i) + x;\n" +
               "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n    gl_PointSize = 3. + shade.x;\n}\n";
    }

    std::string geometry(const std::string& input, int corners) {
        // llvmpipe writes beyond its memory where strips have less than a primitive (Mesa 22.3).
        // Every OpenGL takes 1,024 numbers for each run: these vertices hand on eight variables of at most four, or 48
        // numbers more, which are too many to be captured.
        const int invocations = 1 + below(3), most = 3 + below(many_ ? 9 : below(4) == 0 ? 30 : 12);
        static const std::string outputs[] = {"points", "line_strip", "triangle_strip"};
        const std::string& output = outputs[below(3)];
        const std::string of = block_ ? "given[k]." : "", at = block_ ? "" : "[k]";
        std::string text =
            "#version 400 compatibility\nlayout(" + input + ", invocations = " + number(invocations) +
            ") in;\nlayout(" + output + ", max_vertices = " + number(most) + ") out;\n" + "uniform float uTwist;\n" +
            (block_ ? "in Pair { vec2 t; float w[2]; } given[];\n" : "in vec2 t[];\n") +
            "in vec3 shade[]; flat in int number[];\nout vec3 colour; flat out ivec2 whole;\n" +
            (many_ ? "out vec4 more[12];\n" : "") +
            "struct Light { float b; };\nfloat x = .5;\nconst int count = " + number(1 + below(5)) + ";\n" +
            (block_ ? "out Given { vec4 part; mat2 turn; } give;\n" : "out vec2 rest[2];\n") +
            "float mixed(float a) { return a * .5 + x; }\n"
            "void corner(int i, int k) {\n    float a = float(i) * " +
            real(.5) +
            " + uTwist;\n"
            "    colour = mix(shade[k], vec3(mixed(" +
            of + "t" + at +
            ".x), fract(a), x), .5);\n"
            "    whole = ivec2(number[k], i);\n" +
            (many_ ? "    for (int n = 0; n < 12; ++n) more[n] = vec4(shade[k], x) * float(n) * .1;\n" : "") +
            (block_ ? "    give.part = vec4(given[k].t, given[k].w[1], x);\n    give.turn = mat2(a);\n"
                    : "    rest[0] = t[k]; rest[1] = vec2(x, a);\n") +
            "    gl_Position = gl_in[k].gl_Position + vec4(cos(a), sin(a), 0, 0) * " + real(.1) + ";\n" +
            (!es_ && below(2) ? "    gl_PointSize = gl_in[k].gl_PointSize;\n" : "") +
            (number_ ? "    gl_PrimitiveID = gl_PrimitiveIDIn + i;\n" : "") + "    x += .01;\n";
        const bool apart = below(2) == 0;
        text += apart ? "    EmitVertex();\n}\n" : "}\n";
        return text + "void main() {\n    int n = (gl_PrimitiveIDIn * 7 + gl_InvocationID * 3 + number[0]) % " +
               number(most + 3) +
               ";\n    if (n == count) return;\n    for (int i = 0; i < n; ++i) {\n"
               "        corner(i, i % " +
               number(corners) + ");\n        " + (apart ? "" : "EmitVertex();") +
               "\n        if ((i * 5 + gl_PrimitiveIDIn) % " + number(2 + below(7)) +
               " == 0) EndPrimitive();\n"
               "        else if (i > 20) x = 1.; else x += .001;\n    }\n}\n";
    }

    std::string fragment() const {
        return std::string("#version 400 compatibility\nin vec3 colour; flat in ivec2 whole;\n") +
               (block_ ? "in Given { vec4 part; mat2 turn; } taken;\n" : "in vec2 rest[2];\n") +
               (many_ ? "in vec4 more[12];\n" : "") +
               "void main() {\n    vec3 c = fract(colour + vec3(whole % 5, 0) * .2);\n    " +
               (many_ ? "for (int n = 0; n < 12; ++n) c = fract(c + more[n].xyw);\n    " : "") +
               (block_ ? "c.z = fract(taken.part.x + taken.part.w * taken.turn[1][1]);\n"
                       : "c.z = fract(rest[0].x + rest[1].y);\n") +
               (number_ ? "    c.x = float(gl_PrimitiveID % 7) / 7.;\n" : "") +
               "    gl_FragColor = vec4(gl_FrontFacing ? c : c * .4, 1.);\n}\n";
    }

    std::mt19937 random_;
    bool es_;  // which has no sizes of points in geometry shaders
    bool block_ = below(2) == 0, colored_ = below(2) == 0, number_ = below(3) == 0;
    bool many_ = below(8) == 0;
};

std::string geometry(unsigned seed, bool es, Folder& folder) { return RandomStages(seed, es).scene(folder); }

TEST_F(Stages, RandomGeometryShadersDrawWhatTheDriverDraws) { compare_random("SNELL_RANDOM_STAGES", 8, 1, geometry); }
TEST_F(StagesEs, RandomGeometryShadersDrawWhatTheDriverDraws) {
    compare_random("SNELL_RANDOM_STAGES", 8, 10001, geometry);
}

TEST_F(Stages, CasesWithGeometryShadersDrawWhatTheDriverDraws) {
    for (const char* name : {"Geometry", "GeometryInput", "GeometryOutput", "LinesAdjacency", "ObjAdj"}) {
        SCOPED_TRACE(name);
        compare([&] { return open_file(SNELL_ROOT "/tests/cases/" + std::string(name) + ".glib"); });
    }
}

// The counts are kept, and made again when what they depend on changes.
TEST_F(Stages, FollowTheirUniforms) {
    const std::string scene = SNELL_ROOT "/tests/cases/LinesAdjacency.glib";
    const auto native = open_file(scene);
    gl::leave_stages(caps);
    const auto emulated = open_file(scene);
    for (const char* value : {"uNum=3", "uNum=40", "uNum=1", "uInk=1,0,0", "uNum=40"}) {
        SCOPED_TRACE(value);
        const Picture a = draw(*native, {.sets = {value}}), b = draw(*emulated, {.sets = {value}});
        EXPECT_EQ(a, b);
    }
}

// What only the other shaders read makes nothing count again.
TEST_F(Stages, CountOnceForWhatTheCountsDependOn) {
    gl::leave_stages(caps);
    const auto document = open_file(SNELL_ROOT "/tests/cases/LinesAdjacency.glib");
    std::vector<std::uint64_t> reads;
    for (const char* value : {"uNum=24", "uNum=24", "uNum=40", "uNum=40", "uInk=1,0,0", "uNum=24"}) {
        const std::uint64_t before = document->runtime->counters().stage_reads;
        draw(*document, {.sets = {value}});
        reads.push_back(document->runtime->counters().stage_reads - before);
    }
    EXPECT_EQ(reads, (std::vector<std::uint64_t>{1, 0, 1, 0, 0, 1}));
}

// What other scenes cost does not depend on whether the stages are there: each counter is the same.
TEST_F(Stages, CostNothingInScenesWithoutThem) {
    const gl::Caps whole = caps;
    for (const char* scene : {"refraction-room/refraction-room", "light/glass/glass"}) {
        SCOPED_TRACE(scene);
        const auto counters = [&] {
            const auto document = open_file(SNELL_ROOT "/scenes/" + std::string(scene) + ".glib");
            for (const double time : {0., 1.}) draw(*document, {.time = time});
            Counters counted = document->runtime->counters();
            counted.specialise_us = 0;
            return counted;
        };
        caps = whole;
        const Counters native = counters();
        caps.geometry = caps.tessellation = false;
        const Counters without = counters();
        for (const CounterName& counter : counter_names())
            EXPECT_EQ(native.*counter.value, without.*counter.value) << counter.name;
        EXPECT_GT(without.draws, 0U);
        EXPECT_EQ(without.stage_reads + without.captured_primitives, 0U);
    }
}

// Said once for the same rungs, at the statement.
TEST_F(Stages, MuchThatTheyEmitIsSaid) {
    folder.write("s.geom",
                 "#version 400 compatibility\nlayout(points) in; layout(points, max_vertices = 64) out;\n"
                 "uniform int uCount;\nvoid main() {\n"
                 "    for (int i = 0; i < uCount; ++i) { gl_Position = vec4(2.); EmitVertex(); }\n}\n");
    std::string scene = "Ladder KIND a b\nGeometry s.geom\nProgram P uCount <0 60 64>\nglBegin gl_points\n";
    for (int i = 0; i < 5000; ++i) scene += "glVertex 0 0 0\n";
    gl::leave_stages(caps);
    const auto document = open(scene + "glEnd\n");
    const auto said = [&](const char* value) {
        draw(*document, {.sets = {value}});
        return document->runtime->take_costs();
    };
    EXPECT_TRUE(said("uCount=60").empty());
    const Diagnostics costs = said("uCount=64");
    ASSERT_EQ(costs.items().size(), 1U);
    EXPECT_EQ(costs.items()[0].code, "costly-stages");
    EXPECT_NE(costs.items()[0].message.find("320000 primitives"), std::string::npos) << costs.items()[0].message;
    const Span span = costs.items()[0].span;
    EXPECT_EQ(document->sources.position(span.file, span.begin).line, 3);
    EXPECT_TRUE(said("uCount=64").empty());
    document->controls.rungs = {document->runtime->rungs()[0] == 0 ? 1U : 0U};
    EXPECT_EQ(said("uCount=64").items().size(), 1U);
}

// The window has it among its problems until the scene is read again.
TEST_F(Stages, MuchThatTheyEmitIsAProblemOfTheWindow) {
    folder.write(
        "s.geom",
        "#version 400 compatibility\nlayout(points) in; layout(points, max_vertices = 128) out;\nvoid main() {\n"
        "    for (int i = 0; i < 128; ++i) { gl_Position = vec4(2.); EmitVertex(); }\n}\n");
    folder.write("s.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    std::string scene = "Geometry s.geom\nFragment s.frag\nProgram P\nglBegin gl_points\n";
    for (int i = 0; i < 2500; ++i) scene += "glVertex 0 0 0\n";
    folder.write("scene.glib", scene + "glEnd\n");
    gl::leave_stages(caps);
    Session session(folder.path("scene.glib"), caps);
    const auto draw_twice = [&] {
        for (int i = 0; i < 2; ++i) {
            draw(*session.document());
            session.drawn_well();
        }
        return session.problems_text();
    };
    EXPECT_TRUE(session.problems().empty()) << session.problems_text();
    for (int reading = 0; reading < 2; ++reading) {
        const std::string text = draw_twice();
        EXPECT_EQ(session.problems().size(), 1U) << text;
        EXPECT_NE(text.find("scene.glib:3:1: warning: without geometry shaders"), std::string::npos) << text;
        session.reload();
    }
}

// Each draw of one program has counts of its own, and so has each part of a mesh.
TEST_F(Stages, CountForEachFaceOfAMesh) {
    folder.write(
        "s.geom",
        "#version 400 compatibility\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
        "uniform int FaceIndex; out float shade;\nvoid main() {\n"
        "    for (int i = 0; i < (FaceIndex % 3 == 0 ? 0 : 3); ++i) {\n        shade = float(FaceIndex) / 32.;\n"
        "        gl_Position = gl_in[i].gl_Position; EmitVertex();\n    }\n}\n");
    folder.write("s.frag", "#version 330\nin float shade; out vec4 c; void main() { c = vec4(shade, 1., 0., 1.); }\n");
    compare([&] {
        return open(
            "Perspective 50\nLookAt 0 0 4 0 0 0 0 1 0\nGeometry s.geom\nFragment s.frag\nProgram P\nSoccerball\n"
            "Sphere .4\n");
    });
}

// One error each. `es32`: also by the stages of OpenGL ES 3.2.
TEST_F(StagesEs, WhatTheyCannotDoIsSaidAtItsPlace) {
    struct Refused {
        const char *geometry, *fragment, *file, *code, *said;
        int line;
        bool es32;
    };
    const std::string emits = "gl_Position = gl_in[0].gl_Position; EmitVertex(); }\n";
    const char* const red = "void main() { gl_FragColor = vec4(1.); }";
    const Refused all[] = {{"void main() {\n    gl_Layer = 1; ", red, "s.geom", "unsupported-stage",
                            "'gl_Layer' cannot be used", 4, false},
                           {"void main() {\n    EmitStreamVertex(1); ", red, "s.geom", "unsupported-stage",
                            "only the first stream of vertices", 4, true},
                           {"void main() {\n    gl_ClipDistance[0] = 1.; ", red, "s.geom", "unsupported-variable",
                            "no 'gl_ClipDistance'", 4, true},
                           {"out float many[2][3];\nvoid main() { many[0][0] = 1.; ",
                            "\nin float many[2][3];\nvoid main() { gl_FragColor = vec4(many[0][0]); }", "s.frag",
                            "unsupported-stage", "'many' has a type", 3, false},
                           {"in vec2 two[][2]; out vec2 one;\nvoid main() { one = two[0][1]; ",
                            "in vec2 one; void main() { gl_FragColor = one.xyxy; }", "s.geom", "unsupported-stage",
                            "'two' has a type", 3, false},
                           {nullptr, "\nvoid main() {\n    gl_FragColor = vec4(gl_PrimitiveID);\n}\n", "s.frag",
                            "unsupported-variable", "no 'gl_PrimitiveID' in fragment shaders", 4, false}};
    const gl::Caps whole = caps;
    for (const Refused& refused : all) {
        SCOPED_TRACE(refused.said);
        const std::string version = "#version 430 compatibility\n";
        folder.write("s.vert", version +
                                   "out vec2 two[2];\nvoid main() { two[0] = two[1] = gl_Vertex.xy; gl_Position = "
                                   "gl_Vertex; }\n");
        folder.write("s.frag", version + refused.fragment);
        std::string scene = "Vertex s.vert\nFragment s.frag\n";
        if (refused.geometry) {
            folder.write("s.geom", version + "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n" +
                                       refused.geometry + emits);
            scene += "Geometry s.geom\n";
        }
        scene += "Program P\nQuadXY\n";
        caps = whole;
        EXPECT_TRUE(!refused.es32 || has(*open(scene), refused.code));
        gl::leave_stages(caps);
        const auto document = open(scene);
        const auto& said = document->diagnostics.items();
        const auto found = ranges::find(said, refused.code, &Diagnostic::code);
        ASSERT_NE(found, said.end());
        EXPECT_NE(found->message.find(refused.said), std::string::npos) << found->message;
        EXPECT_TRUE(document->sources.name(found->span.file).ends_with(refused.file));
        EXPECT_EQ(document->sources.position(found->span.file, found->span.begin).line, refused.line);
        EXPECT_EQ(document->diagnostics.errors(), 1U);
    }
}

// By the tables of the OpenGL specification (section 10.1).
TEST(StageMeshes, ListTheCornersOfEveryTopology) {
    using runtime::corners_of;
    using Numbers = std::vector<std::uint32_t>;
    const Numbers eight{0, 1, 2, 3, 4, 5, 6, 7}, five{0, 1, 2, 3, 4};
    EXPECT_EQ(corners_of(Topology::line_loop, Numbers{4, 5, 6}), (Numbers{4, 5, 5, 6, 6, 4}));
    EXPECT_EQ(corners_of(Topology::triangle_strip, five), (Numbers{0, 1, 2, 2, 1, 3, 2, 3, 4}));
    EXPECT_EQ(corners_of(Topology::triangle_fan, five), (Numbers{0, 1, 2, 0, 2, 3, 0, 3, 4}));
    EXPECT_EQ(corners_of(Topology::line_strip_adjacency, five), (Numbers{0, 1, 2, 3, 1, 2, 3, 4}));
    EXPECT_EQ(corners_of(Topology::triangles, five), (Numbers{0, 1, 2}));
    EXPECT_EQ(corners_of(Topology::triangle_strip_adjacency, eight), (Numbers{0, 1, 2, 6, 4, 3, 4, 0, 2, 5, 6, 7}));
}

}  // namespace
}  // namespace snell::test
