// Tessellation where the context has none, against the driver's own: the same pixels.
#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "tests/resources/without_stages.h"

namespace snell::test {
namespace {

// A program with tessellation that nobody wrote, and what it draws. The stages share names on purpose.
class RandomPatches {
public:
    RandomPatches(unsigned seed, bool es) : random_(seed), es_(es) {}

    // The scene; its shaders are written into the folder.
    std::string scene(Folder& folder) {
        folder.write("s.vert", vertex());
        folder.write("s.tcs", control());
        folder.write("s.tes", evaluation());
        folder.write("s.geom", geometry());
        folder.write("s.frag", fragment());
        std::string scene = "Ortho -1 1 -1 1\nNumPatchVertices " + number(in_) + "\nVertex s.vert\n";
        if (controls_) scene += "TessControl s.tcs\n";
        scene += "TessEvaluation s.tes\n";
        if (emits_) scene += "Geometry s.geom\n";
        scene += "Fragment s.frag\nProgram P uTwist .4\n";
        if (below(3) == 0) scene += "CullFace back\n";
        for (int draw = 0; draw < 2; ++draw) {
            scene += "glBegin gl_patches\n";
            for (int i = 0, all = in_ * (1 + below(4)) + below(in_); i < all; ++i)
                scene += fmt::format("glVertex {} {} {}\n", real(-1), real(-1), real(-1));
            scene += "glEnd\nTranslate .1 .05 0\n";
        }
        return scene;
    }

private:
    static std::string number(int n) { return std::to_string(n); }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    std::string real(double from) { return std::to_string(std::uniform_real_distribution<double>(from, 1)(random_)); }

    static constexpr std::string_view head = "#version 400 compatibility\nuniform float uTwist;\n";
    std::string given(std::string_view direction, std::string_view instance) const {
        return block_ ? fmt::format("{} Pair {{ vec2 t; float w[2]; }} {};\n", direction, instance)
                      : fmt::format("{} vec2 t{};\n", direction, instance.ends_with("[]") ? "[]" : "");
    }

    std::string vertex() const {
        const std::string t = block_ ? "given.t" : "t";
        return std::string(head) + given("out", "given") +
               "out vec3 shade; flat out int number;\nfloat x = .25;\nconst int count = 2;\n"
               "struct Light { vec3 a; };\nfloat mixed(float a) { return a + x; }\n"
               "void main() {\n    Light light = Light(vec3(x));\n    x += gl_Vertex.x;\n"
               "    shade = fract(gl_Vertex.zyx * 3.) + light.a * .1; number = gl_VertexID;\n    " +
               t + " = vec2(mixed(x), uTwist);\n" + (block_ ? "    given.w[0] = x; given.w[1] = gl_Vertex.y;\n" : "") +
               "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n";
    }

    std::string level(int n) {
        const std::string own = below(3) == 0 ? "float(gl_PrimitiveID)" : "0.";
        return below(20) == 0 ? "0." : fmt::format("{} + {} * {} + uTwist", real(.5), own, 1 + below(n));
    }

    std::string control() {
        const std::string of = block_ ? "given[k]." : "", at = block_ ? "" : "[k]", id = "[gl_InvocationID]";
        std::string text = std::string(head) + "layout(vertices = " + number(out_) + ") out;\n" +
                           given("in", "given[]") + "in vec3 shade[]; flat in int number[];\n" +
                           (block_ ? "out Mine { vec2 t; float w[2]; } mine[];\n" : "out vec2 mine[];\n") +
                           "out vec3 tint[]; patch out float whole; patch out ivec2 numbers;\n"
                           "float x = .5;\nfloat mixed(float a) { x += .1; return a * .5 + x; }\n"
                           "struct Light { float b; };\nvoid main() {\n"
                           "    int k = (gl_InvocationID + " +
                           number(below(3)) +
                           ") % gl_PatchVerticesIn;\n    float kept = mixed(shade[k].x);\n"
                           "    gl_out[gl_InvocationID].gl_Position = gl_in[k].gl_Position + vec4(kept * .1);\n"
                           "    tint[gl_InvocationID] = shade[k] * kept;\n    mine" +
                           id + (block_ ? ".t" : "") + " = " + of + "t" + at + ";\n" +
                           (block_ ? "    mine" + id + ".w[0] = given[k].w[1]; mine" + id + ".w[1] = kept;\n" : "");
        if (phases_)
            text += "    barrier();\n    vec3 next = tint[(gl_InvocationID + 1) % " + number(out_) +
                    "] * kept;\n    barrier();\n    tint[gl_InvocationID] += next;\n";
        text += "    if (gl_InvocationID == 0) {\n        whole = x; numbers = ivec2(number[0], gl_PrimitiveID);\n";
        for (int i = 0; i < 4; ++i) text += fmt::format("        gl_TessLevelOuter[{}] = {};\n", i, level(4));
        for (int i = 0; i < 2; ++i) text += fmt::format("        gl_TessLevelInner[{}] = {};\n", i, level(9));
        return text + "    }\n}\n";
    }

    std::string evaluation() {
        static constexpr std::array domains{"triangles", "quads", "isolines"};
        static constexpr std::array spacings{"equal_spacing", "fractional_even_spacing", "fractional_odd_spacing"};
        const int corners = controls_ ? out_ : in_;
        const std::string mine = !controls_ ? (block_ ? "given[k].t" : "t[k]") : block_ ? "mine[k].t" : "mine[k]";
        std::string text =
            std::string(head) + fmt::format("layout({}, {}, {}{}) in;\n", domains[static_cast<std::size_t>(domain_)],
                                            spacings[static_cast<std::size_t>(below(3))], below(2) ? "cw" : "ccw",
                                            points_ ? ", point_mode" : "");
        if (controls_)
            text += (block_ ? "in Mine { vec2 t; float w[2]; } mine[];\n" : "in vec2 mine[];\n") +
                    std::string("in vec3 tint[]; patch in float whole; patch in ivec2 numbers;\n");
        else
            text += given("in", "given[]") + "in vec3 shade[];\n";
        text +=
            "out vec3 colour; flat out ivec2 told;\nfloat x = .5;\nconst int count = 3;\n"
            "float mixed(float a) { return a * .5 + x; }\nvoid main() {\n"
            "    int k = " +
            number(below(corners)) + ";\n    vec2 a = " + mine + ";\n    k = gl_PrimitiveID % " + number(corners) +
            ";\n    a += " + mine + ";\n" + (controls_ && block_ ? "    a.y += mine[k].w[1];\n" : "") +
            "    vec4 middle = vec4(0);\n"
            "    for (int i = 0; i < gl_PatchVerticesIn; ++i) middle += gl_in[i].gl_Position;\n"
            "    colour = " +
            (controls_ ? std::string("tint[k] + vec3(whole, mixed(gl_TessLevelOuter[0]), gl_TessLevelInner[0])")
                       : std::string("shade[k]")) +
            ";\n    told = " + (controls_ ? "numbers" : "ivec2(gl_PrimitiveID, 1)") +
            ";\n    vec2 p = mix(gl_in[0].gl_Position.xy, middle.xy / float(gl_PatchVerticesIn), .3) * .5;\n"
            "    p += (gl_TessCoord.xy + gl_TessCoord.yz * .2 - .4) * " +
            real(.6) + " + a * .05;\n    gl_Position = vec4(p, fract(p.x * 7.) * .5, 1.);\n";
        return text + (points_ && !emits_ && !es_ ? "    gl_PointSize = 3.;\n" : "") + "}\n";
    }

    std::string geometry() {
        const int corners = points_ ? 1 : domain_ == 2 ? 2 : 3;
        static constexpr std::array inputs{"points", "lines", "triangles"};
        return std::string(head) +
               fmt::format("layout({}) in;\nlayout(triangle_strip, max_vertices = 3) out;\n",
                           inputs[static_cast<std::size_t>(corners - 1)]) +
               "in vec3 colour[]; flat in ivec2 told[];\nout vec3 shine; flat out ivec2 heard; float x = .1;\n"
               "void main() {\n    for (int i = 0; i < 3; ++i) {\n        int k = i % " +
               number(corners) +
               ";\n        shine = colour[k] + vec3(gl_PrimitiveIDIn % 3) * .2; heard = told[k];\n"
               "        gl_Position = gl_in[k].gl_Position + vec4(i == 1 ? x : 0., i == 2 ? x : 0., 0, 0);\n"
               "        EmitVertex();\n    }\n}\n";
    }

    std::string fragment() const {
        return std::string(head) +
               (emits_ ? "in vec3 shine; flat in ivec2 heard;\n" : "in vec3 colour; flat in ivec2 told;\n") +
               "void main() {\n    vec3 c = fract(" + (emits_ ? "shine" : "colour") + " + vec3(" +
               (emits_ ? "heard" : "told") +
               " % 5, 0) * .2);\n    gl_FragColor = vec4(gl_FrontFacing ? c : c * .4, 1.);\n}\n";
    }

    std::mt19937 random_;
    bool es_;
    bool block_ = below(2) == 0, controls_ = below(5) > 0 || es_, phases_ = below(3) == 0, emits_ = below(3) == 0;
    int in_ = 1 + below(5), out_ = 1 + below(6), domain_ = below(3);
    bool points_ = below(4) == 0;
};

std::string patches(unsigned seed, bool es, Folder& folder) { return RandomPatches(seed, es).scene(folder); }

class Patches : public Stages {};
class PatchesEs : public StagesEs {};

TEST_F(Patches, RandomTessellationDrawsWhatTheDriverDraws) { compare_random("SNELL_RANDOM_PATCHES", 10, 1, patches); }
TEST_F(PatchesEs, RandomTessellationDrawsWhatTheDriverDraws) {
    compare_random("SNELL_RANDOM_PATCHES", 10, 10001, patches);
}

TEST_F(Patches, CasesWithTessellationDrawWhatTheDriverDraws) {
    for (const char* name : {"NumPatchVertices", "ObjPatch", "TessControl", "TessEvaluation"}) {
        SCOPED_TRACE(name);
        compare([&] { return open_file(SNELL_ROOT "/tests/cases/" + std::string(name) + ".glib"); });
    }
}

// Levels are kept, and asked for again when what they depend on changes.
TEST_F(Patches, FollowTheirUniforms) {
    const std::string scene = SNELL_ROOT "/docs/teaching/06-geometry/solution/round.glib";
    const auto native = open_file(scene);
    gl::leave_stages(caps);
    const auto emulated = open_file(scene);
    for (const char* value : {"uDetail=3", "uDetail=16", "uRound=.4", "uShrink=.5", "uDetail=3"}) {
        SCOPED_TRACE(value);
        EXPECT_EQ(draw(*native, {.sets = {value}}), draw(*emulated, {.sets = {value}}));
    }
}

TEST_F(Patches, AskForLevelsOnceForWhatTheyDependOn) {
    gl::leave_stages(caps);
    const auto document = open_file(SNELL_ROOT "/docs/teaching/06-geometry/solution/round.glib");
    std::vector<std::uint64_t> reads;
    for (const char* value : {"uDetail=3", "uDetail=3", "uDetail=16", "uDetail=16", "uDetail=3"}) {
        const std::uint64_t before = document->runtime->counters().stage_reads;
        draw(*document, {.sets = {value}});
        reads.push_back(document->runtime->counters().stage_reads - before);
    }
    EXPECT_EQ(reads, (std::vector<std::uint64_t>{2, 0, 2, 0, 2}));
}

constexpr std::string_view pass_on = "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n";

// Each face has its levels, which a texture gives; a color comes from the mesh.
TEST_F(Patches, TextureAndFaceGiveLevels) {
    folder.write("four.bmp", bmp(2, 2, {{255, 0, 0}, {60, 0, 0}, {120, 0, 0}, {200, 0, 0}}));
    folder.write("s.vert", pass_on);
    folder.write(
        "s.tcs",
        "#version 400 compatibility\nlayout(vertices = 3) out; uniform int FaceIndex; uniform sampler2D uUnit;\n"
        "void main() {\n    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
        "    float level = 1. + 7.3 * texelFetch(uUnit, ivec2(gl_in[0].gl_Position.x > 0., gl_in[0].gl_Position.y > "
        "0.), 0).r;\n"
        "    for (int i = 0; i < 3; ++i) gl_TessLevelOuter[i] = level * float(FaceIndex % 3);\n"
        "    gl_TessLevelInner[0] = level;\n}\n");
    folder.write(
        "s.tes",
        "#version 400 compatibility\nlayout(triangles) in; out vec3 shade;\nvoid main() {\n"
        "    vec4 p = mat3x4(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position) * gl_TessCoord;\n"
        "    shade = fract(gl_TessCoord * 3.);\n"
        "    gl_Position = gl_ModelViewProjectionMatrix * vec4(normalize(p.xyz), 1.);\n}\n");
    folder.write("s.frag", "#version 330\nin vec3 shade; out vec4 c; void main() { c = vec4(shade, 1.); }\n");
    compare([&] {
        return open(
            "Perspective 50\nLookAt 0 0 4 0 0 0 0 1 0\nTexture2D 6 four.bmp\nVertex s.vert\nTessControl s.tcs\n"
            "TessEvaluation s.tes\nFragment s.frag\nProgram P uUnit 6\nSoccerball\n");
    });
}

// More vertices than are kept from frame to frame, in several pieces.
TEST_F(Patches, ManyAreDividedForEachFrame) {
    folder.write("s.vert", pass_on);
    folder.write("s.tcs",
                 "#version 400 compatibility\nlayout(vertices = 1) out;\nvoid main() {\n"
                 "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
                 "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = 64.;\n"
                 "    gl_TessLevelInner[0] = gl_TessLevelInner[1] = 64.;\n}\n");
    folder.write("s.tes",
                 "#version 400 compatibility\nlayout(quads) in;\nvoid main() {\n"
                 "    gl_Position = vec4(gl_in[0].gl_Position.xy + gl_TessCoord.xy * .07, 0., 1.); }\n");
    folder.write("s.frag", "void main() { gl_FragColor = vec4(1., .5, 0., 1.); }\n");
    std::string scene =
        "Vertex s.vert\nTessControl s.tcs\nTessEvaluation s.tes\nFragment s.frag\nProgram P\n"
        "NumPatchVertices 1\nglBegin gl_patches\n";
    for (int i = 0; i < 520; ++i) scene += fmt::format("glVertex {} {} 0\n", i % 23 * .08 - 1, i / 23 * .08 - 1);
    gl::leave_stages(caps);
    const auto document = open(scene + "glEnd\n");
    expect_clean(*document);
    const Picture first = draw(*document), second = draw(*document);
    EXPECT_EQ(first, second);
    EXPECT_GT(first.count({255, 128, 0, 255}), 64 * 64 / 2);
}

TEST_F(Patches, WhatTheyCannotDoIsSaidAtItsPlace) {
    folder.write("s.vert", pass_on);
    folder.write("s.tcs",
                 "#version 400\nlayout(vertices = 1) out;\nvoid main() {\n    float all[2]; all[1] = 1.;\n"
                 "    barrier();\n    gl_TessLevelOuter[0] = all[1];\n}\n");
    folder.write("s.tes", "#version 400\nlayout(isolines) in;\nvoid main() { gl_Position = gl_in[0].gl_Position; }\n");
    gl::leave_stages(caps);
    const auto document = open(
        "Vertex s.vert\nTessControl s.tcs\nTessEvaluation s.tes\nProgram P\nNumPatchVertices 1\n"
        "glBegin gl_patches\nglVertex 0 0 0\nglEnd\n");
    ASSERT_TRUE(has(*document, "unsupported-stage"));
    const auto& said = document->diagnostics.items();
    const Span span = ranges::find(said, "unsupported-stage", &Diagnostic::code)->span;
    EXPECT_EQ(document->sources.position(span.file, span.begin).line, 5);
}

// What the layout says is in no shader that stands for it.
TEST_F(Patches, ProgramsThatDifferOnlyInTheirLayoutDoNotShareIt) {
    folder.write("s.vert", pass_on);
    folder.write("s.frag",
                 "#version 400\nout vec4 c;\nvoid main() { c = vec4(gl_FrontFacing ? 1. : .4, .5, .2, 1.); }\n");
    std::string scene = "Ortho -1 1 -1 1\nNumPatchVertices 4\nPointSize 3\nVertex s.vert\nFragment s.frag\n";
    int name = 0;
    for (const char* layout : {"quads, equal_spacing", "quads, fractional_odd_spacing, cw", "isolines",
                               "quads, point_mode", "quads, fractional_even_spacing"}) {
        const std::string file = fmt::format("{}.tes", name++);
        folder.write(file,
                     fmt::format("#version 400\nlayout({}) in;\nvoid main() {{\n    gl_Position = mix("
                                 "gl_in[0].gl_Position, gl_in[2].gl_Position, vec4(gl_TessCoord.xy, 0., 0.));\n}}\n",
                                 layout));
        folder.write("s.tcs",
                     "#version 400\nlayout(vertices = 4) out;\nvoid main() {\n"
                     "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
                     "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = 3.5;\n"
                     "    gl_TessLevelInner[0] = gl_TessLevelInner[1] = 3.5;\n}\n");
        scene += fmt::format("TessControl s.tcs\nTessEvaluation {}\nProgram P{}\nglBegin gl_patches\n", file, name);
        for (const auto& [x, y] : {std::pair(-.9, -.9), std::pair(-.6, -.9), std::pair(-.6, .9), std::pair(-.9, .9)})
            scene += fmt::format("glVertex {} {} 0\n", x + .35 * (name - 1), y);
        scene += "glEnd\n";
    }
    compare([&] { return open(scene); });
}

TEST_F(Patches, ErrorsOfAGeometryShaderStandThere) {
    folder.write("s.vert", pass_on);
    folder.write("s.geom",
                 "#version 330\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\nvoid main() {\n"
                 "    int k = vec3(1);\n    float z = q1 + 1.;\n    EmitVertex();\n}\n");
    gl::leave_stages(caps);
    const auto document = open("Vertex s.vert\nGeometry s.geom\nProgram P\nQuadXY\n");
    std::vector<int> lines;
    for (const Diagnostic& said : document->diagnostics.items())
        if (document->sources.name(said.span.file).ends_with("s.geom") &&
            said.message.find("(geometry shader of 'P')") != std::string::npos)
            lines.push_back(document->sources.position(said.span.file, said.span.begin).line);
    EXPECT_EQ(lines, (std::vector<int>{5, 6}));
    complaints.clear();
}

TEST_F(PatchesEs, LessonDrawsWhatTheDriverDraws) {
    compare([&] { return open_file(SNELL_ROOT "/docs/teaching/06-geometry/solution/round.glib"); });
}

}  // namespace
}  // namespace snell::test
