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

}  // namespace
}  // namespace snell
