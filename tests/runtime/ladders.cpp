// Ladders: each rung's picture, and what choosing costs.
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

class LadderScenes : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        folder.write("kind.frag",
                     "void main() {\n#if KIND == KIND_r\ngl_FragColor = vec4(1., 0., 0., 1.);\n#elif KIND == KIND_g\n"
                     "gl_FragColor = vec4(0., 1., 0., 1.);\n#else\ngl_FragColor = vec4(0., 0., 1., 1.);\n#endif\n}\n");
        folder.write("broken.frag",
                     "uniform float uBlue;\nvoid main() {\n#if KIND == KIND_bad\ngl_FragColor = nonsense(1.);\n"
                     "#elif KIND == KIND_g\ngl_FragColor = vec4(0., 1., 0., 1.);\n"
                     "#else\ngl_FragColor = vec4(0., 0., uBlue, 1.);\n#endif\n}\n");
    }
    static std::string scene(const std::string& ladder, const std::string& shader) {
        return ladder + "\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment " + shader +
               "\nProgram P uBlue <0 1 1>\nQuadXY\n";
    }
    Pixel with(Document& document, Rungs rungs) {
        document.controls.rungs = std::move(rungs);
        follow_rungs(document);
        return draw(document).center();
    }
};

TEST_F(LadderScenes, EachRungHasItsPicture) {
    EXPECT_EQ(draw(scene("Ladder KIND r g b", "kind.frag")).center(), red);
    EXPECT_EQ(draw(scene("Ladder KIND r <g> b", "kind.frag")).center(), green);
    EXPECT_EQ(draw(scene("Ladder KIND r g <b>", "kind.frag")).center(), blue);
}

TEST_F(LadderScenes, ARungIsCompiledOnceAndKept) {
    auto document = open(scene("Ladder KIND r g b", "kind.frag"));
    expect_clean(*document);
    const auto& compiled = document->runtime->counters().programs_compiled;
    EXPECT_EQ(compiled, 1u);
    EXPECT_EQ(with(*document, {0}), red);
    EXPECT_EQ(compiled, 1u);
    EXPECT_EQ(with(*document, {2}), blue);
    EXPECT_EQ(compiled, 2u);
    EXPECT_EQ(with(*document, {0}), red);
    EXPECT_EQ(with(*document, {2}), blue);
    EXPECT_EQ(compiled, 2u) << "going back costs no compile";
    EXPECT_EQ(with(*document, {1}), green);
    EXPECT_EQ(compiled, 3u);
}

TEST_F(LadderScenes, ProgramsBeforeTheLadderDoNotKnowIt) {
    folder.write("known.frag",
                 "void main() {\n#ifdef KIND\ngl_FragColor = vec4(1., 0., 0., 1.);\n#else\n"
                 "gl_FragColor = vec4(0., 1., 0., 1.);\n#endif\n}\n");
    auto document = open(
        "Ortho -2 2 -2 2\nVertex plain.vert\nFragment known.frag\nProgram Before\nTranslate -1 0 0\nQuadXY\n"
        "Ladder KIND r g\nProgram After\nTranslate 2 0 0\nQuadXY\n");
    expect_clean(*document);
    const Picture picture = draw(*document);
    EXPECT_EQ(picture.at(16, 32), green);
    EXPECT_EQ(picture.at(48, 32), red);
    EXPECT_EQ(document->runtime->counters().programs_compiled, 2u);
    with(*document, {1});
    EXPECT_EQ(document->runtime->counters().programs_compiled, 3u) << "only the one behind the ladder";
}

TEST_F(LadderScenes, BrokenCodeOfAnotherRungDoesNotMatter) {
    auto document = open(scene("Ladder KIND bad <g> b", "broken.frag"));
    expect_clean(*document);
    EXPECT_EQ(draw(*document).center(), green);
}

TEST_F(LadderScenes, ABrokenRungIsReportedAndTheLastGoodOneStays) {
    auto document = open(scene("Ladder KIND bad <g> b", "broken.frag"));
    EXPECT_EQ(with(*document, {0}), green);
    EXPECT_TRUE(document->runtime->ladder_problems().has_errors());
    EXPECT_EQ(with(*document, {2}), blue);
    EXPECT_FALSE(document->runtime->ladder_problems().has_errors());
    EXPECT_EQ(with(*document, {0}), blue);
    EXPECT_EQ(document->runtime->ladder_problems().errors(), 1u) << "said again, without compiling again";
    EXPECT_FALSE(document->diagnostics.has_errors());
    complaints.clear();  // the driver's, of the broken rung
}

TEST_F(LadderScenes, ABrokenFirstRungCanBeLeft) {
    auto document = open(scene("Ladder KIND <bad> g b", "broken.frag"));
    EXPECT_TRUE(document->diagnostics.has_errors());
    EXPECT_EQ(with(*document, {1}), green);
    complaints.clear();
}

TEST_F(LadderScenes, NumbersAreComparedByNameAndHaveAValue) {
    folder.write("waves.frag",
                 "void main() {\n#if WAVES == WAVES_16 && WAVES_VALUE == 16 && WAVES > WAVES_8\n"
                 "gl_FragColor = vec4(0., float(WAVES_VALUE) / 16., 0., 1.);\n#else\n"
                 "gl_FragColor = vec4(float(WAVES_VALUE) / 16., 0., 0., 1.);\n#endif\n}\n");
    auto document = open(scene("Ladder WAVES 3 8 <16> 64", "waves.frag"));
    expect_clean(*document);
    EXPECT_EQ(draw(*document).center(), green);
    EXPECT_TRUE(near(with(*document, {1}), {128, 0, 0, 255}));
}

TEST_F(LadderScenes, ControlsFollowTheRung) {
    auto document = open(scene("Ladder KIND bad <g> b", "broken.frag"));
    EXPECT_FALSE(document->controls.find(0, "uBlue")->active);
    document->controls.find(0, "uBlue")->value = {.5};
    document->controls.rungs = {2};
    EXPECT_TRUE(follow_rungs(*document));
    EXPECT_FALSE(follow_rungs(*document));
    EXPECT_TRUE(document->controls.find(0, "uBlue")->active);
    EXPECT_EQ(document->controls.rungs, Rungs{2});
    EXPECT_TRUE(near(draw(*document).center(), {0, 0, 128, 255}, 3)) << "values are kept";
}

// The uniform that only one rung of the first program has moves the places of the second program's controls.
TEST_F(LadderScenes, ControlsOfAnotherRungKeepTheirValuesAtOtherPlaces) {
    folder.write("more.frag",
                 "#if KIND == KIND_b\nuniform float uMore;\n#else\nconst float uMore = 0.;\n#endif\n"
                 "void main() { gl_FragColor = vec4(1., uMore, 0., 1.); }\n");
    folder.write("color.frag", color_fragment);
    auto document = open(
        "Ladder KIND a b\nOrtho -2 2 -2 2\nVertex plain.vert\nFragment more.frag\nProgram First\nTranslate -1 0 0\n"
        "QuadXY\nFragment color.frag\nProgram Second uColor [1. 0. 0. 1.]\nTranslate 2 0 0\nQuadXY\n");
    expect_clean(*document);
    document->controls.find(1, "uColor")->value = {0, 0, 1, 1};
    EXPECT_EQ(draw(*document).at(48, 32), blue);
    document->controls.rungs = {1};
    const Picture picture = draw(*document);  // with the controls of the rung before
    EXPECT_EQ(picture.at(16, 32), red);
    EXPECT_EQ(picture.at(48, 32), blue);
    ASSERT_FALSE(same_uniforms(document->controls, document->runtime->controls())) << "the test tests something";
    follow_rungs(*document);
    EXPECT_EQ(draw(*document), picture);
}

TEST_F(LadderScenes, ControlsInAnotherOrderAreFoundByName) {
    folder.write("two.frag",
                 "uniform float uRed, uGreen;\nvoid main() { gl_FragColor = vec4(uRed, uGreen, 0., 1.); }\n");
    auto document =
        open("Ortho -1 1 -1 1\nVertex plain.vert\nFragment two.frag\nProgram P uRed 1. uGreen 0.\nQuadXY\n");
    EXPECT_EQ(draw(*document).center(), red);
    std::swap(document->controls.items[0].value, document->controls.items[1].value);
    std::swap(document->controls.items[0], document->controls.items[1]);
    EXPECT_EQ(draw(*document).center(), green);
}

TEST_F(LadderScenes, ProgramsOfOneTextHaveTheirOwnValues) {
    folder.write("color.frag", color_fragment);
    auto document = open(
        "Ortho -2 2 -2 2\nVertex plain.vert\nFragment color.frag\nProgram A uColor [1. 0. 0. 1.]\nTranslate -1 0 0\n"
        "QuadXY\nProgram B uColor [0. 1. 0. 1.]\nTranslate 2 0 0\nQuadXY\n");
    expect_clean(*document);
    EXPECT_EQ(document->runtime->counters().programs_compiled, 1u);
    const Picture picture = draw(*document);
    EXPECT_EQ(picture.at(16, 32), red);
    EXPECT_EQ(picture.at(48, 32), green);
}

TEST_F(LadderScenes, TexturesOfAnotherRungAreReadWhenItIsChosen) {
    folder.write("green.bmp", bmp(1, 1, {{0, 255, 0}}));
    folder.write(
        "picture.frag",
        "uniform sampler2D uUnit;\nvoid main() {\n#if KIND == KIND_picture\n"
        "gl_FragColor = texture2D(uUnit, vec2(.5));\n#else\ngl_FragColor = vec4(1., 0., 0., 1.);\n#endif\n}\n");
    auto document = open(
        "Ladder KIND plain picture\nOrtho -1 1 -1 1\nTexture2D 5 green.bmp\nVertex plain.vert\n"
        "Fragment picture.frag\nProgram P uUnit 5\nQuadXY\n");
    EXPECT_EQ(draw(*document).center(), red);
    const Counters& counters = document->runtime->counters();
    EXPECT_EQ(counters.images_decoded, 0u);
    EXPECT_EQ(with(*document, {1}), green);
    EXPECT_EQ(counters.images_decoded, 1u);
    with(*document, {0});
    EXPECT_EQ(with(*document, {1}), green);
    EXPECT_EQ(counters.images_decoded, 1u);
    EXPECT_EQ(counters.textures, 1u);
}

TEST_F(LadderScenes, PassesOffScreenFollow) {
    auto document = open(
        "Ladder KIND r g b\nOrtho -1 1 -1 1\nTexture2D 6 16 16\nVertex plain.vert\nFragment kind.frag\n"
        "RenderToTexture 6\nProgram Kind\nQuadXY\nRenderToTexture\nFragment show.frag\nProgram Show uUnit 6\nQuadXY\n");
    folder.write("show.frag", texture_fragment);
    document = open_file(folder.path("scene.glib"));
    expect_clean(*document);
    EXPECT_EQ(draw(*document).center(), red);
    EXPECT_EQ(with(*document, {1}), green);
    EXPECT_EQ(with(*document, {0}), red);
    EXPECT_EQ(document->runtime->counters().targets, 1u);
}

TEST_F(LadderScenes, RungsThatAreNotThereAreIgnored) {
    auto document = open(scene("Ladder KIND r g b", "kind.frag"));
    EXPECT_EQ(with(*document, {3}), red);
    EXPECT_EQ(with(*document, {1, 1}), red);
    EXPECT_EQ(with(*document, {}), red);
}

TEST_F(LadderScenes, AChoiceBeforeOpeningCompilesThatRungOnly) {
    folder.write("scene.glib", scene("Ladder KIND <bad> g b", "broken.frag"));
    auto document = open_document(folder.path("scene.glib"), caps, [](const Scene&, Rungs& rungs) { rungs = {1}; });
    expect_clean(*document);
    EXPECT_EQ(document->controls.rungs, Rungs{1});
    EXPECT_EQ(draw(*document).center(), green);
    EXPECT_EQ(document->runtime->counters().programs_compiled, 1u);
}

}  // namespace
}  // namespace snell::test
