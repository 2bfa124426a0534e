// Hard cases of meshes, beside the plain loops of latitudes and longitudes.
#include "src/content/mesh/surface.h"
#include "tests/hard_case.h"
#include "tests/mesh/check.h"
#include "tests/mesh/obj_check.h"

namespace snell::content {
namespace {

using namespace check;
using test::hard_case;
constexpr double pi = std::numbers::pi;

// The loops of every tutorial, in float: (slices + 1) × (stacks + 1) vertices, two triangles a cell.
Mesh tutorial_sphere(int slices, int stacks) {
    Mesh m;
    for (int j = 0; j <= stacks; ++j)
        for (int i = 0; i <= slices; ++i) {
            const float lat = static_cast<float>(pi) * static_cast<float>(j) / static_cast<float>(stacks);
            const float lng = 2 * static_cast<float>(pi) * static_cast<float>(i) / static_cast<float>(slices);
            m.positions.push_back({std::sin(lat) * std::cos(lng), std::cos(lat), std::sin(lat) * std::sin(lng)});
        }
    const auto row = static_cast<std::uint32_t>(slices) + 1;
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(stacks); ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            m.indices.insert(m.indices.end(), {a, a + 1, a + row, a + row, a + 1, a + row + 1});
        }
    return m;
}

double degenerate(const Mesh& m) {
    int count = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) count += length(area_vector(m, i)) < 1e-9;
    return count;
}

bool sound(const Mesh& m) {
    for (const auto* list : {&m.positions, &m.normals, &m.texcoords})
        for (const Float3& v : *list)
            if (!std::isfinite(v[0] + v[1] + v[2])) return false;
    return std::all_of(m.indices.begin(), m.indices.end(), [&](std::uint32_t i) { return i < m.positions.size(); });
}

TEST(HardMeshes, Spheres) {
    const Mesh ours = made(Sphere{1, 60, 60}), naive = tutorial_sphere(60, 60);
    for (std::size_t i = 0; i < ours.tangents.size(); ++i) EXPECT_NEAR(length(wide(ours.tangents[i])), 1, 1e-6);
    hard_case({"35", "poles of a sphere: no triangle without area, a tangent at every vertex; naive: the usual loops",
               "of 7200 triangles", 0, degenerate(ours), degenerate(naive)});
    int seams = 0, seams_naive = 0;
    for (std::size_t j = 0; j <= 60; ++j) {
        seams += ours.positions[j * 61] != ours.positions[j * 61 + 60];
        seams_naive += naive.positions[j * 61] != naive.positions[j * 61 + 60];
    }
    hard_case({"36", "the seam of a sphere: both sides equal bit for bit; naive: sin(2 pi) in float",
               "of 61 rows apart", 0, static_cast<double>(seams), static_cast<double>(seams_naive)});
    hard_case({"42", "watertight: each edge belongs to two triangles; naive: the usual loops", "edges that do not", 0,
               0. + unpaired_edges(ours) + unpaired_edges(made(Torus{1, .5, 41, 43})) +
                   unpaired_edges(made(Cone{1, 2, 60, 3})) + unpaired_edges(made(Cylinder{.5, 3, 60, 7})),
               0. + unpaired_edges(naive)});
}

TEST(HardMeshes, CountsAndRadiiThatMakeNoSolid) {
    int flat = 0, flat_naive = 0, odd = 0;
    for (const int slices : {1, 2, 3}) {
        const MeshResult r = make_shape(Sphere{1, slices, 8}, false);
        flat += !(volume(r.mesh) > .1) || (slices < 3 && !has_issue(r, "too-few-slices"));
        flat_naive += !(std::abs(volume(tutorial_sphere(slices, 8))) > .1);
    }
    hard_case({"37", "a sphere of 1, 2, 3 slices has a volume, and what was mended is said; naive: the usual loops",
               "of 3 flat or silent", 0, static_cast<double>(flat), static_cast<double>(flat_naive)});
    for (const Torus& torus : {Torus{1, 1}, Torus{0, 1}, Torus{-1, -.5}, Torus{0, 0}}) {
        const MeshResult r = make_shape(torus, false);
        odd += r.issues.empty() || !sound(r.mesh);
    }
    odd += made(Torus{.2, 1}).positions != made(Torus{1, .2}).positions;
    hard_case({"38", "torus with inner > outer: that of outer > inner; equal, 0, negative: defined, and said",
               "of 5 another, silent or not finite", 0, static_cast<double>(odd), std::nullopt});
}

TEST(HardMeshes, TheTeapotsLid) {
    double worst = 0, naive = 0;
    for (int patch = 12; patch < 16; ++patch)
        for (int i = 0; i <= 16; ++i)
            for (const double t : {0., 1e-12, 1e-7, 1e-4, 5e-3}) {
                const D3 n = teapot_point(patch, i / 16., t).normal;
                worst = std::max(worst, std::atan2(std::hypot(n[0], n[2]), n[1]) * 180 / pi);
                // The cross product of differences in float.
                const auto at = [&](double s, double u) { return teapot_point(patch, s, u).position; };
                const double h = 1e-7;
                const auto difference = [](const Vec3& a, const Vec3& b) {
                    return D3{static_cast<float>(a[0]) - static_cast<float>(b[0]),
                              static_cast<float>(a[1]) - static_cast<float>(b[1]),
                              static_cast<float>(a[2]) - static_cast<float>(b[2])};
                };
                const double s = std::min(i / 16., 1 - h);
                const D3 c = cross(difference(at(s + h, t), at(s, t)), difference(at(s, t + h), at(s, t)));
                const double off = length(c) > 0 ? std::acos(std::abs(c[1]) / length(c)) * 180 / pi : INFINITY;
                naive = std::max(naive, off);
            }
    hard_case({"39",
               "the tip of the teapot's lid, where the derivatives' cross product vanishes: the limit of the normal",
               "degrees off the axis", 1, worst, naive});
}

TEST(HardMeshes, ObjFilesOfEveryHand) {
    const std::string good = "f 1 2 3\n";
    int odd = 0;
    const std::vector<std::string> texts = {"f 1 2 5\n",
                                            "f 0 1 2\n",
                                            "f -5 1 2\n",
                                            "f 1 2 99999999999999999999\n",
                                            "f 1 2 2\n",
                                            "v nan 0 0\nf 1 2 5\n",
                                            "v 0 -inf 0\nf 1 2 5\n",
                                            "v 9 9 9\n",
                                            "vn 0 0 0\nf 1//1 2//1 3//1\n"};
    for (const std::string& text : texts) {
        const MeshResult r = parse_obj(square + text + good, ObjAs::triangles, false);
        odd += !sound(r.mesh) || r.mesh.indices.size() < 3;
    }
    hard_case({"40", "OBJ: faces without area, NaN, indices out of range, 0, negative, isolated vertices, normals of 0",
               "of 9 files not sound", 0, static_cast<double>(odd), std::nullopt});
    // Fins: three triangles on one edge. Borders: an edge of one triangle.
    const std::string fins = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n";
    int unsound = 0;
    for (const std::string& text : {fins + "f 1 2 3\nf 1 2 4\nf 2 1 5\n", square + good, fins + "f 1 2 3\nf 1 2 4\n"}) {
        const MeshResult r = parse_obj(text, ObjAs::adjacency, false);
        unsound += !sound(r.mesh) || r.mesh.indices.size() % 6 != 0 || r.mesh.indices.empty();
    }
    hard_case({"41", "adjacency at edges of one and of three triangles: every neighbour is a vertex",
               "of 3 files not sound", 0, static_cast<double>(unsound), std::nullopt});
}

}  // namespace
}  // namespace snell::content
