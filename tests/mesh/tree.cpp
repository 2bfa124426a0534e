#include "src/content/mesh/tree.h"
#include "src/content/mesh/mesh.h"
#include "tests/sanitized.h"
#include "tests/std.h"

namespace snell::content {
namespace {

struct Walked {
    std::size_t leaves = 0, depth = 0, triangles = 0;
    bool sound = true;  // every box holds what is below it, every leaf is small, every triangle is in one leaf
};

// The box of what is below.
std::pair<Float3, Float3> walk(const Tree& tree, std::size_t node, std::size_t depth, Walked& out) {
    const Float4 &low = tree.nodes[2 * node], &high = tree.nodes[2 * node + 1];
    constexpr float inf = std::numeric_limits<float>::infinity();
    Float3 least{inf, inf, inf}, most{-inf, -inf, -inf};
    const auto add = [&](const float* a, const float* b) {
        for (std::size_t k = 0; k < 3; ++k) least[k] = std::min(least[k], a[k]), most[k] = std::max(most[k], b[k]);
    };
    out.depth = std::max(out.depth, depth);
    if (high[3] >= 0) {
        ++out.leaves;
        const auto first = static_cast<std::size_t>(low[3]), count = static_cast<std::size_t>(high[3]);
        out.sound = out.sound && count <= tree_leaf && first == out.triangles;
        out.triangles += count;
        for (std::size_t i = 3 * first; i < 3 * (first + count); ++i)
            add(tree.triangles[i].data(), tree.triangles[i].data());
    } else {
        for (const std::size_t child : {node + 1, static_cast<std::size_t>(low[3])}) {
            const auto [a, b] = walk(tree, child, depth + 1, out);
            add(a.data(), b.data());
        }
    }
    for (std::size_t k = 0; k < 3; ++k)
        out.sound = out.sound && (out.triangles == 0 || (least[k] == low[k] && most[k] == high[k]));
    return {least, most};
}

Walked walk(const Tree& tree) {
    Walked out;
    walk(tree, 1, 1, out);
    return out;
}

// Whether the ray meets the triangle (Möller and Trumbore), from either side.
bool meets(const Float4* corner, const std::array<double, 3>& o, const std::array<double, 3>& d) {
    const auto minus = [](const Float4& a, const Float4& b) {
        return std::array<double, 3>{double{a[0]} - b[0], double{a[1]} - b[1], double{a[2]} - b[2]};
    };
    const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto dot = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const auto e = minus(corner[1], corner[0]), f = minus(corner[2], corner[0]), p = cross(d, f);
    const std::array<double, 3> t{o[0] - corner[0][0], o[1] - corner[0][1], o[2] - corner[0][2]};
    const double det = dot(e, p);
    if (det == 0) return false;
    const auto q = cross(t, e);
    const double u = dot(t, p) / det, v = dot(d, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && dot(f, q) / det > 0;
}

bool touches(const Tree& tree, std::size_t node, const std::array<double, 3>& o, const std::array<double, 3>& d) {
    double enter = -1e-9, leave = 1e300;
    for (std::size_t k = 0; k < 3; ++k) {
        const double a = (tree.nodes[2 * node][k] - 1e-6 - o[k]) / d[k];
        const double b = (tree.nodes[2 * node + 1][k] + 1e-6 - o[k]) / d[k];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

// The vertices of all triangles that the ray meets.
std::multiset<float> met(const Tree& tree, bool by_boxes, const std::array<double, 3>& o,
                         const std::array<double, 3>& d, std::size_t& tried) {
    std::multiset<float> found;
    const auto try_all = [&](std::size_t first, std::size_t count) {
        for (std::size_t t = first; t < first + count; ++t, ++tried)
            if (meets(&tree.triangles[3 * t], o, d))
                found.insert(tree.triangles[3 * t][3] + 0.5F * tree.triangles[3 * t + 1][3]);
    };
    if (!by_boxes) {
        try_all(0, tree.triangle_count());
        return found;
    }
    std::vector<std::size_t> waiting{1};
    while (!waiting.empty()) {
        EXPECT_LE(waiting.size(), tree_depth);
        const std::size_t node = waiting.back();
        waiting.pop_back();
        if (!touches(tree, node, o, d)) continue;
        const auto link = static_cast<std::size_t>(tree.nodes[2 * node][3]);
        if (tree.nodes[2 * node + 1][3] >= 0) {
            try_all(link, static_cast<std::size_t>(tree.nodes[2 * node + 1][3]));
        } else {
            waiting.push_back(link);
            waiting.push_back(node + 1);
        }
    }
    return found;
}

Float3 in_model(const Tree& tree, const Float4& corner) {
    const Float4& frame = tree.nodes.front();
    Float3 out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = frame[k] + corner[k] / frame[3];
    return out;
}

Mesh shape(const Shape& what) { return make_shape(what, false).mesh; }

// Wherever a mesh lies and however large it is, its tree is the same, and has the mesh's corners.
TEST(MeshTree, LiesAroundItsOwnOrigin) {
    const Mesh box = shape(Box{2, 2, 2});
    const Tree near = make_tree(box);
    for (const Float3& offset : {Float3{1e3F, 0, 0}, Float3{1e6F, -1e6F, 1e6F}})
        for (const float size : {1.0F, 0x1p20F, 0x1p-60F, 0x1p100F}) {
            Mesh moved = box;
            for (Float3& p : moved.positions)
                for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] + offset[k]) * size;
            const Tree tree = make_tree(moved);
            EXPECT_EQ(tree.triangles, near.triangles) << offset[0] << " " << size;
            for (const Float4& corner : tree.triangles)
                EXPECT_EQ(in_model(tree, corner), moved.positions[static_cast<std::size_t>(corner[3])]);
        }
    for (const Mesh& mesh : {shape(Teapot{}), shape(Sphere{}), shape(Torus{})}) {
        const Tree tree = make_tree(mesh);
        EXPECT_EQ((Float3{tree.nodes[0][0], tree.nodes[0][1], tree.nodes[0][2]}), (Float3{}))
            << "a mesh around the model's origin keeps its digits";
    }
}

TEST(MeshTree, FindsWhatTryingAllFinds) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const Mesh& mesh : {shape(Teapot{}), shape(Sphere{}), shape(Torus{}), shape(Box{})}) {
        const Tree tree = make_tree(mesh);
        EXPECT_EQ(tree.triangle_count(), mesh.indices.size() / 3);
        std::size_t hits = 0, tried = 0, all = 0;
        for (int i = 0; i < 150; ++i) {
            const std::array<double, 3> o{2 * any(random), 2 * any(random), 2 * any(random)};
            const std::array<double, 3> d{any(random), any(random), any(random)};
            const auto fast = met(tree, true, o, d, tried), slow = met(tree, false, o, d, all);
            EXPECT_EQ(fast, slow);
            hits += slow.size();
        }
        EXPECT_GT(hits, 20U);
        if (tree.triangle_count() > 1000) {
            EXPECT_LT(tried * 30, all);
        }
    }
}

TEST(MeshTree, HoldsEveryTriangleOnce) {
    for (const Mesh& mesh : {shape(Teapot{}), shape(Sphere{}), shape(Torus{}), shape(Box{}), Mesh{}}) {
        const Tree tree = make_tree(mesh);
        const Walked walked = walk(tree);
        EXPECT_TRUE(walked.sound);
        EXPECT_EQ(walked.triangles, mesh.indices.size() / 3);
        EXPECT_LE(walked.depth, 2 + 2 * std::log2(1 + mesh.indices.size() / 3));
        std::multiset<float> vertices, wanted;
        for (const Float4& corner : tree.triangles) {
            vertices.insert(corner[3]);
            const Float3& p = mesh.positions[static_cast<std::size_t>(corner[3])];
            EXPECT_EQ(p, in_model(tree, corner));
        }
        for (std::uint32_t v : mesh.indices) wanted.insert(static_cast<float>(v));
        EXPECT_EQ(vertices, wanted);
    }
}

// Each triangle a thousand times smaller than the last: the surface alone would give a tree as deep as a list.
TEST(MeshTree, IsNeverDeeperThanItSays) {
    Mesh mesh;
    float x = 1e30F;
    for (std::uint32_t i = 0; i < 3000; ++i, x *= 0.97F) {
        for (const Float3& p : {Float3{x, 0, 0}, Float3{x, x, 0}, Float3{x, 0, x}}) mesh.positions.push_back(p);
        for (std::uint32_t k = 0; k < 3; ++k) mesh.indices.push_back(3 * i + k);
    }
    const Walked walked = walk(make_tree(mesh));
    EXPECT_TRUE(walked.sound);
    EXPECT_EQ(walked.triangles, 3000U);
    EXPECT_LE(walked.depth, tree_depth);
    // All in one place.
    mesh.positions.assign(mesh.positions.size(), Float3{1, 2, 3});
    EXPECT_LE(walk(make_tree(mesh)).depth, 13U);
}

TEST(MeshTree, ReadsEveryKindOfTriangle) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}, {5, 5, 5}, {6, 6, 6}};
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    const auto corners = [&](Topology topology, std::vector<std::uint32_t> indices) {
        mesh.topology = topology;
        mesh.indices = std::move(indices);
        std::set<std::array<float, 3>> out;
        const Tree tree = make_tree(mesh);
        for (std::size_t i = 0; i < tree.triangles.size(); i += 3) {
            std::array<float, 3> t{tree.triangles[i][3], tree.triangles[i + 1][3], tree.triangles[i + 2][3]};
            std::ranges::rotate(t, std::ranges::min_element(t));
            out.insert(t);
        }
        return out;
    };
    using Set = std::set<std::array<float, 3>>;
    const Set both{{0, 1, 2}, {1, 3, 2}};
    EXPECT_EQ(corners(Topology::triangles, {0, 1, 2, 2, 1, 3, 4}), both);
    EXPECT_EQ(corners(Topology::triangle_strip, {0, 1, 2, 3}), both);
    EXPECT_EQ(corners(Topology::triangle_fan, {1, 3, 2, 0}), (Set{{1, 3, 2}, {0, 1, 2}}));
    EXPECT_EQ(corners(Topology::triangles_adjacency, {0, 6, 1, 6, 2, 6, 2, 7, 1, 7, 3, 7}), both);
    EXPECT_EQ(corners(Topology::triangle_strip_adjacency, {0, 6, 1, 6, 2, 6, 3, 7}), both);
    EXPECT_TRUE(corners(Topology::lines, {0, 1, 2, 3}).empty());
    EXPECT_TRUE(corners(Topology::points, {0, 1, 2}).empty());
    EXPECT_EQ(corners(Topology::triangles, {0, 1, 99, 0, 1, 2}).size(), 1U);
    mesh.positions[1][0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(corners(Topology::triangles, {0, 1, 2}).empty());
    mesh.positions[1][0] = 1;
    mesh.w = {1, 2, 1, 1, 1, 1, 1, 1};
    mesh.indices = {0, 1, 2};
    const Tree halved = make_tree(mesh);
    EXPECT_EQ(halved.nodes[3][0] / halved.nodes[0][3], 0.5F);
    mesh.w[1] = 0;  // infinitely far
    EXPECT_EQ(make_tree(mesh).triangle_count(), 0U);
}

// A mesh whose vertices have no normals says so in its triangles, and one that is too large has no tree.
TEST(MeshTree, KnowsItsNormalsAndItsLimit) {
    Mesh box = shape(Box{});
    const std::size_t count = box.indices.size() / 3, most = std::max(count, box.positions.size());
    EXPECT_FALSE(make_tree(box, most + 1).too_large);
    const Tree refused = make_tree(box, most);
    EXPECT_TRUE(refused.too_large);
    EXPECT_EQ(refused.triangle_count(), 0U);
    box.normals.clear();
    for (const Float4& corner : make_tree(box).triangles) EXPECT_EQ(corner[3], -1);
}

// Whatever a mesh is like, its tree fits into the textures that its limit is for.
TEST(MeshTree, FillsRows) {
    Mesh scattered;  // one triangle a leaf, at worst
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-1, 1);
    for (std::uint32_t i = 0; i < 3 * 1023; ++i) {
        scattered.positions.push_back({any(random), any(random), any(random)});
        scattered.indices.push_back(i);
    }
    for (const Mesh& mesh : {scattered, shape(Teapot{}), shape(Sphere{}), Mesh{}}) {
        Tree tree = make_tree(mesh);
        const std::size_t rows = 1 + 4 * std::max(tree.triangle_count(), mesh.positions.size()) / tree_row;
        EXPECT_GE(limit_of_rows(rows), tree.triangle_count());
        for (std::vector<Float4>* list : {&tree.nodes, &tree.triangles}) {
            const std::vector<Float4> before = *list;
            const auto [width, height] = fill_rows(*list);
            EXPECT_EQ(list->size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
            EXPECT_LT(list->size(), before.size() + tree_row);
            EXPECT_LE(static_cast<std::size_t>(height), rows);
            EXPECT_TRUE(height == 1 || static_cast<std::size_t>(width) == tree_row);
            EXPECT_TRUE(std::equal(before.begin(), before.end(), list->begin()));
        }
    }
}

TEST(MeshTree, IsBuiltQuickly) {
    Sphere sphere;
    sphere.slices = sphere.stacks = 224;
    const Mesh mesh = shape(sphere);
    ASSERT_GT(mesh.indices.size() / 3, 99000U);
    double best = 1e9;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        const Tree tree = make_tree(mesh);
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        EXPECT_EQ(tree.triangle_count(), mesh.indices.size() / 3);
    }
    RecordProperty("milliseconds", static_cast<int>(best * 1e3));
    EXPECT_LT(best, 1.0 * patience) << "seconds; 0.05 on an idle machine";
}

}  // namespace
}  // namespace snell::content
