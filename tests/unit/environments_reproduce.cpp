// The pictures in scenes/environments are what make_environments makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "src/content/image.h"
#include "src/optics/cube.h"
#include "tests/scratch.h"
#include "tools/environments/faces.h"
#include "tools/environments/panorama.h"
#include "tools/environments/room.h"
#include "tools/environments/sky.h"

namespace snell::environments {
namespace {

const std::string folder = SNELL_ROOT "/scenes/environments/";

std::string file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Environments, RoomIsReproducedByteForByte) {
    const Room room;
    EXPECT_TRUE(file(folder + "room.hdr") == encode_hdr(render_panorama(room, 512, 2)));
    const Faces faces = render_faces(room, 256, 3);
    for (std::size_t i = 0; i < 6; ++i) {
        const std::string name = folder + "room/" + std::string(face_names[i]) + ".bmp";
        EXPECT_TRUE(file(name) == encode_bmp(faces[i])) << name;
    }
}

// The brightness that the pictures of 8 bits lose, and the same directions: the reader sees what the room shows.
TEST(Environments, PanoramaIsTheLightOfTheRoom) {
    const Panorama small = render_panorama(sky_radiance, 64, 1);
    const Scratch scratch;  // OpenImageIO reads this format from disk only
    const std::string bytes = encode_hdr(small);
    const auto read = content::decode_image(scratch.write("sky.hdr", bytes), bytes);
    ASSERT_TRUE(read.image) << (read.issues.empty() ? "" : read.issues[0].message);
    ASSERT_EQ(read.image->type, content::PixelType::f16);
    ASSERT_EQ(read.image->width, 64);
    const auto channels = static_cast<std::size_t>(read.image->channels);
    for (std::size_t i = 0; i < small.texels.size(); ++i) {
        const Colour& c = small.texels[i];
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint16_t half = 0;
            std::memcpy(&half, &read.image->pixels.at(2 * (i * channels + k)), 2);
            ASSERT_NEAR(content::half_to_float(half), c[static_cast<int>(k)], .009 * std::max({c.r, c.g, c.b}));
        }
    }
    // Where +X and up are; the texels are coarse, so near them.
    EXPECT_LT(glm::length(small.texels[16 * 64 + 48] - sky_radiance({1, -.05, .05})), .1);
    EXPECT_LT(glm::length(small.texels[32] - sky_radiance({0, 1, -.02})), .2);
}

// PNG's bytes depend on zlib's version; its pixels don't.
TEST(Environments, SkyIsReproducedPixelForPixel) {
    const Faces faces = render_faces(sky_radiance, 256, 3);
    for (std::size_t i = 0; i < 6; ++i) {
        const std::string name = folder + "sky/" + std::string(face_names[i]) + ".png";
        const auto read = content::decode_image(name, file(name));
        ASSERT_TRUE(read.image) << name;
        const content::Image rgba = content::to_rgba(*read.image);
        ASSERT_EQ(rgba.pixels.size(), faces[i].rgb.size() / 3 * 4);
        std::size_t different = 0;
        for (std::size_t p = 0; p < faces[i].rgb.size(); ++p)
            different += std::to_integer<std::uint8_t>(rgba.pixels[p / 3 * 4 + p % 3]) != faces[i].rgb[p];
        EXPECT_EQ(different, 0U) << name;
    }
}

// A face that is turned or mirrored would not go on where its neighbour ends. Asked of the sky, which has no edges of
// its own; the room, whose walls differ in colour, is made by the same function.
TEST(Environments, FacesMeetAlongAllTwelveEdges) {
    std::array<content::Image, 6> images;
    optics::CubeTexels texels;
    for (std::size_t i = 0; i < 6; ++i) {
        const std::string name = folder + "sky/" + std::string(face_names[i]) + ".png";
        auto read = content::decode_image(name, file(name));
        ASSERT_TRUE(read.image) << name;
        images[i] = content::to_rgba(*read.image);
        texels[i] = {images[i].width,
                     images[i].height,
                     4,
                     {reinterpret_cast<const std::uint8_t*>(images[i].pixels.data()), images[i].pixels.size()}};
    }
    for (int face = 0; face < 6; ++face)
        for (int side = 0; side < 4; ++side) {
            double across = 0, mirrored = 0;
            for (int k = 0; k < 256; ++k) {
                const double edge = 0.5 / 256, along = (k + 0.5) / 256;
                const auto seen = [&](double offset, double a) {
                    const double far = side % 2 ? 1 - offset : offset;
                    const optics::CubePoint p =
                        side < 2 ? optics::CubePoint{face, far, a} : optics::CubePoint{face, a, far};
                    return optics::sample_cube(texels, optics::cube_direction(p), optics::Edges::clamped);
                };
                across += glm::length(seen(edge, along) - seen(-edge, along)) / 256;
                mirrored += glm::length(seen(edge, along) - seen(-edge, 1 - along)) / 256;
            }
            EXPECT_LT(across, 0.05) << "face " << face << " side " << side;
            EXPECT_GT(mirrored, 1.5 * across) << "face " << face << " side " << side;
        }
}

}  // namespace
}  // namespace snell::environments
