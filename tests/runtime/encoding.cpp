// Light and its encoding by the sRGB curve: of textures that are read, and of what the window shows.
#include "src/gl/present.h"
#include "tests/hard_case.h"
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

// IEC 61966-2-1, written again.
double decode(double c) { return c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4); }
double encode(double l) { return l <= .0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - .055; }
int byte_of(double light) { return static_cast<int>(std::lround(255 * encode(light))); }

constexpr std::string_view square = "Ortho -1 1 -1 1\nBackground 0 0 0\nVertex plain.vert\n";

class Encodings : public PlainTest, public testing::WithParamInterface<bool> {
protected:
    void SetUp() override {
        request.es = GetParam();
        PlainTest::SetUp();
    }
    std::string colored(std::string_view color) {
        return std::string(square) + "Fragment color.frag\nProgram C uColor " + std::string(color) + "\nQuadXY 0 2\n";
    }
    // All bytes from 0 to 255, in a row.
    std::string ramp() {
        std::vector<std::array<int, 3>> pixels;
        for (int i = 0; i < 256; ++i) pixels.push_back({i, i, i});
        folder.write("ramp.bmp", bmp(256, 1, pixels));
        return std::string(square) +
               "Filter nearest\nTexture2D 5 ramp.bmp srgb\nFragment texture.frag\n"
               "Program T uUnit 5\nQuadXY 0 1\n";
    }
};

INSTANTIATE_TEST_SUITE_P(Contexts, Encodings, testing::Bool(),
                         [](const auto& context) { return std::string(context.param ? "ES" : "GL"); });

TEST_P(Encodings, OutputEncodesLight) {
    for (const double light : {0., .001, .0031, .05, .2140411, .5, .9, 1., 2.}) {
        const std::string color = std::to_string(light);
        const Picture picture = draw("Output srgb\n" + colored("[" + color + " 0. " + color + " 1.]"));
        const int expected = light > 1 ? 255 : byte_of(light);
        EXPECT_TRUE(near(picture.center(), {expected, 0, expected, 255}, 1)) << light;
    }
}

TEST_P(Encodings, TheLastOutputOfASceneHolds) {
    EXPECT_TRUE(
        near(draw("Output srgb\n" + colored("[.5 .5 .5 1.]") + "Output raw\n").center(), {128, 128, 128, 255}, 1));
    EXPECT_TRUE(near(draw(colored("[.5 .5 .5 1.]") + "Output\n").center(), {188, 188, 188, 255}, 1));
}

TEST_P(Encodings, BackgroundAndBlendingAreLight) {
    EXPECT_TRUE(near(draw("Output srgb\nBackground .5 .5 .5\n").at(1, 1), {188, 188, 188, 255}, 1));
    const Picture blended = draw("Output srgb\nBlend\n" + colored("[1. 1. 1. .5]"));
    EXPECT_NEAR(blended.center()[0], byte_of(.5), 1) << "half of the light, not half of the display's number";
}

TEST_P(Encodings, SamplesOfAPixelAreAveragedAsLight) {
    // An edge through the middle of a column of pixels.
    const std::string scene =
        "Output srgb\n" + std::string(square) +
        "Fragment color.frag\nProgram C uColor [1. 1. 1. 1.]\nTranslate 1.015625 0 0\nQuadXY 0 1\n";
    const Look look{.samples = 4};
    const Picture picture = draw(scene, look);
    const int edge = picture.at(32, 32)[0];
    const double covered = decode(edge / 255.);
    EXPECT_NEAR(covered * 4, std::round(covered * 4), .05) << edge << " of 255 is " << covered << " of the light";
    EXPECT_GT(covered, .2);
    EXPECT_LT(covered, .8);
}

TEST_P(Encodings, ATextureIsDecodedAndShownAsItWas) {
    const Look look{.width = 256, .height = 256};
    const Picture shown = draw("Output srgb\n" + ramp(), look);
    const Picture raw = draw(ramp(), look);
    for (int i = 0; i < 256; ++i) {
        EXPECT_NEAR(shown.at(i, 128)[0], i, 1);
        EXPECT_NEAR(raw.at(i, 128)[0], 255 * decode(i / 255.), 1) << i;
    }
}

TEST_P(Encodings, FilteringIsOfLight) {
    folder.write("checks.bmp", bmp(2, 2, {{0, 0, 0}, {255, 255, 255}, {255, 255, 255}, {0, 0, 0}}));
    for (const std::string filter : {"linear", "mipmap"}) {
        const Picture picture =
            draw("Output srgb\n" + std::string(square) + "Filter " + filter +
                     "\nTexture2D 5 checks.bmp srgb\nFragment texture.frag\nProgram T uUnit 5\nQuadXY\n",
                 {.width = 1, .height = 1});
        EXPECT_NEAR(picture.center()[0], byte_of(.5), 2) << filter;
    }
}

TEST_P(Encodings, OneFileMayBeReadBothWays) {
    folder.write("grey.bmp", bmp(1, 1, {{188, 188, 188}}));
    folder.write("two.frag",
                 "#version 330 compatibility\nuniform sampler2D uRaw, uLight;\nin vec2 vST;\n"
                 "void main() { gl_FragColor = vec4(texture(uRaw, vST).r, texture(uLight, vST).r, 0., 1.); }\n");
    const Picture picture = draw(std::string(square) + "Texture2D 5 grey.bmp raw\nTexture2D 6 grey.bmp SRGB\n" +
                                 "Fragment two.frag\nProgram T uRaw 5 uLight 6\nQuadXY\n");
    EXPECT_TRUE(near(picture.center(), {188, 128, 0, 255}, 1));
}

TEST_P(Encodings, OffScreenTexturesKeepLight) {
    const std::string scene = "Output srgb\nTexture2D 5 64 64\nRenderToTexture 5\n" + colored("[.5 .5 .5 1.]") +
                              "RenderToTexture\nFragment texture.frag\nProgram T uUnit 5\nQuadXY 0 1\n";
    EXPECT_NEAR(draw(scene).center()[0], byte_of(128 / 255.), 1) << "encoded once";
}

// Irradiance of encoded bytes, decoded, against that of half floats that hold the same light.
TEST_P(Encodings, IrradianceIsOfLight) {
    std::vector<std::array<int, 3>> sky;
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 32\n";
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const int value = y < 5 ? 255 : 20 + 5 * y;
            sky.push_back({value, value, value});
            int exponent = 0;
            const double mantissa = std::frexp(decode(value / 255.), &exponent);
            const auto channel = static_cast<char>(std::lround(mantissa * 256 - .5));
            hdr += {channel, channel, channel, static_cast<char>(exponent + 128)};
        }
    folder.write("sky.bmp", bmp(32, 16, sky));
    folder.write("sky.hdr", hdr);
    folder.write("up.frag",
                 "#version 330 compatibility\nuniform samplerCube uCube;\n"
                 "void main() { gl_FragColor = vec4(texture(uCube, vec3(0., 1., 0.)).rgb, 1.); }\n");
    const auto up = [&](const std::string& map) {
        return draw("CubeMap 6 " + map + "\nIrradiance 7 6\n" + std::string(square) +
                    "Fragment up.frag\nProgram U uCube 7\nQuadXY\n")
            .center()[0];
    };
    const int light = up("sky.hdr"), decoded = up("sky.bmp srgb"), encoded = up("sky.bmp");
    EXPECT_NEAR(decoded, light, 2);
    EXPECT_GT(encoded, light + 10) << "computed from the display's numbers it is too bright";
}

TEST_P(Encodings, LightIsNotDecodedAgain) {
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n";
    hdr += {static_cast<char>(128), static_cast<char>(128), static_cast<char>(128), static_cast<char>(128)};  // .5
    folder.write("grey.hdr", hdr);
    const std::string scene =
        std::string(square) + "Texture2D 5 grey.hdr srgb\nFragment texture.frag\nProgram T uUnit 5\nQuadXY\n";
    auto document = open(scene);
    EXPECT_TRUE(has(*document, "light-already"));
    EXPECT_NEAR(draw(*document).center()[0], 128, 1);
}

// The screen gets the bytes that files get, also where OpenGL ES decodes what it copies.
TEST_P(Encodings, TheScreenShowsWhatFilesHold) {
    auto document = open("Output srgb\n" + ramp());
    for (const int samples : {1, 4}) {
        gl::Canvas canvas;
        ASSERT_TRUE(canvas.resize(256, 256, samples, document->runtime->display_pixels()));
        document->runtime->draw({0, View{}, document->controls}, {canvas.framebuffer(), 256, 256});
        canvas.resolve();
        const gl::Target screen = gl::make_target(515, 513, 1);
        for (const int size : {1, 2}) {
            canvas.show(3, 1, 256 * size, 256 * size, screen.framebuffer.get());
            const auto shown = gl::read_rgba8(screen.framebuffer.get(), 515, 513, 1);
            std::vector<int> bytes, wanted;
            for (std::size_t i = 0; i < 256; ++i) {
                // Enlarged, two pixels lie on either side of the middle of the old one: half a byte away.
                const std::size_t at = 4 * (515 * 400 + 3 + static_cast<std::size_t>(size) * i);
                const int byte = std::to_integer<int>(shown[at]), expected = static_cast<int>(i);
                bytes.push_back(size == 2 && std::abs(byte - expected) == 1 ? expected : byte);
                wanted.push_back(expected);
            }
            EXPECT_EQ(bytes, wanted) << samples << " samples, enlarged " << size;
        }
    }
    expect_quiet();
}

TEST_P(Encodings, FloatsHoldLight) {
    auto document = open("Output srgb\n" + colored("[.25 .5 3. 1.]"));
    const gl::Target target = gl::make_target(4, 4, 1, gl::Pixels::rgba32f);
    document->runtime->draw({0, View{}, document->controls}, {target.framebuffer.get(), 4, 4});
    const auto values = gl::read_rgba32f(target.framebuffer.get(), 4, 4, 1);
    EXPECT_EQ(std::vector<float>(values.begin(), values.begin() + 3), (std::vector<float>{.25, .5, 3}));
}

}  // namespace
}  // namespace snell::test
