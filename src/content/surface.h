// Builds meshes of triangles, or of the same faces' edges. Internal to content/.
#pragma once

#include <span>

#include "src/content/mesh.h"

namespace snell::content {

// Collects vertices and faces. Faces are counter-clockwise seen from outside. A corner that falls on its
// neighbour (sphere poles, cone apex) makes a quad a triangle and a triangle nothing, so no degenerate
// triangles arise.
class Surface {
public:
    explicit Surface(bool wire) : wire_(wire) { mesh_.topology = wire ? Topology::lines : Topology::triangles; }

    // How much is about to come; saves reallocation.
    void reserve(std::size_t vertices, std::size_t quads);
    // `normal` of any length but 0; -0 becomes 0, so that equal places have equal bits.
    std::uint32_t vertex(const Vec3& position, const Vec3& normal, const Vec3& texcoord);
    void tangent(const Vec3& tangent);  // of the vertex just added; all vertices or none
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    // Indices from here to the next part() or the end are drawn with `face_index`. Not for wires.
    void part(int face_index);

    // (nu + 1) x (nv + 1) vertices that `make(i, j)` adds, rows of constant j first; outward is dP/di x dP/dj.
    template <class Make>
    void grid(int nu, int nv, Make make) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (int j = 0; j <= nv; ++j)
            for (int i = 0; i <= nu; ++i) make(i, j);
        const auto row = static_cast<std::uint32_t>(nu) + 1;
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i) {
                const std::uint32_t a = first + static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i);
                quad(a, a + 1, a + row + 1, a + row);
            }
    }

    Mesh finish() &&;  // bounds computed; wire: each edge once

private:
    bool same(std::uint32_t a, std::uint32_t b) const { return mesh_.positions[a] == mesh_.positions[b]; }
    void edge(std::uint32_t a, std::uint32_t b);
    void close_part();

    bool wire_;
    Mesh mesh_;
};

struct SinCos {
    double sin = 0, cos = 1;
};
// n + 1 equal steps around the full circle. The last entry is the first one bit for bit, quarter turns are
// exact, and opposite entries are exact mirror images: seams close and poles are points.
std::vector<SinCos> circle(int n);

// A ring of a surface of revolution about +Y.
struct Ring {
    double radius = 0, y = 0;
    double normal_radial = 1, normal_y = 0;
    double t = 0;
};
// Rings in the order that makes d/ds x d/dring point outward (upward on the outside). s = 0 at -X, .25 at
// +Z, .5 at +X, .75 at -Z. `tangents`: along the rings' order, d/dring, for the unit sphere's rings.
void revolve(Surface& surface, int slices, std::span<const Ring> rings, bool tangents = false);

// ---- makers of the shapes; parameters are in their domain (see mesh.cpp) ----------------------------
Mesh make_sphere(const Sphere& s, bool wire);
Mesh make_torus(const Torus& s, bool wire);
Mesh make_cone(const Cone& s, bool wire);
Mesh make_cylinder(const Cylinder& s, bool wire);
Mesh make_disk(const Disk& s, bool wire);
Mesh make_xarrow(const Xarrow& s, bool wire);
Mesh make_box(const Box& s, bool wire);
Mesh make_quad(const Quad& s, bool wire);
Mesh make_quad_box(const QuadBox& s, bool wire);
Mesh make_cloud(const PointCloud& s);
Mesh make_teapot(bool wire);
Mesh make_soccerball(const Soccerball& s, bool wire);

}  // namespace snell::content
