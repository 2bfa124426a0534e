#include "tests/oracle/optics/mesh_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace snell::optics {
namespace {

struct Walk {
    glm::dvec3 from{0}, along{0}, normal{0};
    double energy = 0;
    bool through = false;
};

// What becomes of a ray at a surface that faces it.
struct Split {
    glm::dvec3 mirrored{0}, refracted{0};
    double reflectance = 1;
};

Split split(const glm::dvec3& along, const glm::dvec3& facing, double n1, double n2) {
    const double c = std::clamp(-glm::dot(along, facing), 0.0, 1.0), k = transmitted_cos2(c, n1, n2), eta = n1 / n2;
    Split out;
    out.mirrored = unit(along + 2.0 * c * facing).value_or(facing);
    if (k < -4.0 * std::numeric_limits<double>::epsilon() * eta * eta) return out;
    const glm::dvec3 inward = eta * (along + c * facing) - std::sqrt(std::clamp(k, 0.0, 1.0)) * facing;
    out.refracted = unit(inward).value_or(along);
    out.reflectance = fresnel(c, n1, n2);
    return out;
}

// By how far a point may be from where it should be, for coordinates of this size.
double rounding(double size) { return 16.0 * std::numeric_limits<double>::epsilon() * size; }

class Tracing {
public:
    Tracing(const MeshTracer& mesh, double n_outside, double n_inside, const MeshNormals& normals)
        : mesh_(mesh), n_outside_(n_outside), n_inside_(n_inside), normals_(normals) {}

    MeshLight from(const Walk& first) {
        light_.inside = 1.0;
        outside(first, Facing::both);
        for (;;) {
            const auto strongest = std::ranges::max_element(waiting_, {}, &Walk::energy);
            if (strongest == waiting_.end() || strongest->energy < series_end || ended()) return std::move(light_);
            const Walk walk = *strongest;
            waiting_.erase(strongest);
            const auto hit = meet(walk, Facing::back);
            if (!hit) {
                leave(walk, false);
                continue;
            }
            outside(part(walk, *hit), Facing::front);
        }
    }

private:
    bool ended() const { return light_.triangles.size() > static_cast<std::size_t>(series_limit); }

    std::optional<MeshHit> meet(const Walk& walk, Facing facing) const {
        const glm::dvec3 far = glm::abs(walk.from);
        return mesh_.nearest({walk.from, walk.along}, -rounding(mesh_.extent() + std::max({far.x, far.y, far.z})),
                             facing);
    }

    // Follows what is mirrored outside again and again until it is gone.
    void outside(Walk walk, Facing facing) {
        while (walk.energy > 0.0) {
            const auto hit = meet(walk, facing);
            if (!hit) return leave(walk, true);
            if (ended() || walk.energy < series_end) return;
            walk = part(walk, *hit);
            facing = Facing::front;
        }
    }

    // Away from the triangle's edges by what a point is rounded: else it may lie beyond the neighbours of all of
    // them at once, and a ray inside would find no way out.
    glm::dvec3 inner_point(const MeshHit& hit) const {
        const std::array<glm::dvec3, 3> unit_weights = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        std::array<glm::dvec3, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh_.point(hit.triangle, unit_weights[k]);
        const double area2 = glm::length(mesh_.face_normal(hit.triangle)), least = rounding(mesh_.extent());
        glm::dvec3 weights = hit.weights;
        for (int k = 0; k < 3; ++k) {
            const double side = glm::length(corner[(static_cast<std::size_t>(k) + 1) % 3] -
                                            corner[(static_cast<std::size_t>(k) + 2) % 3]);
            weights[k] = std::max(weights[k], std::min(least * side / area2, 0.25));
        }
        return mesh_.point(hit.triangle, weights / (weights.x + weights.y + weights.z));
    }

    void leave(const Walk& walk, bool closed) {
        light_.exits.push_back(
            {walk.from, closed ? walk.normal : walk.along, walk.along, walk.energy, walk.through || !closed, closed});
        light_.inside -= walk.energy;
    }

    glm::dvec3 curved(const MeshHit& hit, const glm::dvec3& face) const {
        glm::dvec3 normal(0.0);
        for (int k = 0; k < 3; ++k) {
            const std::size_t at = hit.triangle * 3 + static_cast<std::size_t>(k);
            if (at < normals_.indices.size() && normals_.indices[at] < normals_.normals.size())
                normal += hit.weights[k] * normals_.normals[normals_.indices[at]];
        }
        return unit(normal).value_or(face);
    }

    // Keeps the part inside, and gives the one outside.
    Walk part(const Walk& walk, const MeshHit& hit) {
        light_.triangles.push_back(hit.triangle);
        const double side = hit.front ? 1.0 : -1.0;
        const double n1 = hit.front ? n_outside_ : n_inside_, n2 = hit.front ? n_inside_ : n_outside_;
        glm::dvec3 facing = side * unit(mesh_.face_normal(hit.triangle)).value_or(glm::dvec3(0.0));
        Split parts = split(walk.along, facing, n1, n2);
        if (!normals_.normals.empty()) {
            const glm::dvec3 other = side * curved(hit, side * facing);
            const Split bent = split(walk.along, other, n1, n2);
            const bool possible = glm::dot(walk.along, other) < 0.0 && glm::dot(bent.mirrored, facing) > 0.0 &&
                                  (bent.reflectance >= 1.0 || glm::dot(bent.refracted, facing) < 0.0);
            if (possible) parts = bent, facing = other;
        }
        const glm::dvec3 at = inner_point(hit);
        const double mirrored = walk.energy * parts.reflectance, refracted = walk.energy - mirrored;
        waiting_.push_back(
            {at, hit.front ? parts.refracted : parts.mirrored, side * facing, hit.front ? refracted : mirrored, true});
        return {at, hit.front ? parts.mirrored : parts.refracted, side * facing, hit.front ? mirrored : refracted,
                !hit.front};
    }

    const MeshTracer& mesh_;
    double n_outside_, n_inside_;
    MeshNormals normals_;
    std::vector<Walk> waiting_;
    MeshLight light_;
};

}  // namespace

MeshLight through_mesh(const MeshTracer& mesh, const Ray& ray, double n_outside, double n_inside,
                       const MeshNormals& normals) {
    const auto along = unit(ray.direction);
    const auto usable = [](double index) { return std::isfinite(index) && index > 0.0; };
    if (!along || !usable(n_outside) || !usable(n_inside)) return {};
    return Tracing(mesh, n_outside, n_inside, normals).from({ray.origin, *along, -*along, 1.0, false});
}

}  // namespace snell::optics
