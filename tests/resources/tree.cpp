// Programs that trace rays through what they draw get its triangles, and only they.
#include "src/runtime/runtime.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr std::string_view glass_vertex =
    "#version 330 compatibility\nout vec3 vModel, vNormal, vEye;\nvoid main() {\n"
    "    vModel = gl_Vertex.xyz;\n    vNormal = gl_Normal;\n"
    "    vec4 eye = gl_ModelViewMatrixInverse * vec4(0., 0., 0., 1.);\n    vEye = eye.xyz / eye.w;\n"
    "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n";

// Red: by how much the straight way through differs from the ball's closed form. Green: its energy. Blue: what is
// mirrored.
constexpr std::string_view glass_fragment =
    "#version 330 compatibility\n#include <snell/mesh.glsl>\nin vec3 vModel, vNormal, vEye;\nvoid main() {\n"
    "    vec3 I = normalize(vModel - vEye);\n"
    "    SnellMesh s = snellMeshBegin(vEye, I, 1., 1.5, true);\n"
    "    float mirrored = snellMeshNext(s) ? s.energy : 0.;\n"
    "    float off = snellMeshNext(s) ? length(s.direction - snellRefractSphere(I, vModel, 1., 1.5)) : 1.;\n"
    "    gl_FragColor = vec4(10. * off, s.energy, mirrored, 1.);\n}\n";

class RuntimeTree : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("glass.vert", std::string(glass_vertex));
        folder.write("glass.frag", std::string(glass_fragment));
    }
    static std::string scene(std::string_view draws) {
        return "Perspective 40\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex glass.vert\nFragment glass.frag\n"
               "Program Glass\n" +
               std::string(draws);
    }
    static std::string message(const Document& document, std::string_view code) {
        const auto& items = document.diagnostics.items();
        const auto found = std::ranges::find(items, code, &Diagnostic::code);
        return found == items.end() ? "" : found->message;
    }
};

class RuntimeTreeEverywhere : public RuntimeTree, public testing::WithParamInterface<ContextRequest> {
protected:
    RuntimeTreeEverywhere() { request = GetParam(); }
};

TEST_P(RuntimeTreeEverywhere, EachDrawHasItsOwnMesh) {
    auto document =
        open(scene("PushMatrix\nTranslate -.9 0 0\nScale .7 .7 .7\nSphere 1 80 80\nPopMatrix\n"
                   "PushMatrix\nTranslate .9 0 0\nBox 1 1 1\nPopMatrix\n"));
    expect_clean(*document);
    const Picture picture = draw(*document, {.width = 64, .height = 64});
    int ball = 0, box = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const Pixel p = picture.at(x, y);
            if (p[0] + p[1] + p[2] == 0) continue;
            (x < 32 ? ball : box) += 1;
            const double from_middle = std::hypot(x - 16.0, y - 31.5);
            if (x < 32 && from_middle < 10) {
                EXPECT_LT(p[0], 12) << x << " " << y;
                EXPECT_GT(p[1], 200) << x << " " << y;
            }
        }
    EXPECT_GT(ball, 375);
    EXPECT_GT(box, 150);
    const Pixel middle = picture.at(16, 32);
    EXPECT_NEAR(middle[1], 255 * .96 * .96, 3);
    EXPECT_NEAR(middle[2], 255 * .04, 2);
    // The box's way is not the ball's.
    EXPECT_GT(picture.at(48, 26)[0], 60);
    EXPECT_EQ(document->runtime->counters().trees, 2U);
}

INSTANTIATE_TEST_SUITE_P(Contexts, RuntimeTreeEverywhere, all_contexts, context_name);

TEST_F(RuntimeTree, IsMadeOncePerMeshAndOnlyWhereItIsRead) {
    folder.write("plain.frag", "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(1.); }\n");
    const std::string plain = "Perspective 40\nLookAt 0 0 4  0 0 0  0 1 0\nFragment plain.frag\nProgram Plain\n";
    auto without = open(plain + "Sphere 1 20 20\nTeapot\n");
    draw(*without);
    const Counters none = without->runtime->counters();
    EXPECT_EQ(none.trees, 0U);
    EXPECT_EQ(none.buffers, 4U);

    auto with = open(plain +
                     "Sphere 1 20 20\nTeapot\nVertex glass.vert\nFragment glass.frag\nProgram Glass\n"
                     "Sphere 1 20 20\nTranslate 0 1 0\nSphere 1 20 20\n");
    expect_clean(*with);
    draw(*with);
    const Counters& some = with->runtime->counters();
    EXPECT_EQ(some.trees, 1U);
    EXPECT_EQ(some.buffers, none.buffers);
    EXPECT_EQ(some.textures, none.textures + 3U);
    const std::uint64_t triangles = 2 * 20 * 19, bytes = some.bytes_uploaded - none.bytes_uploaded;
    EXPECT_GE(bytes, triangles * 3 * 16);
    EXPECT_LE(bytes, triangles * (3 + 4 + 2) * 16);
    draw(*with);
    EXPECT_EQ(with->runtime->counters().bytes_uploaded, some.bytes_uploaded);
}

TEST_F(RuntimeTree, WhatIsNoSurfaceIsMetByNoRay) {
    auto document = open(scene("glBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 0\nglEnd\n"));
    EXPECT_TRUE(has(*document, "mesh-tree-empty"));
    draw(*document);
}

TEST_F(RuntimeTree, AMeshThatIsTooLargeSaysWhy) {
    caps.max_texture = 64;
    expect_clean(*open(scene("Sphere 1 90 90\n")));  // 16,020 triangles
    auto document = open(scene("Sphere 1 92 92\n"));
    ASSERT_TRUE(has(*document, "mesh-tree-too-large"));
    const std::string said = message(*document, "mesh-tree-too-large");
    EXPECT_NE(said.find("16384 or more triangles"), std::string::npos) << said;
    EXPECT_NE(said.find("GL_MAX_TEXTURE_SIZE is 64"), std::string::npos) << said;
    EXPECT_TRUE(near(draw(*document).center(), {255, 255, 255, 255})) << "rays pass by: one exit";
}

class RuntimeTreeEs30 : public RuntimeTree {
protected:
    RuntimeTreeEs30() { request = {30, true}; }
    void SetUp() override {
        RuntimeTree::SetUp();
        caps.glsl = 300;
    }
};

TEST_F(RuntimeTreeEs30, NeedsNoTextureBuffers) {
    auto document = open(scene("Sphere 1 80 80\n"));
    expect_clean(*document);
    const Pixel middle = draw(*document).center();
    EXPECT_LT(middle[0], 12);
    EXPECT_NEAR(middle[1], 255 * .96 * .96, 3);
    EXPECT_NEAR(middle[2], 255 * .04, 2);
}

TEST_F(RuntimeTreeEs30, RefusesTextureBuffersOfTheScene) {
    folder.write("glass.frag",
                 "#version 330 compatibility\nuniform samplerBuffer list;\nvoid main() { gl_FragColor = "
                 "texelFetch(list, 0); }\n");
    auto document = open(scene("Sphere\n"));
    ASSERT_TRUE(has(*document, "unsupported-type"));
    EXPECT_NE(message(*document, "unsupported-type").find("samplerBuffer"), std::string::npos);
}

}  // namespace
}  // namespace snell::test
