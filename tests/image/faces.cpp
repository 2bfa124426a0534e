// Cube maps from six files.
#include "src/content/cube/cubemap.h"
#include "tests/image/help.h"

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
