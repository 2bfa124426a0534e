// Light through a closed mesh of glass: every path, through any number of interfaces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/oracle/optics/mesh.h"
#include "tests/oracle/optics/sphere.h"

namespace snell::optics {

// One way out of the mesh.
struct MeshExit {
    glm::dvec3 position{0};   // where it leaves
    glm::dvec3 normal{0};     // unit length, outward, there
    glm::dvec3 direction{0};  // unit length, away from the mesh
    double energy = 0;        // share of the light, with unpolarised reflectances multiplied at every interface
    bool through = false;     // it came from inside; else it was only mirrored
    bool closed = true;       // false: inside, it found no surface to leave through, and goes on as it was
};

struct MeshLight {
    std::vector<MeshExit> exits;
    double inside = 0;                   // share that had not come out when the series stopped
    std::vector<std::size_t> triangles;  // all that were met, in their order
};

// Normals at the mesh's vertices, to be interpolated: three for each triangle. Empty: triangles are flat.
struct MeshNormals {
    std::span<const glm::dvec3> normals;
    std::span<const std::uint32_t> indices;
};

// All exits of light that comes along the ray from outside the mesh. At each triangle a ray becomes two, with the
// shares of Fresnel's equations; all of it is mirrored past the critical angle. Of the rays that wait, the one
// outside goes first, then always the strongest inside: for a ball the exits are those of through_sphere, in its
// order. Rays outside meet fronts of triangles only and rays inside backs: a ray can't meet the triangle that it
// leaves, so that none needs to be moved off it. What a ray lies behind by no more than rounding is still met.
// Ends when no ray has series_end of the light, or after series_limit + 1 interfaces, as many as a ball's
// series_limit exits have; `inside` is the rest.
// A ray that passes by: one exit, with energy 1. One that meets a back first began inside. With `normals`, where an
// interpolated normal would send light to the wrong side of the triangle, the triangle's own is taken.
// Empty: no direction, or indices that are not positive and finite.
MeshLight through_mesh(const MeshTracer& mesh, const Ray& ray, double n_outside, double n_inside,
                       const MeshNormals& normals = {});

}  // namespace snell::optics
