// Surfaces of revolution.
#include <algorithm>
#include <cmath>

#include "src/content/mesh/surface.h"

namespace snell::content {
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
