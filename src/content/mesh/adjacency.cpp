#include "src/content/mesh/adjacency.h"

#include <algorithm>

namespace snell::content {
namespace {

// An edge of a triangle. `edge` combines its two places in ascending order.
struct Half {
    std::uint64_t edge = 0;
    std::uint32_t corner = 0;  // index into the triangle list at which the edge begins
    bool reversed = false;     // runs from the higher place to the lower
};

std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
std::uint32_t far_corner(std::uint32_t corner) { return next_corner(next_corner(corner)); }

std::vector<Half> sorted_halves(std::span<const std::uint32_t> triangles, const Weld& weld) {
    std::vector<Half> halves(triangles.size());
    for (std::uint32_t c = 0; c < triangles.size(); ++c) {
        const std::uint32_t from = weld.place[triangles[c]], to = weld.place[triangles[next_corner(c)]];
        halves[c] = {std::uint64_t{std::min(from, to)} << 32 | std::max(from, to), c, from > to};
    }
    std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
        if (a.edge != b.edge) return a.edge < b.edge;
        if (a.reversed != b.reversed) return b.reversed;
        return a.corner < b.corner;
    });
    return halves;
}

// The partner of the k-th edge of `own`, which all join the same places in the same direction; those of `other` run in
// the opposite direction.
const Half& partner(std::span<const Half> own, std::span<const Half> other, std::size_t k) {
    if (k < other.size()) return other[k];
    if (!other.empty()) return other[0];
    return own[(k + 1) % own.size()];  // an edge at a border is alone and is its own partner
}

}  // namespace

std::vector<std::uint32_t> with_adjacency(std::span<const std::uint32_t> triangles, const Weld& weld,
                                          std::size_t* border_edges, std::size_t* crowded_edges) {
    std::vector<std::uint32_t> result(triangles.size() * 2);
    for (std::size_t c = 0; c < triangles.size(); ++c) result[2 * c] = triangles[c];

    const std::vector<Half> halves = sorted_halves(triangles, weld);
    for (auto begin = halves.begin(); begin != halves.end();) {
        const auto end = std::find_if(begin, halves.end(), [&](const Half& h) { return h.edge != begin->edge; });
        const auto split = std::find_if(begin, end, [](const Half& h) { return h.reversed; });
        const std::span<const Half> along(&*begin, static_cast<std::size_t>(split - begin));
        const std::span<const Half> against(along.data() + along.size(), static_cast<std::size_t>(end - split));
        for (std::size_t k = 0; k < along.size(); ++k)
            result[2 * along[k].corner + 1] = triangles[far_corner(partner(along, against, k).corner)];
        for (std::size_t k = 0; k < against.size(); ++k)
            result[2 * against[k].corner + 1] = triangles[far_corner(partner(against, along, k).corner)];
        if (border_edges && end - begin == 1) ++*border_edges;
        if (crowded_edges && (end - begin > 2 || along.size() == 2 || against.size() == 2)) ++*crowded_edges;
        begin = end;
    }
    return result;
}

}  // namespace snell::content
