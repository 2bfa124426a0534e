// The scene that the slides print, as printed, with the pictures and the two-line shader that they leave out.
#include "tests/optics/gl/common.h"

namespace snell::test {
namespace {

class PrintedScene : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        const std::string corpus = SNELL_ROOT "/../shared/corpus/bailey/";
        if (!std::filesystem::exists(corpus + "cubemap.glib")) GTEST_SKIP() << "the slides' scene is not at " << corpus;
        for (const char* name : {"refract.vert", "refract.frag"}) folder.write(name, file(corpus + name));
        for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"})
            folder.write(std::string("nv") + face + ".bmp",
                         file(std::string(SNELL_ROOT "/scenes/environments/room/") + face + ".bmp"));
        folder.write(
            "texture.vert",
            "out vec2 vST;\n"
            "void main() { vST = gl_MultiTexCoord0.st; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write(
            "texture.frag",
            "uniform sampler2D TexUnit; in vec2 vST;\nvoid main() { gl_FragColor = texture(TexUnit, vST); }\n");
        // The object that the shaders are for is not in the print either. Around the eye, where the print leaves us, a
        // ball would refract exactly as it reflects: straight back.
        document = open(file(corpus + "cubemap.glib") + "\nTranslate 0. 0. -3.\nSphere\n");
        expect_clean(*document);
        ASSERT_TRUE(document->runtime);
    }
    static std::string file(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::unique_ptr<Document> document;
};

TEST_F(PrintedScene, HasItsSliders) {
    const Index refract = static_cast<Index>(document->scene().programs.size() - 1);
    const Control* eta = document->controls.find(refract, "uEta");
    const Control* mix = document->controls.find(refract, "uMix");
    ASSERT_TRUE(eta && mix);
    EXPECT_EQ(eta->widget, Widget::slider);
    EXPECT_EQ(eta->min, 0.1);
    EXPECT_EQ(eta->value, std::vector<double>{1.1});
    EXPECT_EQ(eta->max, 5.0);
    EXPECT_EQ(mix->min, 0.0);
    EXPECT_EQ(mix->value, std::vector<double>{0.0});
    EXPECT_EQ(mix->max, 1.0);
}

TEST_F(PrintedScene, ChangesWithTheMix) {
    const Picture before = draw(*document, square(64)), after = draw(*document, square(64, {"uMix=1"}));
    EXPECT_FALSE(before == after);
}

TEST_F(PrintedScene, AMisspeltSliderIsAnErrorThatNamesTheRightOne) {
    Diagnostics problems;
    EXPECT_FALSE(set_control(document->controls, document->scene(), "uMxi=1", problems));
    ASSERT_TRUE(problems.has_errors());
    EXPECT_NE(render(problems, document->sources).find("uMix"), std::string::npos);
}

}  // namespace
}  // namespace snell::test
