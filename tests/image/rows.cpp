// Pictures that are written band by band are those that are written at once; a failure leaves what was there.
#include <sys/resource.h>
#include <csignal>

#include "src/content/image/png_write.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::content {
namespace {

Image noise(int width, int height, int channels, PixelType type = PixelType::u8) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.type = type;
    image.pixels.resize(image.bytes());
    unsigned state = 1;
    for (std::byte& byte : image.pixels) byte = static_cast<std::byte>((state = state * 1664525U + 1013904223U) >> 24);
    if (type == PixelType::f32) {
        std::vector<float> floats(image.pixels.size() / 4);
        for (std::size_t i = 0; i < floats.size(); ++i) floats[i] = static_cast<float>(i % 97) / 32;
        std::memcpy(image.pixels.data(), floats.data(), image.pixels.size());
    }
    return image;
}

std::string by_rows(const std::string& path, const Image& image, int band) {
    RowWriter writer(path, image);
    for (int y = 0; y < image.height; y += band) {
        const auto rows = static_cast<std::size_t>(std::min(band, image.height - y));
        writer.add(
            std::span(image.pixels).subspan(static_cast<std::size_t>(y) * image.row_bytes(), rows * image.row_bytes()));
    }
    return writer.finish();
}

TEST(ImageRows, BandsAreTheSameFile) {
    const Scratch folder;
    for (const char* extension : {"png", "bmp", "tif", "exr", "tga", "jpg", "hdr", "ppm", "webp"}) {
        const bool floats = std::string(extension) == "exr" || std::string(extension) == "hdr";
        const Image image = noise(37, 41, 3, floats ? PixelType::f32 : PixelType::u8);
        const std::string whole = folder.path(std::string("whole.") + extension);
        ASSERT_EQ(write_image(whole, image), "") << extension;
        ASSERT_EQ(by_rows(folder.path(std::string("bands.") + extension), image, 7), "") << extension;
        const auto a = decode_image(whole, bytes_of(whole));
        const auto b = decode_image(whole, bytes_of(folder.path(std::string("bands.") + extension)));
        ASSERT_TRUE(a.image && b.image) << extension;
        EXPECT_EQ(a.image->pixels, b.image->pixels) << extension;
        EXPECT_EQ(a.image->width, 37);
        EXPECT_EQ(a.image->height, 41);
    }
}

TEST(ImageRows, AlphaIsKept) {
    const Scratch folder;
    const Image image = noise(16, 16, 4);
    ASSERT_EQ(by_rows(folder.path("a.png"), image, 5), "");
    const auto read = decode_image("a.png", bytes_of(folder.path("a.png")));
    ASSERT_TRUE(read.image);
    EXPECT_EQ(read.image->pixels, image.pixels);
}

TEST(ImageRows, WhatIsNotWholeLeavesWhatWasThere) {
    const Scratch folder;
    for (const char* extension : {"png", "bmp", "exr"}) {
        const std::string path = folder.write(std::string("a.") + extension, "old");
        const Image image = noise(16, 16, 3);
        {
            RowWriter writer(path, image);
            EXPECT_EQ(writer.add(std::span(image.pixels).first(8 * image.row_bytes())), "");
            EXPECT_NE(writer.finish(), "") << "rows are missing";
        }
        {
            RowWriter given_up(path, image);
            given_up.add(std::span(image.pixels).first(8 * image.row_bytes()));
        }
        RowWriter writer(path, image);
        EXPECT_NE(writer.add(std::span(image.pixels).first(5)), "") << "no whole row";
        EXPECT_NE(writer.finish(), "");
        EXPECT_EQ(bytes_of(path), "old") << extension;
    }
    EXPECT_EQ(folder.entries(), 3U) << "nothing is left beside them";
}

// Every kind of file, broken off at every kind of place: while its head is written, its rows, its end.
TEST(ImageRows, AFullDiskIsSaidAndTheOldFileStays) {
    const Scratch folder;
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    getrlimit(RLIMIT_FSIZE, &usual);
    for (const char* extension : {"png", "bmp", "exr", "tif", "tga", "jpg", "hdr", "ppm", "webp"}) {
        const std::string path = folder.write(std::string("full.") + extension, "old");
        const Image image = noise(150, 150, 3);
        for (const rlim_t bytes : {0, 10, 3000}) {
            const rlimit small{bytes, usual.rlim_max};
            setrlimit(RLIMIT_FSIZE, &small);
            const std::string error = write_image(path, image);
            setrlimit(RLIMIT_FSIZE, &usual);
            EXPECT_NE(error, "") << extension << " of " << bytes << " bytes";
            EXPECT_NE(error.find("File too large"), std::string::npos) << extension << ": " << error;
            EXPECT_EQ(bytes_of(path), "old") << extension;
        }
        EXPECT_EQ(write_image(path, image), "") << extension;
        EXPECT_GT(bytes_of(path).size(), 3000U) << "the test can fail";
    }
    std::signal(SIGXFSZ, before);
    EXPECT_EQ(folder.entries(), 9U) << "nothing is left beside them";
}

}  // namespace
}  // namespace snell::content
