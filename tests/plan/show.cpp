// Where a scene is moved of which nothing is in view.
#include <gtest/gtest.h>

#include <cmath>

#include "src/plan/show.h"

namespace snell {
namespace {

DepthBox box_at(double x, double y, double z, float half) {
    DepthBox box{glm::dmat4(1), {-half, -half, -half}, {half, half, half}};
    box.eye_from_model[3] = {x, y, z, 1};
    return box;
}

TEST(ViewsToTry, MoveTheSceneAwayUntilAllOfItIsInThePicture) {
    const std::vector<DepthBox> boxes{box_at(0, 0, 0, 1)};
    const Camera camera;
    const std::vector<View> views = views_to_try(boxes, camera, {});
    ASSERT_FALSE(views.empty());
    const double z = views[0].scene.z;
    EXPECT_EQ(views[0].scene.x, 0) << "straight away first";
    const double slope = std::tan(25 / 57.29577951308232);
    for (const double nearest : {z + 1, z - 1}) EXPECT_LE(1, -nearest * slope) << "a corner's sides are in the picture";
    EXPECT_GT(z, -10) << "and no farther than that";
    EXPECT_NEAR(z * 10, std::round(z * 10), 1e-9) << "in round numbers";
}

TEST(ViewsToTry, FindWhatIsBesideAndBehind) {
    const std::vector<DepthBox> boxes{box_at(40, -7, 30, 1)};
    const std::vector<View> views = views_to_try(boxes, {}, {});
    ASSERT_GE(views.size(), 2U);
    EXPECT_NEAR(views[1].scene.x, -40, .5);
    EXPECT_NEAR(views[1].scene.y, 7, .1);
    EXPECT_LT(views[1].scene.z + 30, -2) << "in front of the eye";
}

TEST(ViewsToTry, MakeWhatIsTooLargeSmaller) {
    const std::vector<View> views = views_to_try(std::vector<DepthBox>{box_at(0, 0, 0, 5000)}, {}, {});
    ASSERT_FALSE(views.empty());
    EXPECT_LT(views.back().scene.scale * 5000, 1000) << "before the far plane";
    EXPECT_GT(views.back().scene.scale, 0);
}

TEST(ViewsToTry, AreNoneForNothingFinite) {
    EXPECT_TRUE(views_to_try({}, {}, {}).empty());
    EXPECT_TRUE(views_to_try(std::vector<DepthBox>{box_at(NAN, 0, 0, 1)}, {}, {}).empty());
}

}  // namespace
}  // namespace snell
