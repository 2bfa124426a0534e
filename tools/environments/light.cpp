#include "tools/environments/light.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "tools/environments/noise.h"

namespace snell::environments {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double texel_side = 0.24;  // of the light maps, in scene units
constexpr double lift = 1e-4;        // of ray origins off their surface

struct Basis {
    glm::dvec3 x, y, z;
};
Basis around(const glm::dvec3& normal) {
    const glm::dvec3 helper = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, normal));
    return {x, glm::cross(normal, x), normal};
}

}  // namespace

Light::Light(const Model& model, const glm::dvec3& to_sun, const Colour& sun, int bounces)
    : model_(model), to_sun_(to_sun), sun_(sun), pane_(6 + 6 * static_cast<int>(model.boxes.size()) + 4) {
    for (const Patch& patch : patches(model)) {
        const auto cells = [](const glm::dvec3& side) {
            return std::clamp(static_cast<int>(std::lround(glm::length(side) / texel_side)), 2, 48);
        };
        Map map{patch, cells(patch.u), cells(patch.v), {}};
        map.irradiance.assign(static_cast<std::size_t>(map.columns * map.rows), Colour(0));
        maps_.push_back(map);
    }
    for (int bounce = 0; bounce < bounces; ++bounce) {
        std::vector<Map> next = maps_;
        fill(next);
        maps_ = std::move(next);
    }
}

Colour Light::Map::at(double u, double v) const {
    const double x = std::clamp(u * columns - 0.5, 0.0, columns - 1.0), y = std::clamp(v * rows - 0.5, 0.0, rows - 1.0);
    const int i = std::min(static_cast<int>(x), columns - 2), j = std::min(static_cast<int>(y), rows - 2);
    const auto cell = [&](int column, int row) { return irradiance[static_cast<std::size_t>(row * columns + column)]; };
    return glm::mix(glm::mix(cell(i, j), cell(i + 1, j), x - i), glm::mix(cell(i, j + 1), cell(i + 1, j + 1), x - i),
                    y - j);
}

// Balls of light: irradiance of a disc that faces the point, in soft shadow.
Colour Light::lamp_light(const glm::dvec3& point, const glm::dvec3& normal) const {
    constexpr unsigned rays = 12;
    Colour sum(0);
    for (const Lamp& lamp : model_.lamps) {
        const glm::dvec3 to = lamp.centre - point;
        const double distance = glm::length(to);
        const Basis basis = around(to / distance);
        for (unsigned i = 0; i < rays; ++i) {
            const glm::dvec2 s = spread(i, rays);
            const double r = lamp.radius * std::sqrt(s.x), phi = 2.0 * pi * s.y;
            const glm::dvec3 target =
                lamp.centre + r * (std::cos(phi) * basis.x + std::sin(phi) * basis.y) - 1.05 * lamp.radius * basis.z;
            const glm::dvec3 way = glm::normalize(target - point);
            const double cosine = glm::dot(way, normal);
            if (cosine <= 0.0 || !visible(model_, point, target)) continue;
            const double size =
                pi * lamp.radius * lamp.radius / std::max(distance * distance, lamp.radius * lamp.radius);
            sum += lamp.radiance * (cosine * size / rays);
        }
    }
    return sum;
}

Colour Light::sun_light(const glm::dvec3& point, const glm::dvec3& normal) const {
    const double cosine = glm::dot(to_sun_, normal);
    if (cosine <= 0.0) return Colour(0);
    return trace(model_, {point, to_sun_}).surface == pane_ ? cosine * sun_ : Colour(0);
}

// Over the hemisphere, by cosine: the window pane is a source like any other; lamps are left to lamp_light.
Colour Light::gathered(const glm::dvec3& point, const glm::dvec3& normal, int rays) const {
    const Basis basis = around(normal);
    Colour sum(0);
    for (int i = 0; i < rays; ++i) {
        const glm::dvec2 s = spread(static_cast<unsigned>(i), static_cast<unsigned>(rays));
        const double r = std::sqrt(s.x), phi = 2.0 * pi * s.y;
        const glm::dvec3 way =
            r * std::cos(phi) * basis.x + r * std::sin(phi) * basis.y + std::sqrt(1.0 - s.x) * basis.z;
        const Hit hit = trace(model_, {point, way});
        const Material m = (*hit.paint)(hit.spot);
        sum += m.albedo / pi * diffuse_light(hit);
        if (hit.surface == pane_) sum += m.emission;
    }
    return pi / rays * sum + lamp_light(point, normal);
}

Colour Light::diffuse_light(const Hit& hit) const {
    const glm::dvec3 lifted = hit.spot.point + lift * hit.spot.normal;
    if (hit.surface < 0) return Colour(0.6);  // balls are too small to pass light on
    const Map& map = maps_[static_cast<std::size_t>(hit.surface)];
    const glm::dvec3 off = hit.spot.point - map.patch.origin;
    const Colour stored = map.at(glm::dot(off, map.patch.u) / glm::dot(map.patch.u, map.patch.u),
                                 glm::dot(off, map.patch.v) / glm::dot(map.patch.v, map.patch.v));
    return stored + sun_light(lifted, hit.spot.normal);
}

void Light::fill(std::vector<Map>& maps) const {
    const auto work = [&](std::size_t first) {
        for (std::size_t k = first; k < maps.size(); k += 2) {
            Map& map = maps[k];
            for (std::size_t i = 0; i < map.irradiance.size(); ++i) {
                const std::size_t columns = static_cast<std::size_t>(map.columns), column = i % columns,
                                  row = i / columns;
                const double u = (static_cast<double>(column) + 0.5) / map.columns;
                const double v = (static_cast<double>(row) + 0.5) / map.rows;
                const glm::dvec3 point = map.patch.origin + u * map.patch.u + v * map.patch.v + lift * map.patch.normal;
                map.irradiance[i] = gathered(point, map.patch.normal, 112);
            }
        }
    };
    std::thread odd(work, std::size_t{1});
    work(0);
    odd.join();
}

Colour Light::radiance(const Hit& hit, const glm::dvec3& direction) const {
    const Material m = (*hit.paint)(hit.spot);
    const glm::dvec3 lifted = hit.spot.point + lift * hit.spot.normal;
    const Colour light = hit.surface < 0 ? gathered(lifted, hit.spot.normal, 24) + sun_light(lifted, hit.spot.normal)
                                         : diffuse_light(hit);
    Colour seen = m.emission + m.albedo / pi * light;
    if (m.gloss > 0.0) {
        const double cosine = std::max(-glm::dot(direction, hit.spot.normal), 0.0);
        const double mirrored = m.gloss + (1.0 - m.gloss) * 0.4 * std::pow(1.0 - cosine, 5.0);
        const glm::dvec3 way = direction + 2.0 * cosine * hit.spot.normal;
        const Hit next = trace(model_, {lifted, way});
        const Material there = (*next.paint)(next.spot);
        seen =
            glm::mix(seen, glm::min(there.emission + there.albedo / pi * diffuse_light(next), Colour(4.0)), mirrored);
    }
    return seen;
}

}  // namespace snell::environments
