// Files that were cut off, filled with zeros or exchanged for something else are no pictures.
#include "src/content/files.h"
#include "src/content/image/image.h"
#include "src/content/image/module.h"
#include "tests/image/help.h"
#include "tests/scratch.h"

namespace snell::content {
namespace {

class WholePictures : public testing::TestWithParam<const char*> {};

TEST_P(WholePictures, EndWhereTheyEnd) {
    const Scratch folder;
    Image image{.width = 37, .height = 23, .channels = 3};
    image.pixels.resize(image.bytes());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::byte>(i * 7 % 251);
    const std::string path = folder.path(std::string("o.") + GetParam());
    ASSERT_EQ(write_image(path, image), "");
    const std::string whole = whole_file(path);
    const auto is = [&](std::string_view bytes) { return is_whole(path, bytes, {}); };
    EXPECT_TRUE(is(whole));
    EXPECT_FALSE(is(""));
    EXPECT_FALSE(is("kept as it is"));
    std::vector<std::size_t> cuts{1, 8, 100, whole.size() / 2, whole.size() - 12, whole.size() - 2, whole.size() - 1};
    for (std::size_t cut = 200; cut < whole.size(); cut += 97) cuts.push_back(cut);
    for (const std::size_t cut : cuts) EXPECT_FALSE(is(whole.substr(0, cut))) << cut << " bytes of " << whole.size();
}

INSTANTIATE_TEST_SUITE_P(Formats, WholePictures, testing::Values("png", "jpg", "exr", "bmp", "tga", "hdr"));

// A file system that lost power leaves zeros.
TEST(WholePicture, HasItsChecksums) {
    const Scratch folder;
    Image image{.width = 37, .height = 23, .channels = 3};
    image.pixels.resize(image.bytes(), std::byte{9});
    const std::string whole = encode_png(image);
    const auto is = [](const std::string& bytes) { return is_whole("o.png", bytes, {}); };
    EXPECT_TRUE(is(whole));
    std::string zeros = whole;
    std::fill(zeros.begin() + static_cast<std::ptrdiff_t>(zeros.size() / 2), zeros.end() - 12, '\0');
    EXPECT_FALSE(is(zeros));
    EXPECT_FALSE(is(whole + "x"));
    EXPECT_FALSE(is(whole + whole));
    EXPECT_FALSE(is(whole.substr(0, 33) + whole.substr(whole.size() - 12))) << "without its pixels";
}

Image grey() {
    Image image{.width = 37, .height = 23, .channels = 3};
    image.pixels.resize(image.bytes(), std::byte{9});
    return image;
}

// Decoders read a renamed file by its content.
TEST(WholePicture, HasTheFormatOfItsName) {
    const Scratch folder;
    for (const std::string name : {"png", "jpg", "exr", "bmp", "tga", "hdr"}) {
        const std::string path = folder.path("o." + name);
        ASSERT_EQ(write_image(path, grey()), "");
        for (const std::string other : {"png", "jpg", "exr", "bmp", "tga", "hdr", "tif", "gif", "webp", "what"})
            EXPECT_EQ(is_whole("o." + other, whole_file(path), {}), name == other) << name << " named " << other;
    }
}

// Their decoders accept the rest of a file that was cut.
TEST(WholePicture, IsOfAFormatInWhichCutsAreFound) {
    const Scratch folder;
    for (const std::string name : {"tif", "gif"}) {
        const std::string path = folder.path("o." + name);
        if (!write_image(path, grey()).empty()) continue;
        const std::string whole = whole_file(path);
        for (std::size_t cut = 0; cut < whole.size(); cut += 13)
            EXPECT_FALSE(is_whole(path, whole.substr(0, whole.size() - cut), {})) << name << " without " << cut;
    }
}

std::string decoded(const Image& image) {
    const std::vector<std::byte> file = decoded_file(image);
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

TEST(DecodedFile, StandsForTheImageUnderAnyName) {
    for (const PixelType type : {PixelType::u8, PixelType::f16, PixelType::f32})
        for (const char* name : {"a.png", "a.bmp", "a.tex", "a.exr", "a"}) {
            SCOPED_TRACE(name);
            const Image image = paint(3, 2, 3, type, [](int x, int y, int c) { return (x + 3 * y + 6 * c) / 18.; });
            const ImageResult result = decode_image(name, decoded(image));
            ASSERT_TRUE(result.image) << describe(result);
            EXPECT_TRUE(result.issues.empty()) << describe(result);
            EXPECT_EQ(result.image->width, 3);
            EXPECT_EQ(result.image->height, 2);
            EXPECT_EQ(result.image->type, type);
            EXPECT_EQ(result.image->pixels, image.pixels);
            EXPECT_EQ(result.image->light, std::string_view(name) == "a.exr");
        }
}

TEST(DecodedFile, HoldsLightIfTheFormatDoes) {
    const Image image = paint(1, 1, 3, PixelType::f16, [](int, int, int) { return 2.; });
    for (const char* name : {"sky.hdr", "sky.exr"})
        EXPECT_TRUE(decode_image(name, decoded(image)).image->light) << name;
}

TEST(DecodedFile, HasTheTopRowFirst) {
    const Image image = paint(1, 2, 1, PixelType::u8, [](int, int y, int) { return y; });
    EXPECT_EQ(decode_image("a.tex", decoded(flipped(image))).image->pixels, image.pixels);
}

// Every byte of the header, and every length: nothing crashes, and what is accepted has the size that it states.
TEST(DecodedFile, DamageIsReported) {
    const std::string file = decoded(paint(2, 2, 4, PixelType::u8, [](int, int, int) { return 1.; }));
    for (std::size_t length = 8; length < file.size(); ++length)
        EXPECT_FALSE(decode_image("a.png", file.substr(0, length)).image) << length;
    for (std::size_t at = 8; at < 28; ++at)
        for (const char byte : {'\0', '\1', '\x7f', '\xff'}) {
            std::string damaged = file;
            damaged[at] = byte;
            const ImageResult result = decode_image("a.png", damaged);
            if (!result.image) continue;
            EXPECT_EQ(result.image->pixels.size(), result.image->bytes()) << at;
        }
}

}  // namespace
}  // namespace snell::content
