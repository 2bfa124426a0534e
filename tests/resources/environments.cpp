// Irradiance, Prefilter and RenderToCube, from the language to the frame.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Environments : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("eye.vert",
                     "#version 330 compatibility\nout vec3 vDir;\nout vec2 vST;\nvoid main() { vDir = gl_Vertex.xyz; "
                     "vST = gl_MultiTexCoord0.st; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write("cube.frag",
                     "#version 330 compatibility\nuniform samplerCube uCube;\nin vec3 vDir;\n"
                     "void main() { gl_FragColor = vec4(texture(uCube, vDir).rgb, 1.); }\n");
        folder.write("harmonics.frag",
                     "#version 330 compatibility\n#include <snell/irradiance.glsl>\nuniform vec3 uHarmonics[9];\n"
                     "in vec3 vDir;\nvoid main() { gl_FragColor = vec4(snellIrradianceHarmonics(uHarmonics, "
                     "normalize(vDir), 2), 1.); }\n");
        folder.write("color.vert", plain_vertex);
        folder.write("color.frag", color_fragment);
        // Just beside each of the twelve edges of a cube, uSide of it; colours as a picture would show them.
        folder.write("edges.frag", R"(#version 330 compatibility
uniform samplerCube uCube;
uniform float uSide, uScale, uLevel;
in vec2 vST;
void main() {
    int edge = int(vST.s * 12.);
    float along = vST.t * 1.96 - .98, off = uSide * 2e-6;
    vec2 signs = vec2((edge & 1) == 0 ? 1. : -1., (edge & 2) == 0 ? 1. : -1.);
    vec2 ends = signs * vec2(1. + off, 1. - off);
    vec3 d = edge < 4 ? vec3(ends, along) : edge < 8 ? vec3(along, ends) : vec3(ends.y, along, ends.x);
    vec3 light = uScale * textureLod(uCube, d, uLevel).rgb;
    gl_FragColor = vec4(light / (1. + light), 1.);
}
)");
        // The centres of the six faces, from left to right.
        folder.write("faces.frag", R"(#version 330 compatibility
uniform samplerCube uCube;
in vec2 vST;
void main() {
    int face = int(vST.s * 6.);
    vec3 d = vec3(0.);
    d[face / 2] = face % 2 == 0 ? 1. : -1.;
    gl_FragColor = vec4(texture(uCube, d).rgb, 1.);
}
)");
        std::vector<std::array<int, 3>> sky;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x) sky.push_back({255 - 7 * y, 128 + (x < 32 ? 2 * x : 128 - 2 * x), 40 + 6 * y});
        folder.write("sky.bmp", bmp(64, 32, sky));
    }
    Picture paced(Document& document, double value) {
        const gl::Target target = gl::make_target(48, 48, 1);
        Diagnostics none;
        set_control(document.controls, document.scene(), "uColor=" + std::to_string(value) + ",0,0,1", none);
        EXPECT_FALSE(none.has_errors()) << render(none, document.sources);
        const View view;
        document.runtime->draw({0, view, document.controls, true}, {target.framebuffer.get(), 48, 48});
        return {48, 48, gl::read_rgba8(target.framebuffer.get(), 48, 48, 1)};
    }
    static const Counters& counters(Document& document) { return document.runtime->counters(); }

    static constexpr std::string_view look =
        "Ortho -1 1 -1 1\nLookAt 0 0 1  0 0 0  0 1 0\nVertex eye.vert\nFragment cube.frag\n";
};

TEST_F(Environments, WhatNothingSamplesIsNotComputed) {
    for (const std::string use : {"QuadXY\n", "Program Unused uCube 7\nProgram\nQuadXY\n"}) {
        auto document = open("CubeMap 6 sky.bmp\nIrradiance 7 6\nPrefilter 8 6\n" + std::string(look) + use);
        expect_clean(*document);
        draw(*document);
        EXPECT_EQ(counters(*document).convolutions, 0U);
        EXPECT_EQ(counters(*document).images_decoded, 0U);
    }
}

TEST_F(Environments, WhatIsSampledIsComputedOnce) {
    const std::string twice = "CubeMap 6 sky.bmp\nIrradiance 7 6\n" + std::string(look) +
                              "Program Show uCube 7\nQuadXY\nIrradiance 7 6\nQuadXY .5\n";
    auto document = open(twice);
    expect_clean(*document);
    draw(*document);
    draw(*document);
    EXPECT_EQ(counters(*document).convolutions, 1U);
    EXPECT_EQ(counters(*document).images_decoded, 1U);
    EXPECT_EQ(counters(*document).textures, 1U) << "the cube map itself is not on the GPU";
    auto both = open("CubeMap 6 sky.bmp\nIrradiance 7 6\nPrefilter 8 6 16\n" + std::string(look) +
                     "Program A uCube 7\nQuadXY\nProgram B uCube 8\nQuadXY\nProgram C uCube 6\nQuadXY\n");
    draw(*both);
    EXPECT_EQ(counters(*both).convolutions, 2U);
    EXPECT_EQ(counters(*both).images_decoded, 1U);
    EXPECT_EQ(counters(*both).textures, 3U);
}

// Nine numbers are all that goes to the GPU, and they show what the convolved map does.
TEST_F(Environments, HarmonicsAreOfferedWhereTheyAreRead) {
    const std::string scene = "CubeMap 6 sky.bmp\nIrradiance 7 6\nPerspective 90\nVertex eye.vert\nFragment ";
    for (const char* at : {"1 .2 0", ".3 -.9 .4", "-.5 .4 -1"}) {
        const std::string end = "QuadXY 0 0\nLookAt 0 0 0  " + std::string(at) + "  0 1 0\nBox\n";
        auto harmonics = open(scene + "harmonics.frag\nProgram Show\n" + end);
        expect_clean(*harmonics);
        const Picture one = draw(*harmonics), other = draw(scene + "cube.frag\nProgram Show uCube 7\n" + end);
        EXPECT_TRUE(near(one.center(), other.center(), 3)) << at;
        EXPECT_EQ(counters(*harmonics).convolutions, 1U);
        EXPECT_EQ(counters(*harmonics).textures, 0U);
    }
    auto lonely = open("Vertex eye.vert\nFragment harmonics.frag\nProgram Show\nSphere\n");
    EXPECT_TRUE(has(*lonely, "no-harmonics"));
    draw(*lonely);
}

const std::string cube_of_a_colour =
    "CubeMap 6 32\nVertex color.vert\nFragment color.frag\nProgram Paint uColor {.2 .4 .6 1.}\nRenderToCube 6\n"
    "Box 4 4 4\nRenderToTexture\n";

TEST_F(Environments, FollowWhatIsDrawnIntoTheirSource) {
    const std::string show = "Irradiance 7 6\nPrefilter 8 6\n" + std::string(look);
    auto document = open(cube_of_a_colour + show + "Program Show uCube 7\nQuadXY\n");
    expect_clean(*document);
    EXPECT_TRUE(near(draw(*document).center(), {51, 102, 153, 255}));
    EXPECT_EQ(counters(*document).convolutions, 1U);
    EXPECT_EQ(counters(*document).cube_faces, 6U);
    draw(*document, {.time = 3});
    EXPECT_EQ(counters(*document).convolutions, 1U) << "nothing changed";
    EXPECT_EQ(counters(*document).cube_faces, 6U);
    EXPECT_TRUE(near(draw(*document, {.sets = {"uColor=.8,.1,0,1"}}).center(), {204, 26, 0, 255}));
    EXPECT_EQ(counters(*document).convolutions, 2U);
    EXPECT_EQ(counters(*document).cube_faces, 12U);
    EXPECT_TRUE(near(draw(cube_of_a_colour + show + "Program Show uCube 8\nQuadXY\n").center(), {51, 102, 153, 255}));
    folder.write("both.frag",
                 "#version 330 compatibility\nuniform vec3 uHarmonics[9];\n"
                 "void main() { gl_FragColor = vec4(.282094792 * uHarmonics[0], 1.); }\n");
    EXPECT_TRUE(near(
        draw(cube_of_a_colour + "Irradiance 7 6\n" + std::string(look) + "Fragment both.frag\nProgram Show\nQuadXY\n")
            .center(),
        {51, 102, 153, 255}));
}

TEST_F(Environments, APassThatSamplesWhatIsComputedFromItsTargetIsAnError) {
    auto document = open("CubeMap 6 32\nIrradiance 7 6\n" + std::string(look) +
                         "Program Show uCube 7\nRenderToCube 6\nBox\nRenderToTexture\nBox\n");
    EXPECT_TRUE(has(*document, "feedback-loop"));
    draw(*document);
}

// Hard case A29: k faces a frame are renewed in turns, so that ages are 0 to 6/k - 1 frames while everything moves,
// (6/k - 1)/2 in the mean; and they settle when it stops.
TEST_F(Environments, FacesAreRenewedInTurns) {
    for (const int k : {1, 2, 3, 6}) {
        SCOPED_TRACE(k);
        auto document = open(
            "CubeMap 6 8\nVertex color.vert\nFragment color.frag\nProgram Paint uColor {0. 0. 0. 1.}\n"
            "RenderToCube 6 0 0 0 " +
            std::to_string(k) + "\nBox 4 4 4\nRenderToTexture\n" + std::string(look) +
            "Fragment faces.frag\nProgram Show uCube 6\nQuadXY\n");
        expect_clean(*document);
        constexpr int frames = 24;
        double sum = 0;
        for (int frame = 0; frame <= frames; ++frame) {
            const std::uint64_t before = counters(*document).cube_faces;
            const Picture picture = paced(*document, frame / 255.0);
            EXPECT_EQ(counters(*document).cube_faces - before, frame == 0 ? 6U : static_cast<unsigned>(k));
            if (frame <= frames - 12) continue;
            int oldest = 0;
            for (int face = 0; face < 6; ++face) {
                const int age = frame - picture.at(8 * face + 4, 24)[0];
                sum += age / 72.0;
                oldest = std::max(oldest, age);
            }
            EXPECT_EQ(oldest, 6 / k - 1);
        }
        EXPECT_NEAR(sum, (6.0 / k - 1) / 2, 1e-9);
        EXPECT_EQ(document->runtime->settled(), k == 6);
        int more = 0;
        while (!document->runtime->settled() && more < 10) {
            paced(*document, frames / 255.0);
            ++more;
        }
        EXPECT_EQ(more, 6 / k - 1) << "frames until all faces are of today";
        const std::uint64_t before = counters(*document).cube_faces;
        EXPECT_TRUE(near(paced(*document, frames / 255.0).at(44, 24), {frames, 0, 0, 255}, 0));
        EXPECT_EQ(counters(*document).cube_faces, before);
    }
}

// Hard case 53: the frame at a time has the same bytes however it was reached, paced frames before it or none.
TEST_F(Environments, PicturesOfATimeDoNotDependOnThoseBefore) {
    folder.write(
        "timer.frag",
        "#version 330 compatibility\nuniform float Timer;\nvoid main() { gl_FragColor = vec4(Timer, 1. - Timer, "
        ".5, 1.); }\n");
    const std::string scene =
        "CubeMap 6 16\nIrradiance 7 6\nVertex color.vert\nFragment timer.frag\nProgram Paint\nRenderToCube 6 [0 0 0] "
        "1\n"
        "Box 4 4 4\nRenderToTexture\n" +
        std::string(look) + "Program Show uCube 6\nQuadXY 0 .5\nProgram Matt uCube 7\nQuadXY -.1 1\n";
    auto fresh = open(scene), used = open(scene);
    expect_clean(*fresh);
    const Picture expected = draw(*fresh, {.time = 4});
    draw(*used, {.time = 1});
    const gl::Target target = gl::make_target(64, 64, 1);
    const View view;
    for (const double time : {2.0, 2.5, 7.0})
        used->runtime->draw({time, view, used->controls, true}, {target.framebuffer.get(), 64, 64});
    EXPECT_FALSE(used->runtime->settled());
    EXPECT_TRUE(draw(*used, {.time = 4}) == expected);
    EXPECT_TRUE(used->runtime->settled());
}

// Of cube maps, irradiance and chains: no step of more than one of 255 across an edge (filters of GPUs have weights of
// 8 bits, so that light is shown by x / (1 + x)). Hard case 16 in real and synthetic surroundings.
TEST_F(Environments, EdgesDoNotShow) {
    std::vector<std::pair<std::string, double>> pictures{{"sky.bmp", 1}};
    const std::filesystem::path hdri = std::filesystem::absolute("../shared/corpus/hdri");
    if (std::filesystem::exists(hdri))
        for (const auto& entry : std::filesystem::directory_iterator(hdri))
            pictures.emplace_back("\"" + entry.path().string() + "\"", .5);
    for (const auto& [picture, scale] : pictures) {
        SCOPED_TRACE(picture);
        auto document =
            open("CubeMap 6 " + picture + "\nIrradiance 7 6\nPrefilter 8 6 16\n" + std::string(look) +
                 "Fragment edges.frag\nProgram Show uCube 6 uLevel 0. uSide 1. uScale " + std::to_string(scale) +
                 "\nQuadXY 0 .5\n" + "Program Matt uCube 7 uLevel 0. uSide 1. uScale " + std::to_string(scale) +
                 "\nTranslate .5 .5 0\nQuadXY 0 .5\n" + "Program Rough uCube 8 uLevel 1. uSide 1. uScale " +
                 std::to_string(scale) + "\nTranslate -1. 0 0\nQuadXY 0 .5\n");
        expect_clean(*document);
        const Picture one = draw(*document, {.width = 96, .height = 96});
        const Picture other =
            draw(*document, {.width = 96, .height = 96, .sets = {"Show.uSide=-1", "Matt.uSide=-1", "Rough.uSide=-1"}});
        int worst = 0;
        double sum = 0;
        for (std::size_t i = 0; i < one.rgba.size(); ++i) {
            const int a = std::to_integer<int>(one.rgba[i]), b = std::to_integer<int>(other.rgba[i]);
            worst = std::max(worst, std::abs(a - b));
            sum += a;
        }
        EXPECT_LE(worst, 1);
        EXPECT_GT(sum / static_cast<double>(one.rgba.size()), 30) << "too dark to tell";
    }
    if (pictures.size() == 1) GTEST_SKIP() << hdri << " is not there: only the synthetic sky was looked at";
}

// Hard case A40: what seamless filtering is for. Interpolated light beside an edge of a smooth sky is nearer to the
// sky's than the nearest texel on one side would be; where walls really meet the edge is blurred by one texel.
TEST_F(Environments, SeamlessFilteringIsForSmoothSurroundings) {
    folder.write("smooth.frag",
                 "#version 330 compatibility\nin vec3 vDir;\nvoid main() { gl_FragColor = vec4(.5 + .5 * "
                 "normalize(vDir), 1.); }\n");
    folder.write("seam.frag", R"(#version 330 compatibility
uniform samplerCube uCube;
uniform bool uClamped;
in vec2 vST;
void main() {
    vec3 d = normalize(vec3(1., vST.t * 1.8 - .9, 1. - vST.s / 16.));
    vec3 m = d / d.x;
    if (uClamped) m.yz = clamp(m.yz, -15. / 16., 15. / 16.);
    vec3 off = texture(uCube, m).rgb - (.5 + .5 * d);
    gl_FragColor = vec4(abs(off) * 16., 1.);
}
)");
    const std::string scene =
        "CubeMap 6 16\nVertex eye.vert\nFragment smooth.frag\nProgram Paint\nRenderToCube 6\nBox 4 4 "
        "4\nRenderToTexture\n" +
        std::string(look) + "Fragment seam.frag\nProgram Show uCube 6 uClamped <0>\nQuadXY\n";
    auto document = open(scene);
    expect_clean(*document);
    const auto rms = [](const Picture& picture) {
        double squares = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                for (std::size_t c = 0; c < 3; ++c) squares += std::pow(picture.at(x, y)[c] / 255.0 / 16, 2);
        return std::sqrt(squares / (3.0 * picture.width * picture.height));
    };
    const double seamless = rms(draw(*document)), clamped = rms(draw(*document, {.sets = {"uClamped=1"}}));
    EXPECT_LT(seamless, clamped / 2.5) << "of which .0011 is rounding to bytes";
}

}  // namespace
}  // namespace snell::test
