// OpenGL leaves to its drivers which triangles fill the domain. All that are known divide it as Direct3D demands: rings
// around the middle, joined by triangles whose diagonals are mirrored about the middle of each edge. Points that a
// level between two whole numbers adds grow out of their neighbours in a fixed order. This does the same, in the same
// fixed point numbers, so that pictures agree.
#include "src/content/mesh/tessellate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace snell::content {

namespace {

constexpr int one = 1 << 16, half = one / 2;

int rounded_up(int fixed) { return (fixed + one - 1) & -one; }
int product(int a, int b) { return static_cast<int>((std::int64_t{a} * b + half) >> 16); }

// One direction of the domain, divided: the places of its points from 0 to 1.
struct Axis {
    bool odd = false;     // there is no point in the middle
    int points = 0;       // both ends included
    int of_half = 0;      // those below the middle
    std::vector<int> at;  // places, in 1/65536
};

// Of the points of half an axis, where the next finer whole level has one more.
int grown_point(int coarse_half, bool odd) {
    const auto count = static_cast<unsigned>(odd ? coarse_half - 1 : coarse_half);
    if (count == 0) return 0;
    return static_cast<int>((count & ~std::bit_floor(count)) << 1) + 1;
}

// `level` is what clamped() gives; `least` is the least number of points.
Axis axis_of(float level, bool odd, int least = 0) {
    Axis axis;
    axis.odd = odd;
    const int fixed = static_cast<int>(std::nearbyint(level * one)), halved = (fixed + 1) / 2;
    axis.points = std::max(least, odd ? rounded_up(half + halved) / half : rounded_up(halved) / half + 1);
    const int reach = halved + (odd || halved == half ? half : 0);  // level 1 counts as level 2 where that is even
    const int coarse = reach / one, fine = rounded_up(reach) / one, fraction = reach - coarse * one;
    axis.of_half = fine;
    const int split = coarse == fine ? fine + 1 : grown_point(coarse, odd);
    const auto share = [&](int segments) {
        return static_cast<int>(std::nearbyint(float{one} / static_cast<float>(segments)));
    };
    const int on_coarse = share(std::max(1, 2 * coarse - (odd ? 1 : 0))), on_fine = share(2 * fine - (odd ? 1 : 0));
    for (int i = 0; i < axis.points; ++i) {
        const bool beyond = i >= fine;
        const int n = beyond ? 2 * fine - i - (odd ? 1 : 0) : i;
        const std::int64_t a = std::int64_t{n > split ? n - 1 : n} * on_coarse, b = std::int64_t{n} * on_fine;
        const int place = static_cast<int>((a * (one - fraction) + b * fraction + half) >> 16);
        axis.at.push_back(n == fine ? half : beyond ? one - place : place);
    }
    return axis;
}

// A row of vertices, by their numbers.
using Row = std::vector<std::uint32_t>;

class Divider {
public:
    Divider(const Tessellator& tessellator, const TessellationLevels& levels) : how_(tessellator), levels_(levels) {}

    DividedDomain run() {
        const std::size_t edges = how_.domain == Domain::quads ? 4 : how_.domain == Domain::triangles ? 3 : 2;
        for (std::size_t i = 0; i < edges; ++i)
            if (!(levels_.outer[i] > 0)) return {};
        if (how_.domain == Domain::isolines)
            lines();
        else if (!coarsest(edges))
            how_.domain == Domain::quads ? quads() : triangles();
        if (!how_.points) return std::move(made_);
        made_.indices.clear();
        for (std::uint32_t i = 0; i < made_.vertices.size(); ++i) made_.indices.push_back(i);
        return std::move(made_);
    }

private:
    // As a level counts: NaN as the least.
    float clamped(float level, float least) const {
        const float most = most_tessellation - (how_.spacing == Spacing::fractional_odd ? 1 : 0);
        const float within = level > least ? std::min(level, most) : least;
        return how_.spacing == Spacing::equal ? std::ceil(within) : within;
    }
    float least() const { return how_.spacing == Spacing::fractional_even ? 2 : 1; }
    bool odd(float level) const {
        return how_.spacing == Spacing::equal ? static_cast<int>(level) % 2 == 1
                                              : how_.spacing == Spacing::fractional_odd;
    }

    Axis edge(std::size_t i) const {
        const float level = clamped(levels_.outer[i], least());
        return axis_of(level, odd(level));
    }
    // The middle has a frame around it, unless all levels are 1.
    Axis inside(float level) const {
        const float with_frame = clamped(level, how_.spacing == Spacing::fractional_odd ? 1 + 1.F / one : least());
        const bool is_odd = odd(with_frame) && with_frame != 1;
        return axis_of(with_frame, is_odd, is_odd ? 4 : 3);
    }

    // All levels are 1. True: there is nothing more to do.
    bool coarsest(std::size_t edges) {
        if (how_.spacing == Spacing::fractional_even) return false;
        const auto is_one = [&](float level) { return std::nearbyint(clamped(level, 1) * one) == one; };
        const auto inner = static_cast<std::ptrdiff_t>(edges - 2);  // of quads 2, of triangles 1
        if (!std::all_of(levels_.outer.begin(), levels_.outer.begin() + static_cast<std::ptrdiff_t>(edges), is_one) ||
            !std::all_of(levels_.inner.begin(), levels_.inner.begin() + inner, is_one))
            return false;
        if (edges == 3) {
            for (const auto& [u, v] : {std::pair(0, one), std::pair(0, 0), std::pair(one, 0)}) vertex(u, v);
            triangle(0, 1, 2);
        } else {
            for (const auto& [u, v] : {std::pair(0, 0), std::pair(one, 0), std::pair(one, one), std::pair(0, one)})
                vertex(u, v);
            triangle(0, 1, 3);
            triangle(1, 2, 3);
        }
        return true;
    }

    std::uint32_t vertex(int u, int v) {
        made_.vertices.push_back({static_cast<float>(u) / one, static_cast<float>(v) / one});
        return static_cast<std::uint32_t>(made_.vertices.size() - 1);
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (how_.clockwise) std::swap(b, c);
        made_.indices.insert(made_.indices.end(), {a, b, c});
    }

    void lines() {
        const float count = std::ceil(std::clamp(levels_.outer[0], 1.F, float{most_tessellation}));
        const Axis across = axis_of(count, static_cast<int>(count) % 2 == 1), along = edge(1);
        for (std::size_t line = 0; line + 1 < across.at.size(); ++line)
            for (std::size_t i = 0; i < along.at.size(); ++i) {
                const std::uint32_t made = vertex(along.at[i], across.at[line]);
                if (i > 0) made_.indices.insert(made_.indices.end(), {made - 1, made});
            }
    }

    // ---- rings: each edge is a row of vertices that ends where the next one begins

    // What `place` makes of each point of each edge but the last one is a vertex.
    template <class Place>
    std::vector<Row> ring(std::span<const int> lengths, const Place& place) {
        std::vector<Row> rows;
        for (std::size_t edge = 0; edge < lengths.size(); ++edge) {
            Row& row = rows.emplace_back();
            for (int i = 0; i + 1 < lengths[edge]; ++i) {
                const auto [u, v] = place(edge, i);
                row.push_back(vertex(u, v));
            }
        }
        for (std::size_t edge = 0; edge < rows.size(); ++edge) rows[edge].push_back(rows[(edge + 1) % rows.size()][0]);
        return rows;
    }

    void triangles() {
        std::vector<Axis> sides{edge(0), edge(1), edge(2)};
        const Axis in = inside(levels_.inner[0]);
        const std::array<int, 3> lengths{sides[0].points, sides[1].points, sides[2].points};
        std::vector<Row> outer = ring(lengths, [&](std::size_t side, int i) {
            const Axis& axis = sides[side];
            const int at = axis.at[static_cast<std::size_t>(side == 1 ? i : axis.points - 1 - i)];
            return side == 0 ? std::pair(0, at) : std::pair(at, side == 2 ? one - at : 0);
        });
        for (int depth = 1; 2 * depth < in.points; ++depth) {
            const int last = in.points - 1 - depth, length = in.points - 2 * depth;
            const std::array<int, 3> all{length, length, length};
            std::vector<Row> inner;
            if (length == 1)
                inner.assign(3, Row{vertex(one / 3, one / 3)});
            else
                inner = ring(all, [&](std::size_t side, int i) {
                    const int at = in.at[static_cast<std::size_t>(side == 1 ? depth + i : last - i)];
                    const int across = product(in.at[static_cast<std::size_t>(depth)], 2 * one / 3);
                    const int along = at - (across + 1) / 2;
                    return side == 0   ? std::pair(across, along)
                           : side == 1 ? std::pair(along, across)
                                       : std::pair(along, one - along - across);
                });
            for (std::size_t side = 0; side < 3; ++side)
                depth == 1 ? join(inner[side], in, outer[side], sides[side]) : join_alike(inner[side], outer[side]);
            outer = std::move(inner);
            if (length == 2) triangle(outer[0][0], outer[1][0], outer[2][0]);
        }
    }

    void quads() {
        std::vector<Axis> sides{edge(0), edge(1), edge(2), edge(3)};
        const std::array<Axis, 2> in{inside(levels_.inner[0]), inside(levels_.inner[1])};
        const std::array<int, 4> lengths{sides[0].points, sides[1].points, sides[2].points, sides[3].points};
        std::vector<Row> outer = ring(lengths, [&](std::size_t side, int i) {
            const Axis& axis = sides[side];
            const int at = axis.at[static_cast<std::size_t>(side == 1 || side == 2 ? i : axis.points - 1 - i)];
            return side % 2 == 1 ? std::pair(at, side == 3 ? one : 0) : std::pair(side == 2 ? one : 0, at);
        });
        std::array<int, 2> left{in[0].points, in[1].points};
        for (int depth = 1; 2 * depth < std::min(in[0].points, in[1].points); ++depth) {
            left = {in[0].points - 2 * depth, in[1].points - 2 * depth};
            std::vector<Row> inner =
                std::min(left[0], left[1]) == 1 ? middle_row(in, left, depth) : quad_ring(in, left, depth);
            for (std::size_t side = 0; side < 4; ++side)
                depth == 1 ? join(inner[side], in[(side + 1) % 2], outer[side], sides[side])
                           : join_alike(inner[side], outer[side]);
            outer = std::move(inner);
        }
        if (left[0] > left[1] && left[1] == 2)
            fill(Row(outer[3].rbegin(), outer[3].rend()), outer[1], Diagonals::forward);
        else if (left[1] >= left[0] && left[0] == 2)
            fill(Row(outer[2].rbegin(), outer[2].rend()), outer[0],
                 in[1].odd ? Diagonals::forward_but_in_the_middle : Diagonals::forward);
    }

    std::vector<Row> quad_ring(const std::array<Axis, 2>& in, const std::array<int, 2>& left, int depth) {
        const std::array<int, 4> lengths{left[1], left[0], left[1], left[0]};
        return ring(lengths, [&](std::size_t side, int i) {
            const bool along_u = side % 2 == 1;
            const Axis &along = in[along_u ? 0 : 1], &across = in[along_u ? 1 : 0];
            const int last = along.points - 1 - depth;
            const int at = along.at[static_cast<std::size_t>(side == 1 || side == 2 ? depth + i : last - i)];
            const int from = across.at[static_cast<std::size_t>(side < 2 ? depth : across.points - 1 - depth)];
            return along_u ? std::pair(at, from) : std::pair(from, at);
        });
    }

    // Where an even level leaves a row of single points in the middle, the ring goes along it and back.
    std::vector<Row> middle_row(const std::array<Axis, 2>& in, const std::array<int, 2>& left, int depth) {
        const bool along_u = left[0] > left[1];
        const Axis& along = in[along_u ? 0 : 1];
        Row there;
        for (int i = 0; i < left[along_u ? 0 : 1]; ++i) {
            const int at = along.at[static_cast<std::size_t>(along_u ? depth + i : along.points - 1 - depth - i)];
            there.push_back(along_u ? vertex(at, half) : vertex(half, at));
        }
        const Row back(there.rbegin(), there.rend()), first{there.front()}, last{there.back()};
        if (along_u) return {first, there, last, back};
        return {there, last, back, first};
    }

    // ---- triangles between two rows

    // Rows of one ring and the next, which has two points less.
    void join_alike(const Row& inner, const Row& outer) {
        triangle(outer[0], outer[1], inner[0]);
        fill(inner, Row(outer.begin() + 1, outer.end() - 1), Diagonals::mirrored);
        triangle(outer[outer.size() - 2], outer.back(), inner.back());
    }

    enum class Diagonals : std::uint8_t { forward, forward_but_in_the_middle, mirrored };
    // Rows of as many points.
    void fill(const Row& inner, const Row& outer, Diagonals diagonals) {
        const std::size_t middle = inner.size() / 2;
        for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
            const std::uint32_t a = inner[i], b = inner[i + 1], c = outer[i], d = outer[i + 1];
            if (diagonals == Diagonals::forward || (diagonals == Diagonals::mirrored && i >= middle)) {
                triangle(a, c, d);
                triangle(a, d, b);
            } else if (diagonals == Diagonals::mirrored || i + 1 == middle) {
                triangle(c, b, a);
                triangle(c, d, b);
            } else {
                triangle(c, d, a);
                triangle(a, d, b);
            }
        }
    }

    // Rows with any numbers of points. Both advance in the order in which levels add points, which is the order of
    // numbers whose bits are reversed.
    void join(const Row& inner, const Axis& in, const Row& outer, const Axis& out) {
        const int inner_half = in.of_half - (in.odd ? 1 : 0), outer_half = out.of_half - (out.odd ? 1 : 0);
        std::size_t a = 0, b = 0;
        const auto advance_outer = [&] { triangle(outer[b], outer[b + 1], inner[a]), ++b; };
        const auto advance_inner = [&] { triangle(inner[a], outer[b], inner[a + 1]), ++a; };
        if (outer_half > 0) advance_outer();
        for (int i = 1; i < most_tessellation / 2; ++i) {
            if (rank(i) < inner_half) advance_inner();
            if (rank(i) < outer_half) advance_outer();
        }
        if (in.odd && out.odd) {
            triangle(inner[a], outer[b], inner[a + 1]);
            triangle(inner[a + 1], outer[b], outer[b + 1]);
            ++a, ++b;
        } else if (in.odd) {
            advance_inner();
        } else if (out.odd) {
            triangle(inner[a], outer[b], outer[b + 1]);
            ++b;
        }
        for (int i = most_tessellation / 2 - 1; i > 0; --i) {
            if (rank(i) < outer_half) advance_outer();
            if (rank(i) < inner_half) advance_inner();
        }
        if (outer_half > 0) advance_outer();
    }

    // Of half an edge at the greatest level: how many points have come before the i-th.
    static int rank(int i) {
        const int bit = std::countr_zero(static_cast<unsigned>(i));
        return (16 >> bit) + (i >> (bit + 1));
    }

    Tessellator how_;
    TessellationLevels levels_;
    DividedDomain made_;
};

}  // namespace

DividedDomain divide(const Tessellator& tessellator, const TessellationLevels& levels) {
    return Divider(tessellator, levels).run();
}

}  // namespace snell::content
