// Cube maps from six files.
#include <atomic>
#include <chrono>
#include <set>
#include <thread>

#include "src/content/cubemap.h"
#include "tests/unit/image_help.h"

namespace snell::content {
namespace {

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

CubeFaces squares(int side) {
    CubeFaces faces;
    for (Image& face : faces) face = checkerboard(side);
    return faces;
}

TEST(ImageFaces, FacesMustBeSquareAndEqual) {
    const std::array<std::string, 6> names{"px.bmp", "nx.bmp", "py.bmp", "ny.bmp", "pz.bmp", "nz.bmp"};
    CubeFaces faces = squares(16);
    EXPECT_TRUE(check_faces(faces, names).empty());
    faces[3] = checkerboard(8);
    auto issues = check_faces(faces, names);
    ASSERT_EQ(issues.size(), 1u);
    EXPECT_EQ(issues[0].code, "cube-faces-unequal");
    EXPECT_NE(issues[0].message.find("ny.bmp"), std::string::npos) << issues[0].message;
    faces[0].height = 8;
    issues = check_faces(faces, names);
    ASSERT_EQ(issues.size(), 2u);
    EXPECT_EQ(issues[0].code, "cube-face-not-square");
    EXPECT_TRUE(issues[0].error);
}

TEST(ImageFaces, FacesAreDecodedAtTheSameTime) {
    const int wanted = std::min<int>(static_cast<int>(std::thread::hardware_concurrency()), 2);
    std::atomic<int> running{0}, most{0};
    const auto results = decode_faces([&](int face) {
        const int now = ++running;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
        }
        // Until there are two, for as long as it takes a busy machine.
        for (int i = 0; i < 5000 && most < wanted; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        --running;
        ImageResult result;
        result.image = checkerboard(face + 1);
        return result;
    });
    for (int face = 0; face < 6; ++face) EXPECT_EQ(results[static_cast<std::size_t>(face)].image->width, face + 1);
    EXPECT_GE(most, wanted);
}

TEST(ImageFaces, FacesOfDifferentTypesAreMadeOneType) {
    CubeFaces faces = squares(8);
    unify_faces(faces);
    for (const Image& face : faces) EXPECT_EQ(face.type, PixelType::u8);
    faces[2] = paint(8, 8, 3, PixelType::f16, [](int, int, int) { return 7.0; });
    unify_faces(faces);
    for (const Image& face : faces) {
        EXPECT_EQ(face.type, PixelType::f16);
        EXPECT_EQ(face.channels, 4);
        EXPECT_EQ(face.pixels.size(), face.bytes());
    }
    EXPECT_EQ(value_at(faces[0], 0), 1.0f);
    EXPECT_EQ(value_at(faces[2], 0), 7.0f);
    EXPECT_EQ(value_at(faces[2], 3), 1.0f);
}

}  // namespace
}  // namespace snell::content
