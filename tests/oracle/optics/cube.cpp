#include "tests/oracle/optics/cube.h"

#include <algorithm>
#include <cmath>

#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

// Directions in which s and t grow, and the face's own.
struct Frame {
    glm::dvec3 s, t, major;
};
const std::array<Frame, 6> frames = {{
    {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
    {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
    {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
}};

int face_of(const glm::dvec3& d) {
    const glm::dvec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x >= 0 ? 0 : 1;
    if (a.y >= a.z) return d.y >= 0 ? 2 : 3;
    return d.z >= 0 ? 4 : 5;
}

// The four texels around a point, and how far it is from the first: texel i has its centre at i + .5.
struct Footprint {
    int column, row;
    double u, v;
};
Footprint footprint(double s, double t, int width, int height) {
    const double x = s * width - 0.5, y = t * height - 0.5;
    const double column = std::floor(x), row = std::floor(y);
    return {static_cast<int>(column), static_cast<int>(row), x - column, y - row};
}

template <class Fetch>
glm::dvec3 bilinear(const Footprint& f, Fetch fetch) {
    const glm::dvec3 top = glm::mix(fetch(f.column, f.row), fetch(f.column + 1, f.row), f.u);
    const glm::dvec3 bottom = glm::mix(fetch(f.column, f.row + 1), fetch(f.column + 1, f.row + 1), f.u);
    return glm::mix(top, bottom, f.v);
}

// One step beyond one edge: the centre of that texel, folded about the edge onto the neighbouring face. A texel
// centre goes to a texel centre exactly.
glm::dvec3 fetch_beyond_edge(const CubeTexels& faces, int face, int column, int row) {
    const int size = faces[0].width;
    const auto centre = [size](int i) { return (2.0 * i + 1.0 - size) / size; };  // in [-1,1] when inside
    const Frame& frame = frames[static_cast<std::size_t>(face)];
    double x = centre(column), y = centre(row);
    const double depth = 1.0 - 1.0 / size;
    x = std::clamp(x, -1.0, 1.0), y = std::clamp(y, -1.0, 1.0);
    const CubePoint there = *cube_point(depth * frame.major + x * frame.s + y * frame.t);
    const auto index = [size](double coordinate) {
        return std::clamp(static_cast<int>(std::floor(coordinate * size)), 0, size - 1);
    };
    return faces[static_cast<std::size_t>(there.face)].at(index(there.s), index(there.t));
}

glm::dvec3 fetch_seamless(const CubeTexels& faces, int face, int column, int row) {
    const int last = faces[0].width - 1;
    const int inside_column = std::clamp(column, 0, last), inside_row = std::clamp(row, 0, last);
    const bool beyond_s = column != inside_column, beyond_t = row != inside_row;
    if (!beyond_s && !beyond_t) return faces[static_cast<std::size_t>(face)].at(column, row);
    if (beyond_s && beyond_t)
        return (faces[static_cast<std::size_t>(face)].at(inside_column, inside_row) +
                fetch_beyond_edge(faces, face, column, inside_row) +
                fetch_beyond_edge(faces, face, inside_column, row)) /
               3.0;
    return fetch_beyond_edge(faces, face, column, row);
}

}  // namespace

std::optional<CubePoint> cube_point(const glm::dvec3& direction) {
    const auto d = unit(direction);
    if (!d) return std::nullopt;
    const int face = face_of(*d);
    const Frame& frame = frames[static_cast<std::size_t>(face)];
    const double major = glm::dot(*d, frame.major);
    return CubePoint{face, 0.5 + 0.5 * glm::dot(*d, frame.s) / major, 0.5 + 0.5 * glm::dot(*d, frame.t) / major};
}

glm::dvec3 cube_direction(const CubePoint& point) {
    const Frame& frame = frames[static_cast<std::size_t>(point.face)];
    return frame.major + (2.0 * point.s - 1.0) * frame.s + (2.0 * point.t - 1.0) * frame.t;
}

glm::dvec3 Texels::at(int column, int row) const {
    const auto first =
        (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)) *
        static_cast<std::size_t>(channels);
    return glm::dvec3(bytes[first], bytes[first + 1], bytes[first + 2]) / 255.0;
}

glm::dvec3 sample_cube(const CubeTexels& faces, const glm::dvec3& direction) {
    const CubePoint p = cube_point(direction).value_or(CubePoint{4, 0.5, 0.5});
    const Texels& face = faces[static_cast<std::size_t>(p.face)];
    return bilinear(footprint(p.s, p.t, face.width, face.height),
                    [&](int column, int row) { return fetch_seamless(faces, p.face, column, row); });
}

glm::dvec3 sample_2d(const Texels& image, double s, double t) {
    return bilinear(footprint(s, t, image.width, image.height), [&](int column, int row) {
        return image.at(std::clamp(column, 0, image.width - 1),
                        image.height - 1 - std::clamp(row, 0, image.height - 1));
    });
}

std::optional<CubePoint> wall_point(const glm::dvec3& direction) {
    auto p = cube_point(direction);
    if (p) p->t = 1.0 - p->t;
    return p;
}

}  // namespace snell::optics
