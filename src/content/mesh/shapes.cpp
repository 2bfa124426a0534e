// Boxes, quads and point clouds.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "parser/vectors.h"
#include "src/content/mesh/surface.h"

namespace snell::content {
namespace {

// -1 to 1 in n steps; steps i and n - i are exact mirror images.
double across(int i, int n) { return static_cast<double>(2 * std::int64_t{i} - n) / n; }
double fraction(int i, int n) { return static_cast<double>(i) / n; }

struct Face {
    Vec3 normal, s, t;  // s x t = normal
};

// splitmix64 (Steele et al. 2014), so that the cloud is the same on every machine.
class Random {
public:
    double unit() {  // in [0, 1)
        std::uint64_t x = state_ += 0x9e3779b97f4a7c15ull;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
        return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_ = 20110321;
};

}  // namespace

// On each face s and t are 0..1, upright (t along +y) and not mirrored seen from outside. On the top face t runs along
// -z, on the bottom face along +z.
Mesh make_box(const Box& b, bool wire) {
    static constexpr std::array<Face, 6> faces{{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                                {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                                {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                                {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                                {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}};
    const Vec3 half{b.dx / 2, b.dy / 2, b.dz / 2};
    Surface surface(wire);
    for (const Face& face : faces)
        surface.grid(1, 1, [&](int i, int j) {
            Vec3 position;
            for (std::size_t k = 0; k < 3; ++k)
                position[k] = half[k] * (face.normal[k] + across(i, 1) * face.s[k] + across(j, 1) * face.t[k]);
            surface.vertex(position, face.normal, {fraction(i, 1), fraction(j, 1), 0});
        });
    return std::move(surface).finish();
}

// The front faces +Z, +Y or +X, on whichever side of the origin the quad is. s and t run as in glman, so that six
// quads around the origin show the faces of a cube map:
//   XY  z >= 0: s +x, t +y    z < 0: s -x, t +y
//   XZ  y >= 0: s +x, t -z    y < 0: s +x, t +z
//   YZ  x >= 0: s -z, t +y    x < 0: s +z, t +y
Mesh make_quad(const Quad& q, bool wire) {
    const bool beyond = q.offset >= 0;
    Surface surface(wire);
    surface.reserve((static_cast<std::size_t>(q.n1) + 1) * (static_cast<std::size_t>(q.n2) + 1),
                    static_cast<std::size_t>(q.n1) * static_cast<std::size_t>(q.n2));
    surface.grid(q.n1, q.n2, [&](int i, int j) {
        const double a = q.size * across(i, q.n1), b = q.size * across(j, q.n2);
        const double u = fraction(i, q.n1), v = fraction(j, q.n2);
        switch (q.plane) {
            case Plane::xy:  // a along x, b along y
                surface.vertex({a, b, q.offset}, {0, 0, 1}, {beyond ? u : 1 - u, v, 0});
                break;
            case Plane::xz:  // a along x, b along -z
                surface.vertex({a, q.offset, -b}, {0, 1, 0}, {u, beyond ? v : 1 - v, 0});
                break;
            case Plane::yz:  // a along y, b along z
                surface.vertex({q.offset, a, b}, {1, 0, 0}, {beyond ? 1 - v : v, u, 0});
                break;
        }
    });
    return std::move(surface).finish();
}

// Quads face +Z. The farthest from a viewer on +Z is first, so that they blend in order. A single quad is in the
// middle.
Mesh make_quad_box(const QuadBox& b, bool wire) {
    Surface surface(wire);
    for (int k = 0; k < b.n; ++k) {
        const double z = b.n == 1 ? 0 : across(k, b.n - 1);
        surface.grid(1, 1, [&](int i, int j) {
            const double x = across(i, 1), y = across(j, 1);
            surface.vertex({x, y, z}, {0, 0, 1}, {(x + 1) / 2, (y + 1) / 2, (z + 1) / 2});
        });
    }
    return std::move(surface).finish();
}

// A regular cloud spans -1 to 1, both included. A jittered cloud has one random point in each of nx x ny x nz equal
// cells. Texture coordinates are the position in the cloud, 0..1; normals are +Z.
Mesh make_cloud(const PointCloud& c) {
    const std::array<int, 3> n{c.nx, c.ny, c.nz};
    Mesh mesh;
    mesh.topology = Topology::points;
    const std::size_t count =
        static_cast<std::size_t>(c.nx) * static_cast<std::size_t>(c.ny) * static_cast<std::size_t>(c.nz);
    mesh.positions.reserve(count);
    mesh.texcoords.reserve(count);
    mesh.normals.assign(count, {0, 0, 1});
    mesh.indices.resize(count);
    for (std::size_t i = 0; i < count; ++i) mesh.indices[i] = static_cast<std::uint32_t>(i);

    Random random;
    const auto place = [&](int i, std::size_t axis) {
        if (c.jitter) return (i + random.unit()) / n[axis] * 2 - 1;
        return n[axis] == 1 ? 0. : across(i, n[axis] - 1);
    };
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i) {
                const double x = place(i, 0), y = place(j, 1), z = place(k, 2);
                mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
                mesh.texcoords.push_back({static_cast<float>((x + 1) / 2), static_cast<float>((y + 1) / 2),
                                          static_cast<float>((z + 1) / 2)});
            }
    mesh.compute_bounds();
    return mesh;
}

// Surfaces of revolution.
namespace {

// Adds a straight side from (radius0, y0) up to (radius1, y1) in `stacks` steps.
void add_side(std::vector<Ring>& rings, double radius0, double y0, double radius1, double y1, int stacks, double t0,
              double t1) {
    // The normal is perpendicular to the side, outward; that of a side without length is radial.
    double radial = y1 - y0, up = radius0 - radius1;
    if (radial == 0 && up == 0) radial = 1;
    for (int j = 0; j <= stacks; ++j) {
        const double f = fraction(j, stacks);
        rings.push_back({radius0 * (1 - f) + radius1 * f, y0 * (1 - f) + y1 * f, radial, up, t0 * (1 - f) + t1 * f});
    }
}

// Adds a cap that faces up (`up` = 1) or down (-1). Rings ascend on the outside, so a lower cap goes from its centre to
// its rim.
void add_cap(std::vector<Ring>& rings, double radius, double y, double up, double t) {
    const Ring centre{0, y, 0, up, t}, rim{radius, y, 0, up, t};
    if (up < 0)
        rings.insert(rings.end(), {centre, rim});
    else
        rings.insert(rings.end(), {rim, centre});
}

// Cones and cylinders of negative height extend below y = 0: they use the same rings, mirrored and in the opposite
// order.
Mesh stand(std::vector<Ring> rings, int slices, bool hang, bool wire) {
    if (hang) {
        for (Ring& r : rings) {
            r.y = -r.y;
            r.normal_y = -r.normal_y;
        }
        std::reverse(rings.begin(), rings.end());
    }
    Surface surface(wire);
    revolve(surface, slices, rings);
    return std::move(surface).finish();
}

}  // namespace

// x = cos(lng) cos(lat), y = sin(lat), z = -sin(lng) cos(lat), with lng = -pi + 2 pi s and lat = -pi/2 + pi t.
Mesh make_sphere(const Sphere& s, bool wire) {
    const std::vector<SinCos> angle = circle(2 * s.stacks);  // begins at the south pole
    std::vector<Ring> rings;
    for (int j = 0; j <= s.stacks; ++j) {
        const double radial = angle[static_cast<std::size_t>(j)].sin, up = -angle[static_cast<std::size_t>(j)].cos;
        rings.push_back({s.radius * radial, s.radius * up, radial, up, fraction(j, s.stacks)});
    }
    Surface surface(wire);
    revolve(surface, s.slices, rings, true);
    return std::move(surface).finish();
}

// The ring is in the XZ plane. s runs around the ring as on the sphere, t around the tube from the outer equator over
// the top.
Mesh make_torus(const Torus& s, bool wire) {
    const std::vector<SinCos> tube = circle(s.sides);
    std::vector<Ring> rings;
    for (int j = 0; j <= s.sides; ++j) {
        const SinCos a = tube[static_cast<std::size_t>(j)];
        rings.push_back({s.outer + s.inner * a.cos, s.inner * a.sin, a.cos, a.sin, fraction(j, s.sides)});
    }
    Surface surface(wire);
    revolve(surface, s.rings, rings);
    return std::move(surface).finish();
}

// The cap at y = 0 has t = 0. The apex has one vertex for each slice, with that slice's normal.
Mesh make_cone(const Cone& s, bool wire) {
    std::vector<Ring> rings;
    add_cap(rings, s.radius, 0, -1, 0);
    add_side(rings, s.radius, 0, 0, std::abs(s.height), s.stacks, 0, 1);
    return stand(std::move(rings), s.slices, s.height < 0, wire);
}

// The caps have t = 0 and t = 1.
Mesh make_cylinder(const Cylinder& s, bool wire) {
    const double height = std::abs(s.height);
    std::vector<Ring> rings;
    add_cap(rings, s.radius, 0, -1, 0);
    add_side(rings, s.radius, 0, s.radius, height, s.stacks, 0, 1);
    add_cap(rings, s.radius, height, 1, 1);
    return stand(std::move(rings), s.slices, s.height < 0, wire);
}

// The disc faces +Z. s and t span its bounding square, s along +x, t along +y.
Mesh make_disk(const Disk& s, bool wire) {
    const std::vector<SinCos> around = circle(s.slices);
    Surface surface(wire);
    surface.grid(s.rings, s.slices, [&](int ring, int slice) {
        const SinCos a = around[static_cast<std::size_t>(slice)];
        const double f = fraction(ring, s.rings);
        surface.vertex({s.radius * f * a.cos, s.radius * f * a.sin, s.z}, {0, 0, 1},
                       {.5 + .5 * f * a.cos, .5 + .5 * f * a.sin, 0});
    });
    return std::move(surface).finish();
}

// A solid arrow, so that it can be lit: a shaft of radius .02 to x = .8, then a head of radius .06. It has n sections
// along X, so that a vertex shader can bend it, and 24 around; t = x.
Mesh make_xarrow(const Xarrow& s, bool wire) {
    constexpr double shaft_radius = .02, head_radius = .06, neck = .8;
    const int shaft = std::clamp(static_cast<int>(std::lround(neck * s.n)), 1, std::max(s.n - 1, 1));
    std::vector<Ring> rings;
    add_cap(rings, shaft_radius, 0, -1, 0);
    add_side(rings, shaft_radius, 0, shaft_radius, neck, shaft, 0, neck);
    rings.insert(rings.end(), {Ring{shaft_radius, neck, 0, -1, neck}, Ring{head_radius, neck, 0, -1, neck}});
    add_side(rings, head_radius, neck, 0, 1, std::max(s.n - shaft, 1), neck, 1);
    Surface surface(wire);
    revolve(surface, 24, rings);
    Mesh mesh = std::move(surface).finish();
    for (auto* vectors : {&mesh.positions, &mesh.normals})  // turns +Y to +X
        for (Float3& v : *vectors) v = {v[1], -v[0] + 0.f, v[2]};
    mesh.compute_bounds();
    return mesh;
}

namespace {

// The Utah teapot: Martin Newell's 32 bicubic Bezier patches of 1975 (rim 4, body 8, lid 8, bottom 4, handle 4, spout
// 4), with the size and position of glutSolidTeapot(1), turned so that +Y is up and the spout points to +X.

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

Vec2 largest_slopes(const Patch& patch) {
    const auto distance = [](const Vec3& a, const Vec3& b) { return length(difference(a, b)); };
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
    const Vec3 product = cross(along_s, along_t);
    if (length(product) >= 1e-4 * net.largest[0] * net.largest[1]) return product;
    return cross(evaluate(patch, bernstein_slope(s), bernstein_slope(t)), along_t);
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
            const double s = fraction(i, n), t = fraction(j, n);
            const SurfacePoint point = teapot_point(patch, s, t);
            surface.vertex(point.position, point.normal, {s, t, 0});
        });
    return std::move(surface).finish();
}

namespace {

// A truncated icosahedron, projected onto a sphere.
constexpr int steps = 12;  // from a face's centre to its seam

Vec3 blend(const Vec3& a, const Vec3& b, double f) {
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}
Vec3 unit_vector(const Vec3& v) { return divided(v, std::sqrt(dot(v, v))); }

std::array<Vec3, 12> icosahedron() {
    const double golden = (1 + std::sqrt(5.)) / 2;
    std::array<Vec3, 12> corners;
    std::size_t i = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double a : {1., -1.})
            for (const double b : {golden, -golden}) {
                corners[i] = {0, 0, 0};
                corners[i][(axis + 1) % 3] = a;
                corners[i][(axis + 2) % 3] = b;
                corners[i] = unit_vector(corners[i]);
                ++i;
            }
    return corners;
}

// A corner of the ball is a third of the way along an edge of the icosahedron, from `from` to `to`.
struct Corner {
    int from = 0, to = 0;
    int id() const { return from * 12 + to; }
};
using BallFace = std::vector<Corner>;  // counter-clockwise seen from outside

// Neighbours' dot product is 1 / sqrt 5.
bool joined(const Vec3& a, const Vec3& b) { return dot(a, b) > .4 && dot(a, b) < .5; }

BallFace pentagon(const std::array<Vec3, 12>& ico, int centre) {
    const auto& axis = ico[static_cast<std::size_t>(centre)];
    BallFace face;
    for (int i = 0; i < 12; ++i)
        if (joined(axis, ico[static_cast<std::size_t>(i)])) face.push_back({centre, i});
    const Vec3 x = ico[static_cast<std::size_t>(face.front().to)], y = cross(axis, x);
    const auto angle = [&](const Corner& c) {
        const Vec3& p = ico[static_cast<std::size_t>(c.to)];
        return std::atan2(dot(p, y) / dot(y, y), dot(p, x) - dot(p, axis) * dot(x, axis));
    };
    std::sort(face.begin() + 1, face.end(), [&](const Corner& a, const Corner& b) {
        const double full = 8, at = angle(a), bt = angle(b);  // angles relative to the first, counter-clockwise
        return (at < 0 ? at + full : at) < (bt < 0 ? bt + full : bt);
    });
    return face;
}

std::vector<BallFace> faces(const std::array<Vec3, 12>& ico) {
    std::vector<BallFace> all;
    for (int i = 0; i < 12; ++i) all.push_back(pentagon(ico, i));
    for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b)
            for (int c = b + 1; c < 12; ++c) {
                const auto [pa, pb, pc] = std::array{ico[static_cast<std::size_t>(a)], ico[static_cast<std::size_t>(b)],
                                                     ico[static_cast<std::size_t>(c)]};
                if (!joined(pa, pb) || !joined(pb, pc) || !joined(pc, pa)) continue;
                const bool ccw = dot(cross(pa, pb), pc) > 0;
                const int second = ccw ? b : c, third = ccw ? c : b;
                all.push_back({{a, second}, {second, a}, {second, third}, {third, second}, {third, a}, {a, third}});
            }
    return all;
}

// Makes one face: rings of points around its centre, in its plane, projected onto the sphere. Both faces at a seam
// compute its points from the same end, so that they are equal to the bit.
class FaceMaker {
public:
    FaceMaker(Surface& surface, const std::array<Vec3, 12>& ico, const BallFace& face, double radius)
        : surface_(surface), face_(face), radius_(radius) {
        for (const Corner& c : face)
            corners_.push_back(
                unit_vector(blend(ico[static_cast<std::size_t>(c.from)], ico[static_cast<std::size_t>(c.to)], 1. / 3)));
        for (const Vec3& c : corners_)
            for (std::size_t k = 0; k < 3; ++k) centre_[k] += c[k] / static_cast<double>(corners_.size());
        const Vec3 arm = difference(corners_[0], centre_);
        reach_ = std::sqrt(dot(arm, arm));
        s_axis_ = unit_vector(arm);
        t_axis_ = cross(unit_vector(centre_), s_axis_);
    }

    void make() {
        const auto sides = static_cast<std::uint32_t>(corners_.size());
        std::vector<std::uint32_t> inner{add(centre_, 0)};
        for (std::uint32_t ring = 1; ring <= steps; ++ring) {
            std::vector<std::uint32_t> outer;
            for (std::uint32_t side = 0; side < sides; ++side)
                for (std::uint32_t m = 0; m < ring; ++m) outer.push_back(add_on_ring(side, ring, m));
            join(inner, outer, sides, ring);
            inner = std::move(outer);
        }
    }

private:
    std::uint32_t add_on_ring(std::uint32_t side, std::uint32_t ring, std::uint32_t m) {
        const std::uint32_t next = (side + 1) % static_cast<std::uint32_t>(corners_.size());
        const bool forward = face_[side].id() < face_[next].id();
        const Vec3& start = corners_[forward ? side : next];
        const Vec3& end = corners_[forward ? next : side];
        const Vec3 on_seam = blend(start, end, static_cast<double>(forward ? m : ring - m) / ring);
        if (ring == steps) return add(on_seam, 1);
        const double f = static_cast<double>(ring) / steps;
        return add(blend(centre_, on_seam, f), f);
    }

    std::uint32_t add(const Vec3& flat, double p) {
        const Vec3 out = unit_vector(flat);
        const Vec3 arm = difference(flat, centre_);
        const double s = .5 + .5 * dot(arm, s_axis_) / reach_, t = .5 + .5 * dot(arm, t_axis_) / reach_;
        const auto clamp01 = [](double x) { return std::clamp(x, 0., 1.); };
        const std::uint32_t index =
            surface_.vertex({radius_ * out[0], radius_ * out[1], radius_ * out[2]}, out, {clamp01(s), clamp01(t), p});
        const double away = dot(s_axis_, out);
        surface_.tangent({s_axis_[0] - away * out[0], s_axis_[1] - away * out[1], s_axis_[2] - away * out[2]});
        return index;
    }

    void join(const std::vector<std::uint32_t>& inner, const std::vector<std::uint32_t>& outer, std::uint32_t sides,
              std::uint32_t ring) {
        const auto in = [&](std::uint32_t i) { return inner[i % inner.size()]; };
        const auto out = [&](std::uint32_t i) { return outer[i % outer.size()]; };
        for (std::uint32_t side = 0; side < sides; ++side)
            for (std::uint32_t m = 0; m < ring; ++m) {
                const std::uint32_t a = side * (ring - 1) + m, b = side * ring + m;
                surface_.triangle(in(a), out(b), out(b + 1));
                if (m + 1 < ring) surface_.triangle(in(a), out(b + 1), in(a + 1));
            }
    }

    Surface& surface_;
    const BallFace& face_;
    double radius_;
    std::vector<Vec3> corners_;
    Vec3 centre_{0, 0, 0}, s_axis_{1, 0, 0}, t_axis_{0, 1, 0};
    double reach_ = 1;
};

}  // namespace

// s and t span the face's plane: its corners are on the circle of radius .5 about (.5, .5), the first one at s = 1. p
// is 0 at the face's centre and 1 along its seam. The tangent is the direction of increasing s.
Mesh make_soccerball(const Soccerball& ball, bool wire) {
    const std::array<Vec3, 12> ico = icosahedron();
    Surface surface(wire);
    int index = 0;
    for (const BallFace& face : faces(ico)) {
        surface.part(index++);
        FaceMaker(surface, ico, face, ball.radius).make();
    }
    return std::move(surface).finish();
}

}  // namespace snell::content
