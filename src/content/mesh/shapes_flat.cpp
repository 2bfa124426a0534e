// Boxes, quads and point clouds.
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

}  // namespace snell::content
