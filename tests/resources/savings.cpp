// What a scene does not call for costs nothing, by exact counts; and what it does call for happens.
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

class Savings : public PlainTest {
protected:
    void SetUp() override {
        PlainTest::SetUp();
        folder.write("cube.frag", fragment("uniform samplerCube uCube;", "texture(uCube, vec3(vST, 1.))"));
        for (int i = 0; i < 20; ++i)
            folder.write("t" + std::to_string(i) + ".bmp",
                         bmp(4, 4, std::vector<std::array<int, 3>>(16, {10 * i, 90, 30})));
    }
    static std::string fragment(std::string_view declarations, std::string_view value) {
        return "#version 330 compatibility\n" + std::string(declarations) +
               "\nin vec2 vST;\nvoid main() { gl_FragColor = vec4(" + std::string(value) + "); }\n";
    }
    // A quad over the whole picture, by a fragment shader of that value.
    std::string quad(std::string_view declarations, std::string_view value, std::string_view uniforms = "") {
        folder.write("own.frag", fragment(declarations, value));
        return "Ortho -1 1 -1 1\nVertex plain.vert\nFragment own.frag\nProgram P " + std::string(uniforms) +
               "\nQuadXY\n";
    }
    // Of a scene that opens without errors and was drawn once.
    Counters counted(const std::string& scene) {
        auto document = open(scene);
        expect_clean(*document);
        draw(*document);
        return document->runtime->counters();
    }
    // What changed between two frames.
    static Counters difference(const Counters& after, const Counters& before) {
        Counters result;
        for (const CounterName& counter : counter_names())
            result.*counter.value = after.*counter.value - before.*counter.value;
        return result;
    }
};

constexpr std::string_view cube_files = "t0.bmp t1.bmp t2.bmp t3.bmp t4.bmp t5.bmp";

TEST_F(Savings, ImagesAreDecodedWhereADrawSamplesThem) {
    std::string textures;
    for (int i = 0; i < 20; ++i) textures += "Texture2D " + std::to_string(i) + " t" + std::to_string(i) + ".bmp\n";
    const std::string two =
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 4\nQuadXY\n"
        "Program B uUnit 9\nQuadXY\n";
    const Counters some = counted(textures + two);
    EXPECT_EQ(some.images_decoded, 2U);
    EXPECT_EQ(some.textures, 2U);
    EXPECT_EQ(some.bytes_uploaded - some.buffers / 2 * counted(quad("", "1.")).bytes_uploaded, 2U * 4 * 4 * 4);
    EXPECT_EQ(some.files_opened, 1U + 2U + 2U) << "the scene, its shaders, two images";
    EXPECT_EQ(counted(textures + "Ortho -1 1 -1 1\nQuadXY\n").images_decoded, 0U);
}

// A draw of a pass that nothing reads is not executed: what it samples is not loaded either.
TEST_F(Savings, ImagesOfUnreadPassesAreNotDecoded) {
    const std::string pass =
        "Texture2D 5 16 16\nTexture2D 6 t6.bmp\nOrtho -1 1 -1 1\nVertex plain.vert\n"
        "Fragment texture.frag\nProgram A uUnit 6\nRenderToTexture 5\nQuadXY\nRenderToTexture\n";
    const Counters unread = counted(pass + quad("", "1."));
    EXPECT_EQ(unread.images_decoded, 0U);
    EXPECT_EQ(unread.targets, 0U);
    EXPECT_EQ(unread.textures, 0U);
    EXPECT_EQ(unread.draws, 1U);
    const Counters read = counted(pass + "Program B uUnit 5\nQuadXY\n");
    EXPECT_EQ(read.images_decoded, 1U);
    EXPECT_EQ(read.targets, 1U);
    EXPECT_EQ(read.draws, 2U);
}

TEST_F(Savings, APassIsReadThroughOthers) {
    const std::string chain =
        "Texture2D 5 16 16\nTexture2D 6 16 16\nTexture2D 7 16 16\nOrtho -1 1 -1 1\n"
        "Vertex plain.vert\nFragment texture.frag\nProgram A uUnit 5\nRenderToTexture 5\n"
        "Program\nColor 1 0 0\nQuadXY\nRenderToTexture 6\nProgram A uUnit 5\nQuadXY\n"
        "RenderToTexture 7\nProgram B uUnit 6\nQuadXY\nRenderToTexture\n";
    EXPECT_EQ(counted(chain + "Program C uUnit 7\nQuadXY\n").passes, 4U);
    EXPECT_EQ(counted(chain + "Program C uUnit 6\nQuadXY\n").passes, 3U);
    EXPECT_EQ(counted(chain + "Program C uUnit 5\nQuadXY\n").passes, 2U);
    EXPECT_EQ(counted(chain + "Program\nQuadXY\n").passes, 1U);
}

TEST_F(Savings, CubeFacesAreDecodedWhereTheSamplerIsActive) {
    const std::string cube = "CubeMap 6 " + std::string(cube_files) + "\n";
    EXPECT_EQ(counted(cube + quad("uniform samplerCube uCube;", "1.", "uCube 6")).images_decoded, 0U);
    EXPECT_EQ(
        counted(cube + quad("uniform samplerCube uCube;", "texture(uCube, vec3(vST, 1.))", "uCube 6")).images_decoded,
        6U);
}

// The units of one seed: the same six files as cube map 5 and 6, and as pictures.
TEST_F(Savings, AFileIsDecodedOnceHoweverOftenItIsNamed) {
    const std::string cube(cube_files);
    const Counters all =
        counted("CubeMap 5 " + cube + "\nCubeMap 6 " + cube + "\nTexture2D 7 t0.bmp\n" +
                quad("uniform samplerCube uA, uB;\nuniform sampler2D uC;",
                     "texture(uA, vec3(vST, 1.)) + texture(uB, vec3(1., vST)) + texture(uC, vST)", "uA 5 uB 6 uC 7"));
    EXPECT_EQ(all.images_decoded, 6U);
    EXPECT_EQ(all.textures, 2U) << "one cube map on both units, and the picture";
}

TEST_F(Savings, NoiseIsMadeWhereItsUniformIsActive) {
    const std::string noise = "Noise2D 64\nNoise3D 16\n";
    EXPECT_EQ(counted(noise + quad("uniform sampler3D Noise3;", "1.")).noise_bytes, 0U);
    EXPECT_EQ(counted(noise + quad("uniform sampler2D Noise2;", "texture(Noise2, vST)")).noise_bytes, 64U * 64 * 4);
    EXPECT_EQ(
        counted(noise + quad("uniform sampler3D Noise3;", "texture(Noise3, vec3(vST, 0.))") + "QuadXY\n").noise_bytes,
        16U * 16 * 16 * 4)
        << "once for both draws";
}

TEST_F(Savings, MipmapsAreMadeWhereTheFilterAsksForThem) {
    const std::string draw = "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 4\nQuadXY\n";
    for (const auto& [filter, chains] :
         {std::pair("nearest", 0U), std::pair("linear", 0U), std::pair("mipmap", 1U), std::pair("anisotropic", 1U)}) {
        const Counters with = counted("Filter " + std::string(filter) + "\nTexture2D 4 t1.bmp\n" + draw);
        EXPECT_EQ(with.mip_chains, chains) << filter;
    }
}

TEST_F(Savings, OnlyADrawnTimerAnimates) {
    const auto animated = [&](const std::string& scene) { return open(scene)->runtime->animated(); };
    EXPECT_FALSE(animated(quad("uniform float Timer;", "1.")));
    EXPECT_FALSE(animated(quad("uniform float Timer;", "Timer * 0.")));
    EXPECT_TRUE(animated(quad("uniform float Timer;", "Timer")));
    EXPECT_TRUE(animated(quad("uniform float uTime;", "uTime")));
    std::string undrawn = quad("uniform float Timer;", "Timer");
    undrawn.erase(undrawn.find("QuadXY"));
    EXPECT_FALSE(animated(undrawn)) << "no draw uses it";
}

TEST_F(Savings, ADrawWhoseAlphaIsOneDoesNotBlend) {
    EXPECT_EQ(counted(quad("", "vST, 0., 1.")).blended_draws, 0U);
    EXPECT_EQ(counted(quad("", "vST, 0., .5")).blended_draws, 1U);
    EXPECT_EQ(counted("Ortho -1 1 -1 1\nColor 1 0 0 .5\nQuadXY\nColor 1 0 0\nQuadXY\n").blended_draws, 1U);
}

TEST_F(Savings, ARungThatIsNotChosenIsNotCompiled) {
    const std::string scene = "Ladder BOUNCES one two\n" + quad("", "BOUNCES == BOUNCES_two ? 1. : .5");
    auto document = open(scene);
    expect_clean(*document);
    draw(*document);
    EXPECT_EQ(document->runtime->counters().variants, 0U);
    document->runtime->choose({1});
    EXPECT_EQ(document->runtime->counters().variants, 1U);
    document->runtime->choose({0});
    EXPECT_EQ(document->runtime->counters().variants, 1U) << "kept";
}

TEST_F(Savings, WhatIsOffIsNotThere) {
    const Counters plain = counted("Ortho -1 1 -1 1\nQuadXY\n");
    EXPECT_EQ(plain.targets, 0U);
    EXPECT_EQ(plain.textures, 0U);
    EXPECT_EQ(plain.convolutions, 0U);
    EXPECT_EQ(plain.trees, 0U);
    EXPECT_EQ(plain.programs_compiled, 1U);
    EXPECT_EQ(plain.passes, 1U);
    EXPECT_EQ(plain.buffers, 2U);
    EXPECT_EQ(plain.files_opened, 1U);
}

TEST_F(Savings, ASliderCostsOneUploadAndNothingElse) {
    auto document =
        open(quad("uniform float uRed, uGreen;", "uRed, uGreen, 0., 1.", "uRed <0. .2 1.> uGreen <0. .4 1.>"));
    expect_clean(*document);
    draw(*document);
    const Counters before = document->runtime->counters();
    draw(*document);
    const Counters still = difference(document->runtime->counters(), before);
    EXPECT_EQ(still.uniform_uploads, 0U);
    const Counters between = document->runtime->counters();
    draw(*document, {.sets = {"uRed=.75"}});
    Counters slid = difference(document->runtime->counters(), between);
    EXPECT_EQ(slid.uniform_uploads, 1U);
    slid.uniform_uploads = 0;
    for (const CounterName& counter : counter_names()) {
        EXPECT_EQ(slid.*counter.value, still.*counter.value) << counter.name << ": as in any other frame";
        const bool of_a_frame = counter.name == "frames" || counter.name == "passes" || counter.name == "draws" ||
                                counter.name == "triangles" || counter.name == "state_changes";
        if (of_a_frame) continue;
        EXPECT_EQ(slid.*counter.value, 0U) << counter.name;
    }
}

// A sphere that moves in a cube map's scene is drawn to it again; nothing moves: nothing is.
TEST_F(Savings, CubeFacesAreDrawnAgainWhenWhatTheyShowChanged) {
    auto document = open(
        "CubeMap 7 16\nRenderToCube 7\nVertex plain.vert\nFragment color.frag\n"
        "Program Wall uColor <0. 1. 0. 1.>\nQuadXY 4 4\nRenderToTexture\n"
        "Fragment cube.frag\nProgram Show uCube 7\nOrtho -1 1 -1 1\nQuadXY\n");
    expect_clean(*document);
    draw(*document);
    EXPECT_EQ(document->runtime->counters().cube_faces, 6U);
    draw(*document);
    EXPECT_EQ(document->runtime->counters().cube_faces, 6U);
    draw(*document, {.sets = {"Wall.uColor=1,0,0,1"}});
    EXPECT_EQ(document->runtime->counters().cube_faces, 12U);
}

// Files are read on all cores: what is said of them is said once each, in the order of the text.
TEST_F(Savings, WhatIsReadAtOnceIsReportedInOrder) {
    std::string scene = "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\n";
    for (int i = 0; i < 12; ++i) {
        folder.write("broken" + std::to_string(i) + ".bmp", "BM, and no picture");
        folder.write("m" + std::to_string(i) + ".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 99\n");
        scene += "Texture2D " + std::to_string(i) + " broken" + std::to_string(i) + ".bmp\nProgram P uUnit " +
                 std::to_string(i) + "\nObj m" + std::to_string(i) + ".obj\n";
    }
    std::string first;
    for (int round = 0; round < 3; ++round) {
        auto document = open(scene);
        EXPECT_EQ(document->diagnostics.errors(), 12U);
        const std::string text = render(document->diagnostics, document->sources);
        if (round == 0) first = text;
        EXPECT_EQ(text, first);
        Span last;
        for (const Diagnostic& diagnostic : document->diagnostics.items()) {
            EXPECT_LT(last.begin, diagnostic.span.begin) << diagnostic.message;
            last = diagnostic.span;
        }
        draw(*document);
    }
}

// The negative control of all of the above: everything is paid for, and the pictures are the same.
TEST_F(Savings, CostNothingButCounters) {
    std::vector<std::string> scenes;
    for (const char* root : {"tests/cases", "scenes"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
            if (entry.path().extension() == ".glib") scenes.push_back(entry.path().string());
    std::ranges::sort(scenes);
    ASSERT_GT(scenes.size(), 30U);
    RuntimeOptions pay_all;
    pay_all.savings = false;
    Counters saved, paid;
    for (const std::string& path : scenes) {
        auto lean = open_document(path, caps), full = open_document(path, caps, nullptr, nullptr, pay_all);
        if (!lean->runtime) continue;
        const Look look{.width = 24, .height = 24, .time = 1.5};
        for (int frame = 0; frame < 2; ++frame) EXPECT_TRUE(draw(*lean, look) == draw(*full, look)) << path;
        for (const CounterName& counter : counter_names()) {
            if (counter.value == &Counters::draws_culled) continue;  // is what is saved
            saved.*counter.value += lean->runtime->counters().*counter.value;
            paid.*counter.value += full->runtime->counters().*counter.value;
            EXPECT_LE(lean->runtime->counters().*counter.value, full->runtime->counters().*counter.value)
                << path << ": " << counter.name;
        }
    }
    for (const CounterName& counter : counter_names()) {
        const bool same = counter.name == "frames" || counter.name == "frames_skipped" || counter.name == "variants" ||
                          counter.name.starts_with("specialise") || counter.name == "images_spared" ||
                          counter.name == "lines" || counter.name == "points" || counter.name == "convolutions" ||
                          counter.value == &Counters::draws_culled ||
                          // None, as this context has the stages.
                          counter.name == "stage_reads" || counter.name.starts_with("captured");
        if (same) continue;
        EXPECT_LT(saved.*counter.value, paid.*counter.value) << counter.name;
    }
}

}  // namespace
}  // namespace snell::test
