// The camera that the user holds, and the objects that it moves, judged by where points come to lie.
#include <glm/gtc/matrix_transform.hpp>

#include "src/plan/plan.h"
#include "src/plan/view.h"
#include "tests/std.h"

namespace snell {
namespace {

glm::dvec2 on_screen(const Lens& lens, const glm::dmat4& view, const glm::dvec3& world) {
    const glm::dvec4 clip = projection_matrix(lens.camera, 1) * lens.shift * view * glm::dvec4(world, 1);
    return glm::dvec2(clip) / clip.w;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
    EXPECT_NEAR(glm::distance(a, b), 0, tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " for " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Lens, TheOtherProjectionKeepsWhatLiesAtTheOrigin) {
    Camera seeing;
    seeing.fov = 40;
    seeing.look_at = {{Vec3{0, 3, 4}, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};
    const glm::dmat4 view = view_matrix(seeing);
    const glm::dvec3 right(glm::inverse(glm::dmat3(view))[0]);
    const Lens own = lens_of(seeing, Projection::scene, view), flat = lens_of(seeing, Projection::ortho, view);
    EXPECT_FALSE(flat.camera.perspective);
    for (const double at : {-1., .5, 1.5})
        EXPECT_NEAR(on_screen(own, view, at * right).x, on_screen(flat, view, at * right).x, 1e-12);
    const Lens same = lens_of(seeing, Projection::perspective, view);
    EXPECT_EQ(same.camera, seeing) << "it has it";
    EXPECT_EQ(same.shift, glm::dmat4(1));

    Camera boxed;
    boxed.perspective = false;
    boxed.ortho = {-1, 3, -2, 2};
    const glm::dmat4 here = view_matrix(boxed);  // the eye is within the scene
    const Lens before = lens_of(boxed, Projection::scene, here), after = lens_of(boxed, Projection::perspective, here);
    EXPECT_TRUE(after.camera.perspective);
    for (const glm::dvec3 p : {glm::dvec3(1, 1, 0), {-1, -2, 0}, {3, 0, 0}}) {
        EXPECT_NEAR(on_screen(before, here, p).x, on_screen(after, here, p).x, 1e-12);
        EXPECT_NEAR(on_screen(before, here, p).y, on_screen(after, here, p).y, 1e-12);
    }
    EXPECT_GT(on_screen(after, here, {3, 0, 1}).x, on_screen(after, here, {3, 0, 0}).x) << "nearer is larger";
}

TEST(Lens, StaysFiniteWhateverTheCamera) {
    for (const double z : {0., -1e-9, 5., 1e300, -1e300}) {
        Camera camera;
        camera.look_at = {{Vec3{0, 0, z}, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};
        for (const bool perspective : {true, false})
            for (const Projection chosen : {Projection::ortho, Projection::perspective}) {
                camera.perspective = perspective;
                camera.ortho = {0, 0, 0, 0};
                const glm::dmat4 view = view_matrix(camera);
                const Lens lens = lens_of(camera, chosen, view);
                const glm::dmat4 m = projection_matrix(lens.camera, 1.5) * lens.shift;
                for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(m[i / 4][i % 4])) << z;
                EXPECT_GT(units_per_step(lens, {0, 0, z}, 500), 0);
            }
    }
}

TEST(Lens, AStepMovesWhatIsHeldByAPixel) {
    Camera camera;
    camera.look_at = {{Vec3{1, 2, 6}, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};
    for (const Projection chosen : {Projection::scene, Projection::ortho}) {
        const glm::dmat4 view = view_matrix(camera);
        const Lens lens = lens_of(camera, chosen, view);
        const glm::dvec3 point(.4, -.3, 1);
        const glm::dvec3 in_eye(view * glm::dvec4(point, 1));
        const double unit = units_per_step(lens, in_eye, 500);
        const glm::dvec3 right(glm::inverse(glm::dmat3(view))[0]);
        const double moved = on_screen(lens, view, point + unit * right).x - on_screen(lens, view, point).x;
        EXPECT_NEAR(moved, 2. / 500, 1e-12);
    }
}

TEST(Background, TheSliderIsGlmansBlue) {
    const auto usual = background_of(.1294);
    EXPECT_NEAR(usual[0], .0706, 1e-4);
    EXPECT_NEAR(usual[1], .1059, 1e-4);
    EXPECT_EQ(background_of(2), background_of(1));
}

TEST(Objects, AreMovedAlongTheCamerasAxesInTheWorldsUnits) {
    Camera camera;
    camera.look_at = {{Vec3{5, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 1, 0}}};  // its right is the world's -Z
    const glm::dmat4 model = glm::scale(glm::translate(glm::dmat4(1), {1, 2, 3}), glm::dvec3(.04, -.04, .04));
    Transformation move;
    move.x = .5;
    move.y = .25;
    expect_near(placed(move, camera, model)[3], {1, 2.25, 2.5});
    expect_near(placed({}, camera, model)[0], model[0], 0);
}

TEST(Objects, TurnAndGrowAboutTheirOwnOrigin) {
    const glm::dmat4 model = glm::translate(glm::dmat4(1), {1, 2, -3});
    Transformation turn;
    turn.rotate_y = 90;
    turn.scale = 2;
    const glm::dmat4 m = placed(turn, {}, model);
    expect_near(m[3], {1, 2, -3});
    expect_near(m * glm::dvec4(1, 0, 0, 1), {1, 2, -5});
    Transformation roll;
    roll.rotate_z = 90;
    expect_near(placed(roll, {}, model) * glm::dvec4(1, 0, 0, 1), {1, 3, -3});
}

TEST(Objects, KeepTheirPlacesWhenTheSceneIsReadAgain) {
    const auto scene = [](std::initializer_list<double> radii) {
        Scene made;
        for (const double radius : radii) {
            Draw draw;
            draw.shape = Sphere{.radius = radius};
            made.draws.push_back(draw);
        }
        return object_names(made);
    };
    View view;
    view.objects[1].x = 2;
    carry_objects(scene({1, 2, 2}), scene({7, 1, 2, 2}), view);
    ASSERT_EQ(view.objects.size(), 1u);
    EXPECT_EQ(view.objects.begin()->first, 2u) << "one more stands before it";
    carry_objects(scene({7, 1, 2, 2}), scene({7, 1, 3, 2}), view);
    EXPECT_EQ(view.objects.begin()->first, 2u) << "only its radius is another";
    carry_objects(scene({7, 1, 3, 2}), scene({7}), view);
    EXPECT_TRUE(view.objects.empty()) << "it is gone";
}

// ---- Which boxes a camera cannot show, and where a scene is moved of which nothing is in view.

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

// ---- boxes, judged by their points ----------------------------------------------------------------------

constexpr glm::dvec2 none_wider{0, 0};

DepthBox placed_box(const glm::dvec3& place, const glm::dvec3& half) {
    const auto at = [&](int axis, double side) { return static_cast<float>(side * half[axis]); };
    return {glm::translate(glm::dmat4(1), place), {at(0, -1), at(1, -1), at(2, -1)}, {at(0, 1), at(1, 1), at(2, 1)}};
}

// True if one of some points of the box is in view.
bool shows(const DepthBox& box, const glm::dmat4& clip, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 100; ++i) {
        glm::dvec4 p(0, 0, 0, 1);
        for (int axis = 0; axis < 3; ++axis) {
            // Corners and edges are the first to come into view.
            const double t = i % 3 ? std::round(unit(random)) : unit(random);
            const auto k = static_cast<std::size_t>(axis);
            p[axis] = glm::mix(static_cast<double>(box.min[k]), static_cast<double>(box.max[k]), t);
        }
        const glm::dvec4 c = clip * box.eye_from_model * p;
        if (std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w) return true;
    }
    return false;
}

TEST(OutOfView, NoPointOfTheBoxIsInView) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-8, 8), size(0, 2), turn(0, 6);
    int out = 0, in = 0;
    for (int i = 0; i < 3000; ++i) {
        const Camera camera{.perspective = i % 2 == 0, .fov = 20 + 10. * (i % 13), .ortho = {-3, 2, -1, 4}};
        const glm::dmat4 clip = projection_matrix(camera, .5 + i % 3, DepthRange{.5, 9});
        DepthBox box = placed_box({place(random), place(random), place(random)},
                                  {size(random), i % 5 ? size(random) : 0, i % 7 ? size(random) : 0});
        box.eye_from_model = glm::rotate(box.eye_from_model, turn(random), glm::dvec3(.2, 1, .4));
        const bool shown = shows(box, clip, random), culled = out_of_view(box, clip, none_wider);
        EXPECT_FALSE(shown && culled) << i;
        (shown ? in : out) += shown || culled;
    }
    EXPECT_GT(out, 700);
    EXPECT_GT(in, 150);
}

// Planes through x = ±z and y = ±z, at 1 and 100.
TEST(OutOfView, IsExactForEachPlane) {
    const glm::dmat4 clip = projection_matrix({.perspective = true, .fov = 90}, 1, DepthRange{1, 100});
    const glm::dvec3 half(.5, .5, .5);
    for (const double side : {-1., 1.}) {
        EXPECT_FALSE(out_of_view(placed_box({side * 10.99, 0, -10}, half), clip, none_wider));
        EXPECT_TRUE(out_of_view(placed_box({side * 11.01, 0, -10}, half), clip, none_wider));
        EXPECT_FALSE(out_of_view(placed_box({0, side * 10.99, -10}, half), clip, none_wider));
        EXPECT_TRUE(out_of_view(placed_box({0, side * 11.01, -10}, half), clip, none_wider));
        EXPECT_FALSE(out_of_view(placed_box({side * 11.01, 0, -10}, half), clip, {.01, 0}));
        EXPECT_TRUE(out_of_view(placed_box({side * 11.2, 0, -10}, half), clip, {.01, 0}));
    }
    EXPECT_FALSE(out_of_view(placed_box({0, 0, -.51}, half), clip, none_wider));
    EXPECT_TRUE(out_of_view(placed_box({0, 0, -.49}, half), clip, none_wider));
    EXPECT_FALSE(out_of_view(placed_box({0, 0, -100.49}, half), clip, none_wider));
    EXPECT_TRUE(out_of_view(placed_box({0, 0, -101}, half), clip, none_wider));
    EXPECT_TRUE(out_of_view(placed_box({0, 0, 50}, half), clip, none_wider)) << "behind the eye, where w is negative";
    EXPECT_FALSE(out_of_view(placed_box({0, 0, 0}, {200, 200, 200}), clip, none_wider)) << "around the eye";
    EXPECT_FALSE(out_of_view(placed_box({0, 0, 0}, {0, 200, 200}), clip, none_wider)) << "flat";
}

// A place far away is rounded to floats, and may be rounded into the picture.
TEST(OutOfView, AllowsForTheRoundingOfFloats) {
    const glm::dmat4 clip = projection_matrix({.perspective = true, .fov = 90}, 1);
    DepthBox box = placed_box({0, 0, 0}, {.5, .5, .5});
    box.eye_from_model = glm::translate(glm::dmat4(1), {1e6 + 11.5, 0, -10});
    box.min[0] = -1e6F - .5F;
    box.max[0] = -1e6F + .5F;
    EXPECT_FALSE(out_of_view(box, clip, none_wider)) << "less outside than the rounding error";
    box.eye_from_model = glm::translate(glm::dmat4(1), {1e6 + 100, 0, -10});
    EXPECT_TRUE(out_of_view(box, clip, none_wider));
}

TEST(OutOfView, IsUnknownWhereNumbersAreNotFinite) {
    const glm::dmat4 clip = projection_matrix({.perspective = true, .fov = 90}, 1);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(out_of_view(placed_box({bad, 0, 5}, {1, 1, 1}), clip, none_wider));
        EXPECT_FALSE(out_of_view(placed_box({0, 0, 5}, {1, 1, 1}), clip * bad, none_wider));
        DepthBox box = placed_box({0, 0, 5}, {1, 1, 1});
        box.max[0] = static_cast<float>(bad);
        EXPECT_FALSE(out_of_view(box, clip, none_wider));
    }
}

}  // namespace
}  // namespace snell
