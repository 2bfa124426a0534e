// The Utah teapot: Martin Newell's 32 bicubic Bezier patches of 1975 (rim 4, body 8, lid 8, bottom 4, handle 4, spout
// 4), with the size and position of glutSolidTeapot(1), turned so that +Y is up and the spout points to +X.
#include "src/content/mesh/teapot.h"

#include <algorithm>
#include <cmath>

#include "src/content/mesh/surface.h"

namespace snell::content {
namespace {

// Newell's numbers, with z up. Rim, body, lid and bottom are surfaces of revolution: the profile has four control
// points (radius, height), and a quarter circle is (r, 0) (r, c) (c, r) (0, r).
struct Turned {
    double radius, height, c;
};
using Profile = std::array<Turned, 4>;

constexpr Turned turned(double radius, double height) { return {radius, height, .56 * radius}; }

// t runs along the profile: outward from the tip of the lid and from the middle of the bottom, otherwise downward.
constexpr std::array<Profile, 5> downward{{
    {turned(1.4, 2.4), turned(1.3375, 2.53125), turned(1.4375, 2.53125), turned(1.5, 2.4)},  // rim
    {turned(1.5, 2.4), turned(1.75, 1.875), turned(2, 1.35), turned(2, .9)},                 // body
    {turned(2, .9), turned(2, .45), turned(1.5, .225), turned(1.5, .15)},                    //
    {turned(0, 3.15), Turned{.8, 3.15, .45}, turned(0, 2.7), turned(.2, 2.7)},               // lid
    {turned(.2, 2.7), turned(.4, 2.55), turned(1.3, 2.55), turned(1.3, 2.4)},                //
}};
constexpr Profile bottom{turned(0, 0), turned(1.425, 0), turned(1.5, .075), turned(1.5, .15)};

// Handle and spout are tubes: each row is half a cross-section, from (x0, z0) around the side at y = width to (x1, z1).
struct Section {
    double x0, z0, x1, z1, width;
};
using Tube = std::array<Section, 4>;
constexpr std::array<Tube, 4> tubes{{
    {{{-1.6, 2.025, -1.5, 2.25, .3},
      {-2.3, 2.025, -2.5, 2.25, .3},
      {-2.7, 2.025, -3, 2.25, .3},
      {-2.7, 1.8, -3, 1.8, .3}}},
    {{{-2.7, 1.8, -3, 1.8, .3}, {-2.7, 1.575, -3, 1.35, .3}, {-2.5, 1.125, -2.65, .9375, .3}, {-2, .9, -1.9, .6, .3}}},
    {{{1.7, 1.425, 1.7, .6, .66},
      {2.6, 1.425, 3.1, .825, .66},
      {2.3, 2.1, 2.4, 2.025, .25},
      {2.7, 2.4, 3.3, 2.4, .25}}},
    {{{2.7, 2.4, 3.3, 2.4, .25},
      {2.8, 2.475, 3.525, 2.49375, .25},
      {2.9, 2.475, 3.45, 2.5125, .15},
      {2.8, 2.4, 3.2, 2.4, .15}}},
}};

using Patch = std::array<std::array<Vec3, 4>, 4>;  // indexed [along t][along s], y up

// Converts Newell's coordinates to snell's: y up, with GLUT's scale and height.
Vec3 placed(double x, double y, double z) { return {.5 * x, .5 * (z - 1.5), .5 * y}; }

Patch turned_patch(const Profile& profile, int quarter, bool reversed) {
    Patch patch;
    for (std::size_t j = 0; j < 4; ++j) {
        const auto [r, h, c] = profile[j];
        const std::array<Vec2, 4> arc{{{r, 0}, {r, c}, {c, r}, {0, r}}};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [x, y] = arc[reversed ? 3 - k : k];
            const std::array<Vec2, 4> turns{{{x, y}, {-y, x}, {-x, -y}, {y, -x}}};
            const auto [tx, ty] = turns[static_cast<std::size_t>(quarter)];
            patch[j][k] = placed(tx, ty, h);
        }
    }
    return patch;
}

Patch tube_patch(const Tube& tube, bool far_half) {
    Patch patch;
    for (std::size_t j = 0; j < 4; ++j) {
        const Section& s = tube[j];
        const double y = far_half ? -s.width : s.width;
        patch[j] = {placed(s.x0, 0, s.z0), placed(s.x0, y, s.z0), placed(s.x1, y, s.z1), placed(s.x1, 0, s.z1)};
        if (far_half) std::reverse(patch[j].begin(), patch[j].end());
    }
    return patch;
}

using Weights = std::array<double, 4>;
Weights bernstein(double t) {
    const double u = 1 - t;
    return {u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t};
}
Weights bernstein_slope(double t) {
    const double u = 1 - t;
    return {-3 * u * u, 3 * u * u - 6 * u * t, 6 * u * t - 3 * t * t, 3 * t * t};
}

// Sums along s first, so that neighbours are equal to the bit on shared edges, where one weight is 1 and the others are
// 0.
Vec3 evaluate(const Patch& patch, const Weights& s, const Weights& t) {
    Vec3 sum{0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t j = 0; j < 4; ++j) {
            double row = 0;
            for (std::size_t k = 0; k < 4; ++k) row += s[k] * patch[j][k][axis];
            sum[axis] += t[j] * row;
        }
    return sum;
}

Vec3 cross_product(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

Vec2 largest_slopes(const Patch& patch) {
    const auto distance = [](const Vec3& a, const Vec3& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    Vec2 largest{0, 0};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; k < 3; ++k) {
            largest[0] = std::max(largest[0], 3 * distance(patch[j][k], patch[j][k + 1]));
            largest[1] = std::max(largest[1], 3 * distance(patch[k][j], patch[k + 1][j]));
        }
    return largest;
}

// A patch, and upper bounds of its derivatives along s and along t, from its control net.
struct Net {
    Patch points;
    Vec2 largest;
};

std::vector<Net> make_nets() {
    std::vector<Patch> patches;
    for (const Profile& profile : downward)
        for (int quarter = 0; quarter < 4; ++quarter) patches.push_back(turned_patch(profile, quarter, false));
    for (int quarter = 0; quarter < 4; ++quarter) patches.push_back(turned_patch(bottom, quarter, true));
    for (const Tube& tube : tubes)
        for (const bool far_half : {false, true}) patches.push_back(tube_patch(tube, far_half));

    std::vector<Net> nets;
    for (const Patch& patch : patches) nets.push_back({patch, largest_slopes(patch)});
    return nets;
}

const std::vector<Net>& nets() {
    static const std::vector<Net> table = make_nets();
    return table;
}

// Ss x St. If the row t = 0 is one point (tip of the lid, middle of the bottom), Ss vanishes like t Sst, and the limit
// of the direction is Sst x St. In floating point the product there is a small rounding error rather than 0, so the
// threshold is relative.
Vec3 normal(const Net& net, double s, double t) {
    const Patch& patch = net.points;
    const Vec3 along_s = evaluate(patch, bernstein_slope(s), bernstein(t));
    const Vec3 along_t = evaluate(patch, bernstein(s), bernstein_slope(t));
    const Vec3 product = cross_product(along_s, along_t);
    if (length(product) >= 1e-4 * net.largest[0] * net.largest[1]) return product;
    return cross_product(evaluate(patch, bernstein_slope(s), bernstein_slope(t)), along_t);
}

}  // namespace

SurfacePoint teapot_point(int patch, double s, double t) {
    const Net& net = nets()[static_cast<std::size_t>(patch)];
    return {evaluate(net.points, bernstein(s), bernstein(t)), normal(net, s, t)};
}

Mesh make_teapot(bool wire) {
    const int n = wire ? 10 : 16;  // steps along each side of a patch; glutWireTeapot has 10
    Surface surface(wire);
    surface.reserve(teapot_patches * 17 * 17, teapot_patches * 16 * 16);
    for (int patch = 0; patch < teapot_patches; ++patch)
        surface.grid(n, n, [&](int i, int j) {
            const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
            const SurfacePoint point = teapot_point(patch, s, t);
            surface.vertex(point.position, point.normal, {s, t, 0});
        });
    return std::move(surface).finish();
}

}  // namespace snell::content
