// A scene that is read again: what did not change is taken over, and the picture is that of a fresh reading.
#include "src/app/window/session.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr std::string_view scene =
    "Ortho -1 1 -1 1\nTexture2D 4 a.bmp\nCubeMap 5 a.bmp a.bmp a.bmp a.bmp a.bmp a.bmp\nIrradiance 6 5 8\n"
    "Noise3D 16\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 4\nQuadXY -.5 .5\n"
    "Fragment light.frag\nProgram B uLight 6 uAmount <0. .5 1.>\nObj t.obj\n";

class Reload : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("plain.vert", plain_vertex);
        folder.write("texture.frag", texture_fragment);
        folder.write("light.frag", light(".1"));
        folder.write("a.bmp", bmp(4, 4, std::vector<std::array<int, 3>>(16, {200, 90, 30})));
        folder.write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
        folder.write("scene.glib", scene);
    }
    static std::string light(const std::string& more) {
        return "#version 330 compatibility\nuniform samplerCube uLight;\nuniform sampler3D Noise3;\n"
               "uniform float uAmount;\nin vec2 vST;\nvoid main() { gl_FragColor = uAmount * texture(uLight, "
               "vec3(vST, 1.)) + texture(Noise3, vec3(vST, 0.)) * " +
               more + "; }\n";
    }
    // The new reading after the old one was drawn, both held against a reading from nothing.
    std::unique_ptr<Document> again(Document& old) {
        RuntimeOptions options;
        options.previous = &*old.runtime;
        auto document = open_document(folder.path("scene.glib"), caps, nullptr, nullptr, options);
        auto fresh = open_document(folder.path("scene.glib"), caps);
        EXPECT_TRUE(draw(*document) == draw(*fresh));
        EXPECT_EQ(render(document->diagnostics, document->sources), render(fresh->diagnostics, fresh->sources));
        EXPECT_EQ(document->files->read_paths().size(), fresh->files->read_paths().size()) << "all is watched";
        EXPECT_EQ(document->runtime->counters().gpu_bytes, fresh->runtime->counters().gpu_bytes);
        return document;
    }
};

TEST_F(Reload, OfNothingNewMakesNothing) {
    auto old = open_file(folder.path("scene.glib"));
    expect_clean(*old);
    draw(*old);
    const Counters counters = again(*old)->runtime->counters();
    EXPECT_EQ(counters.programs_compiled, 0U);
    EXPECT_EQ(counters.shaders_compiled, 0U);
    EXPECT_EQ(counters.bytes_uploaded, 0U);
    EXPECT_EQ(counters.images_decoded, 0U);
    EXPECT_EQ(counters.convolutions, 0U);
    EXPECT_EQ(counters.noise_bytes, 0U);
    EXPECT_EQ(counters.files_opened, 4U) << "the scene and its shaders";
}

TEST_F(Reload, OfOneShaderCompilesOneProgram) {
    auto old = open_file(folder.path("scene.glib"));
    draw(*old);
    folder.write("light.frag", light(".7"));
    const Counters counters = again(*old)->runtime->counters();
    EXPECT_EQ(counters.programs_compiled, 1U);
    EXPECT_EQ(counters.shaders_compiled, 1U) << "the vertex shader is that of before";
    EXPECT_EQ(counters.bytes_uploaded, 0U);
    EXPECT_EQ(counters.textures, 0U);
}

TEST_F(Reload, OfOneImageDecodesItAndCompilesNothing) {
    auto old = open_file(folder.path("scene.glib"));
    draw(*old);
    folder.write("b.bmp", bmp(4, 4, std::vector<std::array<int, 3>>(16, {20, 190, 30})));
    std::string changed(scene);
    changed.replace(changed.find("a.bmp"), 5, "b.bmp");
    folder.write("scene.glib", changed);
    auto now = again(*old);
    EXPECT_EQ(now->runtime->counters().images_decoded, 1U);
    EXPECT_EQ(now->runtime->counters().programs_compiled, 0U);
    // And by another content of the same name.
    folder.write("b.bmp", bmp(8, 4, std::vector<std::array<int, 3>>(32, {20, 10, 230})));
    EXPECT_EQ(again(*now)->runtime->counters().images_decoded, 1U);
}

TEST_F(Reload, OfOneMeshUploadsIt) {
    auto old = open_file(folder.path("scene.glib"));
    draw(*old);
    folder.write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 .5 0\nv 0 0 0\nf 1 2 3\n");
    const Counters counters = again(*old)->runtime->counters();
    EXPECT_EQ(counters.meshes, 1U);
    EXPECT_EQ(counters.textures, 0U);
    EXPECT_EQ(counters.programs_compiled, 0U);
}

TEST_F(Reload, WarningsOfWhatIsTakenOverAreSaidAtTheirNewPlaces) {
    folder.write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
    auto old = open_file(folder.path("scene.glib"));
    ASSERT_GT(old->diagnostics.warnings() + old->diagnostics.errors(), 0U);
    folder.write("scene.glib", "# one line more\n" + std::string(scene));
    again(*old);
}

// What one reading set in a program that both have must not be seen in the other.
TEST_F(Reload, ValuesOfUniformsAreNotTakenOver) {
    folder.write("light.frag", "uniform float uAmount;\nvoid main() { gl_FragColor = vec4(uAmount, 0., 0., 1.); }\n");
    auto old = open_file(folder.path("scene.glib"));
    const Picture before = draw(*old, {.sets = {"uAmount=1"}});
    std::string changed(scene);
    changed.replace(changed.find("<0. .5 1.>"), 10, ".25");
    folder.write("scene.glib", changed);
    auto now = again(*old);
    EXPECT_EQ(now->runtime->counters().programs_compiled, 0U);
    EXPECT_TRUE(draw(*old) == before) << "the old one still draws, too";
}

TEST_F(Reload, WhatIsDrawnOffScreenIsNotShared) {
    const std::string pass =
        "Texture2D 5 8 8\nOrtho -1 1 -1 1\nRenderToTexture 5\nColor 1 0 0\nQuadXY\n"
        "RenderToTexture\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 5\nQuadXY\n";
    folder.write("scene.glib", pass);
    auto old = open_file(folder.path("scene.glib"));
    const Picture red = draw(*old);
    std::string green = pass;
    green.replace(green.find("1 0 0"), 5, "0 1 0");
    folder.write("scene.glib", green);
    auto now = again(*old);
    EXPECT_TRUE(near(draw(*now).center(), {0, 255, 0, 255}));
    EXPECT_TRUE(draw(*old) == red);
}

TEST_F(Reload, ARefusedEditLeavesTheOldPictureWhole) {
    Session session(folder.path("scene.glib"), caps);
    const Picture before = draw(*session.document());
    folder.write("light.frag", light("nonsense"));
    session.reload();
    EXPECT_TRUE(session.stale());
    complaints.clear();  // of the broken shader
    EXPECT_TRUE(draw(*session.document()) == before);
    folder.write("light.frag", light(".3"));
    session.reload();
    EXPECT_FALSE(session.stale());
    EXPECT_EQ(session.document()->runtime->counters().programs_compiled, 1U);
    EXPECT_EQ(session.document()->runtime->counters().bytes_uploaded, 0U);
    draw(*session.document());
}

}  // namespace
}  // namespace snell::test
