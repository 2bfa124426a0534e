// glman's raw textures.
#include "tests/image/help.h"

namespace snell::content {
namespace {

Bytes sizes(std::initializer_list<std::int32_t> values) {
    Bytes b;
    for (const std::int32_t v : values) b.i32(v);
    return b;
}

TEST(ImageTex, OneTwoAndThreeDimensionsOfBytes) {
    const std::vector<std::vector<std::int32_t>> shapes{{5}, {3, 4}, {2, 3, 4}};
    for (const auto& shape : shapes) {
        Bytes b;
        std::int32_t texels = 1;
        for (const std::int32_t side : shape) {
            b.i32(side);
            texels *= side;
        }
        for (std::int32_t i = 0; i < texels * 4; ++i) b.u8(static_cast<std::uint32_t>(i));
        const auto result = decode_image("a.tex", b.str());
        ASSERT_TRUE(result.image) << describe(result);
        const Image& image = *result.image;
        EXPECT_EQ(image.width, shape[0]);
        EXPECT_EQ(image.height, shape.size() > 1 ? shape[1] : 1);
        EXPECT_EQ(image.depth, shape.size() > 2 ? shape[2] : 1);
        EXPECT_EQ(image.type, PixelType::u8);
        EXPECT_TRUE(image.bottom_first);
        EXPECT_EQ(texel(image, image.width - 1, image.height - 1, image.depth - 1)[3], texels * 4 - 1);
        EXPECT_TRUE(result.issues.empty());
    }
}

TEST(ImageTex, FloatsBecomeHalfs) {
    Bytes b = sizes({2, 1});
    for (const float v : {0.5f, -2.0f, 1.0f, 1.0f, 100.0f, 0.25f, 0.0f, 1.0f}) b.f32(v);
    const auto result = decode_image("a.tex", b.str());
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_EQ(result.image->type, PixelType::f16);
    EXPECT_EQ(value_at(*result.image, 0), 0.5f);
    EXPECT_EQ(value_at(*result.image, 1), -2.0f);  // negative values stay
    EXPECT_EQ(value_at(*result.image, 4), 100.0f);
}

TEST(ImageTex, TheSizesSeenInScenes) {
    for (const auto& [w, h] : {std::pair{128, 128}, {256, 256}, {360, 168}}) {
        Bytes b = sizes({w, h});
        b.zeros(static_cast<std::size_t>(w * h) * 16);
        const auto result = decode_image("a.tex", b.str());
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(result.image->width, w);
        EXPECT_EQ(result.image->height, h);
        EXPECT_EQ(result.image->type, PixelType::f16);
    }
    Bytes b = sizes({32, 32, 32});
    b.zeros(32 * 32 * 32 * 16);
    EXPECT_EQ(decode_image("a.tex", b.str()).image->depth, 32);
}

TEST(ImageTex, JunkIsExplained) {
    for (const std::string& junk : {std::string("\x01\x02\x03"), std::string("\x40\0\0\0\x40\0\0\0", 8)}) {
        const auto result = decode_image("a.tex", junk);
        EXPECT_FALSE(result.image);
        ASSERT_EQ(result.issues.size(), 1u);
        EXPECT_EQ(result.issues[0].code, "image-unreadable");
        EXPECT_NE(result.issues[0].message.find(std::to_string(junk.size()) + " bytes"), std::string::npos);
        EXPECT_FALSE(result.issues[0].help.empty());
    }
}

// 20 bytes that start with 1 and 3: one texel of floats, or 1 x 3 texels of bytes.
TEST(ImageTex, AmbiguousSizesAreAnError) {
    Bytes b = sizes({1, 3});
    b.zeros(12);
    const auto result = decode_image("a.tex", b.str());
    EXPECT_FALSE(result.image);
    EXPECT_TRUE(has_issue(result, "image-ambiguous")) << describe(result);
}

TEST(ImageTex, EveryOtherLengthIsRefused) {
    Bytes b = sizes({4, 4});
    b.zeros(4 * 4 * 4);
    const std::string& whole = b.str();
    ASSERT_TRUE(decode_image("a.tex", whole).image);
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const bool a_row = n == 4 + 4 * 4 || n == 4 + 4 * 16;  // one size, then 4 texels: that is a whole file
        EXPECT_EQ(decode_image("a.tex", std::string_view(whole).substr(0, n)).image.has_value(), a_row) << n;
    }
    EXPECT_FALSE(decode_image("a.tex", whole + "x").image);
}

TEST(ImageTex, NegativeAndHugeSizesAreRefused) {
    for (const std::int32_t side : {-1, 0, 1'000'000, std::numeric_limits<std::int32_t>::max()}) {
        Bytes b = sizes({side, side, side});
        b.zeros(64);
        EXPECT_FALSE(decode_image("a.tex", b.str()).image) << side;
    }
    ImageLimits small;
    small.side = 4;
    Bytes b = sizes({5});
    b.zeros(20);
    EXPECT_TRUE(has_issue(decode_image("a.tex", b.str(), small), "image-too-large"));
}

TEST(ImageTex, IsKnownByItsSizeUnderAnyName) {
    Bytes b = sizes({4, 4});
    b.zeros(4 * 4 * 4);
    const auto result = decode_image("noise", b.str());
    ASSERT_TRUE(result.image) << describe(result);
    const auto header = read_header(b.str(), b.size());
    ASSERT_TRUE(header);
    EXPECT_EQ(header->format, "tex");
}

}  // namespace
}  // namespace snell::content
