// PNG: written by us and read back, and files of every kind made through libpng.
#include <png.h>

#include "tests/image/help.h"

namespace snell::content {
namespace {

struct PngKind {
    int color = PNG_COLOR_TYPE_RGB, depth = 8;
    bool interlaced = false, transparency = false;
};

void append(png_structp png, png_bytep data, png_size_t n) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), n);
}

// `rows` as PNG stores them: big-endian, packed bits.
std::string encode(const PngKind& kind, int width, int height, std::string rows) {
    std::string out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &out, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kind.depth, kind.color,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const std::array<png_color, 4> palette{{{10, 20, 30}, {40, 50, 60}, {70, 80, 90}, {255, 0, 128}}};
    if (kind.color == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), 4);
    const std::array<png_byte, 2> alphas{0, 77};
    if (kind.transparency && kind.color == PNG_COLOR_TYPE_PALETTE) png_set_tRNS(png, info, alphas.data(), 2, nullptr);
    png_set_gAMA(png, info, 1.0);  // to be left alone
    png_write_info(png, info);
    std::vector<png_bytep> pointers;
    const std::size_t row = rows.size() / static_cast<std::size_t>(height);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        pointers.push_back(reinterpret_cast<png_bytep>(rows.data() + y * row));
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return out;
}

std::string counting(std::size_t n) {
    std::string s;
    for (std::size_t i = 0; i < n; ++i) s += static_cast<char>(i * 37 + 11);
    return s;
}

TEST(ImagePng, EightBitsOfEveryChannelCount) {
    const std::pair<int, int> kinds[] = {{PNG_COLOR_TYPE_GRAY, 1},
                                         {PNG_COLOR_TYPE_GRAY_ALPHA, 2},
                                         {PNG_COLOR_TYPE_RGB, 3},
                                         {PNG_COLOR_TYPE_RGB_ALPHA, 4}};
    for (const auto& [color, channels] : kinds) {
        for (const bool interlaced : {false, true}) {
            const std::string rows = counting(static_cast<std::size_t>(9 * 7 * channels));
            const auto result = decode_image("a.png", encode({color, 8, interlaced}, 9, 7, rows));
            ASSERT_TRUE(result.image) << describe(result);
            EXPECT_TRUE(result.issues.empty());
            EXPECT_EQ(result.image->channels, channels);
            EXPECT_EQ(result.image->type, PixelType::u8);
            EXPECT_EQ(std::memcmp(result.image->pixels.data(), rows.data(), rows.size()), 0) << color << interlaced;
        }
    }
}

TEST(ImagePng, SixteenBitsBecomeHalfs) {
    const std::string rows("\x00\x00\x80\x00\xff\xff\x00\x01", 8);  // 0, 32768, 65535, 1
    const auto result = decode_image("a.png", encode({PNG_COLOR_TYPE_GRAY, 16}, 4, 1, rows));
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_EQ(result.image->type, PixelType::f16);
    EXPECT_EQ(value_at(*result.image, 0), 0.0f);
    EXPECT_NEAR(value_at(*result.image, 1), 32768 / 65535.0, 1e-3);
    EXPECT_EQ(value_at(*result.image, 2), 1.0f);
    EXPECT_NEAR(value_at(*result.image, 3), 1 / 65535.0, 1e-8);
}

TEST(ImagePng, PaletteBitsAndTransparency) {
    for (const bool interlaced : {false, true}) {
        const auto result = decode_image("a.png", encode({PNG_COLOR_TYPE_PALETTE, 2, interlaced, true}, 4, 1, "\x1b"));
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(texel(*result.image, 0, 0), (Texel{10, 20, 30, 0}));
        EXPECT_EQ(texel(*result.image, 1, 0), (Texel{40, 50, 60, 77}));
        EXPECT_EQ(texel(*result.image, 2, 0), (Texel{70, 80, 90, 255}));
        EXPECT_EQ(texel(*result.image, 3, 0), (Texel{255, 0, 128, 255}));
    }
    const auto opaque = decode_image("a.png", encode({PNG_COLOR_TYPE_PALETTE, 8}, 2, 1, std::string("\x03\x00", 2)));
    ASSERT_TRUE(opaque.image);
    EXPECT_EQ(opaque.image->channels, 3);
    EXPECT_EQ(texel(*opaque.image, 0, 0), (Texel{255, 0, 128, 255}));
}

TEST(ImagePng, OneBitGreySpreadsToTheFullRange) {
    const auto result = decode_image("a.png", encode({PNG_COLOR_TYPE_GRAY, 1}, 8, 1, "\xb1"));
    ASSERT_TRUE(result.image);
    const std::string expected = "10110001";
    for (int x = 0; x < 8; ++x)
        EXPECT_EQ(texel(*result.image, x, 0)[0], expected[static_cast<std::size_t>(x)] == '1' ? 255 : 0);
}

TEST(ImagePng, EveryPrefixAndCorruptByteIsSafe) {
    for (const bool interlaced : {false, true}) {
        const std::string whole = encode({PNG_COLOR_TYPE_RGB, 8, interlaced}, 16, 16, counting(16 * 16 * 3));
        for (std::size_t n = 0; n < whole.size(); ++n) {
            const auto result = decode_image("a.png", std::string_view(whole).substr(0, n));
            EXPECT_TRUE(result.image || !result.issues.empty()) << n;
            std::string corrupt = whole;
            corrupt[n] = static_cast<char>(corrupt[n] ^ 0x55);
            const auto other = decode_image("a.png", corrupt);
            EXPECT_TRUE(other.image || !other.issues.empty()) << n;
        }
    }
}

TEST(ImagePng, TruncatedFilesGiveTheirFirstRows) {
    // Random-looking rows hardly compress, so that half the file is about half the rows.
    std::string rows;
    std::uint32_t seed = 1;
    for (int i = 0; i < 64 * 64 * 3; ++i) rows += static_cast<char>((seed = seed * 1664525u + 1013904223u) >> 24);
    const std::string whole = encode({PNG_COLOR_TYPE_RGB, 8}, 64, 64, rows);
    const auto result = decode_image("a.png", std::string_view(whole).substr(0, whole.size() / 2));
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_TRUE(has_issue(result, "image-truncated"));
    EXPECT_EQ(std::memcmp(result.image->pixels.data(), rows.data(), std::size_t{16} * 64 * 3), 0);
}

TEST(ImagePng, HugeSizesAreRefusedFromTheHeader) {
    std::string file = encode({PNG_COLOR_TYPE_RGB, 8}, 4, 4, counting(48));
    file.replace(16, 8, std::string("\x00\x0f\x42\x40\x00\x0f\x42\x40", 8));  // 1,000,000 twice
    const auto result = decode_image("a.png", file);
    EXPECT_FALSE(result.image);
    EXPECT_TRUE(has_issue(result, "image-too-large")) << describe(result);
    const auto header = read_header(file, file.size());
    ASSERT_TRUE(header);
    EXPECT_EQ(header->height, 1'000'000);
}

class ImagePngFile : public ScratchFolder {};

TEST_F(ImagePngFile, WritesEveryChannelCountExactly) {
    for (int channels = 1; channels <= 4; ++channels) {
        const Image image = paint(17, 5, channels, PixelType::u8,
                                  [](int x, int y, int c) { return ((x * 13 + y * 57 + c * 29) % 256) / 255.0; });
        ASSERT_EQ(write_image(file("a.png"), image), "");
        const auto result = read_file(file("a.png"));
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(result.image->channels, channels);
        EXPECT_EQ(result.image->pixels, image.pixels);
        EXPECT_EQ(entries(), 1u);
    }
}

TEST_F(ImagePngFile, FloatsAreClampedAndRounded) {
    const std::array<float, 8> values{-1.0f, 0.0f, 0.5f, 1.0f, 7.0f, std::nanf(""), 100.4f / 255, 100.6f / 255};
    for (const PixelType type : {PixelType::f32, PixelType::f16}) {
        const Image image = paint(8, 1, 1, type, [&](int x, int, int) { return values[static_cast<std::size_t>(x)]; });
        ASSERT_EQ(write_image(file("a.png"), image), "");
        const auto result = read_file(file("a.png"));
        const std::array<int, 8> expected{0, 0, 128, 255, 255, 0, 100, 101};
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(texel(*result.image, x, 0)[0], expected[static_cast<std::size_t>(x)]) << x;
    }
}

TEST_F(ImagePngFile, RowsInTextureOrderAreTurned) {
    Image image = paint(1, 2, 1, PixelType::u8, [](int, int y, int) { return y; });
    image.bottom_first = true;
    ASSERT_EQ(write_image(file("a.png"), image), "");
    EXPECT_EQ(texel(*read_file(file("a.png")).image, 0, 0)[0], 255);
}

}  // namespace
}  // namespace snell::content
