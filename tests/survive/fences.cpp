// Mesa 22.3's llvmpipe frees fences that its threads are about to unlock, when these are late.
// tests/survive/late_unlock.cpp makes them late: without gl::settle() each of these commands ends by a signal within
// half a second.
#include "tests/cli/run.h"
#include "tests/harness/harness.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

class Fences : public testing::Test {
protected:
    void SetUp() override {
        if (sanitized) GTEST_SKIP() << "sanitizers want to be loaded first";
        const Outcome info = snell("info");
        if (!info.says("llvmpipe")) GTEST_SKIP() << "another driver: " << info.output;
        folder.write("plain.vert", plain_vertex);
        folder.write("texture.frag", texture_fragment);
        folder.write("cube.frag",
                     "#version 330 compatibility\nuniform samplerCube uUnit;\nin vec2 vST;\n"
                     "void main() { gl_FragColor = texture(uUnit, vec3(vST, 1.)); }\n");
        folder.write("plain.glib", "Ortho -1.5 1.5 -1.5 1.5\nSphere 1 30 30\n");
        const std::string head = "Texture2D 5 64 64\nCubeMap 6 32\nOrtho -1.5 1.5 -1.5 1.5\nTimer 2\n";
        const std::string shaded = "Vertex plain.vert\nFragment ";
        folder.write("passes.glib", head + "RenderToCube 6 0 0 0\nQuadBox 4\nRenderToTexture 5\n" + shaded +
                                        "cube.frag\nProgram C uUnit 6\nSphere .5\nRenderToTexture\n" + shaded +
                                        "texture.frag\nProgram A uUnit 5\nQuadXY\n");
    }
    // Under delays, with the driver's threads.
    Outcome late(const std::string& arguments) const {
        return snell(arguments, "LP_NUM_THREADS=2 LD_PRELOAD=" SNELL_BIN "/late_unlock.so");
    }
    static void expect_none(const Outcome& outcome) {
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        EXPECT_TRUE(outcome.says(", freed while locked 0\n")) << outcome.output;
        EXPECT_FALSE(outcome.says("signalled 0,")) << "nothing was looked at";
    }
    Folder folder;
};

TEST_F(Fences, PicturesOfAccuracyFreeNoneThatIsLocked) {
    expect_none(late("accuracy " + folder.path("plain.glib") + " --size 32x32 --no-time --knobs samples"));
}

TEST_F(Fences, TimesOfFramesFreeNoneThatIsLocked) {
    expect_none(late("explain " + folder.path("passes.glib") + " --size 32x32 --reps 20"));
}

TEST_F(Fences, PicturesFreeNoneThatIsLocked) {
    expect_none(late("render " + folder.path("passes.glib") + " --size 32x32 --samples 4 --frames 30 -o " +
                     folder.path("p.png")));
}

}  // namespace
}  // namespace snell::test
