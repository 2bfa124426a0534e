// Matrices: facts of geometry, and hard inputs.
#include "src/plan/plan.h"
#include "src/plan/view.h"
#include "tests/plan/finite.h"
#include "tests/std.h"

namespace snell {
namespace {

glm::dvec3 ndc(const glm::dmat4& m, glm::dvec3 p) {
    const glm::dvec4 clip = m * glm::dvec4(p, 1);
    return glm::dvec3(clip) / clip.w;
}

glm::dmat4 diagonal(double x, double y, double z) {
    glm::dmat4 m(1);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

TEST(Projection, PerspectiveAngleIsVertical) {
    Camera camera;
    camera.fov = 90;
    const glm::dmat4 m = projection_matrix(camera, 1);
    EXPECT_NEAR(ndc(m, {0, 5, -5}).y, 1, 1e-12);
    EXPECT_NEAR(ndc(m, {-5, 0, -5}).x, -1, 1e-12);
    EXPECT_NEAR(ndc(m, {0, 0, -.1}).z, -1, 1e-9);
    EXPECT_NEAR(ndc(m, {0, 0, -1000}).z, 1, 1e-9);
}

// The square of the shorter side shows the same in every window.
TEST(Projection, LongerSideShowsMore) {
    Camera perspective, ortho;
    perspective.fov = 60;
    ortho.perspective = false;
    ortho.ortho = {-1, 3, 2, 4};
    for (const Camera& camera : {perspective, ortho}) {
        const glm::dvec3 point(.3, .8, -7);
        const glm::dvec3 square = ndc(projection_matrix(camera, 1), point);
        const glm::dvec3 wide = ndc(projection_matrix(camera, 2), point);
        const glm::dvec3 tall = ndc(projection_matrix(camera, .25), point);
        EXPECT_NEAR(wide.x, square.x / 2, 1e-12);
        EXPECT_NEAR(wide.y, square.y, 1e-12);
        EXPECT_NEAR(tall.x, square.x, 1e-12);
        EXPECT_NEAR(tall.y, square.y / 4, 1e-12);
    }
}

TEST(Projection, OrthoPutsItsCornersOnTheCorners) {
    Camera camera;
    camera.perspective = false;
    camera.ortho = {-2, 6, 1, 9};
    const glm::dmat4 m = projection_matrix(camera, 1);
    EXPECT_NEAR(ndc(m, {-2, 1, 0}).x, -1, 1e-12);
    EXPECT_NEAR(ndc(m, {-2, 1, 0}).y, -1, 1e-12);
    EXPECT_NEAR(ndc(m, {6, 9, 0}).x, 1, 1e-12);
    EXPECT_LT(std::abs(ndc(m, {0, 0, 0}).z), 1) << "the eye's own plane is drawn";
    EXPECT_LT(ndc(m, {0, 0, 1}).z, ndc(m, {0, 0, 0}).z) << "nearer is nearer";
    camera.ortho = {6, -2, 1, 9};
    EXPECT_NEAR(ndc(projection_matrix(camera, 1), {6, 1, 0}).x, -1, 1e-12) << "swapped sides mirror";
}

TEST(Projection, NeverNaN) {
    const Camera usual;
    const glm::dmat4 expected = projection_matrix(usual, 1);
    for (const double fov : {0., -50., 180., 181., 360., nan_value, infinity, -infinity, 5e-324}) {
        Camera camera;
        camera.fov = fov;
        EXPECT_EQ(projection_matrix(camera, 1), expected) << fov;
    }
    Camera narrow;
    narrow.fov = .0001;
    EXPECT_NEAR(ndc(projection_matrix(narrow, 1), {0, 100 * std::tan(.00005 * M_PI / 180), -100}).y, 1, 1e-9);
    for (const double aspect : {0., -1., nan_value, infinity}) {
        EXPECT_EQ(projection_matrix(usual, aspect), expected) << aspect;
    }
    for (const double aspect : {1e-300, 1e300}) EXPECT_TRUE(all_finite(projection_matrix(usual, aspect)));
    for (const DepthRange depth : {DepthRange{1, 1}, {0, 10}, {-1, 10}, {10, 1}, {nan_value, 1}, {1, infinity}}) {
        EXPECT_EQ(projection_matrix(usual, 1, depth), expected);
    }
    Camera ortho;
    ortho.perspective = false;
    const glm::dmat4 box = projection_matrix(ortho, 1);
    for (const std::array<double, 4>& sides : std::vector<std::array<double, 4>>{{0, 0, 0, 0},
                                                                                 {1, 1, -1, 1},
                                                                                 {-1, 1, 2, 2},
                                                                                 {nan_value, 1, 0, 1},
                                                                                 {-1e308, 1e308, 0, 1},
                                                                                 {0, 5e-324, 0, 1}}) {
        ortho.ortho = sides;
        EXPECT_EQ(projection_matrix(ortho, 1), box);
    }
}

TEST(Projection, DepthRangeIsTheCallers) {
    const glm::dmat4 m = projection_matrix(Camera{}, 1, DepthRange{2, 5});
    EXPECT_NEAR(ndc(m, {0, 0, -2}).z, -1, 1e-12);
    EXPECT_NEAR(ndc(m, {0, 0, -5}).z, 1, 1e-12);
}

TEST(FittedDepth, HoldsEveryBoxWithinTheUsualPlanes) {
    glm::dmat4 away(1);
    away[3] = {0, 0, -50, 1};
    const DepthBox box{away, {-1, -1, -1}, {1, 1, 1}};
    const std::optional<DepthRange> one = fit_depth(std::array{box});
    ASSERT_TRUE(one);
    EXPECT_TRUE(one->near > 48 && one->near < 49 && one->far > 51 && one->far < 52);
    const DepthBox around{glm::dmat4(1), {-2000, -1, -2000}, {1, 1, 2000}};
    const std::optional<DepthRange> both = fit_depth(std::array{box, around});
    ASSERT_TRUE(both);
    EXPECT_EQ(both->near, .1) << "the eye is inside";
    EXPECT_EQ(both->far, 1000);
    EXPECT_FALSE(fit_depth(std::array{DepthBox{glm::dmat4(1), {0, 0, 1}, {1, 1, 2}}})) << "behind the eye";
    EXPECT_FALSE(fit_depth(std::array{DepthBox{glm::dmat4(nan_value), {0, 0, 1}, {1, 1, 2}}}));
    EXPECT_FALSE(fit_depth({}));
}

TEST(LookAt, MapsEyeCenterAndUp) {
    const glm::dmat4 m = view_matrix(looking({1, 2, 3}, {4, 2, -1}, {0, 3, 0}));
    EXPECT_LT(rigidity(m), 1e-15);
    EXPECT_NEAR(glm::length(glm::dvec3(m * glm::dvec4(1, 2, 3, 1))), 0, 1e-14);
    const glm::dvec4 center = m * glm::dvec4(4, 2, -1, 1);
    EXPECT_NEAR(center.x, 0, 1e-14);
    EXPECT_NEAR(center.y, 0, 1e-14);
    EXPECT_NEAR(center.z, -5, 1e-14);
    EXPECT_NEAR((m * glm::dvec4(0, 1, 0, 0)).y, 1, 1e-15);
    EXPECT_EQ(view_matrix(Camera{}), glm::dmat4(1));
}

// However near up is to the viewing direction: rigid, and still turned the way up says.
TEST(LookAt, NearlyParallelUpStaysRigid) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(.3, -.8, .52));
    const glm::dvec3 side = glm::normalize(glm::cross(forward, glm::dvec3(.1, .2, .9)));
    for (double angle = 1e-2; angle > 1e-11; angle /= 10) {
        const glm::dvec3 up = forward + angle * side;
        const glm::dmat4 m = view_matrix(looking({0, 0, 0}, {forward.x, forward.y, forward.z}, {up.x, up.y, up.z}));
        EXPECT_LT(rigidity(m), 1e-12) << angle;
        const glm::dvec3 eye_up(m[0][1], m[1][1], m[2][1]);
        EXPECT_NEAR(glm::dot(eye_up, side), 1, 1e-6) << angle;
    }
}

// A common way round a vertical view is a tiny offset; it means what it says.
TEST(LookAt, TinyOffsetFromVerticalKeepsItsUp) {
    const glm::dmat4 m = view_matrix(looking({0, 5, 1e-6}, {0, 0, 0}, {0, 1, 0}));
    EXPECT_NEAR(m[0][0], 1, 1e-12);
    EXPECT_LT(rigidity(m), 1e-12);
}

TEST(LookAt, DegenerateInputsAreDefined) {
    for (const Camera& camera :
         {looking({1, 1, 1}, {1, 1, 1}, {0, 1, 0}), looking({0, 5, 0}, {0, 0, 0}, {0, 1, 0}),
          looking({0, -5, 0}, {0, 0, 0}, {0, 1, 0}), looking({0, 0, 5}, {0, 0, 0}, {0, 0, 0}),
          looking({5, 0, 0}, {0, 0, 0}, {-1, 0, 0}), looking({0, 0, 0}, {nan_value, 0, 0}, {0, 1, 0}),
          looking({nan_value, 0, 0}, {0, 0, 0}, {0, 1, 0}), looking({0, 0, 5}, {0, 0, 0}, {0, infinity, 0}),
          looking({1e308, 1e308, 1e308}, {-1e308, 0, 0}, {0, 1, 0}), looking({0, 0, 1e-300}, {0, 0, 0}, {0, 1e-300, 0}),
          looking({0, 0, 1e300}, {0, 0, 0}, {0, 1e300, 0})}) {
        const glm::dmat4 m = view_matrix(camera);
        EXPECT_TRUE(all_finite(m));
        EXPECT_LT(rigidity(m), 1e-12);
        EXPECT_NEAR(glm::determinant(glm::dmat3(m)), 1, 1e-12) << "no mirror image";
    }
}

// Straight down is the limit of tilting a level camera down, straight up of tilting it up.
TEST(LookAt, VerticalViewsKeepTheHorizon) {
    for (const double y : {5., -5.}) {
        const glm::dmat4 vertical = view_matrix(looking({0, y, 0}, {0, 0, 0}, {0, 1, 0}));
        const glm::dmat4 nearly = view_matrix(looking({0, y, 1e-5}, {0, 0, 0}, {0, 1, 0}));
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(glm::length(glm::dvec3(vertical[c]) - glm::dvec3(nearly[c])), 0, 1e-5);
        }
    }
}

using Wide = glm::mat<3, 3, long double>;

// inverse(transpose) in extended precision.
glm::dmat3 oracle(const glm::dmat4& m) { return glm::dmat3(glm::transpose(glm::inverse(Wide(glm::dmat3(m))))); }

double angle_between(glm::dvec3 a, glm::dvec3 b) {
    a /= std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
    b /= std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TEST(NormalMatrix, IsTheInverseTranspose) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-2, 2);
    for (int round = 0; round < 200; ++round) {
        glm::dmat4 m(1);
        for (int c = 0; c < 4; ++c) {
            for (int r = 0; r < 3; ++r) m[c][r] = number(random);
        }
        if (std::abs(glm::determinant(glm::dmat3(m))) < .05) continue;
        const glm::dmat3 expected = oracle(m), got = normal_matrix(m);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(glm::length(got[c] - expected[c]), 0, 1e-10);
    }
}

TEST(NormalMatrix, FlatAndZeroMatrices) {
    for (int degrees = 1; degrees < 180; degrees += 7) {  // the determinant is rounding noise of either sign
        Transformation turn;
        turn.rotate_x = degrees;
        turn.rotate_y = 31 - 3 * degrees;
        const glm::dmat4 rotation = turn.matrix();
        const glm::dvec3 plane = glm::dvec3(rotation * glm::dvec4(0, 0, 1, 0));
        const glm::dmat3 flat = normal_matrix(rotation * diagonal(3, 2, 0) * rotation);
        const glm::dvec3 normal = glm::dvec3(glm::transpose(rotation) * glm::dvec4(0, 0, 1, 0));
        EXPECT_LT(angle_between(flat * normal, plane), 1e-12) << degrees;
    }
    EXPECT_EQ(normal_matrix(diagonal(0, 0, 0)), glm::dmat3(1));
    EXPECT_EQ(normal_matrix(diagonal(1, 0, 0)), glm::dmat3(1));
    EXPECT_EQ(normal_matrix(diagonal(nan_value, 1, 1)), glm::dmat3(1));
    EXPECT_EQ(normal_matrix(diagonal(infinity, 1, 1)), glm::dmat3(1));
}

TEST(Transformation, TurnsAboutTheVerticalAndThenTiltsAboutTheScreensHorizontal) {
    Transformation t;
    t.rotate_x = 90;
    t.rotate_y = 90;
    // About Y first: X goes to -Z, which the tilt moves to Y. Exactly.
    EXPECT_EQ(t.matrix() * glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0));
    EXPECT_EQ(t.matrix() * glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0));
    t.scale = 2;
    t.x = 1;
    t.y = 2;
    t.z = 3;
    EXPECT_EQ(t.matrix() * glm::dvec4(0, 1, 0, 1), glm::dvec4(1, 2, 5, 1));
}

// The step of a drag is a rotation about one line, whatever was turned before.
TEST(Transformation, NoDragRollsTheScene) {
    for (const Vec3 from : {Vec3{0, 0, 5}, {0, 3, 4}, {1, -6, 2}, {0, 5, 0}, {-3, 4, 1e-9}})
        for (const Vec3 up : {Vec3{0, 1, 0}, {0, 0, 1}, {.2, 1, -.3}, {0, -2, 0}}) {
            Camera camera;
            camera.look_at = {{from, Vec3{0, 0, 0}, up}};
            const glm::dmat4 view = view_matrix(camera);
            const glm::dvec3 vertical = vertical_of(camera, view);
            EXPECT_NEAR(glm::length(vertical), 1, 1e-15);
            EXPECT_NEAR(vertical.x, 0, 1e-12) << "the camera is level";
            EXPECT_GE(vertical.y, -1e-12);
            for (const double turned : {0., 37., 90., -150.})
                for (const double tilted : {0., 25., -80.}) {
                    Transformation t;
                    t.rotate_y = turned;
                    t.rotate_x = tilted;
                    const glm::dmat4 before = t.matrix(vertical);
                    EXPECT_NEAR((before * glm::dvec4(vertical, 0)).x, 0, 1e-12) << "up is up on the screen";
                    EXPECT_LT(rigidity(before), 1e-15);
                    t.rotate_x += 10;
                    const glm::dmat4 tilt = t.matrix(vertical) * glm::inverse(before);
                    EXPECT_NEAR(glm::distance(tilt[0], glm::dvec4(1, 0, 0, 0)), 0, 1e-12);
                    EXPECT_NEAR(tilt[1].y, std::cos(10 * M_PI / 180), 1e-12);
                    t.rotate_x -= 10;
                    t.rotate_y += 10;
                    const glm::dmat4 turn = glm::inverse(before) * t.matrix(vertical);
                    const glm::dvec4 axis(vertical, 0);
                    EXPECT_NEAR(glm::distance(turn * axis, axis), 0, 1e-12);
                }
        }
}

TEST(Transformation, ACameraWithoutAnUpVectorHasTheScreens) {
    for (const Vec3 up : {Vec3{0, 0, 0}, {nan_value, 0, 0}, {0, infinity, 0}}) {
        Camera camera;
        camera.look_at = {{Vec3{0, 0, 5}, Vec3{0, 0, 0}, up}};
        EXPECT_EQ(vertical_of(camera, view_matrix(camera)), glm::dvec3(0, 1, 0));
    }
    Camera tiny;
    tiny.look_at = {{Vec3{0, 0, 5}, Vec3{0, 0, 0}, Vec3{0, 1e-300, 0}}};
    EXPECT_EQ(vertical_of(tiny, view_matrix(tiny)), glm::dvec3(0, 1, 0));
}

TEST(Transformation, ExactAtQuartersHoweverFar) {
    for (int quarter = -9; quarter <= 9; ++quarter) {
        Transformation near, far;
        near.rotate_y = 90. * quarter;
        far.rotate_y = near.rotate_y + 360e6;
        const glm::dmat4 m = near.matrix();
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) EXPECT_EQ(m[c][r], std::round(m[c][r]));
        }
        EXPECT_EQ(m, far.matrix());
    }
    Transformation big;
    big.rotate_x = 1e9;  // 280 degrees
    EXPECT_NEAR(big.matrix()[1][1], std::cos(280 * M_PI / 180), 1e-15);
}

TEST(Transformation, RotationStaysRigidAfterManySteps) {
    Transformation t;
    for (int i = 0; i < 1'000'000; ++i) {
        t.rotate_x += .1;
        t.rotate_y -= .37;
    }
    EXPECT_LT(rigidity(t.matrix()), 1e-15);
    t.rotate_x = nan_value;
    t.scale = infinity;
    t.x = nan_value;
    EXPECT_TRUE(all_finite(t.matrix()));
}

}  // namespace
}  // namespace snell
