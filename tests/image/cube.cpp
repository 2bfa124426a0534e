// Cube maps: every layout is painted as a function of direction, split, and looked up where OpenGL's own rule
// for cube maps says that a direction falls.
#include "src/content/cube/cubemap.h"
#include "tests/hard_case.h"
#include "tests/image/help.h"

namespace snell::content {
namespace {

using Direction = std::array<double, 3>;

Direction unit(const Direction& d) {
    const double length = std::hypot(d[0], d[1], d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}

// Smooth, different in every direction, without any symmetry between the axes.
double color(const Direction& direction, int c) {
    const Direction d = unit(direction);
    const std::array<double, 3> value{.5 + .4 * d[0] + .1 * d[1] * d[2], .5 + .4 * d[1] - .1 * d[2] * d[0],
                                      .5 + .4 * d[2] + .1 * d[0] * d[1]};
    return value[static_cast<std::size_t>(c)];
}

// Section 8.13 of the OpenGL 4.6 specification, from the direction's side: which face, and where on it.
struct FacePoint {
    int face;
    double s, t;
};

FacePoint look_up(const Direction& d) {
    const double ax = std::abs(d[0]), ay = std::abs(d[1]), az = std::abs(d[2]);
    int face;
    double sc, tc, ma;
    if (ax >= ay && ax >= az) {
        face = d[0] > 0 ? 0 : 1;
        sc = d[0] > 0 ? -d[2] : d[2];
        tc = -d[1];
        ma = ax;
    } else if (ay >= az) {
        face = d[1] > 0 ? 2 : 3;
        sc = d[0];
        tc = d[1] > 0 ? d[2] : -d[2];
        ma = ay;
    } else {
        face = d[2] > 0 ? 4 : 5;
        sc = d[2] > 0 ? d[0] : -d[0];
        tc = -d[1];
        ma = az;
    }
    return {face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
}

// Bilinear within the face.
double sample(const Image& face, double s, double t, int c) {
    const auto at = [&](int x, int y) {
        x = std::clamp(x, 0, face.width - 1);
        y = std::clamp(y, 0, face.height - 1);
        return static_cast<double>(value_at(face, static_cast<std::size_t>((y * face.width + x) * face.channels + c)));
    };
    const double x = s * face.width - .5, y = t * face.height - .5;
    const int u = static_cast<int>(std::floor(x)), v = static_cast<int>(std::floor(y));
    const double fx = x - u, fy = y - v;
    return (at(u, v) * (1 - fx) + at(u + 1, v) * fx) * (1 - fy) +
           (at(u, v + 1) * (1 - fx) + at(u + 1, v + 1) * fx) * fy;
}

std::vector<Direction> directions() {
    std::vector<Direction> result;
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            for (int z = -3; z <= 3; ++z) {
                if (x != 0 || y != 0 || z != 0) result.push_back({x / 3.0, y / 3.0, z / 3.0});  // edges and corners too
            }
        }
    }
    return result;
}

void expect_colors(const CubeFaces& faces, double tolerance) {
    for (const Direction& d : directions()) {
        const auto [face, s, t] = look_up(d);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sample(faces[static_cast<std::size_t>(face)], s, t, c), color(d, c), tolerance)
                << d[0] << ' ' << d[1] << ' ' << d[2] << " on face " << face;
        }
    }
}

TEST(ImageCube, FaceDirectionsInvertOpenGlsLookUp) {
    for (int face = 0; face < 6; ++face) {
        for (const double s : {.1, .4, .9}) {
            for (const double t : {.2, .7}) {
                const FacePoint p = look_up(face_direction(face, s, t));
                EXPECT_EQ(p.face, face);
                EXPECT_NEAR(p.s, s, 1e-12);
                EXPECT_NEAR(p.t, t, 1e-12);
            }
        }
    }
}

// A panorama as seen from inside: the middle is straight ahead (-Z), its right half is to the right (+X).
Direction panorama_direction(double u, double v) {
    const double pi = std::acos(-1.0), longitude = (u - .5) * 2 * pi, latitude = (.5 - v) * pi;
    return {std::sin(longitude) * std::cos(latitude), std::sin(latitude), -std::cos(longitude) * std::cos(latitude)};
}

Image panorama(int width, PixelType type) {
    return paint(width, width / 2, 3, type, [&](int x, int y, int c) {
        return color(panorama_direction((x + .5) / width, (y + .5) * 2 / width), c);
    });
}

TEST(ImageCube, PanoramasOfEveryType) {
    expect_colors(split_cube(panorama(256, PixelType::u8), CubeLayout::equirectangular), .015);
    expect_colors(split_cube(panorama(256, PixelType::f16), CubeLayout::equirectangular), .01);
    expect_colors(split_cube(panorama(256, PixelType::f32), CubeLayout::equirectangular), .01);
}

TEST(ImageCube, PanoramaPositionsInvertTheirDirections) {
    for (const double u : {.01, .25, .5, .6, .99}) {
        for (const double v : {.01, .3, .5, .99}) {
            const auto p = equirectangular_position(panorama_direction(u, v));
            EXPECT_NEAR(p[0], u, 1e-12);
            EXPECT_NEAR(p[1], v, 1e-12);
        }
    }
    EXPECT_EQ(equirectangular_position({0, 1, 0}), (std::array<double, 2>{.5, 0}));
    EXPECT_EQ(equirectangular_position({0, -2, 0}), (std::array<double, 2>{.5, 1}));
}

// The error falls as the square of the texel: nothing is off by half a texel.
TEST(ImageCube, PanoramasConvergeWithResolution) {
    std::array<double, 2> worst{};
    for (std::size_t i = 0; i < 2; ++i) {
        const int width = i == 0 ? 64 : 256;
        const CubeFaces faces = split_cube(panorama(width, PixelType::f32), CubeLayout::equirectangular, width / 4);
        for (int face = 0; face < 6; ++face) {
            const Image& image = faces[static_cast<std::size_t>(face)];
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    const Direction d = face_direction(face, (x + .5) / image.width, (y + .5) / image.height);
                    const double found =
                        static_cast<double>(value_at(image, static_cast<std::size_t>((y * image.width + x) * 3)));
                    worst[i] = std::max(worst[i], std::abs(found - color(d, 0)));
                }
            }
        }
    }
    EXPECT_LT(worst[0], .004);
    EXPECT_LT(worst[1], worst[0] / 8);
}

// Half of the columns of a fine panorama are white: faces much coarser than it must show grey, not one or the
// other.
TEST(ImageCube, FinePanoramasAreAveraged) {
    const Image stripes = paint(2048, 1024, 3, PixelType::f32, [](int x, int, int) { return x % 2; });
    const CubeFaces faces = split_cube(stripes, CubeLayout::equirectangular, 8);
    for (const int face : {0, 1, 4, 5}) {
        for (std::size_t i = 0; i < 8 * 8 * 3; ++i)
            EXPECT_NEAR(value_at(faces[static_cast<std::size_t>(face)], i), .5, .1) << face;
    }
}

TEST(ImageCube, PanoramasKeepTheirMean) {
    const CubeFaces faces = split_cube(panorama(256, PixelType::f32), CubeLayout::equirectangular, 4);
    for (int face = 0; face < 6; ++face) {
        double expected = 0, found = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x)
                expected += color(face_direction(face, (x + .5) / 64, (y + .5) / 64), 2) / 4096;
        }
        for (std::size_t i = 0; i < 16; ++i)
            found += static_cast<double>(value_at(faces[static_cast<std::size_t>(face)], 3 * i + 2)) / 16;
        EXPECT_NEAR(found, expected, .002) << face;
    }
}

// The unfolded layouts as drawn in cubemap.h, painted by folding them: cells touch along shared edges, which is
// checked below on the painted picture itself.
struct Unfolded {
    CubeLayout layout;
    int columns, rows;
    std::array<std::array<int, 3>, 6> cell;    // column, row, turned
    std::vector<std::array<int, 4>> touching;  // two cells that share an edge: column and row of each
};

const Unfolded unfolded[] = {
    {CubeLayout::cross_horizontal,
     4,
     3,
     {{{2, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 2, 0}, {1, 1, 0}, {3, 1, 0}}},
     {{0, 1, 1, 1}, {1, 1, 2, 1}, {2, 1, 3, 1}, {1, 0, 1, 1}, {1, 1, 1, 2}}},
    {CubeLayout::cross_vertical,
     3,
     4,
     {{{2, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 2, 0}, {1, 1, 0}, {1, 3, 1}}},
     {{0, 1, 1, 1}, {1, 1, 2, 1}, {1, 0, 1, 1}, {1, 1, 1, 2}, {1, 2, 1, 3}}},
    {CubeLayout::strip_horizontal, 6, 1, {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}}, {}},
    {CubeLayout::strip_vertical, 1, 6, {{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {0, 4, 0}, {0, 5, 0}}}, {}},
};

Image fold_out(const Unfolded& u, int size, PixelType type) {
    return paint(u.columns * size, u.rows * size, 3, type, [&](int x, int y, int c) {
        for (int face = 0; face < 6; ++face) {
            const auto [column, row, turned] = u.cell[static_cast<std::size_t>(face)];
            if (x / size != column || y / size != row) continue;
            const double s = (x % size + .5) / size, t = (y % size + .5) / size;
            return color(turned ? face_direction(face, 1 - s, 1 - t) : face_direction(face, s, t), c);
        }
        return 0.0;
    });
}

TEST(ImageCube, CrossesAndStripsOfEveryTypeAndSize) {
    for (const Unfolded& u : unfolded) {
        SCOPED_TRACE(static_cast<int>(u.layout));
        EXPECT_EQ(detect_layout(u.columns * 64, u.rows * 64), u.layout);
        expect_colors(split_cube(fold_out(u, 64, PixelType::u8), u.layout), .03);
        expect_colors(split_cube(fold_out(u, 64, PixelType::f16), u.layout), .03);
        for (const int size : {32, 128})
            expect_colors(split_cube(fold_out(u, 64, PixelType::f32), u.layout, size), .04);
    }
}

TEST(ImageCube, WholeFacesAreCopiedExactly) {
    for (const Unfolded& u : unfolded) {
        const CubeFaces faces = split_cube(fold_out(u, 16, PixelType::u8), u.layout);
        for (int face = 0; face < 6; ++face) {
            const Image expected = paint(16, 16, 3, PixelType::u8, [&](int x, int y, int c) {
                return color(face_direction(face, (x + .5) / 16, (y + .5) / 16), c);
            });
            EXPECT_LE(compare(faces[static_cast<std::size_t>(face)], expected)->max, 1.001 / 255);
        }
    }
}

// That the crosses are real unfoldings: colours go on across the edges of touching cells.
TEST(ImageCube, CrossesAreContinuousPictures) {
    constexpr int size = 32;
    for (const Unfolded& u : unfolded) {
        const Image image = fold_out(u, size, PixelType::f32);
        const auto at = [&](int x, int y) {
            return static_cast<double>(value_at(image, static_cast<std::size_t>((y * image.width + x) * 3)));
        };
        for (const auto& [c0, r0, c1, r1] : u.touching) {
            for (int i = 0; i < size; ++i) {
                const bool beside = r0 == r1;
                const double a = beside ? at(c1 * size - 1, r0 * size + i) : at(c0 * size + i, r1 * size - 1);
                const double b = beside ? at(c1 * size, r0 * size + i) : at(c0 * size + i, r1 * size);
                EXPECT_NEAR(a, b, .04) << c0 << r0 << c1 << r1;
            }
        }
    }
}

// Texels on both sides of every edge of the cube nearly agree: no face is turned or mirrored.
TEST(ImageCube, FacesOfAPanoramaMeetAtTheirEdges) {
    const CubeFaces faces = split_cube(panorama(512, PixelType::f32), CubeLayout::equirectangular, 64);
    int edges = 0;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < 64; ++i) {
            const double m = (i + .5) / 64;
            for (const auto& [s, t, ds, dt] : {std::array{1 - 1 / 128.0, m, 1 / 64.0, 0.0},
                                               {1 / 128.0, m, -1 / 64.0, 0.0},
                                               {m, 1 - 1 / 128.0, 0.0, 1 / 64.0},
                                               {m, 1 / 128.0, 0.0, -1 / 64.0}}) {
                const FacePoint beyond = look_up(face_direction(face, s + ds, t + dt));
                ASSERT_NE(beyond.face, face);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_NEAR(sample(faces[static_cast<std::size_t>(face)], s, t, c),
                                sample(faces[static_cast<std::size_t>(beyond.face)], beyond.s, beyond.t, c), .02);
                }
                ++edges;
            }
        }
    }
    EXPECT_EQ(edges, 6 * 4 * 64);
}

// Around the seam at ±180° and the poles, where longitudes wrap and rows end.
TEST(ImageCube, PanoramasHaveNoSeam) {
    constexpr int width = 256, size = 64;
    const Image image = panorama(width, PixelType::f32);
    const CubeFaces faces = split_cube(image, CubeLayout::equirectangular, size);
    // Without wrapping, and with texels at their corners instead of their middles.
    const auto naive = [&](const Direction& d) {
        const auto [u, v] = equirectangular_position(d);
        return sample(image, u + .5 / width, v + .5 * 2 / width, 0);
    };
    double worst = 0, worst_naive = 0;
    for (const int face : {2, 3, 5, 4})
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Direction d = face_direction(face, (x + .5) / size, (y + .5) / size);
                if (std::abs(d[0]) > .1) continue;
                const Image& f = faces[static_cast<std::size_t>(face)];
                const auto at = static_cast<std::size_t>((y * size + x) * f.channels);
                worst = std::max(worst, std::abs(static_cast<double>(value_at(f, at)) - color(d, 0)));
                worst_naive = std::max(worst_naive, std::abs(naive(d) - color(d, 0)));
            }
    test::hard_case({"18", "panoramas at ±180° and at the poles; naive: no wrapping, off by half a texel",
                     "of the range", 2e-3, worst, worst_naive});
}

TEST(ImageCube, PicturesInTextureOrderAreTurnedFirst) {
    const Image image = panorama(64, PixelType::f32);
    const CubeFaces expected = split_cube(image, CubeLayout::equirectangular),
                    found = split_cube(flipped(image), CubeLayout::equirectangular);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(found[i].pixels, expected[i].pixels);
}

TEST(ImageCube, TinyPicturesAreSplit) {
    const Image image = paint(2, 1, 3, PixelType::f32, [](int, int, int) { return .25; });
    for (const Image& face : split_cube(image, CubeLayout::equirectangular)) {
        EXPECT_EQ(face.width, 1);
        EXPECT_EQ(value_at(face, 0), .25f);
    }
    for (const Image& face : split_cube(image, CubeLayout::equirectangular, 16)) EXPECT_EQ(value_at(face, 700), .25f);
}

TEST(ImageCube, LayoutsAreKnownByTheirProportions) {
    EXPECT_EQ(detect_layout(1024, 512), CubeLayout::equirectangular);
    EXPECT_EQ(detect_layout(4096, 2047), CubeLayout::equirectangular);
    EXPECT_EQ(detect_layout(512, 512), std::nullopt);
    EXPECT_EQ(detect_layout(1000, 512), std::nullopt);
    EXPECT_EQ(detect_layout(1920, 1080), std::nullopt);
    EXPECT_EQ(detect_layout(401, 300), std::nullopt);
    EXPECT_EQ(detect_layout(0, 0), std::nullopt);
    EXPECT_EQ(detect_layout(-4, -3), std::nullopt);
}

class ImagePanorama : public ScratchFolder {};

// Photographed environments, where the folder with them is at hand: bright at the top out of doors, and their
// faces meet.
TEST_F(ImagePanorama, PhotographedEnvironments) {
    const std::filesystem::path folder = "../shared/corpus/hdri";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path());
        const auto result = read_file(entry.path());
        ASSERT_TRUE(result.image) << describe(result);
        EXPECT_EQ(result.image->type, PixelType::f16);
        ASSERT_EQ(detect_layout(result.image->width, result.image->height), CubeLayout::equirectangular);
        const CubeFaces faces = split_cube(*result.image, CubeLayout::equirectangular);
        for (const Image& face : faces) {
            EXPECT_EQ(face.width, result.image->height / 2);
            for (std::size_t i = 0; i < face.pixels.size() / 2; ++i) ASSERT_TRUE(std::isfinite(value_at(face, i)));
        }
    }
}

// ---- Cube maps from six files.

TEST(ImageFaces, NamesOfSixFiles) {
    const auto lists = face_names("textures/sky.jpg");
    const std::set<std::array<std::string, 6>> found(lists.begin(), lists.end());
    const auto expect = [&](const std::array<std::string, 6>& names) { EXPECT_EQ(found.count(names), 1u) << names[0]; };
    expect({"textures/sky_posx.jpg", "textures/sky_negx.jpg", "textures/sky_posy.jpg", "textures/sky_negy.jpg",
            "textures/sky_posz.jpg", "textures/sky_negz.jpg"});
    expect({"textures/skypx.jpg", "textures/skynx.jpg", "textures/skypy.jpg", "textures/skyny.jpg",
            "textures/skypz.jpg", "textures/skynz.jpg"});
    expect({"textures/sky_right.jpg", "textures/sky_left.jpg", "textures/sky_top.jpg", "textures/sky_bottom.jpg",
            "textures/sky_front.jpg", "textures/sky_back.jpg"});
    EXPECT_EQ(found.size(), lists.size());
    EXPECT_EQ(lists.front()[0], "textures/sky_posx.jpg");
    EXPECT_EQ(face_names("no.dots/sky").front()[5], "no.dots/sky_negz");
}

TEST(ImageFaces, FacesMustBeSquareAndEqual) {
    const std::array<std::string, 6> names{"px.bmp", "nx.bmp", "py.bmp", "ny.bmp", "pz.bmp", "nz.bmp"};
    const Image usual = checkerboard(16), small = checkerboard(8);
    Image wide = usual;
    FacePictures faces{&wide, &usual, &usual, &usual, &usual, &usual};
    EXPECT_TRUE(check_faces(faces, names).empty());
    faces[3] = &small;
    auto issues = check_faces(faces, names);
    ASSERT_EQ(issues.size(), 1u);
    EXPECT_EQ(issues[0].code, "cube-faces-unequal");
    EXPECT_NE(issues[0].message.find("ny.bmp"), std::string::npos) << issues[0].message;
    wide.height = 8;
    issues = check_faces(faces, names);
    ASSERT_EQ(issues.size(), 2u);
    EXPECT_EQ(issues[0].code, "cube-face-not-square");
    EXPECT_TRUE(issues[0].error);
}

TEST(ImageFaces, TheFirstFaceDecidesBetweenSidesThatAreEquallyFrequent) {
    const Image large = checkerboard(64), small = checkerboard(32);
    const FacePictures halves{&large, &large, &large, &small, &small, &small};
    EXPECT_EQ(common_side(halves), 64);
    EXPECT_EQ(common_side({&small, nullptr, nullptr, &large, &large, &large}), 64);
    EXPECT_EQ(common_side({}), 0);
    const auto issues = check_faces(halves, {"px", "nx", "py", "ny", "pz", "nz"});
    ASSERT_EQ(issues.size(), 3u);
    EXPECT_NE(issues[0].message.find("(ny) is 32 x 32, but the other faces are 64 x 64"), std::string::npos)
        << issues[0].message;
}

}  // namespace
}  // namespace snell::content
