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
    EXPECT_TRUE(result.issues.empty()) << describe(result);
    ASSERT_EQ(result.image->width, 3);
    ASSERT_EQ(result.image->height, 2);
    EXPECT_FALSE(result.image->bottom_first);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(texel(*result.image, i % 3, i / 3), top_first[static_cast<std::size_t>(i)]) << i;
}

// A texel as the file has it: blue first.
Bytes& bgr(Bytes& b, const Texel& t) {
    for (const std::size_t c : {2u, 1u, 0u}) b.u8(static_cast<std::uint32_t>(t[c]));
    return b;
}

Bytes rgb24(const std::array<Texel, 6>& texels, bool pad_last = true) {
    Bytes b;
    for (std::size_t i = 0; i < 6; ++i) {
        bgr(b, texels[i]);
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
    for (const Texel& t : {black, white, red, green, blue, odd}) bgr(b, t).zeros(entry_bytes - 3);
    return b;
}

constexpr Kind fields{.bits = 32, .compression = 3}, runs8{.bits = 8, .compression = 1, .used = 6};
constexpr std::array<int, 4> red_lowest{0, 8, 16, 24};
constexpr std::array<std::uint32_t, 4> masks{0xff, 0xff00, 0xff0000, 0xff000000};

Kind with_header(std::uint32_t header, Kind kind = {}) {
    kind.header = header;
    return kind;
}

ImageResult decode(const Kind& kind, const Bytes& between, const Bytes& pixels) {
    return decode_image("a.bmp", bmp(kind, between, pixels, masks));
}

// Indices into `palette`: bottom row white black odd, top row red green blue.
TEST(ImageBmp, EveryKindGivesTheSamePicture) {
    struct Row {
        std::string name;
        Kind kind;
        Bytes between, pixels;
    };
    const Bytes indices = Bytes().list({1, 0, 5, 0, 2, 3, 4, 0});
    std::vector<Row> rows = {
        {"rows from the top", {.height = -2}, {}, rgb24(top_first)},
        {"no padding behind the last row", {}, {}, rgb24(bottom_first, false)},
        {"32 bits without alpha", {.bits = 32}, {}, words32(bottom_first, {16, 8, 0, 24}, false)},
        {"masks behind the header", fields, Bytes().u32(masks[0]).u32(masks[1]).u32(masks[2]),
         words32(bottom_first, red_lowest, false)},
        {"palette of 8 bits", {.bits = 8, .used = 6}, palette(4), indices},
        {"palette of 4 bits", {.bits = 4, .used = 6}, palette(4), Bytes().list({0x10, 0x50, 0, 0, 0x23, 0x40, 0, 0})},
        {"old palette, three bytes an entry",
         {.header = 12, .bits = 8},
         Bytes(palette(3)).zeros((256 - 6) * 3),
         indices},
        // A literal and a byte of padding, the end of the row, three runs of one, the end.
        {"runs of 8 bits", runs8, palette(4), Bytes().list({0, 3, 1, 0, 5, 0, 0, 0, 1, 2, 1, 3, 1, 4, 0, 1})},
        // Two runs, whose nibbles alternate, and a literal that is already a multiple of two bytes.
        {"runs of 4 bits",
         {.bits = 4, .compression = 2, .used = 6},
         palette(4),
         Bytes().list({2, 0x10, 1, 0x50, 0, 0, 0, 3, 0x23, 0x40, 0, 1})},
    };
    for (const std::uint32_t header : {12u, 40u, 52u, 56u, 64u, 108u, 124u})
        rows.push_back({"24 bits, header " + std::to_string(header), with_header(header), {}, rgb24(bottom_first)});
    for (const std::uint32_t header : {56u, 108u, 124u})
        rows.push_back({"masks in the header " + std::to_string(header),
                        with_header(header, fields),
                        {},
                        words32(bottom_first, red_lowest, true)});
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        expect_picture(decode(row.kind, row.between, row.pixels));
    }
}

TEST(ImageBmp, OneRowOfEveryWidth) {
    for (int width = 1; width <= 9; ++width) {
        for (const bool padded : {true, false}) {
            Bytes pixels;
            for (int x = 0; x < width; ++x) pixels.u8(static_cast<std::uint32_t>(x)).u8(100).u8(200);
            if (padded) pixels.zeros((4 - pixels.size() % 4) % 4);
            const auto result = decode({.width = width, .height = 1}, {}, pixels);
            ASSERT_TRUE(result.image) << describe(result);
            EXPECT_TRUE(result.issues.empty()) << width << describe(result);
            EXPECT_EQ(texel(*result.image, width - 1, 0), (Texel{200, 100, width - 1, 255}));
        }
    }
}

// Texels that the six of the test picture do not have: alpha, 16 bits, one bit, and what runs leave out.
TEST(ImageBmp, TexelsAreWhatTheBitsSay) {
    auto alpha = bottom_first;
    alpha[0][3] = 7;
    struct Expected {
        int x, y;
        Texel texel;
    };
    struct Row {
        const char* name;
        Kind kind;
        Bytes between, pixels;
        std::vector<Expected> expected;
    };
    const Row rows[] = {
        {"32 bits with alpha",
         {.bits = 32},
         {},
         words32(alpha, {16, 8, 0, 24}, true),
         {{0, 1, {255, 255, 255, 7}}, {0, 0, red}}},
        {"5 5 5: white, and red with 16/31 of green",
         {.bits = 16, .width = 2, .height = 1},
         {},
         Bytes().u16(0x7fff).u16(0x7c00 | 16 << 5),
         {{0, 0, white}, {1, 0, {255, 132, 0, 255}}}},
        {"5 6 5: white, and 32/63 of green",
         {.bits = 16, .compression = 3, .width = 2, .height = 1},
         Bytes().u32(0xf800).u32(0x07e0).u32(0x001f),
         Bytes().u16(0xffff).u16(32 << 5),
         {{0, 0, white}, {1, 0, {0, 130, 0, 255}}}},
        {"one bit",
         {.bits = 1, .width = 10, .height = 1},
         Bytes().u32(0).u32(0xffffff),
         Bytes().list({0b10110000, 0b01000000, 0, 0}),
         {{0, 0, white}, {1, 0, black}, {2, 0, white}, {3, 0, white}, {4, 0, black}, {8, 0, black}, {9, 0, white}}},
        // Two to the right and one up, then a run far beyond the end of the row. The rest has the palette's first
        // colour.
        {"runs that skip and overrun",
         runs8,
         palette(4),
         Bytes().list({0, 2, 2, 1, 200, 4, 0, 1}),
         {{2, 0, blue}, {1, 0, black}, {2, 1, black}}},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        const auto result = decode(row.kind, row.between, row.pixels);
        ASSERT_TRUE(result.image) << describe(result);
        for (const auto& [x, y, expected] : row.expected)
            EXPECT_EQ(texel(*result.image, x, y), expected) << x << ' ' << y;
    }
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

// A whole file of each way to store pixels.
std::array<std::string, 3> whole_files() {
    const Bytes runs = Bytes().list({0, 3, 1, 0, 5, 0, 0, 0, 3, 2, 0, 1});
    return {bmp({}, {}, rgb24(bottom_first)), bmp(runs8, palette(4), runs),
            bmp(with_header(124, fields), {}, words32(bottom_first, red_lowest, true), masks)};
}

TEST(ImageBmp, EveryPrefixIsSafe) {
    for (const std::string& file : whole_files()) {
        ASSERT_TRUE(decode_image("a.bmp", file).issues.empty());
        for (std::size_t n = 0; n < file.size(); ++n) {
            const auto result = decode_image("a.bmp", std::string_view(file).substr(0, n));
            EXPECT_TRUE(result.image || !result.issues.empty()) << n;
        }
    }
}

TEST(ImageBmp, EveryCorruptByteIsSafe) {
    ImageLimits limits;
    limits.bytes = 1 << 20;
    for (const std::string& whole : whole_files()) {
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
    struct Row {
        Kind kind;
        const char* said;  // a part of the code or of the message
    };
    for (const auto& [kind, said] : {Row{{.bits = 13}, "13 bits"},
                                     {{.compression = 4}, "compression"},
                                     {{.width = 0}, "[image-unreadable]"},
                                     {{.height = std::numeric_limits<std::int32_t>::min()}, "[image-too-large]"},
                                     {{.width = 1'000'000, .height = 1'000'000}, "[image-too-large]"}}) {
        const auto result = decode(kind, {}, rgb24(bottom_first));
        EXPECT_FALSE(result.image) << said;
        EXPECT_NE(describe(result).find(said), std::string::npos) << said << ": " << describe(result);
    }
    const auto header = read_header(bmp({.width = 1'000'000, .height = 1'000'000}, {}, {}), 54);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->width, 1'000'000);
}

// ---- glman's raw textures.

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
