// Texels as the window's texture panel gets them: against what shaders read at the same coordinates, and against known
// values.
#include "src/gl/texels.h"
#include "src/runtime/inspect.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

class Texels : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    void SetUp() override {
        request = GetParam();
        GlTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        folder.write("color.frag", color_fragment);
        folder.write("texture.frag", texture_fragment);
        viewer_ = std::make_unique<gl::TexelViewer>(caps.es);
    }
    void TearDown() override {
        viewer_.reset();
        document_.reset();
        GlTest::TearDown();
    }

    // A raw texture of floats: the row of t = 0 first.
    void raw(const std::string& name, std::vector<int> size, const std::vector<float>& values) {
        std::string bytes;
        const auto put = [&](std::uint32_t word) {
            for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i));
        };
        for (const int side : size) put(static_cast<std::uint32_t>(side));
        for (const float value : values) put(std::bit_cast<std::uint32_t>(value));
        folder.write(name, bytes);
    }
    static std::vector<float> numbers(std::size_t count) {
        std::vector<float> values;
        for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<float>(i) * .37F - 5);
        return values;
    }
    // A document whose picture is what `read` gives; the texture is there once it was drawn.
    void scene(const std::string& textures, const std::string& declared, const std::string& read) {
        folder.write("read.frag", "#version 330 compatibility\nuniform vec4 uAt;\n" + declared +
                                      "\nvoid main() { gl_FragColor = " + read + "; }\n");
        document_ = open("Blend off\n" + textures +
                         "\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment read.frag\nProgram P uUnit 5 uAt {0. 0. 0. "
                         "0.}\nQuadXY 0. 5.\n");
        expect_clean(*document_);
        draw(*document_, {.width = 4, .height = 4});
    }
    // What the shader reads there.
    std::array<float, 4> seen(const std::array<double, 3>& at, int level) {
        for (Control& control : document_->controls.items)
            if (control.name == "uAt") control.value = {at[0], at[1], at[2], static_cast<double>(level)};
        Inspection found;
        EXPECT_TRUE(floats_.resize(4, 4));
        floats_.inspect(*document_->runtime, {.time = 0, .view = view_, .controls = document_->controls}, 1, 1, 0,
                        found);
        return {found.pixel()[0], found.pixel()[1], found.pixel()[2], found.pixel()[3]};
    }
    std::vector<float> read(const gl::Plane& plane) {
        std::vector<float> rgba;
        EXPECT_TRUE(viewer_->read(plane, 0, 0, plane.width(), plane.height(), rgba));
        return rgba;
    }
    // Every texel of the plane is what the shader reads at its coordinates.
    void expect_as_seen(const gl::Plane& plane) {
        const std::vector<float> rgba = read(plane);
        int texels = 0;
        for (int y = 0; y < plane.height(); ++y)
            for (int x = 0; x < plane.width(); ++x) {
                const auto texel = plane.texel(x, y);
                const std::size_t at = std::size_t{4} * static_cast<std::size_t>(y * plane.width() + x);
                const std::array<float, 4> here{rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
                if (!texel) {
                    EXPECT_EQ(here, (std::array<float, 4>{})) << x << ", " << y;
                    continue;
                }
                ++texels;
                const std::array<float, 4> there = seen(plane.coordinates(*texel), plane.level);
                for (std::size_t c = 0; c < 4; ++c) {  // filters round
                    EXPECT_NEAR(here[c], there[c], 1e-6 * std::max(1.F, std::abs(there[c]))) << x << ", " << y;
                }
            }
        EXPECT_GT(texels, 0);
    }
    // The picture's pixels as bytes, top row first.
    std::vector<std::array<int, 4>> picture(const gl::Plane& plane, const gl::TexelLook& look, int width, int height) {
        EXPECT_TRUE(viewer_->draw(plane, look, width, height));
        std::vector<float> rgba;
        gl::TexelViewer other(caps.es);
        EXPECT_TRUE(other.read({viewer_->picture(), GL_TEXTURE_2D, {width, height, 1}}, 0, 0, width, height, rgba));
        std::vector<std::array<int, 4>> pixels;
        for (int y = height - 1; y >= 0; --y)  // its first row is the top one
            for (int x = 0; x < width; ++x) {
                const std::size_t at = std::size_t{4} * static_cast<std::size_t>(y * width + x);
                const auto byte = [&](std::size_t c) { return static_cast<int>(std::lround(255 * rgba[at + c])); };
                pixels.push_back({byte(0), byte(1), byte(2), byte(3)});
            }
        return pixels;
    }

    std::unique_ptr<gl::TexelViewer> viewer_;
    std::unique_ptr<Document> document_;
    FloatPicture floats_;
    View view_;
};

constexpr const char* lod_2d = "uniform sampler2D uUnit;";

TEST_P(Texels, ABitmapIsShownAsItsFileHasIt) {
    folder.write("four.bmp", bmp(2, 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {51, 102, 153}}));
    scene("Texture2D 5 four.bmp", lod_2d, "texture(uUnit, uAt.xy)");
    const auto held = document_->runtime->texture(0);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->levels, 1);
    EXPECT_EQ(held->pixels, gl::Pixels::rgba8);
    EXPECT_FALSE(held->changes);
    const std::vector<float> bytes{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 51, 102, 153, 255};
    const std::vector<float> rgba = read(held->plane);
    for (std::size_t i = 0; i < bytes.size(); ++i) EXPECT_NEAR(rgba[i], bytes[i] / 255, 1e-6) << i;
    // Eight pixels a texel, beginning at half a texel: the edges are sharp.
    const auto pixels = picture(held->plane, {.left = .5, .top = 0, .zoom = 8}, 8, 16);
    const auto at = [&](std::size_t x, std::size_t y) { return pixels[y * 8 + x]; };
    EXPECT_EQ(at(3, 7), (std::array{255, 0, 0, 255}));
    EXPECT_EQ(at(4, 7), (std::array{0, 255, 0, 255}));
    EXPECT_EQ(at(3, 8), (std::array{0, 0, 255, 255}));
    EXPECT_EQ(at(4, 8), (std::array{51, 102, 153, 255}));
    const std::array<int, 4> channels{51, 102, 153, 255};
    for (int channel = 0; channel < 4; ++channel) {
        const int value = channels[static_cast<std::size_t>(channel)];
        EXPECT_EQ(picture(held->plane, {.left = 1, .top = 1, .channel = channel}, 1, 1)[0],
                  (std::array{value, value, value, 255}));
    }
    EXPECT_EQ(picture(held->plane, {.left = 2}, 1, 1)[0], (std::array{0, 0, 0, 0})) << "beside the texture";
}

TEST_P(Texels, LightBeyondOneIsExactAndShownInARange) {
    raw("light.tex", {2, 2}, {-1.5F, .25F, 1.F / 1024, 1, 4, 8, 12, 1, 0, 0, 0, 1, 5.5F, 9.5F, 13.5F, .5F});
    scene("Texture2D 5 light.tex", lod_2d, "texture(uUnit, uAt.xy)");
    const auto held = document_->runtime->texture(0);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->pixels, gl::Pixels::rgba16f);
    EXPECT_EQ(read(held->plane),
              (std::vector<float>{0, 0, 0, 1, 5.5F, 9.5F, 13.5F, .5F, -1.5F, .25F, 1.F / 1024, 1, 4, 8, 12, 1}))
        << "the last row is on top";
    const auto shown = picture(held->plane, {.low = -1.5F, .high = 13.5F}, 2, 2);
    EXPECT_EQ(shown[1], (std::array{119, 187, 255, 255})) << "7, 11 and 15 of 15";
    EXPECT_EQ(shown[2][0], 0);
    EXPECT_EQ(shown[2][1], std::lround(255 * 1.75 / 15));
    const auto light = picture(held->plane, {.high = 20, .light = true}, 2, 2);
    EXPECT_NEAR(light[3][0], 255 * (1.055 * std::pow(.2, 1 / 2.4) - .055), 1) << "encoded for the display";
}

TEST_P(Texels, WhatIsNoColorIsMarked) {
    const std::vector<float> values{-1.5F, 0,        0, 1,   4, 0, 0, 1, nan, 0, 0, 1,
                                    0,     infinite, 0, .5F, 0, 0, 0, 2, 1,   1, 1, 1};
    const gl::Texture texture = gl::make_texture(
        GL_TEXTURE_2D, {gl::Pixels::rgba32f, 6, 1, 1, reinterpret_cast<const std::byte*>(values.data())},
        {gl::Sampling::Mode::nearest, 1, true});
    const gl::Plane plane{texture.get(), GL_TEXTURE_2D, {6, 1, 1}};
    const std::vector<float> rgba = read(plane);
    EXPECT_EQ(rgba[0], -1.5F);
    EXPECT_TRUE(std::isnan(rgba[8]));
    EXPECT_EQ(rgba[13], infinite);
    const std::array<int, 4> above{255, 0, 0, 255}, negative{0, 255, 0, 255}, endless{0, 0, 255, 255},
        none{255, 255, 0, 255};
    gl::TexelLook look{.marks = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}}};
    auto shown = picture(plane, look, 6, 1);
    EXPECT_EQ(shown[0], (std::array{0, 0, 0, 255}));
    EXPECT_EQ(shown[1], (std::array{255, 0, 0, 255}));
    EXPECT_EQ(shown[2], none) << "in any case";
    EXPECT_EQ(shown[3], endless) << "in any case";
    look.flags = true;
    shown = picture(plane, look, 6, 1);
    EXPECT_EQ(shown[0], negative);
    EXPECT_EQ(shown[1], above);
    EXPECT_EQ(shown[4], (std::array{0, 0, 0, 255})) << "an alpha above 1 has no effect";
    EXPECT_EQ(shown[5], (std::array{110, 110, 110, 255})) << "dim grey";
    // One pixel for all of them: the worst is not missed.
    look.zoom = 1. / 6;
    EXPECT_EQ(picture(plane, look, 1, 1)[0], none);
}

TEST_P(Texels, APixelThatCoversManyShowsTheirMean) {
    std::vector<std::array<int, 3>> board;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) board.push_back({(x + y) % 2 * 200, x < 8 ? 0 : 100, y < 8 ? 50 : 150});
    folder.write("board.bmp", bmp(16, 16, board));
    scene("Filter mipmap\nTexture2D 5 board.bmp", lod_2d, "textureLod(uUnit, uAt.xy, uAt.w)");
    auto held = document_->runtime->texture(0);
    ASSERT_TRUE(held);
    const auto shown = picture(held->plane, {.zoom = .125}, 2, 2);
    EXPECT_EQ(shown[0], (std::array{100, 0, 50, 255}));
    EXPECT_EQ(shown[1], (std::array{100, 100, 50, 255}));
    EXPECT_EQ(shown[2], (std::array{100, 0, 150, 255}));
    ASSERT_EQ(held->levels, 5);
    held->plane.level = 3;
    EXPECT_EQ(held->plane.width(), 2);
    EXPECT_EQ(picture(held->plane, {}, 2, 2), shown) << "the level of as many texels";
    expect_as_seen(held->plane);
}

TEST_P(Texels, FacesOfACubeMapAreThoseThatShadersSeeInTheirDirections) {
    std::string files;
    int color = 10;
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"}) {
        std::vector<std::array<int, 3>> pixels;
        for (int i = 0; i < 9; ++i, color += 4) pixels.push_back({color, 255 - color, color / 2});
        folder.write(std::string(face) + ".bmp", bmp(3, 3, pixels));
        files += std::string(" ") + face + ".bmp";
    }
    scene("CubeMap 5" + files, "uniform samplerCube uUnit;", "textureLod(uUnit, uAt.xyz, uAt.w)");
    const auto held = document_->runtime->texture(0);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->plane.width(), 12);
    EXPECT_EQ(held->plane.height(), 9);
    // The cell of the face in front, and the one above it.
    EXPECT_EQ(held->plane.coordinates(*held->plane.texel(4, 4)), (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(held->plane.coordinates(*held->plane.texel(4, 1)), (std::array<double, 3>{0, 1, 0}));
    EXPECT_EQ(held->plane.coordinates(*held->plane.texel(7, 4)), (std::array<double, 3>{1, 0, 0}));
    expect_as_seen(held->plane);
}

// Over every fold of the cross the directions go on.
TEST_P(Texels, TheCrossIsWithoutSeams) {
    const gl::Plane plane{0, GL_TEXTURE_CUBE_MAP, {64, 64, 1}};
    const auto angle = [&](int x, int y, int right, int down) {
        const auto a = plane.coordinates(*plane.texel(x, y)), b = plane.coordinates(*plane.texel(x + right, y + down));
        double dot = 0, of_a = 0, of_b = 0;
        for (std::size_t i = 0; i < 3; ++i) dot += a[i] * b[i], of_a += a[i] * a[i], of_b += b[i] * b[i];
        return std::acos(std::min(1., dot / std::sqrt(of_a * of_b)));
    };
    for (int along = 0; along < 64; along += 21) {
        for (const int x : {63, 127, 191}) EXPECT_LT(angle(x, 64 + along, 1, 0), 1.6 * 2 / 64);
        for (const int y : {63, 127}) EXPECT_LT(angle(64 + along, y, 0, 1), 1.6 * 2 / 64);
    }
}

TEST_P(Texels, SlicesOfNoiseAreWhatAShaderReads) {
    scene("Noise3D 8", "uniform sampler3D Noise3;", "texture(Noise3, uAt.xyz)");
    auto held = document_->runtime->noise(3);
    ASSERT_TRUE(held);
    EXPECT_FALSE(document_->runtime->noise(2));
    for (const int slice : {0, 5}) {
        held->plane.slice = slice;
        expect_as_seen(held->plane);
    }
}

TEST_P(Texels, OfOneAndThreeDimensionsAreWhatAShaderReads) {
    raw("band.tex", {16}, numbers(4 * 16));
    scene("Texture1D 5 band.tex", "uniform sampler1D uUnit;", "texture(uUnit, uAt.x)");
    auto held = document_->runtime->texture(0);
    ASSERT_TRUE(held);
    if (held->plane.target == GL_TEXTURE_1D) {
        EXPECT_EQ(held->plane.height(), 2) << "a band";
    }
    expect_as_seen(held->plane);
    raw("block.tex", {3, 4, 5}, numbers(std::size_t{4} * 3 * 4 * 5));
    scene("Texture3D 5 block.tex", "uniform sampler3D uUnit;", "texture(uUnit, uAt.xyz)");
    held = document_->runtime->texture(0);
    ASSERT_TRUE(held);
    held->plane.slice = 2;
    expect_as_seen(held->plane);
}

TEST_P(Texels, ARenderTargetIsWhatItsPassDrew) {
    folder.write("place.frag",
                 "#version 330 compatibility\nuniform float uBlue;\nvoid main() {\n    gl_FragColor = "
                 "vec4(floor(gl_FragCoord.xy) * 10. / 255., uBlue, 1.);\n}\n");
    document_ = open(
        "Blend off\nTexture2D 5 4 3\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment place.frag\n"
        "Program A uBlue <0. .2 1.>\nRenderToTexture 5\nQuadXY 0. 5.\nRenderToTexture\nFragment texture.frag\n"
        "Program B uUnit 5\nQuadXY 0. 5.\n");
    expect_clean(*document_);
    for (const double blue : {.2, .6}) {
        document_->controls.items[0].value = {blue};
        draw(*document_, {.width = 8, .height = 8});
        const auto held = document_->runtime->texture(0);
        ASSERT_TRUE(held);
        EXPECT_TRUE(held->changes);
        const std::vector<float> rgba = read(held->plane);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 4; ++x) {
                const std::size_t at = std::size_t{4} * static_cast<std::size_t>(y * 4 + x);
                EXPECT_EQ(std::lround(255 * rgba[at]), 10 * x);
                EXPECT_EQ(std::lround(255 * rgba[at + 1]), 10 * (2 - y)) << "the top row is the last";
                EXPECT_EQ(std::lround(255 * rgba[at + 2]), std::lround(255 * blue));
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, Texels, all_contexts, context_name);

}  // namespace
}  // namespace snell::test
