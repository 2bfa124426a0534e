// Noise by its statistics, its lattice and its seams.
#include "src/content/image/noise.h"
#include "tests/image/help.h"

namespace snell::content {
namespace {

struct Statistics {
    double mean = 0, deviation = 0;
};

std::array<Statistics, 4> statistics(const Image& image) {
    std::array<Statistics, 4> result;
    const double texels = static_cast<double>(image.pixels.size() / 4);
    for (std::size_t c = 0; c < 4; ++c) {
        double sum = 0, squares = 0;
        for (std::size_t i = c; i < image.pixels.size(); i += 4) {
            const double v = std::to_integer<int>(image.pixels[i]) / 255.0;
            sum += v;
            squares += v * v;
        }
        result[c].mean = sum / texels;
        result[c].deviation = std::sqrt(squares / texels - result[c].mean * result[c].mean);
    }
    return result;
}

// What scenes are tuned to.
constexpr std::array<double, 4> flat{.074, .024, .014, .0070}, solid{.066, .032, .017, .0075};

void expect_statistics(const Image& image, const std::array<double, 4>& deviations, double tolerance) {
    const auto found = statistics(image);
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(found[c].mean, .498, .498 * .01) << "channel " << c;
        EXPECT_NEAR(found[c].deviation, deviations[c], deviations[c] * tolerance) << "channel " << c;
    }
}

TEST(ImageNoise, HasTheAmplitudesThatScenesAreTunedTo) {
    for (const int size : {64, 100, 128, 256, 400, 512, 65, 127}) {
        SCOPED_TRACE(size);
        expect_statistics(make_noise(2, size), flat, .05);
    }
    for (const int size : {64, 100, 128, 65}) {
        SCOPED_TRACE(size);
        expect_statistics(make_noise(3, size), solid, .05);
    }
}

// Where the finer octaves have no room they get as many cells as fit; the amplitudes stay.
TEST(ImageNoise, SmallTexturesKeepTheirAmplitudes) {
    for (const int size : {16, 24, 32, 48, 63}) {
        SCOPED_TRACE(size);
        expect_statistics(make_noise(3, size), solid, .08);
    }
}

TEST(ImageNoise, EverySizeIsMade) {
    for (const int size : {1, 2, 3, 4, 5, 7, 8, 13}) {
        for (const int dimensions : {2, 3}) {
            const Image image = make_noise(dimensions, size);
            EXPECT_EQ(image.width, size);
            EXPECT_EQ(image.height, size);
            EXPECT_EQ(image.depth, dimensions == 3 ? size : 1);
            EXPECT_EQ(image.pixels.size(), image.bytes());
            EXPECT_EQ(texel(image, 0, 0), (Texel{127, 127, 127, 127}));
        }
    }
}

void expect_lattice(const Image& image) {
    for (int c = 0; c < 4; ++c) {
        const int step = image.width / (4 << c);
        int off_centre = 0;
        for (int z = 0; z<image.depth; z += image.depth> 1 ? step : 1) {
            for (int y = 0; y < image.height; y += step) {
                for (int x = 0; x < image.width; x += step) {
                    ASSERT_EQ(texel(image, x, y, z)[static_cast<std::size_t>(c)], 127) << c << ' ' << x << ' ' << y;
                }
                off_centre += texel(image, step / 2, y, z)[static_cast<std::size_t>(c)] != 127;
            }
        }
        EXPECT_GT(off_centre, 0);  // elsewhere it is not flat
    }
}

TEST(ImageNoise, LatticePointsAreExactlyTheCentre) {
    for (const int size : {64, 128, 256}) expect_lattice(make_noise(2, size));
    for (const int size : {64, 128}) expect_lattice(make_noise(3, size));
}

// Twice the size has the same field at twice the resolution, up to the amplitude's fine adjustment.
TEST(ImageNoise, ResolutionDoesNotChangeThePattern) {
    const Image small = make_noise(3, 64), large = make_noise(3, 128);
    for (int i = 0; i < 64; ++i) {
        const int y = i * 29 % 64, z = i * 47 % 64;
        EXPECT_NEAR(texel(small, i, y, z)[0], texel(large, 2 * i, 2 * y, 2 * z)[0], 2) << i;
    }
}

// Steps across the edge of the texture are no larger than elsewhere, in value and in slope.
TEST(ImageNoise, TilesWithoutSeams) {
    const Image image = make_noise(3, 64);
    const auto at = [&](int axis, int i, int u, int v, std::size_t c) {
        const int a = (i + 64) % 64;
        if (axis == 0) return texel(image, a, u, v)[c];
        return axis == 1 ? texel(image, u, a, v)[c] : texel(image, u, v, a)[c];
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t c = 0; c < 2; ++c) {
            int inside = 0, bend_inside = 0, across = 0, bend_across = 0;
            for (int u = 0; u < 64; ++u) {
                for (int v = 0; v < 64; ++v) {
                    for (int i = 0; i < 64; ++i) {
                        const int here = at(axis, i, u, v, c), next = at(axis, i + 1, u, v, c),
                                  last = at(axis, i - 1, u, v, c);
                        const int step = std::abs(next - here), bend = std::abs(next - 2 * here + last);
                        const bool edge = i == 63 || i == 0;
                        (edge ? across : inside) = std::max(edge ? across : inside, step);
                        (edge ? bend_across : bend_inside) = std::max(edge ? bend_across : bend_inside, bend);
                    }
                }
            }
            EXPECT_LE(across, inside);
            EXPECT_LE(bend_across, bend_inside + 1);
        }
    }
}

TEST(ImageNoise, OctavesDiffer) {
    const Image image = make_noise(3, 64);
    double product = 0, squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const int r = std::to_integer<int>(image.pixels[i]) - 127, g = std::to_integer<int>(image.pixels[i + 1]) - 127;
        product += r * g;
        squares += std::sqrt(static_cast<double>(r * r) * g * g);
    }
    EXPECT_LT(std::abs(product) / squares, .1);
}

TEST(ImageNoise, IsTheSameEveryTime) {
    EXPECT_EQ(make_noise(3, 64).pixels, make_noise(3, 64).pixels);
    EXPECT_EQ(make_noise(2, 100).pixels, make_noise(2, 100).pixels);
}

TEST(ImageNoise, FilesAreNamedWithThreeDigits) {
    EXPECT_EQ(noise_file_name(3, 64), "noise3d.064.tex");
    EXPECT_EQ(noise_file_name(2, 400), "noise2d.400.tex");
    EXPECT_EQ(noise_file_name(2, 8), "noise2d.008.tex");
}

// glman's own textures, where the folder with them is at hand.
TEST(ImageNoise, AgreesWithTheOriginals) {
    for (const int dimensions : {2, 3}) {
        const std::filesystem::path path = "../shared/corpus/glman/" + noise_file_name(dimensions, 64);
        if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
        const auto original = read_file(path);
        ASSERT_TRUE(original.image) << describe(original);
        const Image ours = make_noise(dimensions, 64);
        ASSERT_EQ(original.image->bytes(), ours.bytes());
        expect_lattice(*original.image);
        const auto theirs = statistics(*original.image), found = statistics(ours);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(found[c].mean, theirs[c].mean, .005);
            EXPECT_NEAR(found[c].deviation, theirs[c].deviation, theirs[c].deviation * .05);
        }
    }
}

}  // namespace
}  // namespace snell::content
