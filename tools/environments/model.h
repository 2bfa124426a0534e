// A room of boxes and balls, lit by the sun and the sky through a window, by lamps and by a fire.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "src/optics/ray.h"
#include "tools/environments/faces.h"

namespace snell::environments {

struct Material {
    Colour albedo{0.8};
    Colour emission{0};
    double gloss = 0;  // part of the light that is mirrored, seen at right angles
};

struct Spot {
    glm::dvec3 point, normal;
    int axis = 0;  // of the normal, for boxes
};
using Paint = std::function<Material(const Spot&)>;
Paint plain(const Colour& albedo, double gloss = 0);
Paint glowing(const Colour& emission);

struct Box {
    glm::dvec3 low, high;
    Paint paint;
};
struct Ball {
    glm::dvec3 centre;
    double radius;
    Paint paint;
};
// A niche in a wall: a box that opens into the room where it touches it.
struct Niche {
    Box box;
    int axis;   // of the wall
    bool high;  // in the wall at the positive end
};
struct Lamp {
    glm::dvec3 centre;
    double radius;
    Colour radiance;
};

struct Model {
    Box shell;  // seen from inside
    std::vector<Box> boxes;
    std::vector<Ball> balls;
    std::vector<Niche> niches;
    std::vector<Lamp> lamps;  // light; what is seen of them are balls or paint
};

struct Hit {
    Spot spot;
    const Paint* paint = nullptr;
    int surface = 0;  // one number for each face of each thing; -1: a ball
    double distance = 0;
};

// The first thing in the way. Precondition: the ray starts in the room or in a niche, its direction has length 1.
Hit trace(const Model& model, const optics::Ray& ray);
bool visible(const Model& model, const glm::dvec3& from, const glm::dvec3& to);

// Rectangles by surface number, for light maps: two sides and an origin, and which way they face.
struct Patch {
    glm::dvec3 origin, u, v, normal;
};
std::vector<Patch> patches(const Model& model);

}  // namespace snell::environments
