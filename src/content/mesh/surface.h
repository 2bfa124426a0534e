// Builds meshes of triangles, or of the edges of the same faces. Internal to src/content.
#pragma once

#include <span>

#include "src/content/mesh/mesh.h"

namespace snell::content {

// With 0 for -0, so that equal places have equal bits.
Float3 to_float3(const Vec3& v);
// Of unit length; 0 if it has no direction.
Float3 unit_float3(const Vec3& v);

// Collects vertices and faces. Faces are counter-clockwise seen from outside. If two adjacent corners coincide (sphere
// poles, cone apex), a quad becomes a triangle and a triangle is dropped, so there are no degenerate triangles.
class Surface {
public:
    explicit Surface(bool wire) : wire_(wire) { mesh_.topology = wire ? Topology::lines : Topology::triangles; }

    // Reserves memory for what will be added.
    void reserve(std::size_t vertices, std::size_t quads);
    // Adds a vertex. `normal` may have any length but 0.
    std::uint32_t vertex(const Vec3& position, const Vec3& normal, const Vec3& texcoord);
    // Sets the tangent of the vertex just added; set it for all vertices or for none.
    void tangent(const Vec3& tangent);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    // Starts a part: indices from here to the next part() or the end are drawn with `face_index`. Not for wires.
    void part(int face_index);

    // Adds a grid of (nu + 1) x (nv + 1) vertices, each added by `make(i, j)`, row by row with constant j. The outside
    // is along dP/di x dP/dj.
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

    Mesh finish() &&;  // computes the bounds; with `wire`, keeps each edge once

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
// n + 1 equal steps around the full circle. The last entry equals the first one bit for bit, quarter turns are exact,
// and opposite entries are exact mirror images, so that seams close and poles are single points.
std::vector<SinCos> circle(int n);

// A ring of a surface of revolution about +Y.
struct Ring {
    double radius = 0, y = 0;
    double normal_radial = 1, normal_y = 0;
    double t = 0;
};
// Adds a surface of revolution. Rings must be in the order in which d/ds x d/dring points outward (upward on the
// outside). s = 0 at -X, .25 at +Z, .5 at +X, .75 at -Z. With `tangents`, adds tangents along d/dring; correct for
// rings of the unit sphere only.
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

// ---- the surface of the teapot
inline constexpr int teapot_patches = 32;

struct SurfacePoint {
    Vec3 position, normal;  // the normal points outward; it is not of unit length, but never 0
};
// Evaluates patch 0..31 (rim 4, body 8, lid 8, bottom 4, handle 4, spout 4) at s and t in 0..1.
SurfacePoint teapot_point(int patch, double s, double t);

}  // namespace snell::content
