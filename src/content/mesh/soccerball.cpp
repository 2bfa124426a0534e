// A truncated icosahedron, projected onto a sphere.
#include <algorithm>
#include <cmath>

#include "src/content/mesh/surface.h"

namespace snell::content {
namespace {

constexpr int steps = 12;  // from a face's centre to its seam

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3 blend(const Vec3& a, const Vec3& b, double f) {
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}
Vec3 unit_vector(const Vec3& v) {
    const double length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

std::array<Vec3, 12> icosahedron() {
    const double golden = (1 + std::sqrt(5.)) / 2;
    std::array<Vec3, 12> corners;
    std::size_t i = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double a : {1., -1.})
            for (const double b : {golden, -golden}) {
                corners[i] = {0, 0, 0};
                corners[i][(axis + 1) % 3] = a;
                corners[i][(axis + 2) % 3] = b;
                corners[i] = unit_vector(corners[i]);
                ++i;
            }
    return corners;
}

// A corner of the ball is a third of the way along an edge of the icosahedron, from `from` to `to`.
struct Corner {
    int from = 0, to = 0;
    int id() const { return from * 12 + to; }
};
using BallFace = std::vector<Corner>;  // counter-clockwise seen from outside

// Neighbours' dot product is 1 / sqrt 5.
bool joined(const Vec3& a, const Vec3& b) { return dot(a, b) > .4 && dot(a, b) < .5; }

BallFace pentagon(const std::array<Vec3, 12>& ico, int centre) {
    const auto& axis = ico[static_cast<std::size_t>(centre)];
    BallFace face;
    for (int i = 0; i < 12; ++i)
        if (joined(axis, ico[static_cast<std::size_t>(i)])) face.push_back({centre, i});
    const Vec3 x = ico[static_cast<std::size_t>(face.front().to)], y = cross(axis, x);
    const auto angle = [&](const Corner& c) {
        const Vec3& p = ico[static_cast<std::size_t>(c.to)];
        return std::atan2(dot(p, y) / dot(y, y), dot(p, x) - dot(p, axis) * dot(x, axis));
    };
    std::sort(face.begin() + 1, face.end(), [&](const Corner& a, const Corner& b) {
        const double full = 8, at = angle(a), bt = angle(b);  // angles relative to the first, counter-clockwise
        return (at < 0 ? at + full : at) < (bt < 0 ? bt + full : bt);
    });
    return face;
}

std::vector<BallFace> faces(const std::array<Vec3, 12>& ico) {
    std::vector<BallFace> all;
    for (int i = 0; i < 12; ++i) all.push_back(pentagon(ico, i));
    for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b)
            for (int c = b + 1; c < 12; ++c) {
                const auto [pa, pb, pc] = std::array{ico[static_cast<std::size_t>(a)], ico[static_cast<std::size_t>(b)],
                                                     ico[static_cast<std::size_t>(c)]};
                if (!joined(pa, pb) || !joined(pb, pc) || !joined(pc, pa)) continue;
                const bool ccw = dot(cross(pa, pb), pc) > 0;
                const int second = ccw ? b : c, third = ccw ? c : b;
                all.push_back({{a, second}, {second, a}, {second, third}, {third, second}, {third, a}, {a, third}});
            }
    return all;
}

// Makes one face: rings of points around its centre, in its plane, projected onto the sphere. Both faces at a seam
// compute its points from the same end, so that they are equal to the bit.
class FaceMaker {
public:
    FaceMaker(Surface& surface, const std::array<Vec3, 12>& ico, const BallFace& face, double radius)
        : surface_(surface), face_(face), radius_(radius) {
        for (const Corner& c : face)
            corners_.push_back(
                unit_vector(blend(ico[static_cast<std::size_t>(c.from)], ico[static_cast<std::size_t>(c.to)], 1. / 3)));
        for (const Vec3& c : corners_)
            for (std::size_t k = 0; k < 3; ++k) centre_[k] += c[k] / static_cast<double>(corners_.size());
        const Vec3 arm = blend(
            {0, 0, 0}, {corners_[0][0] - centre_[0], corners_[0][1] - centre_[1], corners_[0][2] - centre_[2]}, 1);
        reach_ = std::sqrt(dot(arm, arm));
        s_axis_ = unit_vector(arm);
        t_axis_ = cross(unit_vector(centre_), s_axis_);
    }

    void make() {
        const auto sides = static_cast<std::uint32_t>(corners_.size());
        std::vector<std::uint32_t> inner{add(centre_, 0)};
        for (std::uint32_t ring = 1; ring <= steps; ++ring) {
            std::vector<std::uint32_t> outer;
            for (std::uint32_t side = 0; side < sides; ++side)
                for (std::uint32_t m = 0; m < ring; ++m) outer.push_back(add_on_ring(side, ring, m));
            join(inner, outer, sides, ring);
            inner = std::move(outer);
        }
    }

private:
    std::uint32_t add_on_ring(std::uint32_t side, std::uint32_t ring, std::uint32_t m) {
        const std::uint32_t next = (side + 1) % static_cast<std::uint32_t>(corners_.size());
        const bool forward = face_[side].id() < face_[next].id();
        const Vec3& start = corners_[forward ? side : next];
        const Vec3& end = corners_[forward ? next : side];
        const Vec3 on_seam = blend(start, end, static_cast<double>(forward ? m : ring - m) / ring);
        if (ring == steps) return add(on_seam, 1);
        const double f = static_cast<double>(ring) / steps;
        return add(blend(centre_, on_seam, f), f);
    }

    std::uint32_t add(const Vec3& flat, double p) {
        const Vec3 out = unit_vector(flat);
        const Vec3 arm{flat[0] - centre_[0], flat[1] - centre_[1], flat[2] - centre_[2]};
        const double s = .5 + .5 * dot(arm, s_axis_) / reach_, t = .5 + .5 * dot(arm, t_axis_) / reach_;
        const auto clamp01 = [](double x) { return std::clamp(x, 0., 1.); };
        const std::uint32_t index =
            surface_.vertex({radius_ * out[0], radius_ * out[1], radius_ * out[2]}, out, {clamp01(s), clamp01(t), p});
        const double away = dot(s_axis_, out);
        surface_.tangent({s_axis_[0] - away * out[0], s_axis_[1] - away * out[1], s_axis_[2] - away * out[2]});
        return index;
    }

    void join(const std::vector<std::uint32_t>& inner, const std::vector<std::uint32_t>& outer, std::uint32_t sides,
              std::uint32_t ring) {
        const auto in = [&](std::uint32_t i) { return inner[i % inner.size()]; };
        const auto out = [&](std::uint32_t i) { return outer[i % outer.size()]; };
        for (std::uint32_t side = 0; side < sides; ++side)
            for (std::uint32_t m = 0; m < ring; ++m) {
                const std::uint32_t a = side * (ring - 1) + m, b = side * ring + m;
                surface_.triangle(in(a), out(b), out(b + 1));
                if (m + 1 < ring) surface_.triangle(in(a), out(b + 1), in(a + 1));
            }
    }

    Surface& surface_;
    const BallFace& face_;
    double radius_;
    std::vector<Vec3> corners_;
    Vec3 centre_{0, 0, 0}, s_axis_{1, 0, 0}, t_axis_{0, 1, 0};
    double reach_ = 1;
};

}  // namespace

// s and t span the face's plane: its corners are on the circle of radius .5 about (.5, .5), the first one at s = 1. p
// is 0 at the face's centre and 1 along its seam. The tangent is the direction of increasing s.
Mesh make_soccerball(const Soccerball& ball, bool wire) {
    const std::array<Vec3, 12> ico = icosahedron();
    Surface surface(wire);
    int index = 0;
    for (const BallFace& face : faces(ico)) {
        surface.part(index++);
        FaceMaker(surface, ico, face, ball.radius).make();
    }
    return std::move(surface).finish();
}

}  // namespace snell::content
