// Hard cases of matrices and of values, beside what the usual library gives for them.
#include <glm/gtc/matrix_transform.hpp>

#include "src/plan/plan.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/declared.h"
#include "src/plan/view.h"
#include "tests/hard_case.h"
#include "tests/plan/finite.h"
#include "tests/std.h"

namespace snell {
namespace {

using test::hard_case;

constexpr double pi = 3.14159265358979323846;

// Between directions whose lengths may be anything that is not 0.
double angle(glm::dvec3 a, glm::dvec3 b) {
    a /= std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
    b /= std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

glm::dvec3 vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

TEST(HardMatrices, LookAtWithoutADirection) {
    int ours = 0, naive = 0;
    for (const Camera& camera : {looking({1, 1, 1}, {1, 1, 1}, {0, 1, 0}), looking({0, 5, 0}, {0, 0, 0}, {0, 1, 0}),
                                 looking({0, 0, 5}, {0, 0, 0}, {0, 0, 0}), looking({5, 0, 0}, {0, 0, 0}, {-1, 0, 0})}) {
        const std::array<Vec3, 3>& at = *camera.look_at;
        ours += !(rigidity(view_matrix(camera)) < 1e-12);
        naive += !(rigidity(glm::lookAt(vector(at[0]), vector(at[1]), vector(at[2]))) < 1e-12);
    }
    hard_case({"23", "LookAt: eye = centre, up parallel or zero; naive: glm::lookAt", "of 4 not rigid", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
    double worst = 0, worst_in_float = 0;
    const glm::dvec3 forward = glm::normalize(glm::dvec3(.3, -.8, .52)),
                     side = glm::cross(forward, glm::dvec3(0, 1, 0));
    for (const double off : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        const glm::dvec3 up = forward + off * side;
        worst = std::max(
            worst, rigidity(view_matrix(looking({0, 0, 0}, {forward.x, forward.y, forward.z}, {up.x, up.y, up.z}))));
        const double in_float = rigidity(glm::lookAt(glm::vec3(0), glm::vec3(forward), glm::vec3(up)));
        if (!(in_float <= worst_in_float) && !std::isnan(worst_in_float)) worst_in_float = in_float;
    }
    hard_case({"A7", "LookAt: up 1e-4 to 1e-8 rad off the view; naive: glm::lookAt in float", "from orthonormal", 1e-6,
               worst, worst_in_float});
}

TEST(HardMatrices, ProjectionsOfNothing) {
    const glm::dmat4 usual = projection_matrix(Camera{}, 1);
    int ours = 0, naive = 0, ours_flat = 0, naive_flat = 0;
    const auto useless = [](const glm::dmat4& m) {
        return !all_finite(m) || !all_finite(glm::inverse(m)) || !(m[0][0] > 0 && m[0][0] < 1e6);
    };
    for (const double fov : {0., -50., 180., 360., nan_value}) {
        Camera camera;
        camera.fov = fov;
        ours += projection_matrix(camera, 1) != usual;
        naive += useless(glm::perspective(glm::radians(fov), 1., .1, 1000.));
    }
    Camera narrow;
    narrow.fov = .0001;
    ours += std::abs(projection_matrix(narrow, 1)[1][1] * std::tan(narrow.fov * pi / 360) - 1) > 1e-9;
    hard_case({"24", "Perspective 0, -50, 180, 360, NaN: the default; .0001 works; naive: glm::perspective",
               "of 6 that show nothing", 0, static_cast<double>(ours), static_cast<double>(naive)});
    const struct {
        double aspect, near, far;
    } flat[] = {{1, 1, 1}, {1, 0, 0}, {0. / 0., .1, 1000}, {infinity, .1, 1000}, {1, 10, nan_value}};
    for (const auto& f : flat) {
        ours_flat += useless(projection_matrix(Camera{}, f.aspect, DepthRange{f.near, f.far}));
        glm::dmat4 theirs(nan_value);
        // GLM asserts that an aspect is not 0: what it computes, without the assertion.
        const double t = std::tan(glm::radians(25.));
        theirs = glm::dmat4(0);
        theirs[0][0] = 1 / (f.aspect * t);
        theirs[1][1] = 1 / t;
        theirs[2][2] = -(f.far + f.near) / (f.far - f.near);
        theirs[2][3] = -1;
        theirs[3][2] = -2 * f.far * f.near / (f.far - f.near);
        naive_flat += useless(theirs);
    }
    hard_case({"25", "near = far, windows of 0 × 0 or without height; naive: gluPerspective's formula",
               "of 5 that show nothing", 0, static_cast<double>(ours_flat), static_cast<double>(naive_flat)});
    Camera ortho;
    ortho.perspective = false;
    const glm::dmat4 box = projection_matrix(ortho, 1);
    int wrong = 0, wrong_ortho = 0;
    for (const std::array<double, 4>& sides :
         {std::array<double, 4>{1, 1, -1, 1}, {-1, 1, 2, 2}, {0, 0, 0, 0}, {nan_value, 1, 0, 1}}) {
        ortho.ortho = sides;
        wrong += projection_matrix(ortho, 1) != box;
        wrong_ortho += !all_finite(glm::ortho(sides[0], sides[1], sides[2], sides[3]));
    }
    const std::array<double, 4> usual_sides = Camera{}.ortho;
    ortho.ortho = {usual_sides[1], usual_sides[0], usual_sides[2], usual_sides[3]};
    wrong += projection_matrix(ortho, 1)[0][0] != -box[0][0];
    hard_case({"26", "Ortho without width or height: the default; swapped sides mirror; naive: glm::ortho",
               "of 5 wrong", 0, static_cast<double>(wrong), static_cast<double>(wrong_ortho)});
}

glm::dmat4 scaled(double x, double y, double z) { return glm::scale(glm::dmat4(1), glm::dvec3(x, y, z)); }

// As a shader normalises it, in float.
double normal_error(const glm::mat3& matrix, const glm::dvec3& normal, const glm::dvec3& truth) {
    const glm::vec3 n = glm::normalize(matrix * glm::vec3(normal));
    if (!std::isfinite(n.x + n.y + n.z) || n == glm::vec3(0)) return infinity;
    return angle(n, truth);
}

TEST(HardMatrices, NormalsOfEveryScale) {
    Transformation turn;
    turn.rotate_x = 33;
    turn.rotate_y = -71;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, -3));
    double ours = 0, naive = 0, ours_large = 0, naive_large = 0, mirrored = 0;
    for (const double scale : {1e-30, 1e-20, 1e-13, 1., 1e10, 1e13, 1e20, 1e30}) {
        for (const glm::dvec3 axes : {glm::dvec3(1, 1, 1), {1, 2, 5}, {-1, 1, 1}, {-1, -2, -3}}) {
            const glm::dmat4 m = turn.matrix() * scaled(scale * axes.x, scale * axes.y, scale * axes.z);
            const glm::dvec3 truth = glm::dmat3(turn.matrix()) * (normal / axes);
            const double of_ours = normal_error(glm::mat3(normal_matrix(m)), normal, truth);
            // glman's: the inverse transpose of a matrix of floats.
            const double of_naive = normal_error(glm::transpose(glm::inverse(glm::mat3(m))), normal, truth);
            ours = std::max(ours, of_ours);
            naive = std::max(naive, of_naive);
            if (scale == 1e10 || scale == 1e13) {
                ours_large = std::max(ours_large, of_ours);
                naive_large = std::max(naive_large, of_naive);
            }
            if (axes.x < 0) mirrored = std::max(mirrored, of_ours);
        }
    }
    EXPECT_LT(mirrored, 1e-6) << "normals of mirrored solids stay outward";
    EXPECT_TRUE(all_finite(normal_matrix(scaled(0, 0, 0))) && all_finite(normal_matrix(scaled(1, 1, 0))));
    hard_case({"29", "Scale 1e-30 to 1e30, unequal and mirrored; naive: inverse transpose in float", "rad", 1e-6, ours,
               naive});
    hard_case({"A8", "Scale 1e10 and 1e13: cofactors vanish, inverses are NaN; naive: inverse transpose in float",
               "rad", 1e-6, ours_large, naive_large});
}

TEST(HardMatrices, ReflectionsOfAnUnequalScale) {
    const glm::dmat4 m = scaled(1, 2, 1);
    double ours = 0, naive = 0;
    for (int i = 0; i < 360; ++i) {
        const glm::dvec3 n(std::cos(i * pi / 180), std::sin(i * pi / 180), 0),
            truth = glm::normalize(n / glm::dvec3(1, 2, 1));
        const auto mirrored = [](const glm::dvec3& normal) {
            const glm::dvec3 u = glm::normalize(normal), d(-1, 0, 0);
            return d - 2 * glm::dot(d, u) * u;
        };
        ours = std::max(ours, angle(mirrored(normal_matrix(m) * n), mirrored(truth)));
        naive = std::max(naive, angle(mirrored(glm::dmat3(m) * n), mirrored(truth)));
    }
    hard_case({"30", "reflections of a ball scaled 1 : 2; naive: normals by the model-view matrix", "degrees", 1e-6,
               ours * 180 / pi, naive * 180 / pi});
}

TEST(HardMatrices, RotationsThatGoOn) {
    Transformation t;
    const glm::mat4 step = glm::rotate(glm::mat4(1), glm::radians(.1F), glm::normalize(glm::vec3(1, 2, 3)));
    glm::mat4 product(1);
    for (int i = 0; i < 10'000'000; ++i) t.rotate_x += .1;
    for (int i = 0; i < 1'000'000; ++i) product = step * product;
    hard_case({"31", "ten million steps of rotation: rebuilt from angles; naive: a product of a million floats",
               "from orthonormal", 1e-12, rigidity(t.matrix()), rigidity(product)});
    Transformation large;
    large.rotate_x = 1e9;  // 280 degrees
    hard_case({"28", "Rotate 1e9 is Rotate 280: reduced by 360 first; naive: cos of radians in float", "of the cosine",
               1e-12, std::abs(large.matrix()[1][1] - std::cos(280 * pi / 180)),
               std::abs(static_cast<double>(std::cos(static_cast<float>(1e9 * pi / 180))) - std::cos(280 * pi / 180))});
}

TEST(HardMatrices, AMillionUnitsAway) {
    const glm::dvec3 far(1e6, 2e6, -1e6), point(.3, .7, -.2);
    const Camera camera = looking({far.x, far.y, far.z + 5}, {far.x, far.y, far.z}, {0, 1, 0});
    const glm::dmat4 model = glm::translate(glm::dmat4(1), far);
    const glm::dvec4 truth(point.x, point.y, point.z - 5, 1);
    const glm::mat4 at_once(view_matrix(camera) * model);
    const glm::vec4 by_world = glm::mat4(view_matrix(camera)) * (glm::mat4(model) * glm::vec4(point, 1));
    const glm::vec4 ours = at_once * glm::vec4(point, 1);
    hard_case({"32", "a million units from the origin: model-view in double; naive: by way of the world in float",
               "units of length", 1e-6, glm::length(glm::dvec4(ours) - truth),
               glm::length(glm::dvec4(by_world) - truth)});
}

TEST(HardValues, RangesThatASliderCannotHave) {
    int ours = 0, naive = 0;
    const Range ranges[] = {{-3e38, 0, 3e38}, {0, .5, infinity},        {nan_value, .5, 1}, {0, nan_value, 1},
                            {5, 2, 1},        {-infinity, 0, infinity}, {-1e300, 0, 1e300}, {0, 1e-320, 1e-310}};
    // What Dear ImGui asserts: an order, and a width that is a number.
    const auto aborts = [](double min, double max) {
        const float width = static_cast<float>(max) - static_cast<float>(min);
        return !(min <= max) || !std::isfinite(width) || !std::isfinite(width * 1.01F);
    };
    Scene scene;
    Program program;
    program.name = "P";
    for (const Range& r : ranges) {
        UniformValue value;
        value.name = "u";
        value.kind = UniformValue::Kind::range;
        value.values = {r.min, r.current, r.max};
        program.uniforms = {value};
        scene.programs = {program};
        ActiveUniform uniform;
        uniform.name = "u";
        uniform.glsl_type = "float";
        uniform.initial = {0};
        Diagnostics diagnostics;
        const Controls controls = make_controls(scene, {{uniform}}, diagnostics);
        const Control& control = *controls.find(0, "u");
        ours += aborts(control.min, control.max) || !std::isfinite(control.value[0]) ||
                control.value[0] < control.min || control.value[0] > control.max;
        naive += aborts(r.min, r.max);
    }
    hard_case({"43", "ranges such as <0 .5 inf>, <-3e38 0 3e38>, <5 2 1>: none reaches Dear ImGui, which aborts",
               "of 8 it would abort for", 0, static_cast<double>(ours), static_cast<double>(naive)});
}

TEST(HardValues, IntegersAreRoundedOnce) {
    int ours = 0, naive = 0, twice = 0;
    for (int i = -2000; i <= 2000; ++i) {
        const double value = i / 100.;
        const double fitted = fit_to_type(value, ValueType::int_);
        ours += std::abs(fitted - value) > .5 || fitted != std::round(fitted);
        naive += std::abs(static_cast<int>(value) - value) > .5;
        twice += fit_to_type(fitted, ValueType::int_) != fitted;
    }
    EXPECT_EQ(twice, 0) << "rounding again changes nothing";
    hard_case({"44", "fractions for an integer: the nearest one; naive: a cast", "of 4001 further than .5", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
}

}  // namespace
}  // namespace snell
