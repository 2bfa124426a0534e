// Half floats, and pictures with values that are no numbers.
#include "src/content/cube/convolve.h"
#include "tests/hard_case.h"
#include "tests/image/help.h"

namespace snell::content {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const float not_a_number = std::nanf("");

TEST(ImageHalf, EveryHalfSurvives) {
    for (std::uint32_t h = 0; h < 0x10000; ++h) {
        const float f = half_to_float(static_cast<std::uint16_t>(h));
        if (std::isnan(f)) {
            EXPECT_TRUE(std::isnan(half_to_float(float_to_half(f))));
        } else {
            ASSERT_EQ(float_to_half(f), h);
        }
    }
}

// The definition: sign, exponent, fraction.
TEST(ImageHalf, ValuesFollowTheFormat) {
    for (int exponent = 0; exponent < 31; ++exponent) {
        for (const int fraction : {0, 1, 511, 1023}) {
            const double expected =
                exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
            EXPECT_EQ(half_to_float(static_cast<std::uint16_t>(exponent << 10 | fraction)),
                      static_cast<float>(expected));
        }
    }
}

TEST(ImageHalf, RoundsToTheNearestEven) {
    for (std::uint32_t h = 0; h < 0x7bff; ++h) {
        const float low = half_to_float(static_cast<std::uint16_t>(h)),
                    high = half_to_float(static_cast<std::uint16_t>(h + 1));
        const float middle = low + (high - low) / 2;  // exact: two more bits than a half has
        ASSERT_EQ(float_to_half(middle), h % 2 == 0 ? h : h + 1) << h;
        ASSERT_EQ(float_to_half(std::nextafter(middle, 0.0f)), h) << h;
        ASSERT_EQ(float_to_half(std::nextafter(middle, infinity)), h + 1) << h;
    }
    EXPECT_EQ(float_to_half(65519.0f), 0x7bff);
    EXPECT_EQ(float_to_half(65520.0f), 0x7c00);
    EXPECT_EQ(float_to_half(-1e30f), 0xfc00);
    EXPECT_EQ(float_to_half(1e-44f), 0);
    EXPECT_EQ(float_to_half(-0.0f), 0x8000);
}

// A raw texture of floats: red as given, the other channels 1.
ImageResult reds(int width, int height, const std::vector<float>& values) {
    Bytes b;
    b.i32(width).i32(height);
    for (const float v : values) b.f32(v).f32(1).f32(1).f32(1);
    return decode_image("a.tex", b.str());
}

float red_of(const Image& image, int x, int y) {
    return value_at(image, 4 * static_cast<std::size_t>(y * image.width + x));
}

TEST(ImageMend, NotANumberBecomesTheMeanOfItsNeighbours) {
    const auto result = reds(3, 3, {1, 2, 3, 4, not_a_number, 6, 7, 8, 9});
    ASSERT_TRUE(result.image);
    EXPECT_TRUE(has_issue(result, "image-non-finite"));
    EXPECT_EQ(red_of(*result.image, 1, 1), 5.0f);
    EXPECT_EQ(red_of(*result.image, 0, 0), 1.0f);
}

TEST(ImageMend, InfinityInACornerSeesThreeNeighbours) {
    const auto result = reds(2, 2, {-infinity, 3, 6, 9});
    ASSERT_TRUE(result.image);
    EXPECT_EQ(red_of(*result.image, 0, 0), 6.0f);
}

TEST(ImageMend, WideHolesFillFromTheirEdge) {
    std::vector<float> values(64, 2.0f);
    for (std::size_t i = 9; i < 55; ++i) values[i] = not_a_number;
    const auto result = reds(8, 8, values);
    ASSERT_TRUE(result.image);
    for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(value_at(*result.image, 4 * i), 2.0f);
    ASSERT_EQ(result.issues.size(), 1u);
    EXPECT_NE(result.issues[0].message.find("46"), std::string::npos) << result.issues[0].message;
}

// A picture of distances is infinite wherever it shows the sky.
TEST(ImageMend, OneWideHoleTakesHardlyLongerThanManyNarrowOnes) {
    constexpr std::int32_t side = 512;
    constexpr std::size_t texels = side * side;
    std::vector<float> lattice(4 * texels, 2.0f), corner(4 * texels, infinity);
    for (std::size_t i = 1; i < texels; i += 2) std::fill_n(lattice.begin() + 4 * i, 4, infinity);
    std::fill_n(corner.begin(), 4, 2.0f);
    const auto seconds = [](const std::vector<float>& values) {
        std::string file = Bytes().i32(side).i32(side).str();
        file.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
        const std::clock_t before = std::clock();
        const auto result = decode_image("a.tex", file);
        const std::clock_t took = std::clock() - before;
        EXPECT_TRUE(result.image && red_of(*result.image, side - 1, side - 1) == 2);
        return static_cast<double>(took) / CLOCKS_PER_SEC;
    };
    const double narrow = std::min(seconds(lattice), seconds(lattice));
    const double wide = std::min(seconds(corner), seconds(corner));
    EXPECT_LT(wide, 16 * narrow);
}

TEST(ImageMend, NothingFiniteIsZero) {
    const auto result = reds(4, 2, std::vector<float>(8, not_a_number));
    ASSERT_TRUE(result.image);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(value_at(*result.image, 4 * i), 0.0f);
}

TEST(ImageMend, LargeValuesAreClampedAndNegativeOnesStay) {
    const auto result = reds(4, 1, {1e30f, -1e30f, -3.5f, 65504.0f});
    ASSERT_TRUE(result.image);
    EXPECT_TRUE(has_issue(result, "image-clamped"));
    EXPECT_EQ(red_of(*result.image, 0, 0), 65504.0f);
    EXPECT_EQ(red_of(*result.image, 1, 0), -65504.0f);
    EXPECT_EQ(red_of(*result.image, 2, 0), -3.5f);
    EXPECT_EQ(red_of(*result.image, 3, 0), 65504.0f);
    EXPECT_NE(describe(result).find("2 values"), std::string::npos) << describe(result);
    const auto large = reds(1, 1, {70000.0f});
    test::hard_case({"A16", "70000 in a picture: clamped to half's 65504; naive: a conversion to half", "off 65504", 0,
                     std::abs(static_cast<double>(red_of(*large.image, 0, 0)) - 65504),
                     std::abs(static_cast<double>(half_to_float(float_to_half(70000.0f))) - 65504)});
}

// What glGenerateMipmap does: each texel of a level is the mean of four.
TEST(ImageMend, OneTexelDoesNotSpreadThroughTheMipmaps) {
    constexpr int size = 64;
    std::vector<float> values(size * size, 2.0f);
    values[size * 20 + 33] = not_a_number;
    const auto share = [](std::vector<float> level, int side) {
        for (; side > 1; side /= 2) {
            std::vector<float> next;
            for (int y = 0; y < side; y += 2)
                for (int x = 0; x < side; x += 2) {
                    const auto at = [&](int i, int j) {
                        return level[static_cast<std::size_t>((y + j) * side + x + i)];
                    };
                    next.push_back((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4);
                }
            level = std::move(next);
        }
        return std::isfinite(level[0]) ? 0.0 : 100.0;
    };
    const auto result = reds(size, size, values);
    std::vector<float> mended;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) mended.push_back(red_of(*result.image, x, y));
    test::hard_case({"20", "one NaN texel of 64 × 64 fills the last mipmap: mended from its neighbours when read",
                     "% of the last level", 0, share(mended, size), share(values, size)});
}

TEST(ImageMend, VolumesAreMendedSliceBySlice) {
    Bytes b;
    b.i32(2).i32(1).i32(2);
    for (const float v : {1.0f, not_a_number, 5.0f, 5.0f}) b.f32(v).f32(0).f32(0).f32(0);
    const auto result = decode_image("a.tex", b.str());
    ASSERT_TRUE(result.image) << describe(result);
    EXPECT_EQ(value_at(*result.image, 4), 1.0f);
}

TEST(ImageMend, SoundPicturesAreNotReported) { EXPECT_TRUE(reds(2, 2, {0, 1, 2, 3}).issues.empty()); }

TEST(ImageCompare, FiguresAgreeWithTheirDefinitions) {
    const Image a = paint(2, 1, 1, PixelType::f32, [](int, int, int) { return 1.0; });
    const Image b = paint(2, 1, 1, PixelType::f32, [](int x, int, int) { return x == 0 ? 1.0 : 1.5; });
    const auto d = compare(a, b, 0.25);
    ASSERT_TRUE(d);
    EXPECT_DOUBLE_EQ(d->max, 0.5);
    EXPECT_DOUBLE_EQ(d->mean, 0.25);
    EXPECT_DOUBLE_EQ(d->rms, std::sqrt(0.125));
    EXPECT_EQ(d->over, 1u);
    EXPECT_FALSE(compare(a, paint(1, 2, 1, PixelType::f32, [](int, int, int) { return 1.0; })));
    const Image n = paint(2, 1, 1, PixelType::f32, [](int, int, int) { return std::nan(""); });
    EXPECT_EQ(compare(a, n)->max, std::numeric_limits<double>::infinity());
    EXPECT_EQ(compare(n, n)->max, 0.0);
}

TEST(ImageCompare, TypesAndRowOrderMayDiffer) {
    const auto ramp = [](int, int y, int) { return y; };
    const Image a = paint(2, 2, 4, PixelType::u8, ramp);
    EXPECT_EQ(compare(a, paint(2, 2, 4, PixelType::f16, ramp))->max, 0.0);
    EXPECT_EQ(compare(a, flipped(a))->max, 0.0);
}

// ---- Hard cases of sums over pictures.

TEST(HardPictures, SumsOfManyTexels) {
    CubeLight light{256, {}};
    light.texels.assign(6 * 256 * 256, {.1F, .1F, .1F});
    float sum = 0;
    for (const auto& texel : light.texels) sum += texel[0];
    const double naive = static_cast<double>(sum) / static_cast<double>(light.texels.size());
    const double value = static_cast<double>(.1F);
    double worst = 0;
    for (const auto& texel : resized(light, 1).texels)
        worst = std::max(worst, std::abs(static_cast<double>(texel[0]) / value - 1));
    test::hard_case({"A23", "the mean of a cube map of 6 · 256² equal texels: summed in double; naive: in float",
                     "relative", 1e-7, worst, std::abs(naive / value - 1)});
}

}  // namespace
}  // namespace snell::content
