// Bitmaps of every kind, put together byte by byte from known pixels.
#include "tests/image/help.h"

namespace snell::content {
namespace {

struct Kind {
    std::uint32_t header = 40, bits = 24, compression = 0, used = 0;
    std::int32_t width = 3, height = 2;
};

// File and information header; `between` are masks and palette, then the pixels.
std::string bmp(const Kind& kind, const Bytes& between, const Bytes& pixels, std::array<std::uint32_t, 4> masks = {}) {
    Bytes b;
    const auto at = static_cast<std::uint32_t>(14 + kind.header + between.size());
    b.text("BM").u32(at + static_cast<std::uint32_t>(pixels.size())).u32(0).u32(at).u32(kind.header);
    if (kind.header == 12) {
        b.u16(static_cast<std::uint32_t>(kind.width))
            .u16(static_cast<std::uint32_t>(kind.height))
            .u16(1)
            .u16(kind.bits);
    } else {
        b.i32(kind.width).i32(kind.height).u16(1).u16(kind.bits).u32(kind.compression).u32(0).u32(2835).u32(2835);
        b.u32(kind.used).u32(0);
        if (kind.header >= 52) b.u32(masks[0]).u32(masks[1]).u32(masks[2]);
        if (kind.header >= 56) b.u32(masks[3]);
        if (kind.header > 56) b.zeros(kind.header - 56);
    }
    return b.text(between.str()).text(pixels.str()).str();
}

// The six texels of the 3 x 2 test picture, top row first.
constexpr Texel red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255};
constexpr Texel white{255, 255, 255, 255}, black{0, 0, 0, 255}, odd{10, 20, 30, 255};
constexpr std::array<Texel, 6> top_first{red, green, blue, white, black, odd};
constexpr std::array<Texel, 6> bottom_first{white, black, odd, red, green, blue};

void expect_picture(const ImageResult& result) {
    ASSERT_TRUE(result.image) << describe(result);
    ASSERT_EQ(result.image->width, 3);
    ASSERT_EQ(result.image->height, 2);
    EXPECT_FALSE(result.image->bottom_first);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(texel(*result.image, i % 3, i / 3), top_first[static_cast<std::size_t>(i)]) << i;
}

Bytes rgb24(const std::array<Texel, 6>& texels, bool pad_last = true) {
    Bytes b;
    for (std::size_t i = 0; i < 6; ++i) {
        b.u8(static_cast<std::uint32_t>(texels[i][2]))
            .u8(static_cast<std::uint32_t>(texels[i][1]))
            .u8(static_cast<std::uint32_t>(texels[i][0]));
        if (i == 2 || (i == 5 && pad_last)) b.zeros(3);
    }
    return b;
}

Bytes words32(const std::array<Texel, 6>& texels, std::array<int, 4> shift, bool alpha) {
    Bytes b;
    for (const Texel& t : texels) {
        std::uint32_t word = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            if (c < 3 || alpha) word |= static_cast<std::uint32_t>(t[c]) << shift[c];
        }
        b.u32(word);
    }
    return b;
}

Bytes palette(std::size_t entry_bytes) {
    Bytes b;
    for (const Texel& t : {black, white, red, green, blue, odd}) {
        b.u8(static_cast<std::uint32_t>(t[2]))
            .u8(static_cast<std::uint32_t>(t[1]))
            .u8(static_cast<std::uint32_t>(t[0]));
        if (entry_bytes == 4) b.u8(0);
    }
    return b;
}

TEST(ImageBmp, TwentyFourBitsInEveryHeader) {
    for (const std::uint32_t header : {12u, 40u, 52u, 56u, 64u, 108u, 124u}) {
        SCOPED_TRACE(header);
        Kind kind;
        kind.header = header;
        const auto result = decode_image("a.bmp", bmp(kind, {}, rgb24(bottom_first)));
        expect_picture(result);
        EXPECT_TRUE(result.issues.empty()) << describe(result);
    }
}

TEST(ImageBmp, NegativeHeightIsTopDown) {
    Kind kind;
    kind.height = -2;
    expect_picture(decode_image("a.bmp", bmp(kind, {}, rgb24(top_first))));
}

TEST(ImageBmp, PaddingOfTheLastRowMayBeMissing) {
    const auto result = decode_image("a.bmp", bmp({}, {}, rgb24(bottom_first, false)));
    expect_picture(result);
    EXPECT_TRUE(result.issues.empty()) << describe(result);
}

TEST(ImageBmp, OneRowOfEveryWidth) {
    for (int width = 1; width <= 9; ++width) {
        for (const bool padded : {true, false}) {
            Kind kind;
            kind.width = width;
            kind.height = 1;
            Bytes pixels;
            for (int x = 0; x < width; ++x) pixels.u8(static_cast<std::uint32_t>(x)).u8(100).u8(200);
            if (padded) pixels.zeros((4 - pixels.size() % 4) % 4);
            const auto result = decode_image("a.bmp", bmp(kind, {}, pixels));
            ASSERT_TRUE(result.image) << describe(result);
            EXPECT_TRUE(result.issues.empty()) << width << describe(result);
            EXPECT_EQ(texel(*result.image, width - 1, 0), (Texel{200, 100, width - 1, 255}));
        }
    }
}

TEST(ImageBmp, ThirtyTwoBitsWithoutAlphaAreOpaque) {
    Kind kind;
    kind.bits = 32;
    expect_picture(decode_image("a.bmp", bmp(kind, {}, words32(bottom_first, {16, 8, 0, 24}, false))));
}

TEST(ImageBmp, ThirtyTwoBitsWithAlphaKeepIt) {
    Kind kind;
    kind.bits = 32;
    auto texels = bottom_first;
    texels[0][3] = 7;
    const auto result = decode_image("a.bmp", bmp(kind, {}, words32(texels, {16, 8, 0, 24}, true)));
    ASSERT_TRUE(result.image);
    EXPECT_EQ(texel(*result.image, 0, 1), (Texel{255, 255, 255, 7}));
    EXPECT_EQ(texel(*result.image, 0, 0), red);
}

TEST(ImageBmp, BitFieldsInsideAndBehindTheHeader) {
    Kind kind;
    kind.bits = 32;
    kind.compression = 3;
    const std::array<int, 4> shift{0, 8, 16, 24};
    const std::array<std::uint32_t, 4> masks{0xff, 0xff00, 0xff0000, 0xff000000};
    for (const std::uint32_t header : {56u, 108u, 124u}) {
        kind.header = header;
        expect_picture(decode_image("a.bmp", bmp(kind, {}, words32(bottom_first, shift, true), masks)));
    }
    kind.header = 40;
    Bytes behind;
    behind.u32(masks[0]).u32(masks[1]).u32(masks[2]);
    expect_picture(decode_image("a.bmp", bmp(kind, behind, words32(bottom_first, shift, false))));
}

TEST(ImageBmp, SixteenBitsScaleToTheFullRange) {
    Kind kind;
    kind.bits = 16;
    kind.width = 2;
    kind.height = 1;
    Bytes five;
    five.u16(0x7fff).u16(0x7c00 | 16 << 5);  // white; red with half green
    auto result = decode_image("a.bmp", bmp(kind, {}, five));
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_EQ(texel(*result.image, 0, 0), white);
    EXPECT_EQ(texel(*result.image, 1, 0), (Texel{255, 132, 0, 255}));  // 16/31 of 255

    kind.compression = 3;  // 5 6 5
    Bytes masks, six;
    masks.u32(0xf800).u32(0x07e0).u32(0x001f);
    six.u16(0xffff).u16(32 << 5);
    result = decode_image("a.bmp", bmp(kind, masks, six));
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_EQ(texel(*result.image, 0, 0), white);
    EXPECT_EQ(texel(*result.image, 1, 0), (Texel{0, 130, 0, 255}));  // 32/63 of 255
}

TEST(ImageBmp, PalettesOfEightAndFourBits) {
    // Indices into `palette`: bottom row white black odd, top row red green blue.
    Kind kind;
    kind.used = 6;
    kind.bits = 8;
    Bytes eight;
    eight.u8(1).u8(0).u8(5).u8(0).u8(2).u8(3).u8(4).u8(0);
    expect_picture(decode_image("a.bmp", bmp(kind, palette(4), eight)));
    kind.bits = 4;
    Bytes four;
    four.u8(0x10).u8(0x50).u16(0).u8(0x23).u8(0x40).u16(0);
    expect_picture(decode_image("a.bmp", bmp(kind, palette(4), four)));
}

TEST(ImageBmp, OldPalettesHaveThreeBytesAnEntry) {
    Kind kind;
    kind.header = 12;
    kind.bits = 8;
    Bytes entries = palette(3), pixels;
    entries.zeros((256 - 6) * 3);
    pixels.u8(1).u8(0).u8(5).u8(0).u8(2).u8(3).u8(4).u8(0);
    expect_picture(decode_image("a.bmp", bmp(kind, entries, pixels)));
}

TEST(ImageBmp, OneBit) {
    Kind kind;
    kind.bits = 1;
    kind.width = 10;
    kind.height = 1;
    Bytes colors, pixels;
    colors.u32(0).u32(0xffffff);
    pixels.u8(0b10110000).u8(0b01000000).u16(0);
    const auto result = decode_image("a.bmp", bmp(kind, colors, pixels));
    ASSERT_TRUE(result.image) << describe(result);
    const std::string expected = "1011000001";
    for (int x = 0; x < 10; ++x) {
        EXPECT_EQ(texel(*result.image, x, 0), expected[static_cast<std::size_t>(x)] == '1' ? white : black) << x;
    }
}

TEST(ImageBmp, RunLengthsOfEightBits) {
    Kind kind;
    kind.bits = 8;
    kind.compression = 1;
    kind.used = 6;
    Bytes pixels;
    pixels.u8(0).u8(3).u8(1).u8(0).u8(5).u8(0);  // literal: white black odd, and a byte of padding
    pixels.u8(0).u8(0);                          // end of row
    pixels.u8(1).u8(2).u8(1).u8(3).u8(1).u8(4);  // runs of one: red, green, blue
    pixels.u8(0).u8(1);
    const auto result = decode_image("a.bmp", bmp(kind, palette(4), pixels));
    expect_picture(result);
    EXPECT_TRUE(result.issues.empty()) << describe(result);
}

TEST(ImageBmp, RunLengthsSkipAndOverrunSafely) {
    Kind kind;
    kind.bits = 8;
    kind.compression = 1;
    kind.used = 6;
    Bytes pixels;
    pixels.u8(0).u8(2).u8(2).u8(1);  // two to the right, one up
    pixels.u8(200).u8(4);            // a run far beyond the end of the row
    pixels.u8(0).u8(1);
    const auto result = decode_image("a.bmp", bmp(kind, palette(4), pixels));
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_EQ(texel(*result.image, 2, 0), blue);
    EXPECT_EQ(texel(*result.image, 1, 0), black);  // the palette's first colour where nothing was drawn
    EXPECT_EQ(texel(*result.image, 2, 1), black);
}

TEST(ImageBmp, RunLengthsOfFourBitsAlternate) {
    Kind kind;
    kind.bits = 4;
    kind.compression = 2;
    kind.used = 6;
    Bytes pixels;
    pixels.u8(2).u8(0x10).u8(1).u8(0x50).u8(0).u8(0);  // white black, odd
    pixels.u8(0).u8(3).u8(0x23).u8(0x40).u8(0).u8(1);  // literal red green blue, already a multiple of two bytes
    expect_picture(decode_image("a.bmp", bmp(kind, palette(4), pixels)));
}

TEST(ImageBmp, WrongOffsetOfThePixelsIsMended) {
    std::string file = bmp({}, {}, rgb24(bottom_first));
    for (const char wrong : {'\0', '\x05'}) {
        file[10] = wrong;
        expect_picture(decode_image("a.bmp", file));
    }
    file[13] = '\x7f';
    expect_picture(decode_image("a.bmp", file));
}

TEST(ImageBmp, TruncatedFilesGiveWhatIsThere) {
    std::string file = bmp({}, {}, rgb24(bottom_first));
    file.resize(54 + 12 + 3);  // the bottom row and one texel of the top row
    const auto result = decode_image("a.bmp", file);
    ASSERT_TRUE(result.image);
    EXPECT_TRUE(has_issue(result, "image-truncated"));
    EXPECT_EQ(texel(*result.image, 2, 1), odd);
    EXPECT_EQ(texel(*result.image, 0, 0), red);
    EXPECT_EQ(texel(*result.image, 1, 0), (Texel{0, 0, 0, 0}));
}

TEST(ImageBmp, EveryPrefixIsSafe) {
    Kind rle;
    rle.bits = 8;
    rle.compression = 1;
    rle.used = 6;
    Bytes runs;
    runs.u8(0).u8(3).u8(1).u8(0).u8(5).u8(0).u8(0).u8(0).u8(3).u8(2).u8(0).u8(1);
    Kind fields;
    fields.header = 124;
    fields.bits = 32;
    fields.compression = 3;
    const std::string files[] = {
        bmp({}, {}, rgb24(bottom_first)), bmp(rle, palette(4), runs),
        bmp(fields, {}, words32(bottom_first, {0, 8, 16, 24}, true), {0xff, 0xff00, 0xff0000, 0xff000000})};
    for (const std::string& file : files) {
        ASSERT_TRUE(decode_image("a.bmp", file).issues.empty());
        for (std::size_t n = 0; n < file.size(); ++n) {
            const auto result = decode_image("a.bmp", std::string_view(file).substr(0, n));
            EXPECT_TRUE(result.image || !result.issues.empty()) << n;
        }
    }
}

TEST(ImageBmp, EveryCorruptByteIsSafe) {
    Kind kind;
    kind.bits = 8;
    kind.compression = 1;
    kind.used = 6;
    Bytes runs;
    runs.u8(0).u8(3).u8(1).u8(0).u8(5).u8(0).u8(0).u8(0).u8(3).u8(2).u8(0).u8(1);
    ImageLimits limits;
    limits.bytes = 1 << 20;
    for (const std::string& whole : {bmp(kind, palette(4), runs), bmp({}, {}, rgb24(bottom_first))}) {
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const int value : {0, 1, 2, 127, 128, 255}) {
                std::string file = whole;
                file[at] = static_cast<char>(value);
                const auto result = decode_image("a.bmp", file, limits);
                EXPECT_TRUE(result.image || !result.issues.empty()) << at;
            }
        }
    }
}

TEST(ImageBmp, ImpossibleHeadersAreNamed) {
    Kind kind;
    kind.bits = 13;
    auto result = decode_image("a.bmp", bmp(kind, {}, rgb24(bottom_first)));
    EXPECT_FALSE(result.image);
    EXPECT_NE(describe(result).find("13 bits"), std::string::npos) << describe(result);
    kind = {};
    kind.compression = 4;
    result = decode_image("a.bmp", bmp(kind, {}, rgb24(bottom_first)));
    EXPECT_FALSE(result.image);
    EXPECT_NE(describe(result).find("compression"), std::string::npos) << describe(result);
    kind = {};
    kind.width = 0;
    EXPECT_TRUE(has_issue(decode_image("a.bmp", bmp(kind, {}, {})), "image-unreadable"));
    kind = {};
    kind.height = std::numeric_limits<std::int32_t>::min();
    EXPECT_TRUE(has_issue(decode_image("a.bmp", bmp(kind, {}, rgb24(bottom_first))), "image-too-large"));
}

TEST(ImageBmp, HugeSizesAreRefusedFromTheHeader) {
    Kind kind;
    kind.width = kind.height = 1'000'000;
    const auto result = decode_image("a.bmp", bmp(kind, {}, rgb24(bottom_first)));
    EXPECT_FALSE(result.image);
    EXPECT_TRUE(has_issue(result, "image-too-large")) << describe(result);
    const auto header = read_header(bmp(kind, {}, {}), 54);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->width, 1'000'000);
}

}  // namespace
}  // namespace snell::content
