// Errors of pictures against their definitions and against known values.
#include "src/accuracy/metrics.h"
#include "src/content/image/image.h"
#include "tests/std.h"

namespace snell::accuracy {
namespace {

Picture filled(int width, int height, float r, float g, float b) {
    Picture picture{width, height, {}};
    for (std::size_t i = 0; i < picture.pixels(); ++i) picture.rgba.insert(picture.rgba.end(), {r, g, b, 1});
    return picture;
}

TEST(Metrics, FiguresAgreeWithTheirDefinitionsOnTwentyPairs) {
    std::mt19937 random(20);
    std::uniform_real_distribution<float> value(0, 1);
    std::normal_distribution<float> noise;
    for (int pair = 0; pair < 20; ++pair) {
        Picture a = filled(17 + 3 * pair, 40 - pair, 0, 0, 0), b = a;
        const float size = std::pow(10.0F, static_cast<float>(-pair) / 5);
        long double sum = 0, squares = 0, most = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i) {
            a.rgba[i] = value(random);
            b.rgba[i] = a.rgba[i] + size * noise(random);
            if (i % 4 == 3) continue;  // alpha is no light
            const long double d = std::abs(static_cast<long double>(a.rgba[i]) - b.rgba[i]);
            sum += d;
            squares += d * d;
            most = std::max(most, d);
        }
        const auto values = static_cast<long double>(3 * a.pixels());
        const auto rms = static_cast<double>(std::sqrt(squares / values));
        const Error ours = compare(a, b);
        EXPECT_NEAR(ours.display.mean, static_cast<double>(sum / values), 1e-9 * ours.display.mean);
        EXPECT_NEAR(ours.display.rmse, rms, 1e-9 * rms);
        EXPECT_NEAR(ours.display.max, static_cast<double>(most), 1e-9 * ours.display.max);
        EXPECT_NEAR(ours.display.psnr, -20 * std::log10(rms), 1e-6);
        // The same of light, which is decoded before it is compared.
        for (Picture* each : {&a, &b})
            for (float& v : each->rgba) v = static_cast<float>(content::light_of_srgb(static_cast<double>(v)));
        EXPECT_NEAR(ours.light.rmse, compare(a, b).display.rmse, 1e-6);
    }
}

TEST(Metrics, KnownDifferences) {
    Picture a = filled(4, 2, .5F, .5F, .5F), b = a;
    EXPECT_EQ(compare(a, b).light.rmse, 0);
    EXPECT_TRUE(std::isinf(compare(a, b).light.psnr));
    b.rgba[0] += .25F;
    const Figures error = compare(a, b).display;
    EXPECT_DOUBLE_EQ(error.max, .25);
    EXPECT_DOUBLE_EQ(error.mean, .25 / 24);
    EXPECT_DOUBLE_EQ(error.rmse, .25 / std::sqrt(24.0));
    EXPECT_NEAR(compare(filled(3, 3, 1, 1, 1), filled(3, 3, .9F, .9F, .9F)).display.psnr, 20, 1e-5);
    b.rgba[3] = 0;
    EXPECT_EQ(compare(a, b).display.rmse, error.rmse) << "alpha is no light";
}

// IEC 61966-2-1: code 188 of 255 is half the light of white; below .04045 the curve is a line.
TEST(Metrics, LightIsDecodedByTheCurveOfSrgb) {
    EXPECT_EQ(content::light_of_srgb(0), 0);
    EXPECT_DOUBLE_EQ(content::light_of_srgb(1), 1);
    EXPECT_NEAR(content::light_of_srgb(188 / 255.), .5, .003);
    EXPECT_NEAR(content::light_of_srgb(.04045), .04045 / 12.92, 1e-12);
    EXPECT_NEAR(content::light_of_srgb(.0404501), content::light_of_srgb(.04045), 1e-6) << "the two pieces meet";
    EXPECT_EQ(content::light_of_srgb(-.5), -content::light_of_srgb(.5));
    EXPECT_GT(content::light_of_srgb(2), 4);
    // A step of a display is little light where it is dark, and much where it is bright.
    const auto step = [](float at) {
        return compare(filled(2, 2, at, at, at), filled(2, 2, at + 1 / 255.F, at + 1 / 255.F, at + 1 / 255.F));
    };
    EXPECT_NEAR(step(.01F).display.rmse, step(.9F).display.rmse, 1e-6);
    EXPECT_NEAR(step(.01F).light.rmse, 1 / 255. / 12.92, 1e-6);
    EXPECT_GT(step(.9F).light.rmse, 20 * step(.01F).light.rmse);
}

TEST(Metrics, RegionsLeaveOutTheRest) {
    Picture a = filled(2, 1, 0, 0, 0), b = filled(2, 1, 0, 0, 0);
    b.rgba[4] = 1;  // the second pixel
    EXPECT_EQ(where_different(a, b), (Region{0, 1}));
    EXPECT_EQ(compare(a, b, {1, 0}).light.rmse, 0);
    EXPECT_DOUBLE_EQ(compare(a, b, {0, 1}).light.rmse, std::sqrt(1 / 3.0));
    EXPECT_EQ(compare(a, b, {0, 1}).pixels, 1U);
}

TEST(Metrics, PixelFiniteInOnePictureOnlyIsAnInfiniteError) {
    for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const Picture good = filled(3, 1, .5F, .5F, .5F);
        Picture bad = good;
        bad.rgba[5] = odd;
        for (const Error& error : {compare(bad, good), compare(good, bad)}) {
            EXPECT_EQ(error.light.rmse, std::numeric_limits<double>::infinity());
            EXPECT_EQ(error.display.max, std::numeric_limits<double>::infinity());
            EXPECT_EQ(error.light.psnr, -std::numeric_limits<double>::infinity());
            EXPECT_EQ(error.nonfinite, 1U);
        }
        EXPECT_EQ(mean_of(flip_map(bad, good), {0, 1, 0}), 1) << "as different as can be";
        EXPECT_EQ(compare(bad, good, {1, 0, 1}).light.rmse, 0) << "it does not count";
        EXPECT_EQ(compare(bad, bad).pixels, 2U);
        EXPECT_EQ(compare(bad, bad).light.rmse, 0);
        EXPECT_EQ(count(where_different(bad, bad)), 0U);
        EXPECT_EQ(where_different(bad, good), (Region{0, 1, 0}));
        EXPECT_EQ(non_finite(bad).count, 1U);
        EXPECT_EQ(non_finite(bad).x, 1);
    }
}

TEST(Metrics, WithoutPixelsThereIsNoError) {
    const Picture grey = filled(2, 1, .5F, .5F, .5F);
    EXPECT_TRUE(std::isnan(compare(grey, grey, {0, 0}).light.rmse));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(compare(filled(2, 1, nan, nan, nan), filled(2, 1, nan, nan, nan)).light.rmse));
}

TEST(Metrics, UnrelatedPicturesDoNotCorrelate) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0, 1);
    Picture a = filled(64, 64, 0, 0, 0), b = a, near = a;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        a.rgba[i] = value(random);
        b.rgba[i] = value(random);
        near.rgba[i] = a.rgba[i] + .05F * value(random);
    }
    EXPECT_NEAR(compare(a, b).correlation, 0, .05);
    EXPECT_GT(compare(a, near).correlation, .95);
    EXPECT_TRUE(compare(a, b).unrelated);
    EXPECT_FALSE(compare(a, near).unrelated);
    EXPECT_FALSE(compare(filled(64, 64, .5F, .5F, .5F), a).unrelated) << "a constant is a poor approximation, but one";
    EXPECT_EQ(compare(filled(2, 2, 1, 1, 1), filled(2, 2, .5F, .5F, .5F)).correlation, 1) << "both are constant";
}

TEST(Directions, AnglesHaveTheirDigitsHoweverSmall) {
    Picture a = filled(5, 1, 0, 0, 1), b = a;
    const double angles[]{0, 1e-5, .01, 90, 180};
    for (std::size_t i = 0; i < 5; ++i) {
        const double radians = angles[i] * std::acos(-1.0) / 180;
        b.rgba[4 * i] = static_cast<float>(3 * std::sin(radians));  // the length says nothing
        b.rgba[4 * i + 2] = static_cast<float>(3 * std::cos(radians));
        Region only(5, 0);
        only[i] = 1;
        EXPECT_NEAR(compare_directions(a, b, only).mean, angles[i], 1e-6 * angles[i]);
    }
    EXPECT_NEAR(compare_directions(a, b).max, 180, 1e-4);
    b.rgba[0] = b.rgba[1] = b.rgba[2] = 0;
    EXPECT_EQ(compare_directions(a, b).pixels, 4U) << "no direction, no angle";
    EXPECT_TRUE(std::isnan(compare_directions(a, filled(a.width, a.height, 0, 0, 0)).mean)) << "and not one of 0";
    b.rgba[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isinf(compare_directions(a, b).mean));
}

// The properties that the paper states: 0 for equal pictures, symmetric, within 0..1, and the largest difference
// of colour, green against blue, is 1.
TEST(Flip, KnownValues) {
    const Picture green = filled(48, 48, 0, 1, 0), blue = filled(48, 48, 0, 0, 1);
    EXPECT_NEAR(mean_of(flip_map(green, blue)), 1, 1e-3);
    EXPECT_EQ(mean_of(flip_map(green, green)), 0);
    const double black_white = mean_of(flip_map(filled(48, 48, 0, 0, 0), filled(48, 48, 1, 1, 1)));
    // .95 + .05 (100^.7 - .4 m) / (.6 m), m = 308.1^.7.
    EXPECT_NEAR(black_white, .967, .002);
    EXPECT_NEAR(mean_of(flip_map(filled(48, 48, 1, 1, 1), filled(48, 48, 0, 0, 0))), black_white, 1e-6);
}

TEST(Flip, GrowsWithTheDifference) {
    const Picture grey = filled(32, 32, .5F, .5F, .5F);
    double before = 0;
    for (float step : {.01F, .03F, .1F, .3F}) {
        const double now = mean_of(flip_map(filled(32, 32, .5F + step, .5F, .5F), grey));
        EXPECT_GT(now, before);
        EXPECT_LE(now, 1);
        before = now;
    }
}

// What the eye can't resolve it does not see: a fine checkerboard is grey from far away.
TEST(Flip, FineDetailVanishesWithDistance) {
    Picture checks = filled(64, 64, 0, 0, 0);
    for (std::size_t i = 0; i < checks.pixels(); ++i) {
        const float on = (i + i / 64) % 2 != 0 ? .6F : .4F;
        for (std::size_t c = 0; c < 3; ++c) checks.rgba[4 * i + c] = on;
    }
    // The value that emits the mean of both lights, found by bisection.
    float low = .4F, high = .6F;
    for (int i = 0; i < 30; ++i)
        (2 * content::light_of_srgb((low + high) / 2) < content::light_of_srgb(.4) + content::light_of_srgb(.6)
             ? low
             : high) = (low + high) / 2;
    const Picture grey = filled(64, 64, low, low, low);
    EXPECT_LT(mean_of(flip_map(checks, grey, 120)), .5 * mean_of(flip_map(checks, grey, 10)));
}

}  // namespace
}  // namespace snell::accuracy
