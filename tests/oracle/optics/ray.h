// Rays against the few things that have exact answers, and the camera that sends them. Lengths are in scene units.
#pragma once

#include <optional>

#include <glm/glm.hpp>

namespace snell::optics {

struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};  // any length but zero; distances below are in units of it
    glm::dvec3 at(double distance) const { return origin + distance * direction; }
};

struct Crossing {
    double enter = 0, leave = 0;  // along the ray, enter <= leave; may be negative (behind the origin)
};

// By the point closest to the centre, h² = r² - |C - closest|²: the textbook's b² - c loses the sphere at a distance
// of 1000 radii in float. nullopt: passes by, or touches in no point.
std::optional<Crossing> cross_sphere(const Ray& ray, const glm::dvec3& centre, double radius);

// Slabs (Kay and Kajiya 1986); a component of direction that is zero decides by the origin alone. nullopt: misses.
std::optional<Crossing> cross_box(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high);

// Where a ray that starts inside leaves the room -half..half. nullopt: the origin is outside.
std::optional<glm::dvec3> room_hit(const Ray& ray, const glm::dvec3& half);

// gluLookAt's eye with gluPerspective's field of view (degrees, vertical).
struct Camera {
    glm::dvec3 eye{0}, centre{0, 0, -1}, up{0, 1, 0};
    double fov_y = 50;
};

// Through a point of a picture of width × height pixels, x to the right and y *down* from the top left corner, so
// the middle of the top left pixel is (.5, .5). The direction has length 1. Precondition: eye, centre and up span a
// plane.
Ray camera_ray(const Camera& camera, double x, double y, int width, int height);

}  // namespace snell::optics
