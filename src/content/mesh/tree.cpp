#include "src/content/mesh/tree.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "parser/text/ranges.h"

namespace snell::content {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Bounds {
    Float3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

    void add(const Float3& point) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], point[k]);
            high[k] = std::max(high[k], point[k]);
        }
    }
    void add(const Bounds& other) {
        add(other.low);
        add(other.high);
    }
    // Half the surface area, in double because it is a square of floats.
    double area() const {
        const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x >= 0 ? x * y + y * z + z * x : 0;
    }
    std::size_t longest() const {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }
};

using Corners = std::array<std::uint32_t, 3>;

Float3 point(const Mesh& mesh, std::uint32_t v) {
    Float3 p = mesh.positions[v];
    if (!mesh.w.empty())
        for (float& x : p) x /= mesh.w[v];
    return p;
}

struct Frame {
    Float3 origin{};
    float scale = 1;

    Float3 from_model(const Float3& p) const {
        Float3 out;
        for (std::size_t k = 0; k < 3; ++k) out[k] = static_cast<float>((double{p[k]} - origin[k]) * double{scale});
        return out;
    }
};

Frame frame_of(const Bounds& box) {
    Frame frame;
    double extent = 0, farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        extent = std::max(extent, double{box.high[k]} / 2 - double{box.low[k]} / 2);
        frame.origin[k] = box.low[k] / 2 + box.high[k] / 2;
        farthest = std::max(farthest, std::abs(double{frame.origin[k]}));
    }
    // Nearer, the difference would round more than it saves.
    if (!(farthest > 2 * extent)) frame.origin = {};
    // Of a single point, no scale is better than another. Beyond 126 a power of two or its inverse is not a float.
    if (extent > 0 && std::isfinite(extent)) frame.scale = std::ldexp(1.0F, std::clamp(-std::ilogb(extent), -126, 126));
    return frame;
}

bool usable(const Mesh& mesh, const Corners& corners) {
    return ranges::all_of(corners, [&](std::uint32_t v) {
        return v < mesh.positions.size() && ranges::all_of(point(mesh, v), [](float x) { return std::isfinite(x); });
    });
}

// Corners in GL's order for each topology, which keeps the front faces.
std::vector<Corners> triangles_of(const Mesh& mesh) {
    const std::vector<std::uint32_t>& v = mesh.indices;
    std::vector<Corners> out;
    out.reserve(v.size() / 3);
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        const Corners corners{v[a], v[b], v[c]};
        if (usable(mesh, corners)) out.push_back(corners);
    };
    switch (mesh.topology) {
        case Topology::triangles:
            for (std::size_t i = 0; i + 2 < v.size(); i += 3) add(i, i + 1, i + 2);
            break;
        case Topology::triangle_strip:
            for (std::size_t i = 0; i + 2 < v.size(); ++i) add(i + i % 2, i + 1 - i % 2, i + 2);
            break;
        case Topology::triangle_fan:
            for (std::size_t i = 1; i + 1 < v.size(); ++i) add(0, i, i + 1);
            break;
        case Topology::triangles_adjacency:
            for (std::size_t i = 0; i + 5 < v.size(); i += 6) add(i, i + 2, i + 4);
            break;
        case Topology::triangle_strip_adjacency:
            for (std::size_t i = 0; i + 5 < v.size(); i += 2) add(i + i % 4, i + 2 - i % 4, i + 4);
            break;
        default:
            break;
    }
    return out;
}

// The depth of a tree of that many triangles if every node is halved.
std::size_t halvings(std::size_t count) {
    std::size_t levels = 1;
    for (; count > tree_leaf; count = (count + 1) / 2) ++levels;
    return levels;
}

class Builder {
public:
    Builder(const Mesh& mesh, std::vector<Corners> triangles) : mesh_(mesh), triangles_(std::move(triangles)) {
        boxes_.resize(triangles_.size());
        middles_.resize(triangles_.size());
        order_.resize(triangles_.size());
        Bounds all;
        for (const Corners& corners : triangles_)
            for (std::uint32_t v : corners) all.add(point(mesh_, v));
        if (!triangles_.empty()) frame_ = frame_of(all);
        std::iota(order_.begin(), order_.end(), 0U);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (std::uint32_t v : triangles_[t]) boxes_[t].add(frame_.from_model(point(mesh_, v)));
            for (std::size_t k = 0; k < 3; ++k) middles_[t][k] = boxes_[t].low[k] / 2 + boxes_[t].high[k] / 2;
        }
    }

    Tree build() {
        tree_.nodes.reserve(triangles_.size() * 2);
        tree_.nodes.push_back({frame_.origin[0], frame_.origin[1], frame_.origin[2], frame_.scale});
        tree_.nodes.push_back({0, 0, 0, 0});
        split(0, triangles_.size(), 1);
        tree_.triangles.reserve(triangles_.size() * 3);
        for (std::uint32_t t : order_)
            for (std::uint32_t v : triangles_[t]) {
                const Float3 p = frame_.from_model(point(mesh_, v));
                tree_.triangles.push_back({p[0], p[1], p[2], v < mesh_.normals.size() ? static_cast<float>(v) : -1});
            }
        return std::move(tree_);
    }

private:
    static constexpr std::size_t bins = 16;
    struct Bin {
        Bounds box;
        std::size_t count = 0;
    };

    void split(std::size_t first, std::size_t count, std::size_t depth) {
        const std::size_t node = tree_.nodes.size();
        Bounds box, middles;
        for (std::size_t i = first; i < first + count; ++i) {
            box.add(boxes_[order_[i]]);
            middles.add(middles_[order_[i]]);
        }
        if (count == 0) box.low = {1, 1, 1}, box.high = {-1, -1, -1};
        tree_.nodes.push_back({box.low[0], box.low[1], box.low[2], static_cast<float>(first)});
        tree_.nodes.push_back({box.high[0], box.high[1], box.high[2], static_cast<float>(count)});
        if (count <= tree_leaf) return;
        const std::size_t axis = middles.longest();
        const bool deep = depth + halvings(count) >= tree_depth;
        std::size_t lower = deep ? 0 : by_surface(first, count, axis, middles);
        if (lower == 0 || lower == count) lower = by_median(first, count, axis);
        split(first, lower, depth + 1);
        tree_.nodes[node][3] = static_cast<float>(tree_.nodes.size() / 2);
        tree_.nodes[node + 1][3] = -1 - static_cast<float>(axis);
        split(first + lower, count - lower, depth + 1);
    }

    std::size_t by_median(std::size_t first, std::size_t count, std::size_t axis) {
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
        std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(count / 2),
                         begin + static_cast<std::ptrdiff_t>(count),
                         [&](std::uint32_t a, std::uint32_t b) { return middles_[a][axis] < middles_[b][axis]; });
        return count / 2;
    }

    // The number of triangles in the lower child at the least expected cost; 0 if all centres coincide, or their extent
    // is not finite.
    std::size_t by_surface(std::size_t first, std::size_t count, std::size_t axis, const Bounds& middles) {
        const float size = middles.high[axis] - middles.low[axis], scale = bins / size;
        if (!(size > 0) || !std::isfinite(size) || !std::isfinite(scale)) return 0;
        const auto bin_of = [&](std::uint32_t t) {
            const float at = (middles_[t][axis] - middles.low[axis]) * scale;
            return std::min(static_cast<std::size_t>(at), bins - 1);
        };
        std::array<Bin, bins> filled;
        for (std::size_t i = first; i < first + count; ++i) {
            Bin& bin = filled[bin_of(order_[i])];
            bin.box.add(boxes_[order_[i]]);
            ++bin.count;
        }
        std::array<double, bins> above{};  // cost of the bins from here on
        Bounds box;
        std::size_t met = 0;
        for (std::size_t b = bins - 1; b > 0; --b) {
            box.add(filled[b].box);
            met += filled[b].count;
            above[b] = box.area() * static_cast<double>(met);
        }
        box = {};
        met = 0;
        double best = std::numeric_limits<double>::infinity();
        std::size_t at = 0;
        for (std::size_t b = 1; b < bins; ++b) {
            box.add(filled[b - 1].box);
            met += filled[b - 1].count;
            const double cost = box.area() * static_cast<double>(met) + above[b];
            if (met > 0 && met < count && cost < best) best = cost, at = b;
        }
        if (at == 0) return 0;
        const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto middle = std::partition(begin, begin + static_cast<std::ptrdiff_t>(count),
                                           [&](std::uint32_t t) { return bin_of(t) < at; });
        return static_cast<std::size_t>(middle - begin);
    }

    const Mesh& mesh_;
    std::vector<Corners> triangles_;
    std::vector<Bounds> boxes_;
    std::vector<Float3> middles_;
    std::vector<std::uint32_t> order_;
    Frame frame_;
    Tree tree_;
};

}  // namespace

Tree make_tree(const Mesh& mesh, std::size_t limit) {
    std::vector<Corners> triangles = triangles_of(mesh);
    const bool large = mesh.positions.size() >= limit || triangles.size() >= limit;
    if (large) triangles.clear();
    Tree tree = Builder(mesh, std::move(triangles)).build();
    tree.too_large = large;
    return tree;
}

std::vector<Float4> tree_normals(const Mesh& mesh) {
    if (mesh.normals.empty()) return {Float4{0, 0, 0, 0}};
    std::vector<Float4> out;
    out.reserve(mesh.normals.size());
    for (const Float3& n : mesh.normals) out.push_back({n[0], n[1], n[2], 0});
    return out;
}

std::array<int, 2> fill_rows(std::vector<Float4>& texels) {
    const std::size_t width = std::clamp<std::size_t>(texels.size(), 1, tree_row);
    const std::size_t height = std::max<std::size_t>(1, (texels.size() + width - 1) / width);
    texels.resize(width * height, {0, 0, 0, 0});
    return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace snell::content
