// Matrices in double precision. The formulas are those of the OpenGL 1.0 specification (glFrustum, glOrtho) and of GLU
// (gluPerspective, gluLookAt), extended to inputs for which these are undefined.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/plan/plan.h"

namespace snell {
namespace {

using std::numbers::pi;

bool usable(double value) { return std::isfinite(value) && value > 0; }

// Half extents that show the square's content, plus more along the longer side.
glm::dvec2 widened(glm::dvec2 half, double aspect) {
    if (aspect >= 1) return {half.x * aspect, half.y};
    return {half.x, half.y / aspect};
}

glm::dmat4 perspective(double fov, double aspect, DepthRange depth) {
    constexpr double smallest = 1e-9;  // in degrees; below it, the reciprocal of the tangent loses its meaning
    if (!(fov >= smallest && fov < 180)) fov = Camera{}.fov;
    if (!usable(depth.near) || !std::isfinite(depth.far) || !(depth.far > depth.near)) depth = DepthRange{};
    const glm::dvec2 half = widened(glm::dvec2(std::tan(fov * (pi / 360))), aspect);
    const double length = depth.far - depth.near;
    glm::dmat4 m(0);
    m[0][0] = 1 / half.x;
    m[1][1] = 1 / half.y;
    m[2][2] = -(depth.far + depth.near) / length;
    m[2][3] = -1;
    m[3][2] = -2 * depth.far * depth.near / length;
    return m;
}

glm::dmat4 orthographic(std::array<double, 4> box, double aspect, DepthRange depth) {
    const auto spans = [](double low, double high) {
        return std::isfinite(low) && std::isfinite(high) && std::isfinite(1 / (high - low)) &&
               std::isfinite(high - low);
    };
    if (!spans(box[0], box[1]) || !spans(box[2], box[3])) box = Camera{}.ortho;
    if (!spans(depth.near, depth.far)) depth = {-DepthRange{}.far, DepthRange{}.far};
    const glm::dvec2 center((box[0] + box[1]) / 2, (box[2] + box[3]) / 2);
    const glm::dvec2 half = widened({(box[1] - box[0]) / 2, (box[3] - box[2]) / 2}, aspect);
    const double length = depth.far - depth.near;
    glm::dmat4 m(1);
    m[0][0] = 1 / half.x;
    m[1][1] = 1 / half.y;
    m[2][2] = -2 / length;
    m[3] = glm::dvec4(-center.x / half.x, -center.y / half.y, -(depth.far + depth.near) / length, 1);
    return m;
}

glm::dvec3 vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double largest_of(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Normalises `v`; returns zero if it has no direction. It is scaled first, so that its squares neither overflow nor
// vanish.
glm::dvec3 direction(glm::dvec3 v) {
    const double size = largest_of(v);
    if (!usable(size)) return glm::dvec3(0);
    v /= size;
    return v / std::sqrt(glm::dot(v, v));
}

// The unit vector perpendicular to `forward` nearest to `up`; zero if they are parallel. The projection is done twice,
// which keeps the result perpendicular to the last digit, however small the angle between them.
glm::dvec3 upright(const glm::dvec3& forward, const glm::dvec3& up) {
    // Below this, the difference of two directions is little more than their rounding error.
    constexpr double parallel = 1e-12;
    glm::dvec3 u = direction(up);
    u -= forward * glm::dot(forward, u);
    if (!(largest_of(u) > parallel)) return glm::dvec3(0);
    u = direction(u);
    return direction(u - forward * glm::dot(forward, u));
}

double length(const glm::dvec3& v) {
    const double size = largest_of(v);
    return size > 0 ? size * std::sqrt(glm::dot(v / size, v / size)) : 0;
}

// |det| relative to its largest possible value (Hadamard's bound), by columns or by rows, whichever is larger: 1 for
// any scaling of perpendicular axes, and rounding noise for a matrix that flattens space.
double independence(const glm::dmat3& a, double determinant) {
    const glm::dmat3 t = glm::transpose(a);
    const double columns = length(a[0]) * length(a[1]) * length(a[2]);
    const double rows = length(t[0]) * length(t[1]) * length(t[2]);
    const double most = std::min(columns, rows);
    return most > 0 ? std::abs(determinant) / most : 0;
}

}  // namespace

glm::dmat4 projection_matrix(const Camera& camera, double aspect, std::optional<DepthRange> depth) {
    if (!usable(aspect)) aspect = 1;  // the window is minimised
    if (camera.perspective) return perspective(camera.fov, aspect, depth.value_or(DepthRange{}));
    return orthographic(camera.ortho, aspect, depth.value_or(DepthRange{-DepthRange{}.far, DepthRange{}.far}));
}

glm::dmat4 view_matrix(const Camera& camera) {
    if (!camera.look_at) return glm::dmat4(1);
    const glm::dvec3 eye = vector((*camera.look_at)[0]);
    if (!finite(eye)) return glm::dmat4(1);
    glm::dvec3 forward = direction(vector((*camera.look_at)[1]) - eye);
    if (forward == glm::dvec3(0)) forward = {0, 0, -1};
    glm::dvec3 up = upright(forward, vector((*camera.look_at)[2]));
    // A camera that looks straight up or down gets the up vector that tilting a level one there would give.
    if (up == glm::dvec3(0)) up = upright(forward, {0, 1, 0});
    if (up == glm::dvec3(0)) up = upright(forward, {0, 0, forward.y});
    const glm::dvec3 right = glm::cross(forward, up);
    glm::dmat4 m(1);
    for (int column = 0; column < 3; ++column) m[column] = glm::dvec4(right[column], up[column], -forward[column], 0);
    const glm::dvec3 shift(-glm::dot(right, eye), -glm::dot(up, eye), glm::dot(forward, eye));
    if (!finite(shift)) return glm::dmat4(1);
    m[3] = glm::dvec4(shift, 1);
    return m;
}

glm::dmat3 normal_matrix(const glm::dmat4& model_view) {
    constexpr double noise = 1e-14;
    // A shader squares the components when it normalises, and the squares must fit into a float.
    constexpr double longest = 1e18, shortest = 1e-18;
    glm::dmat3 a(model_view);
    const double size = std::max({largest_of(a[0]), largest_of(a[1]), largest_of(a[2])});
    if (!usable(size)) return glm::dmat3(1);
    a /= size;
    const glm::dmat3 cofactors(glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1]));
    const double determinant = glm::dot(a[0], cofactors[0]);
    const double top = std::max({largest_of(cofactors[0]), largest_of(cofactors[1]), largest_of(cofactors[2])});
    if (!(independence(a, determinant) > noise)) {
        // A matrix of rank 2 gives every normal the direction of the plane's. Of a lower rank, no lit surface is left.
        return top > noise ? cofactors / top : glm::dmat3(1);
    }
    // The division by the determinant comes last, because the inverse alone may overflow.
    const double sign = determinant < 0 ? -1 : 1;
    const double scale = std::abs(determinant) / top;
    const glm::dmat3 inverse_transpose = (cofactors / (top * sign)) / scale / size;
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (int column = 0; column < 3; ++column) {
        low = std::min(low, length(inverse_transpose[column]));
        high = std::max(high, length(inverse_transpose[column]));
    }
    if (low > shortest && high < longest) return inverse_transpose;
    return inverse_transpose / (std::sqrt(low) * std::sqrt(high));
}

std::array<glm::dvec3, 8> DepthBox::corners() const {
    std::array<glm::dvec3, 8> result;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto at = [&](unsigned i) { return static_cast<double>((corner >> i & 1) != 0 ? max[i] : min[i]); };
        result[corner] = glm::dvec3(eye_from_model * glm::dvec4(at(0), at(1), at(2), 1));
    }
    return result;
}

std::optional<DepthRange> fit_depth(std::span<const DepthBox> boxes) {
    const DepthRange usual;
    double nearest = HUGE_VAL, farthest = 0;
    for (const DepthBox& box : boxes)
        for (const glm::dvec3& corner : box.corners()) {
            if (!std::isfinite(corner.z)) return std::nullopt;
            nearest = std::min(nearest, -corner.z);
            farthest = std::max(farthest, -corner.z);
        }
    // The range is widened by 1 % on both sides to absorb rounding.
    const DepthRange fitted{std::max(usual.near, nearest * .99), std::min(usual.far, farthest * 1.01)};
    if (!(fitted.far > fitted.near)) return std::nullopt;
    return fitted;
}

bool out_of_view(const DepthBox& box, const glm::dmat4& clip_from_eye, const glm::dvec2& margin) {
    // Of the sum of absolute values: about 80 times the rounding error of a float.
    constexpr double rounding = 1e-5;
    const glm::dvec3 low(box.min[0], box.min[1], box.min[2]), high(box.max[0], box.max[1], box.max[2]);
    const glm::dvec3 middle = (low + high) / 2., half = (high - low) / 2.;
    const glm::dmat4& eye = box.eye_from_model;
    const glm::dvec4 at = eye * glm::dvec4(middle, 1);
    glm::dvec4 size = glm::abs(eye[3]);
    for (int axis = 0; axis < 3; ++axis) size += glm::abs(eye[axis]) * (std::abs(middle[axis]) + half[axis]);
    const glm::dmat4 rows = glm::transpose(clip_from_eye);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec4 w = rows[3] * (axis < 2 ? 1 + margin[axis] : 1.);
        const double error = rounding * glm::dot(glm::abs(w) + glm::abs(rows[axis]), size);
        for (const double side : {-1., 1.}) {
            const glm::dvec4 inwards = w + side * rows[axis];
            double most = glm::dot(inwards, at);
            for (int k = 0; k < 3; ++k) most += std::abs(glm::dot(inwards, eye[k])) * half[k];
            if (most < -error) return true;  // all corners are beyond one plane, and so is everything between them
        }
    }
    return false;
}

}  // namespace snell
