// A sampler whose unit has nothing reads black of its own kind, whatever was drawn before in the same context.
#include "tests/harness/plain.h"
#include "tests/words.h"

namespace snell::test {
namespace {

struct Kind {
    std::string types, value;  // what is looked up
    int alpha = 255;
};

const Kind lookups[]{
    {"sampler1D isampler1D usampler1D", "texture(t, vST.x)"},
    {"sampler2D isampler2D usampler2D sampler1DArray sampler2DRect isampler2DRect", "texture(t, vST)"},
    {"sampler3D samplerCube isampler3D isamplerCube usampler3D usamplerCube", "texture(t, vec3(vST, 1.))"},
    {"sampler1DShadow sampler2DShadow sampler2DRectShadow", "texture(t, vec3(vST, 0.))", 0},
    {"samplerCubeShadow", "texture(t, vec4(vST, 1., 0.))", 0},
    {"sampler2DArray usampler2DArray", "texture(t, vec3(vST, 0.))"},
    {"sampler2DArrayShadow", "texture(t, vec4(vST, 0., 0.))", 0},
    {"samplerCubeArray", "texture(t, vec4(vST, 1., 0.))"},
    {"samplerBuffer isamplerBuffer", "texelFetch(t, 0)", 0},
    {"sampler2DMS usampler2DMS", "texelFetch(t, ivec2(0), 0)", 0},
    {"sampler2DMSArray", "texelFetch(t, ivec3(0), 0)", 0},
};

std::vector<Kind> all_kinds() {
    std::vector<Kind> all;
    for (const Kind& kind : lookups)
        for (const std::string& type : words(kind.types)) all.push_back({type, kind.value, kind.alpha});
    return all;
}
const Kind of_pictures{"sampler2D", "texture(t, vST)"};

class Unbound : public PlainTest, public testing::WithParamInterface<ContextRequest> {
protected:
    void SetUp() override {
        request = GetParam();
        PlainTest::SetUp();
        folder.write("red.bmp", bmp(2, 2, std::vector<std::array<int, 3>>(4, {255, 60, 200})));
    }
    // Fills texture units with everything that a scene can bind.
    void draw_before() {
        folder.write(
            "all.frag",
            "#version 330 compatibility\nuniform sampler2D a[3];\nuniform samplerCube b[3];\nuniform sampler3D "
            "c[2];\nin vec2 vST;\nvoid main() { vec3 p = vec3(vST, 1.); gl_FragColor = texture(a[0], vST) + "
            "texture(a[1], vST) + texture(a[2], vST) + texture(b[0], p) + texture(b[1], p) + texture(b[2], p) + "
            "texture(c[0], p) + texture(c[1], p); }\n");
        draw(
            "Filter nearest\nOrtho -1 1 -1 1\nTexture2D 6 red.bmp\nCubeMap 6 red.bmp red.bmp red.bmp red.bmp red.bmp "
            "red.bmp\nNoise3D 16\nVertex plain.vert\nFragment all.frag\nProgram P a [6 6 6] b [6 6 6] c [3 "
            "3]\nQuadXY\n");
    }
    // Red is the alpha that is read; green and blue the sum of the rest, which is none.
    std::string scene(const Kind& kind) {
        const bool late = kind.types.find("CubeArray") != std::string_view::npos;
        folder.write("own.frag", std::string(late ? "#version 400 compatibility" : "#version 330 compatibility") +
                                     "\nuniform " + kind.types + " t;\nin vec2 vST;\nvoid main() { vec4 c = vec4(" +
                                     kind.value + "); gl_FragColor = vec4(c.a, c.r + c.g + c.b - " +
                                     (kind.alpha ? "0." : "3. * c.a") + ", .2, 1.); }\n");
        return "Ortho -1 1 -1 1\nVertex plain.vert\nFragment own.frag\nProgram P t 5\nQuadXY\n";
    }
    bool possible(const Kind& kind) const {
        const auto has = [&](std::string_view part) { return kind.types.find(part) != std::string_view::npos; };
        if (!caps.es) return !has("CubeArray") || caps.glsl >= 400;
        return kind.types == "sampler1D" ||
               (!has("1D") && !has("Rect") && (caps.glsl >= 320 || !(has("Buffer") || has("MS") || has("CubeArray"))));
    }
};

TEST_P(Unbound, SamplersOfEveryKindReadBlack) {
    int tried = 0;
    for (const Kind& kind : all_kinds()) {
        if (!possible(kind)) continue;
        SCOPED_TRACE(kind.types);
        draw_before();
        auto document = open(scene(kind));
        expect_clean(*document);
        EXPECT_TRUE(has(*document, "unbound-texture"));
        EXPECT_EQ(draw(*document).center(), (Pixel{kind.alpha, 0, 51, 255}));
        ++tried;
    }
    EXPECT_GE(tried, caps.es ? 15 : 27);
}

// The programs of one scene share the units as well.
TEST_P(Unbound, NoProgramReadsAnothersTexture) {
    const Picture alone = draw(scene(of_pictures) + "QuadXY\n");
    folder.write("texture.frag", texture_fragment);
    const Picture after =
        draw("Texture2D 6 red.bmp\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 6\nQuadXY\nClear\n" +
             scene(of_pictures));
    EXPECT_TRUE(alone == after);
}

// A texture that can't be read because it is drawn to is not the one of the draw before either.
TEST_P(Unbound, AFeedbackLoopReadsBlack) {
    const std::string pass =
        "Texture2D 7 16 16\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nRenderToTexture 7\n";
    const std::string loop = "Program L uUnit 7\nQuadXY\nRenderToTexture\nProgram S uUnit 7\nQuadXY\n";
    auto alone = open(pass + loop);
    const Picture picture = draw(*alone);
    auto after = open("Texture2D 6 red.bmp\n" + pass + "Program A uUnit 6\nQuadXY 0 .1\n" + loop);
    EXPECT_TRUE(has(*after, "feedback-loop"));
    EXPECT_EQ(draw(*after).at(2, 2), picture.at(2, 2));
}

TEST_P(Unbound, TheWarningSaysWhatToDo) {
    auto document = open(scene(of_pictures));
    const std::string said = render(document->diagnostics, document->sources);
    EXPECT_NE(said.find("'t' reads texture unit 5, but nothing is bound there: it reads as black [unbound-texture]"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("bind one with 'Texture2D 5 FILE' before the draw"), std::string::npos) << said;
    folder.write("noise.frag",
                 "uniform sampler3D Noise3D;\nvoid main() { gl_FragColor = texture3D(Noise3D, vec3(.5)); }\n");
    auto noise = open("Noise3D 16\nVertex plain.vert\nFragment noise.frag\nProgram N\nQuadXY\n");
    EXPECT_NE(render(noise->diagnostics, noise->sources).find("the sampler of snell's own noise is called 'Noise3'"),
              std::string::npos);
    auto other = open("CubeMap 5 red.bmp red.bmp red.bmp red.bmp red.bmp red.bmp\n" + scene(of_pictures));
    EXPECT_NE(render(other->diagnostics, other->sources).find("but no Texture2D is bound there"), std::string::npos);
}

std::string floats(std::string_view declarations, std::string_view value) {
    return "#version 330 compatibility\n" + std::string(declarations) + "\nvoid main() { gl_FragColor = vec4(" +
           std::string(value) + ", 1.); }\n";
}

// Matrices of instances stand in a buffer: a scene's own block must not read them.
TEST_P(Unbound, UniformBlocksReadNoInstances) {
    folder.write("own.frag",
                 floats("layout(std140) uniform Mine { vec4 values[8]; };", "values[0].rgb + values[5].rgb"));
    const std::string block = "Ortho -1 1 -1 1\nVertex plain.vert\nFragment own.frag\nProgram P\nQuadXY\n";
    const Picture alone = draw(block);
    std::string crowd;
    for (int i = 0; i < 20; ++i) crowd += "Translate .1 0 0\nQuadXY\n";
    draw(crowd);
    EXPECT_TRUE(draw(block) == alone);
}

TEST_P(Unbound, FaceIndexIsZeroWhereThereAreNoFaces) {
    folder.write("own.frag", floats("uniform int FaceIndex;", "vec3(float(FaceIndex) * .03)"));
    const std::string one = "Ortho -1 1 -1 1\nVertex plain.vert\nFragment own.frag\nProgram P\nQuadXY\n";
    const Picture alone = draw(one);
    EXPECT_EQ(alone.center(), (Pixel{0, 0, 0, 255}));
    EXPECT_TRUE(draw("Ortho -1 1 -1 1\nVertex plain.vert\nFragment own.frag\nProgram P\nSoccerball\nClear\nQuadXY\n") ==
                alone);
}

INSTANTIATE_TEST_SUITE_P(Contexts, Unbound,
                         testing::Values(ContextRequest{33, false, false, true}, ContextRequest{45, false, false, true},
                                         ContextRequest{30, true, false, true}, ContextRequest{32, true, false, true}),
                         context_name);

}  // namespace
}  // namespace snell::test
