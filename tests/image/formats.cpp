// What goes through the OpenImageIO module, and what decides which way a file goes.
#include <unistd.h>

#include "src/content/image/formats.h"
#include "src/content/image/image.h"
#include "tests/image/help.h"
#include "tests/pattern.h"

namespace snell::content {
namespace {

class ImageFormats : public ScratchFolder {};

// Smooth, so that lossy formats stay close; its four corners differ, so that a turned picture does not.
double smooth(int x, int y, int c) {
    const double u = x / 31.0, v = y / 23.0;
    const std::array<double, 4> channel{.1 + .8 * u, .1 + .8 * v, .9 - .4 * u - .4 * v, 1};
    return channel[static_cast<std::size_t>(c)];
}

TEST_F(ImageFormats, EightBitFormatsRoundTrip) {
    struct Format {
        const char* extension;
        double tolerance;
    };
    const Image image = paint(32, 24, 4, PixelType::u8, smooth);
    const Image rgb = paint(32, 24, 3, PixelType::u8, smooth);
    for (const auto& [extension, tolerance] :
         {Format{"jpg", .05}, {"tif", 0}, {"tga", 0}, {"bmp", 0}, {"ppm", 0}, {"webp", .05}, {"gif", .1}}) {
        SCOPED_TRACE(extension);
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const auto result = read_file(path);
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_TRUE(result.issues.empty()) << describe(result);
        EXPECT_EQ(result.image->type, PixelType::u8);
        const auto d = compare(to_rgba(*result.image), to_rgba(rgb));
        ASSERT_TRUE(d);
        EXPECT_LE(d->max, tolerance);
    }
}

TEST_F(ImageFormats, FloatFormatsRoundTrip) {
    const auto bright = [](int x, int y, int c) { return smooth(x, y, c) * (x == 3 ? 900 : 1); };
    const Image image = paint(32, 24, 3, PixelType::f32, bright);
    for (const auto& [extension, relative] : {std::pair{"exr", 1.0 / 2048}, {"tif", 1.0 / 2048}, {"hdr", 1.0 / 100}}) {
        SCOPED_TRACE(extension);
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const auto result = read_file(path);
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(result.image->type, PixelType::f16);
        ASSERT_EQ(result.image->channels, 3);
        for (std::size_t i = 0; i < std::size_t{32} * 24 * 3; i += 3) {
            const float largest = std::max({value_at(image, i), value_at(image, i + 1), value_at(image, i + 2)});
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(value_at(*result.image, i + c), value_at(image, i + c),
                            static_cast<double>(largest) * relative);
            }
        }
    }
}

// A texture that declares its file sRGB asks for this. A page has the file decoded, under the same name.
TEST_F(ImageFormats, OnlyFormatsOfLightHoldLight) {
    const Image image = paint(4, 4, 3, PixelType::f32, smooth);
    for (const auto& [extension, light] : {std::pair{"exr", true}, {"hdr", true}, {"tif", false}, {"png", false}}) {
        SCOPED_TRACE(extension);
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const auto result = read_file(path);
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(result.image->light, light);
        const std::vector<std::byte> decoded = decoded_file(*result.image);
        const auto again = decode_image(path, {reinterpret_cast<const char*>(decoded.data()), decoded.size()});
        ASSERT_TRUE(again.image) << describe(again);
        EXPECT_EQ(again.image->light, light);
    }
}

// Floats reach a float format as they are, beyond half's range and precision.
TEST_F(ImageFormats, FloatsAreWrittenUnchanged) {
    const Image image = paint(3, 1, 3, PixelType::f32, [](int x, int, int c) {
        return (x == 0 ? 1e30 : x == 1 ? -.1 : 1 / 3.0) + c;
    });
    ASSERT_EQ(write_image(file("a.exr"), image), "");
    const std::string bytes = bytes_of(file("a.exr"));
    const float third = static_cast<float>(1 / 3.0);
    EXPECT_TRUE(bytes.find("channels") != std::string::npos);
    const auto result = read_file(file("a.exr"));
    ASSERT_TRUE(result.image);
    EXPECT_TRUE(has_issue(result, "image-clamped"));
    EXPECT_EQ(value_at(*result.image, 0), 65504.0f);
    EXPECT_EQ(value_at(*result.image, 6), half_to_float(float_to_half(third)));
}

TEST_F(ImageFormats, NonFiniteTexelsOfAnEnvironmentAreMended) {
    const Image image =
        paint(4, 4, 3, PixelType::f32, [](int x, int y, int) { return x == 1 && y == 1 ? std::nan("") : 2.0; });
    ASSERT_EQ(write_image(file("a.exr"), image), "");
    const auto result = read_file(file("a.exr"));
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_TRUE(has_issue(result, "image-non-finite"));
    for (std::size_t i = 0; i < 48; ++i) EXPECT_EQ(value_at(*result.image, i), 2.0f);
}

TEST_F(ImageFormats, AlphaStaysApartFromColour) {
    const Image image = paint(8, 8, 4, PixelType::u8, [](int x, int, int c) { return c == 3 ? .2 : x / 10.0; });
    for (const char* extension : {"tif", "tga", "png", "bmp"}) {
        SCOPED_TRACE(extension);
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const auto result = read_file(path);
        ASSERT_TRUE(result.image) << describe(result);
        const auto d = compare(image, *result.image);
        ASSERT_TRUE(d);
        EXPECT_EQ(d->max, 0);
    }
}

TEST_F(ImageFormats, GreyStaysGrey) {
    const Image image = paint(8, 4, 1, PixelType::u8, [](int x, int, int) { return x / 7.0; });
    for (const char* extension : {"tif", "png", "jpg"}) {
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const auto result = read_file(path);
        ASSERT_TRUE(result.image);
        EXPECT_EQ(result.image->channels, 1) << extension;
        EXPECT_EQ(texel(to_rgba(*result.image), 7, 3)[1], texel(*result.image, 7, 3)[0]);
    }
}

// The orientation of a photograph: the same JPEG with an EXIF block that says how to turn it.
TEST_F(ImageFormats, PhotographsAreTurnedUpright) {
    ASSERT_EQ(write_image(file("a.jpg"), paint(32, 24, 3, PixelType::u8, smooth)), "");
    const std::string plain = bytes_of(file("a.jpg"));
    const Image upright = *read_file(file("a.jpg")).image;
    // Where each orientation puts the stored picture's top left corner (x, y of the result; 1: right or bottom).
    const std::array<std::pair<int, int>, 9> corner{
        {{0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::uint32_t orientation = 1; orientation <= 8; ++orientation) {
        SCOPED_TRACE(orientation);
        Bytes exif;
        exif.u8(0xff).u8(0xe1).u8(0).u8(34).text("Exif").u16(0).text("II*").u8(0).u32(8);
        exif.u16(1).u16(0x0112).u16(3).u32(1).u16(orientation).u16(0).u32(0);
        put("b.jpg", plain.substr(0, 2) + exif.str() + plain.substr(2));
        const auto result = read_file(file("b.jpg"));
        ASSERT_TRUE(result.image) << describe(result);
        const Image& image = *result.image;
        EXPECT_EQ(image.width, orientation < 5 ? 32 : 24);
        EXPECT_EQ(image.height, orientation < 5 ? 24 : 32);
        const auto [right, bottom] = corner[orientation];
        EXPECT_EQ(texel(image, right ? image.width - 1 : 0, bottom ? image.height - 1 : 0), texel(upright, 0, 0));
        // The corner to the right of it in the stored picture lies along the other axis when turned.
        const bool turned = orientation >= 5;
        const int x = turned ? right : 1 - right, y = turned ? 1 - bottom : bottom;
        EXPECT_EQ(texel(image, x ? image.width - 1 : 0, y ? image.height - 1 : 0), texel(upright, 31, 0));
    }
}

TEST_F(ImageFormats, ContentDecidesBeforeTheName) {
    const Image image = paint(4, 4, 3, PixelType::u8, smooth);
    ASSERT_EQ(write_image(file("a.png"), image), "");
    ASSERT_EQ(write_image(file("a.tif"), image), "");
    for (const char* original : {"a.png", "a.tif"}) {
        put("wall.bmp", bytes_of(file(original)));
        const auto result = read_file(file("wall.bmp"));
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(compare(*result.image, image)->max, 0);
        EXPECT_TRUE(has_issue(result, "image-misnamed"));
    }
}

TEST_F(ImageFormats, WhatIsNoPictureIsNamed) {
    const auto check = [&](std::string_view content, std::string_view expected) {
        put("a.jpg", content);
        const auto result = read_file(file("a.jpg"));
        EXPECT_FALSE(result.image);
        EXPECT_NE(describe(result).find(expected), std::string::npos) << describe(result);
        ASSERT_FALSE(result.issues.empty());
        EXPECT_FALSE(result.issues[0].help.empty());
    };
    check("", "empty");
    check("<!DOCTYPE html><html></html>", "HTML");
    check("version https://git-lfs.github.com/spec/v1\n", "Git LFS");
    check("%PDF-1.4", "PDF");
    check("hello, this is a text", "image: ");
}

TEST_F(ImageFormats, TruncatedAtAnyByteIsSafe) {
    const Image image = paint(8, 6, 3, PixelType::u8, smooth);
    for (const char* extension : {"jpg", "tif", "tga", "exr", "hdr"}) {
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const std::string whole = bytes_of(path);
        const std::size_t step = std::max<std::size_t>(whole.size() / 60, 1);
        for (std::size_t n = 1; n < whole.size(); n += step) {
            put(std::string("b.") + extension, whole.substr(0, n));
            const auto result = read_file(file(std::string("b.") + extension));
            EXPECT_TRUE(result.image || !result.issues.empty()) << extension << n;
        }
    }
}

TEST_F(ImageFormats, LimitsHoldForTheModuleToo) {
    const Image image = paint(32, 8, 3, PixelType::u8, smooth);
    ASSERT_EQ(write_image(file("a.tif"), image), "");
    ImageLimits limits;
    limits.side = 16;
    const auto wide = decode_image(file("a.tif"), bytes_of(file("a.tif")), limits);
    EXPECT_FALSE(wide.image);
    EXPECT_TRUE(has_issue(wide, "image-too-large")) << describe(wide);
    limits = {};
    limits.bytes = 32 * 8 * 3 - 1;
    EXPECT_TRUE(has_issue(decode_image(file("a.tif"), bytes_of(file("a.tif")), limits), "image-too-large"));
    limits.bytes = 32 * 8 * 3;
    EXPECT_TRUE(decode_image(file("a.tif"), bytes_of(file("a.tif")), limits).image);
}

// A Radiance header that claims 10^6 x 10^6 is refused without any attempt to take the memory.
TEST_F(ImageFormats, ClaimsAreNotBelieved) {
    put("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 1000000\n");
    const auto result = read_file(file("a.hdr"));
    EXPECT_FALSE(result.image);
    EXPECT_TRUE(has_issue(result, "image-too-large")) << describe(result);
}

// OpenImageIO takes memory for the whole picture when it opens one of these: a few bytes must not cost gigabytes.
TEST_F(ImageFormats, ClaimsAreNotBelievedByReadersThatTakeMemoryAtOnce) {
    using std::string_literals::operator""s;
    const std::string rest(64, '\0');
    const std::pair<const char*, std::string> pictures[] = {
        {"a.gif", "GIF89a\xff\xff\xff\xff"s},
        {"a.webp", "RIFF\x56\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\xff\xff\xff\xff\xff"s},
        {"a.jp2", "\xff\x4f\xff\x51\0\x2f\0\0\0\x0f\x42\x40\0\x0f\x42\x40"s},
        {"b.jp2", "\0\0\0\x0cjP  \r\n\x87\n....jp2c\xff\x4f\xff\x51\0\x2f\0\0\xff\xff\xff\xff\0\0\0\1"s},
        {"a.heic",
         "\0\0\0\x18"
         "ftypheic\0\0\0\x14ispe\0\0\0\0\0\0\0\x40\0\0\0\x40\0\0\0\x14ispe\0\0\0\0\xff\xff\xff\xff\0\0\0\x40"s},
        {"a.psd", "8BPS\0\1\0\0\0\0\0\0\0\3\0\0\x75\x30\0\0\x75\x30\0\x08\0\3"s},
    };
    for (const auto& [name, bytes] : pictures) {
        const auto result = decode_image(name, bytes + rest);
        EXPECT_FALSE(result.image) << name;
        EXPECT_TRUE(has_issue(result, "image-too-large")) << name << ": " << describe(result);
    }
}

// Otherwise the same picture would differ from second to second.
TEST_F(ImageFormats, NoDateIsWritten) {
    for (const char* name : {"a.tif", "a.exr", "a.png", "a.jpg", "a.hdr"}) {
        ASSERT_EQ(write_image(file(name), checkerboard(8)), "") << name;
        const std::string bytes = bytes_of(file(name));
        EXPECT_TRUE(test::matches(bytes, "[0-9]{4}[:-][0-9]{2}[:-][0-9]{2}[ T]").empty()) << name;
    }
}

// A header without pixels is an error, not a black picture.
TEST_F(ImageFormats, HeadersAloneAreNoPictures) {
    put("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 4\n");
    EXPECT_TRUE(has_issue(read_file(file("a.hdr")), "image-unreadable"));
    EXPECT_FALSE(read_file(file("a.hdr")).image);
    for (const char* name : {"a.tif", "a.exr", "a.png"}) {
        ASSERT_EQ(
            write_image(file(name), paint(64, 64, 3, PixelType::u8, [](int x, int y, int) { return (x + y) / 128.0; })),
            "");
        const std::string whole = bytes_of(file(name));
        put(name, whole.substr(0, 40));
        EXPECT_FALSE(read_file(file(name)).image) << name;
    }
}

TEST_F(ImageFormats, HeadersAreReadWithoutDecoding) {
    const Image image = paint(33, 21, 3, PixelType::u8, smooth);
    for (const auto& [extension, format] : {std::pair{"jpg", "jpeg"},
                                            {"exr", "exr"},
                                            {"hdr", "hdr"},
                                            {"gif", "gif"},
                                            {"png", "png"},
                                            {"bmp", "bmp"},
                                            {"webp", "webp"}}) {
        SCOPED_TRACE(extension);
        const std::string path = file(std::string("a.") + extension);
        ASSERT_EQ(write_image(path, image), "");
        const std::string bytes = bytes_of(path);
        const auto header = read_header(std::string_view(bytes).substr(0, 4096), bytes.size());
        ASSERT_TRUE(header);
        EXPECT_EQ(header->format, format);
        EXPECT_EQ(header->width, 33);
        EXPECT_EQ(header->height, 21);
    }
}

TEST_F(ImageFormats, SeveralThreadsMayRead) {
    const Image image = paint(32, 24, 3, PixelType::u8, smooth);
    ASSERT_EQ(write_image(file("a.tif"), image), "");
    std::array<double, 4> errors{};
    std::vector<std::jthread> threads;
    for (double& error : errors) {
        threads.emplace_back([&] {
            for (int i = 0; i < 20; ++i) error += compare(*read_file(file("a.tif")).image, image)->max;
        });
    }
    threads.clear();
    for (const double error : errors) EXPECT_EQ(error, 0);
}

// ---- writing ---------------------------------------------------------------------------------------------

TEST_F(ImageFormats, NothingIsLeftWhenWritingFails) {
    const Image image = paint(4, 4, 3, PixelType::u8, smooth);
    for (const std::string& name :
         {std::string("a.xyz"), std::string("noextension"), std::string("none/a.png"), std::string("none/a.exr")}) {
        EXPECT_NE(write_image(file(name), image), "") << name;
        EXPECT_EQ(entries(), 0u) << name;
    }
    EXPECT_NE(write_image(file("a.xyz"), image).find("xyz"), std::string::npos);
    std::filesystem::create_directory(file("folder.png"));
    EXPECT_NE(write_image(file("folder.png"), image), "");
    EXPECT_EQ(entries(), 1u);
    EXPECT_NE(write_image(file("a.png"), Image{}), "");
}

// Writers that end well and have written nothing: "null" always, JPEG 2000's of OpenImageIO 2.4.
TEST_F(ImageFormats, AnEmptyFileIsNoPicture) {
    const Image image = paint(64, 48, 3, PixelType::u8, smooth);
    EXPECT_NE(write_image(file("a.null"), image), "");
    EXPECT_EQ(entries(), 0u);
    const std::string wrong = write_image(file("a.jp2"), image);
    if (wrong.empty()) {
        EXPECT_TRUE(read_file(file("a.jp2")).image);
    }
    EXPECT_EQ(entries(), wrong.empty() ? 1u : 0u);
}

TEST_F(ImageFormats, AFailedWriteKeepsTheOldFile) {
    put("a.hdr", "old");
    const Image empty;
    EXPECT_NE(write_image(file("a.hdr"), empty), "");
    EXPECT_EQ(bytes_of(file("a.hdr")), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(ImageFormats, LinksStayLinks) {
    put("real.png", "old");
    std::filesystem::create_symlink("real.png", file("link.png"));
    ASSERT_EQ(write_image(file("link.png"), paint(2, 2, 3, PixelType::u8, smooth)), "");
    EXPECT_TRUE(std::filesystem::is_symlink(file("link.png")));
    EXPECT_TRUE(read_file(file("real.png")).image);
    EXPECT_EQ(entries(), 2u);
}

TEST(ImageWrite, OnlyPngDoesWithoutTheModule) {
    EXPECT_TRUE(writes_without_module("a/b.PNG"));
    EXPECT_FALSE(writes_without_module("a.exr"));
    EXPECT_FALSE(writes_without_module("png"));
}

// ---- the module itself -----------------------------------------------------------------------------------

// Run by the tests below in copies of this program that stand elsewhere.
TEST(ImageModuleElsewhere, DISABLED_IsMissing) {
    const auto result = decode_image("/nowhere/a.jpg", "\xff\xd8\xff");
    EXPECT_TRUE(has_issue(result, "image-module-missing")) << describe(result);
    EXPECT_NE(write_image((std::filesystem::temp_directory_path() / "snell-unwritten.exr").string(), checkerboard(8))
                  .find("module"),
              std::string::npos);
}

TEST(ImageModuleElsewhere, DISABLED_IsFound) {
    const auto result = decode_image("/nowhere/a.jpg", "\xff\xd8\xff");
    EXPECT_TRUE(has_issue(result, "image-unreadable")) << describe(result);
}

TEST_F(ImageFormats, TheModuleIsFoundInstalledAndMissedByName) {
    namespace fs = std::filesystem;
    fs::create_directories(file("bin"));
    fs::create_directories(file("lib/snell"));
    fs::copy_file("/proc/self/exe", file("bin/tests"));
    const std::string run =
        file("bin/tests") + " --gtest_also_run_disabled_tests --gtest_filter=ImageModuleElsewhere.DISABLED_";
    EXPECT_EQ(std::system((run + "IsMissing > " + file("log")).c_str()), 0) << bytes_of(file("log"));
    fs::copy_file(SNELL_BIN "/snell_oiio.so", file("lib/snell/snell_oiio.so"));
    EXPECT_EQ(std::system((run + "IsFound > " + file("log")).c_str()), 0) << bytes_of(file("log"));
}

TEST(ImageBasics, CheckerboardIsMagentaAndBlack) {
    const Image image = checkerboard(64);
    EXPECT_EQ(texel(image, 0, 0), (Texel{255, 0, 255, 255}));
    EXPECT_EQ(texel(image, 8, 0), (Texel{0, 0, 0, 255}));
    EXPECT_EQ(texel(image, 63, 63), (Texel{255, 0, 255, 255}));
}

TEST(ImageBasics, FlippingTurnsRowsOfEverySlice) {
    Image image = paint(2, 4, 1, PixelType::u8, [](int x, int y, int) { return (x + 10 * y) / 255.0; });
    image.height = 2;
    image.depth = 2;
    const Image turned = flipped(image);
    EXPECT_TRUE(turned.bottom_first);
    EXPECT_EQ(texel(turned, 0, 0, 0)[0], 10);
    EXPECT_EQ(texel(turned, 1, 1, 1)[0], 21);
    EXPECT_EQ(flipped(turned).pixels, image.pixels);
}

TEST(ImageBasics, SpreadingToFourChannels) {
    for (const PixelType type : {PixelType::u8, PixelType::f16, PixelType::f32}) {
        const auto value = [](int, int, int c) { return (c + 1) / 5.0; };
        const Image grey = to_rgba(paint(1, 1, 1, type, value)), alpha = to_rgba(paint(1, 1, 2, type, value)),
                    rgb = to_rgba(paint(1, 1, 3, type, value));
        const auto expect = [](const Image& image, std::array<double, 4> expected) {
            for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(value_at(image, c), expected[c], 1e-3);
        };
        expect(grey, {.2, .2, .2, 1});
        expect(alpha, {.2, .2, .2, .4});
        expect(rgb, {.2, .4, .6, 1});
    }
}

}  // namespace
}  // namespace snell::content
