// Many draws of one mesh are instances of one draw, where nobody can tell.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Instances : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    Instances() { request = GetParam(); }
    void SetUp() override {
        GlTest::SetUp();
        folder.write("lit.vert",
                     "out vec3 vNormal, vEye;\nout vec2 vST;\nvoid main() {\n    vNormal = normalize(gl_NormalMatrix * "
                     "gl_Normal);\n    vEye = (gl_ModelViewMatrix * gl_Vertex).xyz;\n    vST = gl_MultiTexCoord0.st;\n"
                     "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n");
        folder.write("lit.frag",
                     "uniform float uAlpha;\nuniform sampler2D uUnit;\nin vec3 vNormal, vEye;\nin vec2 vST;\n"
                     "void main() { gl_FragColor = vec4(normalize(vNormal) * .5 + .5 - .1 * vEye, uAlpha) * "
                     "texture(uUnit, vST); }\n");
        folder.write("a.bmp", bmp(2, 2, {{255, 200, 90}, {90, 200, 255}, {30, 90, 250}, {250, 250, 250}}));
        folder.write("t.obj", "v 0 0 0\nv .3 0 0\nv 0 .3 .1\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n");
    }
    // Overlapping and turned, so that their order shows where they blend.
    static std::string crowd(int count, const std::string& shape = "Obj t.obj") {
        std::string text =
            "Perspective 60\nLookAt 0 0 3 0 0 0 0 1 0\nTexture2D 6 a.bmp\nVertex lit.vert\n"
            "Fragment lit.frag\nProgram P uUnit 6 uAlpha <0. .5 1.>\n";
        for (int i = 0; i < count; ++i) {
            const auto number = [&](int n) { return std::to_string(n * i % 17 / 17. - .5); };
            text += "PushMatrix\nTranslate " + number(3) + " " + number(5) + " " + number(7) + "\nRotate " +
                    std::to_string(37 * i) + " .2 1 .1\nScale 1 " + std::to_string(1 + i % 3) + " 1\n" + shape +
                    "\nPopMatrix\n";
        }
        return text;
    }
    // Draws of a frame; the picture must be that of draws one by one.
    std::uint64_t draws(const std::string& scene, const Look& look = {}) {
        auto many = open(scene);
        expect_clean(*many);
        RuntimeOptions options;
        options.savings = false;
        auto single = open_document(folder.path("scene.glib"), caps, nullptr, nullptr, options);
        const Picture picture = draw(*many, look);
        EXPECT_TRUE(picture == draw(*single, look));
        EXPECT_LT(picture.count(picture.at(0, 0)), 64 * 64) << "something is drawn";
        EXPECT_EQ(many->runtime->counters().triangles, single->runtime->counters().triangles);
        return many->runtime->counters().draws;
    }
};

TEST_P(Instances, AreTheSamePicture) {
    EXPECT_EQ(draws(crowd(300)), 2U);
    EXPECT_EQ(draws(crowd(300, "Sphere .1 6 6")), 2U);
    EXPECT_EQ(draws("Ortho -1 1 -1 1\n" + crowd(40, "Teapot")), 1U);
}

TEST_P(Instances, FollowTheView) {
    Look look;
    look.view.scene.rotate_y = 40;
    look.view.objects[7].x = .5;
    look.view.eye.x = .1;
    EXPECT_EQ(draws(crowd(40), look), 1U);
}

TEST_P(Instances, OfTheBuiltInProgram) {
    std::string scene = "Ortho -1 1 -1 1\n";
    for (int i = 0; i < 40; ++i) scene += "Translate .03 .02 0\nQuadXY 0 .2\n";
    EXPECT_EQ(draws(scene), 1U);
    std::string colours = "Ortho -1 1 -1 1\n";
    for (int i = 0; i < 40; ++i)
        colours += "Color 1 " + std::to_string(i / 40.) + " 0\nTranslate .03 .02 0\nQuadXY 0 .2\n";
    EXPECT_EQ(draws(colours), 40U) << "each has its own colour";
}

TEST_P(Instances, EndWhereStateChanges) {
    EXPECT_EQ(draws(crowd(8)), 8U) << "too few";
    EXPECT_EQ(draws(crowd(40, "Clear\nObj t.obj")), 40U);
    EXPECT_EQ(draws(crowd(20) + "Blend off\n" + crowd(20)), 2U);
}

TEST_P(Instances, AreNotForProgramsThatCouldTell) {
    folder.write("lit.vert",
                 "uniform mat4 uModelViewMatrix;\nout vec3 vNormal, vEye;\nout vec2 vST;\nvoid main() {\n"
                 "    vNormal = gl_Normal;\n    vEye = (uModelViewMatrix * gl_Vertex).xyz;\n    vST = vec2(.5);\n"
                 "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n");
    EXPECT_EQ(draws(crowd(40)), 40U);
    folder.write("lit.vert",
                 "out vec3 vNormal, vEye;\nout vec2 vST;\nvoid main() {\n    vNormal = gl_Normal; vEye = vec3(0.);\n"
                 "    vST = vec2(.5);\n    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n");
    folder.write("lit.frag",
                 "in vec3 vNormal, vEye;\nin vec2 vST;\nvoid main() { gl_FragColor = vec4(gl_NormalMatrix[0] * .5 + "
                 ".5, 1.); }\n");
    EXPECT_EQ(draws(crowd(40)), 40U) << "its fragments read the matrix";
}

TEST_P(Instances, ASliderAndAStillFrameCostWhatTheyDoForOne) {
    auto document = open(crowd(300));
    draw(*document);
    const std::uint64_t first = document->runtime->counters().uniform_uploads;
    draw(*document);
    EXPECT_EQ(document->runtime->counters().uniform_uploads, first);
    draw(*document, {.sets = {"uAlpha=1"}});
    EXPECT_EQ(document->runtime->counters().uniform_uploads, first + 1);
}

INSTANTIATE_TEST_SUITE_P(Contexts, Instances, all_contexts, context_name);

}  // namespace
}  // namespace snell::test
