// The parts of pictures that a slide shows.
#include "src/accuracy/report/slide/slide.h"
#include "src/content/image/image.h"
#include "tests/accuracy/pictures.h"
#include "tests/std.h"

namespace snell::test {
namespace {

using namespace accuracy;

TEST(SlideCrops, WindowIsWhereTheDifferenceIs) {
    const Picture reference = noise(200, 150, 3);
    Picture a = reference, b = reference;
    for (int y = 77; y < 77 + 64; ++y)
        for (int x = 31; x < 31 + 96; ++x) b.rgba[4 * static_cast<std::size_t>(y * 200 + x) + 1] = 2;
    for (float& value : a.rgba) value += .1F;  // all pictures have it: no difference between them
    for (std::size_t i = 0; i < b.rgba.size(); ++i)
        if (b.rgba[i] != 2) b.rgba[i] = a.rgba[i];
    for (const auto& pictures : {std::vector<const Picture*>{&a, &b}, {&b, &a}}) {
        const Window window = largest_window(disagreement(pictures, reference), 200, 150, 96, 64);
        EXPECT_EQ(window.x, 31);
        EXPECT_EQ(window.y, 77);
        EXPECT_EQ(window.width, 96);
        EXPECT_EQ(window.height, 64);
    }
    const Window all = largest_window(std::vector<float>(12, 1), 4, 3, 96, 64);
    EXPECT_EQ(all.width, 4);
    EXPECT_EQ(all.height, 3);
}

TEST(SlideCrops, PixelsThatAreNotFiniteDiffer) {
    const Picture reference = flat(30, 20, .5F);
    Picture odd = reference;
    odd.rgba[4 * (7 * 30 + 11)] = std::nanf("");
    const Picture* pictures[]{&odd};
    const Window window = largest_window(disagreement(pictures, reference), 30, 20, 1, 1);
    EXPECT_EQ(window.x, 11);
    EXPECT_EQ(window.y, 7);
}

// The colours of a window are those of the whole map.
TEST(SlideCrops, MapIsThatOfTheWholePicture) {
    const Picture a = noise(90, 70, 5), b = noise(90, 70, 6);
    const std::vector<float> whole = flip_map(a, b);
    for (const Window window : {Window{0, 0, 20, 10}, Window{41, 33, 30, 20}, Window{60, 50, 30, 20}}) {
        const std::vector<float> part = flip_in(a, b, window);
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x)
                ASSERT_NEAR(part[static_cast<std::size_t>(y * window.width + x)],
                            whole[static_cast<std::size_t>((window.y + y) * 90 + window.x + x)], 1e-5)
                    << x << ' ' << y;
    }
}

TEST(SlideCrops, AreTheirPixels) {
    Picture picture = flat(5, 4, .25F);
    picture.rgba[4 * (2 * 5 + 3) + 1] = 7;
    picture.rgba[4 * (2 * 5 + 3) + 2] = std::nanf("");
    const content::Image image = crop(picture, {2, 1, 3, 2});
    ASSERT_EQ(image.pixels.size(), 3U * 6U);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(std::to_integer<int>(image.pixels[i]), i == 3 * 4 + 1 ? 255 : i == 3 * 4 + 2 ? 0 : 64) << i;
}

TEST(SlideCrops, SmallerPicturesAreMeans) {
    const auto checks = [](int x, int y, std::size_t) { return (x + y) % 2; };
    const content::Image small = content::reduced(100, 50, 20, 20, checks);
    EXPECT_EQ(small.width, 20);
    EXPECT_EQ(small.height, 10);
    for (const std::byte value : small.pixels) EXPECT_NEAR(std::to_integer<int>(value), 128, 6);
    EXPECT_EQ(content::reduced(7, 3, 20, 20, checks).width, 7) << "nothing is made larger";
}

}  // namespace
}  // namespace snell::test
