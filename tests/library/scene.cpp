// The library as scenes get it: by #include in their own shaders, in any version of GLSL.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class LibraryScene : public GlTest, public testing::WithParamInterface<const char*> {};

// Half of each picture is a formula written out, the other the library's; no step between them may show.
TEST_P(LibraryScene, IncludesItInAnyVersion) {
    const std::string version = GetParam();
    const bool old = version.find("120") != std::string::npos || version.empty();
    folder.write("a.vert",
                 version + (old ? "varying vec2 vST;" : "out vec2 vST;") +
                     "\nvoid main() { vST = gl_MultiTexCoord0.st; gl_Position = gl_ModelViewProjectionMatrix * "
                     "gl_Vertex; }\n");
    folder.write("a.frag", version +
                               "#include <snell/dispersion.glsl>\n#include <snell/environment.glsl>\n"
                               "#include <snell/irradiance.glsl>\n#include <snell/noise.glsl>\n" +
                               (old ? "varying vec2 vST;" : "in vec2 vST;") +
                               "\nvoid main() {\n"
                               "    float c = vST.t;\n"
                               "    float f = snellFresnelExact(c, 1., 1.5);\n"
                               "    if (vST.s < .5) {\n"
                               "        float t = sqrt(1. - (1. - c * c) / 2.25);\n"
                               "        float s = (c - 1.5 * t) / (c + 1.5 * t), p = (t - 1.5 * c) / (t + 1.5 * c);\n"
                               "        f = .5 * (s * s + p * p);\n"
                               "    }\n"
                               "    gl_FragColor = vec4(f, snellNoise(vec3(1., 2., 3.)), snellFresnelF0(1., 3.), 1.);\n"
                               "}\n");
    const Picture picture =
        draw("Ortho -1 1 -1 1\nLookAt 0 0 1  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n");
    for (int y = 0; y < picture.height; ++y) {
        const Pixel left = picture.at(8, y), right = picture.at(56, y);
        EXPECT_TRUE(near(left, right, 1)) << y << ": " << left[0] << " " << right[0];
        EXPECT_EQ(right[1], 0);
        EXPECT_NEAR(right[2], 64, 1);
    }
    EXPECT_GT(picture.at(56, 63)[0], 200) << "grazing";
    EXPECT_NEAR(picture.at(56, 0)[0], 10, 1) << "normal incidence";
}

INSTANTIATE_TEST_SUITE_P(Versions, LibraryScene,
                         testing::Values("", "#version 120\n", "#version 330 compatibility\n",
                                         "#version 400 compatibility\n"));

}  // namespace
}  // namespace snell::test
