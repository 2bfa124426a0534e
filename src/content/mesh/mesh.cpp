#include "src/content/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/content/mesh/surface.h"

namespace snell::content {
namespace {

using Issues = std::vector<MeshIssue>;

void warn(Issues& issues, std::string code, std::string message, std::string help = {}) {
    issues.push_back({false, std::move(code), std::move(message), std::move(help)});
}
void fail(Issues& issues, std::string code, std::string message, std::string help = {}) {
    issues.push_back({true, std::move(code), std::move(message), std::move(help)});
}

// ---- mending of parameters ---------------------------------------------------------------------------

void at_least(int& count, int least, std::string_view what, Issues& issues) {
    if (count >= least) return;
    warn(issues, fmt::format("too-few-{}", what), fmt::format("{} {} are too few; {} are used", count, what, least));
    count = least;
}

// Reports an error and returns false if the shape cannot be made.
bool finite(double value, std::string_view what, Issues& issues) {
    if (std::abs(value) <= 1e37) return true;
    fail(issues, "size-not-finite", fmt::format("the {} {} is too large or not a number", what, value),
         "give a size between -1e37 and 1e37");
    return false;
}

bool positive(double& value, std::string_view what, Issues& issues) {
    if (!finite(value, what, issues)) return false;
    if (value < 0) {
        warn(issues, "negative-size", fmt::format("the {} {} is negative; {} is used", what, value, -value));
        value = -value;
    }
    if (value == 0)
        warn(issues, "zero-size", fmt::format("the {} is 0, so the shape is invisible", what), "give a size above 0");
    return true;
}

// Halves the largest count until the product of all (count + 1) fits.
template <std::size_t N>
void fit(const std::array<int*, N>& counts, const MeshLimits& limits, Issues& issues, bool quads = false) {
    const auto product = [&] {
        double p = 1;
        for (const int* c : counts) p *= static_cast<double>(*c) + 1;
        return p;
    };
    const double asked = product();
    // Indices must fit in 32 bits, with at most six for each vertex.
    const std::uint64_t limit = quads ? std::min(limits.vertices, limits.sub_quads) : limits.vertices;
    const double most = static_cast<double>(std::clamp<std::uint64_t>(limit, 1024, 500'000'000));
    while (product() > most) {
        int* largest = *std::max_element(counts.begin(), counts.end(), [](int* a, int* b) { return *a < *b; });
        *largest /= 2;
    }
    if (product() < asked)
        fail(issues, "too-many-vertices",
             fmt::format("{:.0f} vertices are too many; {:.0f} are used", asked, product()),
             limit_help(limit, limit < limits.vertices ? &Limits::sub_quads : &Limits::vertices));
}

// ---- each shape: parameters into their domain, then make it ------------------------------------------

struct Maker {
    bool wire;
    const MeshLimits& limits;
    Issues& issues;

    Mesh operator()(Sphere s) const {
        if (!positive(s.radius, "radius", issues)) return {};
        at_least(s.slices, 3, "slices", issues);
        at_least(s.stacks, 2, "stacks", issues);
        fit(std::array{&s.slices, &s.stacks}, limits, issues);
        return make_sphere(s, wire);
    }

    // Scenes give the two radii in either order; the larger one is the ring's.
    Mesh operator()(Torus s) const {
        if (!positive(s.outer, "outer radius", issues) || !positive(s.inner, "inner radius", issues)) return {};
        if (s.inner > s.outer) {
            warn(issues, "torus-radii-swapped",
                 fmt::format(
                     "the inner radius {} is larger than the outer radius {}; the larger one is used as the ring's",
                     s.inner, s.outer));
            std::swap(s.inner, s.outer);
        } else if (s.inner == s.outer) {
            warn(issues, "torus-without-hole", "both radii are equal: the torus has no hole");
        }
        at_least(s.sides, 3, "sides", issues);
        at_least(s.rings, 3, "rings", issues);
        fit(std::array{&s.sides, &s.rings}, limits, issues);
        return make_torus(s, wire);
    }

    template <class Standing>
    bool mend_standing(Standing& s) const {
        if (!positive(s.radius, "radius", issues) || !finite(s.height, "height", issues)) return false;
        if (s.height == 0) warn(issues, "zero-size", "the height is 0; only the flat caps are drawn");
        at_least(s.slices, 3, "slices", issues);
        at_least(s.stacks, 1, "stacks", issues);
        int rows = s.stacks + std::min(4, std::numeric_limits<int>::max() - s.stacks);  // including those of the caps
        fit(std::array{&s.slices, &rows}, limits, issues);
        s.stacks = std::clamp(rows - 4, 1, s.stacks);
        return true;
    }
    Mesh operator()(Cone s) const { return mend_standing(s) ? make_cone(s, wire) : Mesh{}; }
    Mesh operator()(Cylinder s) const { return mend_standing(s) ? make_cylinder(s, wire) : Mesh{}; }

    Mesh operator()(Box s) const {
        if (!positive(s.dx, "length along x", issues) || !positive(s.dy, "length along y", issues) ||
            !positive(s.dz, "length along z", issues))
            return {};
        return make_box(s, wire);
    }

    Mesh operator()(const Teapot&) const { return make_teapot(wire); }

    Mesh operator()(Disk s) const {
        if (!finite(s.z, "z", issues) || !positive(s.radius, "radius", issues)) return {};
        at_least(s.slices, 3, "slices", issues);
        at_least(s.rings, 1, "rings", issues);
        fit(std::array{&s.slices, &s.rings}, limits, issues);
        return make_disk(s, wire);
    }

    Mesh operator()(Quad s) const {
        if (!finite(s.offset, "offset", issues) || !positive(s.size, "size", issues)) return {};
        at_least(s.n1, 1, "cells", issues);
        at_least(s.n2, 1, "cells", issues);
        fit(std::array{&s.n1, &s.n2}, limits, issues, true);
        return make_quad(s, wire);
    }

    Mesh operator()(QuadBox s) const {
        at_least(s.n, 1, "quads", issues);
        int corners = 3;  // four for a quad
        fit(std::array{&s.n, &corners}, limits, issues, true);
        return make_quad_box(s, wire);
    }

    Mesh operator()(Soccerball s) const {
        if (!positive(s.radius, "radius", issues)) return {};
        return make_soccerball(s, wire);
    }

    Mesh operator()(PointCloud s) const {
        at_least(s.nx, 1, "points", issues);
        at_least(s.ny, 1, "points", issues);
        at_least(s.nz, 1, "points", issues);
        fit(std::array{&s.nx, &s.ny, &s.nz}, limits, issues);
        return make_cloud(s);
    }

    Mesh operator()(Xarrow s) const {
        at_least(s.n, 2, "slices", issues);
        int around = 24;
        fit(std::array{&s.n, &around}, limits, issues);
        return make_xarrow(s, wire);
    }

    Mesh no_data() const {
        fail(issues, "shape-needs-data", "this shape's vertices come from a file or a list");
        return {};
    }
    Mesh operator()(const ObjFile&) const { return no_data(); }
    Mesh operator()(const ShpFile&) const { return no_data(); }
    Mesh operator()(const VertexList&) const { return no_data(); }
};

}  // namespace

void Mesh::compute_bounds() {
    min = max = {0, 0, 0};
    bool first = true;
    for (const Float3& p : positions) {
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            min[k] = first ? p[k] : std::min(min[k], p[k]);
            max[k] = first ? p[k] : std::max(max[k], p[k]);
        }
        first = false;
    }
}

std::size_t Mesh::bytes() const {
    return (positions.size() + normals.size() + texcoords.size() + tangents.size()) * sizeof(Float3) +
           w.size() * sizeof(float) + colors.size() * sizeof(Float4) + indices.size() * sizeof(std::uint32_t) +
           parts.size() * sizeof(MeshPart);
}

MeshResult make_shape(const Shape& shape, bool wire, const MeshLimits& limits) {
    MeshResult result;
    result.mesh = std::visit(Maker{wire, limits, result.issues}, shape);
    return result;
}

}  // namespace snell::content
