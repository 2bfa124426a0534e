// Light in a Model: computed once on every surface, then looked up.
#pragma once

#include <vector>

#include "tools/environments/model.h"

namespace snell::environments {

class Light {
public:
    // `sun`: irradiance at right angles and the direction to it; it comes in through niche 0, whose far wall is the
    // window pane. `bounces`: how often light is passed from surface to surface.
    Light(const Model& model, const glm::dvec3& to_sun, const Colour& sun, int bounces);

    // Light that comes back from a hit toward the ray's origin.
    Colour radiance(const Hit& hit, const glm::dvec3& direction) const;

private:
    struct Map {
        Patch patch;
        int columns = 1, rows = 1;
        std::vector<Colour> irradiance;  // all but the sun's
        Colour at(double u, double v) const;
    };
    Colour gathered(const glm::dvec3& point, const glm::dvec3& normal, int rays) const;
    Colour lamp_light(const glm::dvec3& point, const glm::dvec3& normal) const;
    Colour sun_light(const glm::dvec3& point, const glm::dvec3& normal) const;
    Colour diffuse_light(const Hit& hit) const;
    void fill(std::vector<Map>& maps) const;

    const Model& model_;
    glm::dvec3 to_sun_;
    Colour sun_;
    int pane_;
    std::vector<Map> maps_;
};

}  // namespace snell::environments
