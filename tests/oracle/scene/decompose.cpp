#include "tests/oracle/scene/decompose.h"

#include <algorithm>
#include <cmath>

namespace snell {
namespace {

constexpr double pi = 3.14159265358979323846;
using Mat3 = std::array<Vec3, 3>;  // columns

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 unit(const Vec3& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}

// Any unit vector at right angles to a unit vector.
Vec3 perpendicular(const Vec3& v) {
    const std::size_t least = std::abs(v[0]) <= std::abs(v[1]) ? (std::abs(v[0]) <= std::abs(v[2]) ? 0 : 2)
                                                               : (std::abs(v[1]) <= std::abs(v[2]) ? 1 : 2);
    Vec3 axis{0, 0, 0};
    axis[least] = 1;
    return unit(cross(v, axis));
}

void rotate_columns(Vec3& p, Vec3& q, double c, double s) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = p[i], b = q[i];
        p[i] = c * a - s * b;
        q[i] = s * a + c * b;
    }
}

// Turns the columns of `a` until they are orthogonal, and those of `v` along with them.
void orthogonalise(Mat3& a, Mat3& v) {
    for (int sweep = 0; sweep < 60; ++sweep) {
        bool done = true;
        for (std::size_t p = 0; p < 2; ++p) {
            for (std::size_t q = p + 1; q < 3; ++q) {
                const double pp = dot(a[p], a[p]), qq = dot(a[q], a[q]), pq = dot(a[p], a[q]);
                if (std::abs(pq) <= 1e-17 * std::sqrt(pp * qq) || pq == 0) continue;
                done = false;
                const double zeta = (qq - pp) / (2 * pq);
                const double t = (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
                const double c = 1 / std::sqrt(1 + t * t);
                rotate_columns(a[p], a[q], c, c * t);
                rotate_columns(v[p], v[q], c, c * t);
            }
        }
        if (done) return;
    }
}

// The rotation whose columns these are; through the unit quaternion, by its largest component (Shepperd 1978).
std::optional<Turn> turn(const Mat3& r) {
    const double trace = r[0][0] + r[1][1] + r[2][2];
    const std::array<double, 4> squares{1 + 2 * r[0][0] - trace, 1 + 2 * r[1][1] - trace, 1 + 2 * r[2][2] - trace,
                                        1 + trace};
    const auto largest = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    const double d = squares[largest];  // four times the square of that component
    Vec3 v;
    double w = 0;
    if (largest == 3) {
        w = d;
        v = {r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0]};
    } else {
        const std::size_t i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
        v[i] = d;
        v[j] = r[i][j] + r[j][i];
        v[k] = r[i][k] + r[k][i];
        w = r[j][k] - r[k][j];
    }
    const double sine = std::hypot(v[0], v[1], v[2]);
    if (sine == 0) return std::nullopt;
    return Turn{2 * std::atan2(sine, w) * (180 / pi), {v[0] / sine, v[1] / sine, v[2] / sine}};
}

}  // namespace

Decomposed decompose(const Mat4& m) {
    Decomposed out;
    out.translate = {m[12], m[13], m[14]};
    Mat3 a{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
    double largest = 0;
    bool diagonal = true;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            largest = std::max(largest, std::abs(a[i][j]));
            diagonal = diagonal && (i == j || a[i][j] == 0);
        }
    }
    if (diagonal) {
        out.scale = {a[0][0], a[1][1], a[2][2]};
        return out;
    }
    for (Vec3& column : a)
        for (double& x : column) x /= largest;
    Mat3 v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    orthogonalise(a, v);
    // Largest first: directions of columns that vanish are made up from the others.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return dot(a[i], a[i]) > dot(a[j], a[j]); });
    Mat3 u, right;
    for (std::size_t i = 0; i < 3; ++i) right[i] = v[order[i]];
    right[2] = cross(right[0], right[1]);  // a rotation: without mirroring
    u[0] = unit(a[order[0]]);
    const Vec3 second = a[order[1]];
    const Vec3 rest{second[0] - dot(second, u[0]) * u[0][0], second[1] - dot(second, u[0]) * u[0][1],
                    second[2] - dot(second, u[0]) * u[0][2]};
    u[1] = dot(rest, rest) > 0 ? unit(rest) : perpendicular(u[0]);
    u[2] = cross(u[0], u[1]);
    const double mirrored = dot(right[2], v[order[2]]) < 0 ? -1 : 1;
    out.scale = {dot(a[order[0]], u[0]) * largest, dot(second, u[1]) * largest,
                 mirrored * dot(a[order[2]], u[2]) * largest};
    const Mat3 transposed{{{right[0][0], right[1][0], right[2][0]},
                           {right[0][1], right[1][1], right[2][1]},
                           {right[0][2], right[1][2], right[2][2]}}};
    out.outer = turn(u);
    out.inner = turn(transposed);
    return out;
}

}  // namespace snell
