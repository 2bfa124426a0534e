// Loading: what is read once, what is read beside other things, what its watcher is told, and files that nothing needs.
#include "src/document/document.h"
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

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
