// A scene that is read again: what did not change is taken over, and the picture is that of a fresh reading.
#include "src/app/window/session.h"
#include "src/document/document.h"
#include "tests/harness/harness.h"
#include "tests/harness/plain.h"

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

// As values are, in the panel and for `--set`.
TEST_F(Reload, MistakesOfProgramsOfOneNameAreToldApart) {
    folder.write("bad.frag", "void main() { gl_FragColor = nothing; }\n");
    folder.write("scene.glib", "Vertex plain.vert\nFragment bad.frag\nProgram A\nQuadXY\nProgram A\nQuadXY\n");
    const auto document = open_file(folder.path("scene.glib"));
    const std::string said = render(document->diagnostics, document->sources);
    EXPECT_NE(said.find("(fragment shader of 'A')"), said.npos) << said;
    EXPECT_NE(said.find("(fragment shader of 'A#2')"), said.npos) << said;
    complaints.clear();
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

// ---- Loading: what is read once, what is read beside other things, what its watcher is told, and files that nothing
// needs.

class Loading : public PlainTest {
protected:
    void SetUp() override {
        PlainTest::SetUp();
        for (const char* name : {"a.bmp", "b.bmp"})
            folder.write(name, bmp(2, 2, std::vector<std::array<int, 3>>(4, {10, 200, 30})));
        folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    std::unique_ptr<Document> open_watched(std::string_view scene, std::vector<LoadProgress>& told,
                                           std::vector<std::string>& names) {
        folder.write("scene.glib", scene);
        const auto here = std::this_thread::get_id();
        const Watcher watcher = [&, here](const LoadProgress& progress) {
            EXPECT_EQ(std::this_thread::get_id(), here);
            told.push_back(progress);
            names.emplace_back(progress.what);
        };
        return open_document(folder.path("scene.glib"), caps, nullptr, nullptr, {.progress = watcher});
    }
    static const Diagnostic* find(const Document& document, std::string_view code) {
        for (const Diagnostic& diagnostic : document.diagnostics.items())
            if (diagnostic.code == code) return &diagnostic;
        return nullptr;
    }
};

TEST_F(Loading, WhatShadersIncludeIsReadOnce) {
    folder.write("inner.glsl", "vec3 inner(float x) { return vec3(x); }\n");
    folder.write("common.glsl", "#include \"inner.glsl\"\nvec4 common(float x) { return vec4(inner(x), 1.); }\n");
    folder.write("a.vert", "#include \"common.glsl\"\nvoid main() { gl_Position = ftransform() * common(1.).x; }\n");
    for (const char* name : {"a.frag", "b.frag", "c.frag"})
        folder.write(name, std::string("#include \"common.glsl\"\nuniform float u") + name[0] +
                               ";\nvoid main() { gl_FragColor = common(.5 + u" + name[0] + "); }\n");
    const auto document = open(
        "Vertex a.vert\nFragment a.frag\nProgram A\nQuadXY\nFragment b.frag\nProgram B\nQuadXY\n"
        "Fragment c.frag\nProgram C\nQuadXY\n");
    expect_clean(*document);
    EXPECT_EQ(document->runtime->counters().files_opened, 1U + 4U + 2U) << "the scene, its shaders, two includes";
    // A reading of the scene is a new one.
    folder.write("inner.glsl", "vec3 inner(float x) { return vec3(x, 0., 0.); }\n");
    const auto again =
        open_document(folder.path("scene.glib"), caps, nullptr, nullptr, {.previous = &*document->runtime});
    expect_clean(*again);
    EXPECT_EQ(again->runtime->counters().files_opened, 1U + 4U + 2U);
    EXPECT_EQ(again->runtime->counters().programs_compiled, 3U) << "what is included is another text";
}

TEST_F(Loading, ItsWatcherIsToldOfEachStageFromNothingToAll) {
    folder.write("noise.frag",
                 "uniform sampler3D Noise3;\nvoid main() { gl_FragColor = texture3D(Noise3, vec3(.5)); }\n");
    const std::string scene =
        "Noise3D 64\nTexture2D 5 a.bmp\nTexture2D 6 b.bmp\nTexture2D 7 b.bmp\nOrtho -1 1 -1 1\n"
        "Vertex plain.vert\nFragment texture.frag\nProgram A uUnit 5\nQuadXY\nProgram B uUnit 6\nQuadXY\n"
        "Fragment noise.frag\nProgram C\nObj t.obj\n";
    std::vector<LoadProgress> told;
    std::vector<std::string> names;
    const auto document = open_watched(scene, told, names);
    expect_clean(*document);
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.front().stage, LoadProgress::Stage::programs);
    EXPECT_EQ(told.front().done, 0U);
    EXPECT_EQ(told.back().stage, LoadProgress::Stage::draws);
    EXPECT_EQ(told.back().done, told.back().of);
    // Texture 7 is not sampled: two images, a mesh, the noise.
    for (const auto& [stage, all] : {std::pair(LoadProgress::Stage::programs, 3U),
                                     {LoadProgress::Stage::files, 4U},
                                     {LoadProgress::Stage::draws, 3U}}) {
        std::vector<std::size_t> counts;
        for (const LoadProgress& progress : told) {
            if (progress.stage != stage) continue;
            EXPECT_EQ(progress.of, all);
            if (counts.empty() || progress.done != counts.back()) counts.push_back(progress.done);
        }
        std::vector<std::size_t> expected(all + 1);
        for (std::size_t i = 0; i <= all; ++i) expected[i] = i;
        EXPECT_EQ(counts, expected);
    }
    EXPECT_TRUE(std::ranges::is_sorted(told, {}, &LoadProgress::stage));
    EXPECT_EQ(names.front(), "A");
    EXPECT_EQ(std::ranges::count(names, "noise3d.064.tex") > 0, true) << "the longest work begins first";
}

TEST_F(Loading, APictureIsTheSameWatchedOrNot) {
    folder.write("noise.frag",
                 "uniform sampler3D Noise3;\nuniform sampler2D Noise2;\nin vec2 vST;\n"
                 "void main() { gl_FragColor = texture3D(Noise3, vec3(vST, .3)) + .1 * texture2D(Noise2, vST); }\n");
    const std::string scene =
        "Noise2D 64\nNoise3D 32\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment noise.frag\nProgram N\nQuadXY\n";
    std::vector<LoadProgress> told;
    std::vector<std::string> names;
    const auto watched = open_watched(scene, told, names);
    const auto plain = open(scene);
    expect_clean(*watched);
    EXPECT_TRUE(draw(*watched) == draw(*plain));
    EXPECT_EQ(watched->runtime->counters().noise_bytes, (64U * 64 + 32U * 32 * 32) * 4);
    EXPECT_EQ(plain->runtime->counters().noise_bytes, (64U * 64 + 32U * 32 * 32) * 4);
}

constexpr std::string_view one_sampled =
    "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 5\nQuadXY\n";

TEST_F(Loading, AFileThatNothingSamplesMayBeMissing) {
    const auto unsampled = open("Texture2D 5 a.bmp\nTexture2D 6 gone.bmp\n" + std::string(one_sampled));
    expect_clean(*unsampled);
    const Diagnostic* note = find(*unsampled, "file-not-found");
    ASSERT_TRUE(note);
    EXPECT_EQ(note->severity, Severity::note);
    EXPECT_TRUE(open("Texture2D 5 gone.bmp\n" + std::string(one_sampled))->diagnostics.has_errors());
}

// Of a program that failed nobody knows what it samples.
TEST_F(Loading, AMissingFileIsAnErrorBesideOthers) {
    folder.write("broken.frag",
                 "#include \"gone.glsl\"\nuniform sampler2D uUnit;\nvoid main() { gl_FragColor = vec4(1.); }\n");
    const auto document =
        open("Texture2D 6 gone.bmp\nVertex plain.vert\nFragment broken.frag\nProgram A uUnit 6\nQuadXY\n");
    const Diagnostic* missing = find(*document, "file-not-found");
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->severity, Severity::error);
}

TEST_F(Loading, WhatNothingSamplesIsReadWhereItIsAskedFor) {
    folder.write("broken.bmp", "no picture at all");
    const auto document = open("Texture2D 5 a.bmp\nTexture2D 6 broken.bmp\n" + std::string(one_sampled));
    EXPECT_TRUE(document->diagnostics.empty()) << "it is not even opened";
    EXPECT_EQ(document->runtime->counters().files_opened, 1U + 2U + 1U);
    check_unsampled(*document);
    ASSERT_EQ(document->diagnostics.items().size(), 1U);
    EXPECT_EQ(document->diagnostics.items()[0].severity, Severity::warning);
    EXPECT_EQ(document->diagnostics.items()[0].span, document->scene().textures[1].files[0].span);
}

// The source of what is sampled is sampled.
TEST_F(Loading, ASourceOfWhatIsComputedIsSampled) {
    folder.write("cube.frag",
                 "uniform samplerCube uCube;\nvoid main() { gl_FragColor = textureCube(uCube, vec3(1.)); }\n");
    std::string faces;
    for (int i = 0; i < 6; ++i) faces += " gone" + std::to_string(i) + ".bmp";
    const auto document = open("CubeMap 5" + faces +
                               "\nIrradiance 6 5\nVertex plain.vert\nFragment cube.frag\n"
                               "Program A uCube 6\nQuadXY\n");
    EXPECT_TRUE(document->diagnostics.has_errors());
}

}  // namespace
}  // namespace snell::test
