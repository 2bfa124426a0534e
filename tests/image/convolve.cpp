// Light gathered from cube maps, against sums over every texel.
#include "src/content/cube/convolve.h"
#include "tests/oracle/light.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::content {
namespace {

using Direction = std::array<double, 3>;
using Color = std::array<double, 3>;

const double pi = std::acos(-1.0);

Direction unit(const Direction& d) {
    const double length = std::hypot(d[0], d[1], d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}
double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

CubeLight light_of(int size, const std::function<Color(const Direction&)>& color) {
    CubeLight light;
    light.size = size;
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const Color c = color(unit(face_direction(face, (column + .5) / size, (row + .5) / size)));
                light.texels.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
            }
    return light;
}

Color gradient(const Direction& d) { return {.5 + .4 * d[1], .3 + .2 * d[0], .7 - .3 * d[2]}; }
// Six walls, and a bright window in the ceiling.
Color window(const Direction& d) {
    if (d[1] > 0 && std::abs(d[0]) < .25 * d[1] && std::abs(d[2]) < .25 * d[1]) return {40, 40, 36};
    const double x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
    if (x >= y && x >= z) return d[0] > 0 ? Color{.9, .3, .3} : Color{.3, .9, .3};
    if (y >= z) return d[1] > 0 ? Color{.9, .9, .9} : Color{.4, .4, .4};
    return d[2] > 0 ? Color{.3, .3, .9} : Color{.8, .8, .2};
}

// The mean of light with weights by the cosine from a direction, over every texel.
Color brute(const CubeLight& light, const Direction& to, const std::function<double(double)>& weight) {
    Color sum{};
    double whole = 0;
    const Direction n = unit(to);
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < light.size; ++row)
            for (int column = 0; column < light.size; ++column) {
                const double s = static_cast<double>(column) / light.size, t = static_cast<double>(row) / light.size;
                const double step = 1.0 / light.size;
                const Direction d = unit(face_direction(face, s + step / 2, t + step / 2));
                const double w = weight(dot(n, d)) * solid_angle(s, t, s + step, t + step);
                for (std::size_t c = 0; c < 3; ++c) sum[c] += w * static_cast<double>(light.at(face, column, row)[c]);
                whole += w;
            }
    for (double& value : sum) value /= whole;
    return sum;
}

double cosine(double c) { return std::max(c, 0.0); }

Direction middle(const CubeLight& light, int face, int column, int row) {
    return face_direction(face, (column + .5) / light.size, (row + .5) / light.size);
}

void expect_mean_kept(const CubeLight& light, const Color& mean, double tolerance) {
    const Color found = mean_radiance(light);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / mean[c], 1, tolerance);
}

// Root mean square over some texels of a level, relative to the light there plus the mean.
double error(const CubeLight& level, const CubeLight& source, double alpha, int samples) {
    std::mt19937 random(7);
    const Color mean = mean_radiance(source);
    double squares = 0;
    for (int i = 0; i < samples; ++i) {
        const auto pick = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
        const int face = pick(6), column = pick(level.size), row = pick(level.size);
        const Color truth =
            brute(source, middle(level, face, column, row), [&](double c) { return lobe_weight(c, alpha); });
        for (std::size_t c = 0; c < 3; ++c) {
            const double off = (static_cast<double>(level.at(face, column, row)[c]) - truth[c]) / (truth[c] + mean[c]);
            squares += off * off / 3;
        }
    }
    return std::sqrt(squares / samples);
}

// Irradiance / π of nine coefficients, as shaders/snell/irradiance.glsl has it.
Color of_harmonics(const Harmonics& h, const Direction& n) {
    Color sum{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto k = [&](std::size_t i) { return static_cast<double>(h[i][c]); };
        sum[c] = .282094792 * k(0) + .325735008 * (k(1) * n[1] + k(2) * n[2] + k(3) * n[0]) +
                 .273137108 * (k(4) * n[0] * n[1] + k(5) * n[1] * n[2] + k(7) * n[0] * n[2]) +
                 .078847891 * (3 * n[2] * n[2] - 1) * k(6) + .136568554 * (n[0] * n[0] - n[1] * n[1]) * k(8);
        sum[c] = std::max(sum[c], 0.0);
    }
    return sum;
}

// Hard case A23: summed in float, 6 · 512² texels lose 3e-5 of their sum.
TEST(CubeLight, ReductionKeepsTheLight) {
    const CubeLight light = light_of(512, window);
    const Color mean = mean_radiance(light);
    for (int size : {256, 100, 16, 7, 1}) {
        SCOPED_TRACE(size);
        expect_mean_kept(resized(light, size), mean, 1e-6);
    }
    expect_mean_kept(resized(light_of(24, window), 64), mean_radiance(light_of(24, window)), 1e-6);
    const CubeLight tenth = light_of(512, [](const Direction&) { return Color{.1, .1, .1}; });
    EXPECT_NEAR(mean_radiance(tenth)[0] / static_cast<double>(.1f), 1, 1e-9);
}

TEST(CubeLight, SolidAnglesAreThoseOfTheSphere) {
    EXPECT_NEAR(6 * solid_angle(0, 0, 1, 1), 4 * pi, 1e-12);
    EXPECT_NEAR(solid_angle(.4995, .4995, .5005, .5005) / solid_angle(0, 0, .001, .001), 5.196, .02);
}

TEST(CubeLight, SurvivesHalfFloats) {
    const CubeLight light = light_of(8, [](const Direction& d) { return Color{d[0], 1e6 * d[1], 1e-3}; });
    const CubeLight back = cube_light(half_faces(light));
    for (std::size_t i = 0; i < light.texels.size(); ++i) {
        EXPECT_NEAR(back.texels[i][0], light.texels[i][0], 5e-4);
        EXPECT_EQ(std::abs(back.texels[i][1]), 65504.0f);
        EXPECT_NEAR(back.texels[i][2], 1e-3f, 1e-6f);
    }
}

TEST(Irradiance, AgreesWithTheSumOverAllTexels) {
    for (const auto& [color, tolerance] : {std::pair{&gradient, .003}, std::pair{&window, .005}}) {
        const CubeLight light = light_of(96, *color), map = irradiance(light);
        const double mean = mean_radiance(light)[1];
        for (int face = 0; face < 6; ++face)
            for (const auto& [column, row] : {std::pair{0, 0}, std::pair{7, 3}, std::pair{15, 8}}) {
                const Color truth = brute(light, middle(map, face, column, row), cosine);
                EXPECT_NEAR(static_cast<double>(map.at(face, column, row)[1]), truth[1], tolerance * mean);
            }
        expect_mean_kept(map, mean_radiance(light), .005);
    }
}

TEST(Irradiance, OfUniformLightIsThatLight) {
    const CubeLight light = light_of(33, [](const Direction&) { return Color{.25, 1, 30}; });
    for (const auto& texel : irradiance(light, 5).texels) {
        EXPECT_NEAR(texel[0], .25f, 1e-6f);
        EXPECT_NEAR(texel[2], 30, 1e-4f);
    }
}

TEST(Prefilter, AgreesWithTheSumOverAllTexels) {
    const CubeLight light = light_of(64, window);
    const auto levels = prefiltered(light, 64);
    ASSERT_EQ(levels.size(), 4U);
    EXPECT_EQ(levels[0].texels, light.texels) << "the first level is the source";
    for (std::size_t level = 1; level < levels.size(); ++level) {
        const double roughness = static_cast<double>(level) / 3;
        EXPECT_EQ(levels[level].size, 64 >> level);
        EXPECT_LT(error(levels[level], light, roughness * roughness, 60), .01) << level;
        expect_mean_kept(levels[level], mean_radiance(light), .005);
    }
}

// The lobe is GGX's: D(h) (n·l) of Walter and others 2007, with h half way between the normal and l.
TEST(Prefilter, LobeIsThatOfMicrofacets) {
    for (const double alpha : {.04, .3, 1.0}) {
        const auto ggx = [&](double c) {
            const double h2 = (1 + c) / 2, base = h2 * (alpha * alpha - 1) + 1;
            return alpha * alpha / (pi * base * base) * c;
        };
        for (const double c : {.999, .7, .2})
            EXPECT_NEAR(lobe_weight(c, alpha) / lobe_weight(1, alpha), ggx(c) / ggx(1), 1e-9);
        EXPECT_EQ(lobe_weight(-.1, alpha), 0);
    }
}

TEST(Prefilter, RoughnessOneIsIrradiance) {
    const CubeLight light = light_of(64, window), last = prefiltered(light, 64).back(), map = irradiance(light, 8);
    const double mean = mean_radiance(light)[0];
    for (std::size_t i = 0; i < last.texels.size(); ++i)
        EXPECT_NEAR(static_cast<double>(last.texels[i][0] - map.texels[i][0]), 0,
                    .01 * (mean + static_cast<double>(map.texels[i][0])));
}

TEST(Prefilter, SizesOfChains) {
    EXPECT_EQ(prefilter_levels(16), 2);
    EXPECT_EQ(prefilter_levels(1024), 8);
    EXPECT_EQ(prefilter_size(100, 128), 128);
    EXPECT_EQ(prefilter_size(4, 128), 16);
    EXPECT_EQ(prefilter_size(4096, 64), 64);
    const auto chain = prefiltered(light_of(3, gradient), 16);
    ASSERT_EQ(chain.size(), 2U);
    expect_mean_kept(chain[1], mean_radiance(light_of(3, gradient)), .005);
}

// Hard case A15: one texel that is no number, one infinite, in all that is made of them.
TEST(Prefilter, NoTexelSpoilsTheOthers) {
    CubeFaces faces = half_faces(light_of(32, gradient));
    const auto spoil = [&](std::size_t face, std::size_t texel, std::uint16_t half) {
        std::memcpy(faces[face].pixels.data() + 8 * texel, &half, 2);
    };
    spoil(0, 100, 0x7e00);
    spoil(3, 7, 0x7c00);
    const CubeLight light = cube_light(faces);
    const auto finite = [](const CubeLight& l) {
        for (const auto& texel : l.texels)
            for (const float value : texel)
                if (!std::isfinite(value)) return false;
        return true;
    };
    EXPECT_TRUE(finite(irradiance(light)));
    for (const CubeLight& level : prefiltered(light, 32)) EXPECT_TRUE(finite(level));
    for (const auto& coefficient : harmonics(light)) EXPECT_TRUE(std::isfinite(coefficient[0]));
}

TEST(Prefilter, IsTheSameEveryTime) {
    const CubeLight light = light_of(32, window);
    const auto one = prefiltered(light, 32), two = prefiltered(light, 32);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].texels, two[i].texels);
}

TEST(HarmonicsOfCubes, GiveIrradiance) {
    for (const auto& [color, tolerance] : {std::pair{&gradient, .003}, std::pair{&window, .2}}) {
        const CubeLight light = light_of(64, *color);
        const Harmonics h = harmonics(light);
        const double mean = mean_radiance(light)[0];
        EXPECT_NEAR(static_cast<double>(h[0][0]), mean * std::sqrt(4 * pi), 1e-5 * mean);
        for (const Direction& n : {Direction{0, 1, 0}, Direction{1, 0, 0}, unit({1, -2, 3})})
            EXPECT_NEAR(of_harmonics(h, n)[0], brute(light, n, cosine)[0], tolerance * mean);
    }
}

// A panorama as it is in its file, with its own solid angles.
struct Panorama {
    const Image& image;

    void each(const std::function<void(const Direction&, double, const Color&)>& use) const {
        for (int y = 0; y < image.height; ++y) {
            const double band = std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height);
            const double up = pi / 2 - pi * (y + .5) / image.height;
            for (int x = 0; x < image.width; ++x) {
                const double longitude = 2 * pi * ((x + .5) / image.width - .5);
                const Direction d{std::sin(longitude) * std::cos(up), std::sin(up),
                                  -std::cos(longitude) * std::cos(up)};
                std::array<std::uint16_t, 3> half{};
                std::memcpy(half.data(),
                            image.pixels.data() + static_cast<std::size_t>(y) * image.row_bytes() +
                                static_cast<std::size_t>(x) * image.pixel_bytes(),
                            sizeof half);
                Color color{};
                for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<double>(half_to_float(half[c]));
                use(d, band * 2 * pi / image.width, color);
            }
        }
    }
    Color gathered(const std::function<double(const Direction&)>& weight) const {
        Color sum{};
        each([&](const Direction& d, double angle, const Color& color) {
            const double w = weight(d) * angle;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += w * color[c];
        });
        return sum;
    }
};

// The weights of the nine coefficients of irradiance at a normal: what convolving by the first three orders is.
double three_orders(double c) { return (.25 + .5 * c + .3125 * (1.5 * c * c - .5)) / pi; }

// Photographed environments, where the folder with them is at hand: what panoramas, irradiance and chains keep of the
// light, and how near both ways to irradiance come to sums over the file's own pixels.
TEST(Environments, KeepTheirLight) {
    const std::filesystem::path folder = "../shared/corpus/hdri";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path());
        const ImageResult result = decode_image(entry.path(), bytes_of(entry.path()));
        ASSERT_TRUE(result.image);
        ASSERT_EQ(result.image->type, PixelType::f16);
        const Panorama panorama{*result.image};
        const Color mean = panorama.gathered([](const Direction&) { return 1 / (4 * pi); });
        const CubeLight light = cube_light(split_cube(*result.image, CubeLayout::equirectangular));
        const CubeLight map = irradiance(light);
        expect_mean_kept(light, mean, .005);
        expect_mean_kept(map, mean, .005);
        for (const CubeLight& level : prefiltered(light, 64)) expect_mean_kept(level, mean, .005);
        const Harmonics h = harmonics(light);
        for (int face = 0; face < 6; ++face) {
            const int column = 3 * face, row = 15 - 2 * face;
            const Direction n = unit(middle(map, face, column, row));
            const Color all = panorama.gathered([&](const Direction& d) { return cosine(dot(n, d)) / pi; });
            const Color nine = panorama.gathered([&](const Direction& d) { return three_orders(dot(n, d)); });
            const Color found = of_harmonics(h, n);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(static_cast<double>(map.at(face, column, row)[c]), all[c], .02 * mean[c]);
                EXPECT_NEAR(found[c], std::max(nine[c], 0.0), .02 * mean[c]);
                EXPECT_NEAR(found[c], all[c], .25 * mean[c]) << "what the three orders leave out";
            }
        }
    }
}

}  // namespace
}  // namespace snell::content
