// Which object is where: held against pictures in which only one object changes.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Pick : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    static constexpr int side = 64;
    Pick() { request = GetParam(); }
    void SetUp() override {
        GlTest::SetUp();
        folder.write("plain.vert", plain_vertex);
        folder.write("color.frag", color_fragment);
    }
    // An object of its own colour, which `P<number>.uColor` changes.
    static std::string object(int number, const std::string& shape, const std::string& color = "{.9 .1 .1 1.}") {
        return "Program P" + std::to_string(number) + " uColor " + color + "\n" + shape + "\n";
    }
    std::vector<Index> ids(Document& document, const Look& look = {}) {
        return document.runtime->pick({look.time, look.view, document.controls}, side, side, {0, 0, side, side});
    }
    // At each pixel, as ids() has them: the last object whose colour shows there.
    std::vector<Index> seen(Document& document, const Look& look = {}) {
        std::vector<Index> last(side * side, none);
        const Picture before = draw(document, look);
        for (Index i = 0; i < document.scene().draws.size(); ++i) {
            const Index program = document.scene().draws[i].program;
            if (program == none) continue;
            Control& control = *document.controls.find(program, "uColor");
            const std::vector<double> value = control.value;
            control.value = {.1, .9, 1 - value[2], value[3]};
            const Picture after = draw(document, look);
            control.value = value;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x)
                    if (before.at(x, y) != after.at(x, y)) last[static_cast<size_t>((side - 1 - y) * side + x)] = i;
        }
        return last;
    }
    // The same, and each of the objects is seen somewhere.
    void expect_exact(const std::string& scene, const Look& look = {}) {
        auto document = open(scene);
        expect_clean(*document);
        const std::vector<Index> truth = seen(*document, look), found = ids(*document, look);
        ASSERT_EQ(found.size(), truth.size());
        int wrong = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) wrong += truth[i] != found[i];
        EXPECT_EQ(wrong, 0);
        for (Index i = 0; i < document->scene().draws.size(); ++i)
            EXPECT_GT(std::ranges::count(truth, i), 8) << "object " << i << " is too small to tell";
    }
    const std::string head = "Perspective 50\nLookAt 0 1 4 0 0 0 0 1 0\nVertex plain.vert\nFragment color.frag\n";
    const std::string three = object(1, "QuadXY -.5 1.") +
                              object(2, "Translate .4 .2 0\nRotate 30 1 1 0\nTorus 1. .3") +
                              object(3, "Translate -.8 0 .3\nSphere .6");
};

TEST_P(Pick, SolidsInFrontOfEachOther) {
    expect_exact(head + three);
    Look look;
    look.view.scene.rotate_y = 70;
    look.view.scene.scale = 1.3;
    look.view.eye.x = .2;
    look.view.objects[2].x = .5;
    expect_exact(head + three, look);
    look.view.projection = Projection::ortho;
    expect_exact(head + three, look);
}

TEST_P(Pick, WhatIsTransparentLeavesThatBehindItButForWhatItShows) {
    expect_exact(head + object(1, "QuadXY -.5 1.") + object(2, "Translate .3 0 0\nSphere .8", "{.9 .1 .1 .4}") +
                 object(3, "Translate -.8 0 .9\nSphere .5", "{.1 .2 .9 .7}"));
}

TEST_P(Pick, AnObjectWithHolesOfNoOpacity) {
    folder.write("color.frag",
                 "uniform vec4 uColor;\nin vec2 vST;\nvoid main() {\n"
                 "    float a = fract(8. * vST.s) < .5 ? 0. : 1.;\n    gl_FragColor = vec4(uColor.rgb, a); }\n");
    expect_exact(head + three);
    // What hides others and is not seen itself: nobody's.
    auto document = open(head + object(1, "QuadXY 1. .5", "{1. 1. 1. 1.}"));
    const std::vector<Index> found = ids(*document);
    EXPECT_GT(std::ranges::count(found, Index{0}), 50);
}

TEST_P(Pick, ShadersThatMoveAndDiscard) {
    folder.write("plain.vert",
                 "out vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; vec4 p = gl_Vertex;\n"
                 "    p.xyz *= 1. + .3 * sin(9. * p.y); gl_Position = gl_ModelViewProjectionMatrix * p; }\n");
    folder.write("color.frag",
                 "uniform vec4 uColor;\nin vec2 vST;\nvoid main() {\n"
                 "    if (fract(6. * vST.s) + fract(5. * vST.t) < .8) discard;\n    gl_FragColor = uColor; }\n");
    expect_exact(head + three);
}

TEST_P(Pick, GeometryThatShadersMake) {
    folder.write(
        "grow.geom",
        "#version 330 compatibility\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
        "void main() {\n    vec4 center = (gl_PositionIn[0] + gl_PositionIn[1] + gl_PositionIn[2]) / 3.;\n"
        "    for (int i = 0; i < 3; ++i) {\n        gl_Position = mix(gl_PositionIn[i], center, .3) + vec4(.3, .2, "
        "0., 0.);\n        EmitVertex();\n    }\n    EndPrimitive();\n}\n");
    folder.write("bare.vert", "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    const std::string scene = "Perspective 50\nLookAt 0 1 4 0 0 0 0 1 0\nVertex plain.vert\nFragment color.frag\n" +
                              object(1, "QuadXY -.5 1.") + "Vertex bare.vert\nGeometry grow.geom\n" +
                              object(2, "Sphere .8 12 12") + object(3, "Translate -.8 0 .3\nSphere .6 9 9");
    expect_exact(scene);
    gl::leave_stages(caps);
    expect_exact(scene);
}

TEST_P(Pick, GeometryThatIsTessellated) {
    folder.write("bare.vert", "#version 400 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n");
    folder.write("round.tcs",
                 "#version 400 compatibility\nlayout(vertices = 3) out;\nvoid main() {\n"
                 "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
                 "    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = 6.;\n"
                 "    gl_TessLevelInner[0] = 6.; }\n");
    folder.write(
        "round.tes",
        "#version 400 compatibility\nlayout(triangles, equal_spacing, ccw) in;\nvoid main() {\n"
        "    vec3 p = gl_TessCoord.x * gl_in[0].gl_Position.xyz + gl_TessCoord.y * gl_in[1].gl_Position.xyz +\n"
        "             gl_TessCoord.z * gl_in[2].gl_Position.xyz;\n"
        "    gl_Position = gl_ModelViewProjectionMatrix * vec4(1.2 * normalize(p), 1.); }\n");
    const std::string patch =
        "NumPatchVertices 3\nglBegin gl_patches\nglVertex 1. 0. .3\nglVertex 0. 1. .3\nglVertex -.7 -.7 .3\nglEnd";
    const std::string scene = "Perspective 50\nLookAt 0 1 4 0 0 0 0 1 0\nVertex plain.vert\nFragment color.frag\n" +
                              object(1, "QuadXY .5 1.4") +
                              "Vertex bare.vert\nTessControl round.tcs\nTessEvaluation round.tes\n" + object(2, patch);
    expect_exact(scene);
    gl::leave_stages(caps);
    expect_exact(scene);
}

TEST_P(Pick, WhatWasClearedAwayAndWhatIsOffScreenIsNotThere) {
    auto document = open("Ortho -1 1 -1 1\nTexture2D 6 32 32\nRenderToTexture 6\n" + std::string("Sphere 1.\n") +
                         "RenderToTexture\nSphere 1.\nClear\nColor 1 0 0\nQuadXY 0. .5\n");
    const std::vector<Index> found = ids(*document);
    const Index quad = 2;
    EXPECT_EQ(found[side / 2 * side + side / 2], quad);
    EXPECT_EQ(found[side / 2 * side + side / 8], none);
    EXPECT_EQ(std::ranges::count(found, quad) + std::ranges::count(found, none), side * side);
}

TEST_P(Pick, OnePixelIsWhatTheWholeHasThere) {
    auto document = open(head + three);
    const std::vector<Index> all = ids(*document);
    const View view;
    for (const auto& [x, y] : {std::pair(32, 32), {20, 40}, {45, 30}, {0, 0}, {63, 63}}) {
        const auto one = document->runtime->pick({0, view, document->controls}, side, side, {x, y, 1, 1});
        ASSERT_EQ(one.size(), 1u);
        EXPECT_EQ(one[0], all[static_cast<size_t>(y * side + x)]);
    }
    EXPECT_TRUE(document->runtime->pick({0, view, document->controls}, side, side, {64, 3, 1, 1}).empty());
    EXPECT_TRUE(document->runtime->pick({0, view, document->controls}, 0, 0, {0, 0, 1, 1}).empty());
}

TEST_P(Pick, TheOutlineIsAroundTheObjectAndLeavesItAlone) {
    auto document = open("Ortho -1 1 -1 1\nBackground 0 0 1\nColor 1 1 1\nQuadXY 0. .5\nColor 0 1 0\nQuadXY .5 .25\n");
    const View view;
    const gl::Target target = gl::make_target(side, side, 1);
    const Surface surface{target.framebuffer.get(), side, side};
    document->runtime->draw({0, view, document->controls}, surface);
    document->runtime->outline({0, view, document->controls}, surface, 0);
    const Picture shown{side, side, gl::read_rgba8(target.framebuffer.get(), side, side, 1)};
    EXPECT_EQ(shown.count({0, 255, 0, 255}), 16 * 16) << "what is in front";
    EXPECT_EQ(shown.count({255, 255, 255, 255}), 32 * 32 - 16 * 16);
    EXPECT_EQ(shown.at(32, 15), (Pixel{255, 158, 13, 255}));
    EXPECT_EQ(shown.at(32, 14), (Pixel{255, 158, 13, 255}));
    EXPECT_LT(shown.at(32, 13)[2], 40) << "a dark rim";
    EXPECT_EQ(shown.at(32, 12), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(shown.count({0, 0, 255, 255}), 64 * 64 - 38 * 38);
}

TEST_P(Pick, CostsNothingUntilAskedFor) {
    auto document = open(head + three);
    draw(*document);
    const Counters before = document->runtime->counters();
    draw(*document);
    const Counters still = document->runtime->counters();
    EXPECT_EQ(still.gpu_bytes, before.gpu_bytes);
    EXPECT_EQ(still.programs_compiled, before.programs_compiled);
    EXPECT_EQ(still.draws - before.draws, 3u);
    ids(*document);
    const Counters picked = document->runtime->counters();
    EXPECT_EQ(picked.programs_compiled, still.programs_compiled + 1) << "the one that writes numbers";
    EXPECT_EQ(picked.shaders_compiled, still.shaders_compiled) << "the scene's own programs draw";
    EXPECT_EQ(picked.gpu_bytes, still.gpu_bytes + 16 * side * side);
    ids(*document);
    EXPECT_EQ(document->runtime->counters().programs_compiled, picked.programs_compiled) << "made once";
    const Picture after = draw(*document);
    EXPECT_TRUE(after == draw(*open(head + three))) << "and the picture is what it was";
}

INSTANTIATE_TEST_SUITE_P(Contexts, Pick, all_contexts, context_name);

}  // namespace
}  // namespace snell::test
