// Boxes, quads and point clouds.
#include <algorithm>
#include <cmath>
#include <cstdint>

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

double share(int i, int n) { return static_cast<double>(i) / n; }

// Adds a straight side from (radius0, y0) up to (radius1, y1) in `stacks` steps.
void add_side(std::vector<Ring>& rings, double radius0, double y0, double radius1, double y1, int stacks, double t0,
              double t1) {
    // The normal is perpendicular to the side, outward; that of a side without length is radial.
    double radial = y1 - y0, up = radius0 - radius1;
    if (radial == 0 && up == 0) radial = 1;
    for (int j = 0; j <= stacks; ++j) {
        const double f = share(j, stacks);
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
        rings.push_back({s.radius * radial, s.radius * up, radial, up, share(j, s.stacks)});
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
        rings.push_back({s.outer + s.inner * a.cos, s.inner * a.sin, a.cos, a.sin, share(j, s.sides)});
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
        const double f = share(ring, s.rings);
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

}  // namespace snell::content
