#include "tools/environments/sky.h"

#include <algorithm>
#include <cmath>

#include "tools/environments/noise.h"

namespace snell::environments {
namespace {

Colour air(const glm::dvec3& d) {
    const double height = std::max(d.y, 0.0), sun = std::max(glm::dot(d, sun_direction()), 0.0);
    const Colour zenith(0.06, 0.19, 0.50), horizon(0.50, 0.66, 0.82), warm(1.0, 0.78, 0.50);
    Colour c = glm::mix(zenith, horizon, std::pow(1.0 - height, 3.2));
    c += warm * (0.16 * std::pow(sun, 9.0) + 0.5 * std::pow(sun, 120.0));
    return c + Colour(1.0, 0.93, 0.8) * (30.0 * smooth(0.99930, 0.99955, sun));
}

double cloud_density(const glm::dvec2& p) {
    const double shape = fbm({p.x, 0.0, p.y}, 6, 14), patches = noise({p.x * 0.35, 5.0, p.y * 0.35}, 34);
    return smooth(0.47, 0.71, shape + 0.22 * (patches - 0.5));
}

// Clouds on a sheet far above: thin where the sheet is seen edge on.
Colour with_clouds(const Colour& behind, const glm::dvec3& d) {
    if (d.y < 0.02) return behind;
    const glm::dvec2 p = 1.5 * glm::dvec2(d.x, d.z) / (d.y + 0.12);
    const double density = cloud_density(p);
    if (density <= 0.0) return behind;
    const glm::dvec2 to_sun = 0.22 * glm::normalize(glm::dvec2(sun_direction().x, sun_direction().z));
    const double lit = std::exp(-1.9 * cloud_density(p + to_sun)),
                 near_sun = std::pow(std::max(glm::dot(d, sun_direction()), 0.0), 8.0);
    const Colour cloud =
        glm::mix(Colour(0.30, 0.36, 0.47), Colour(1.15, 1.10, 1.02), lit) + near_sun * Colour(0.35, 0.28, 0.18);
    return glm::mix(behind, cloud, 0.93 * density * smooth(0.02, 0.16, d.y));
}

// Height of a mountain range over the horizon (tangent of the angle), all around without a seam.
double range_height(double x, double z, double roughness, int seed) {
    const glm::dvec3 circle = roughness * glm::normalize(glm::dvec3(x, 0, z));
    double sum = 0, amplitude = 0.5;
    for (int i = 0; i < 6; ++i, amplitude *= 0.5)
        sum += amplitude * (1.0 - std::abs(2.0 * noise(circle * std::pow(2.0, i) + 40.0, seed + i) - 1.0));
    return sum;
}

struct Range {
    double base, relief, roughness, haze;
    Colour colour;
    int seed;
    bool snow;
};

Colour with_ranges(Colour c, const glm::dvec3& d) {
    const double flat = std::hypot(d.x, d.z);
    if (flat < 0.3) return c;
    const double elevation = d.y / flat;
    static const Range ranges[] = {{-0.10, 0.60, 2.1, 0.26, {0.13, 0.155, 0.21}, 61, true},
                                   {-0.08, 0.31, 3.3, 0.15, {0.075, 0.115, 0.10}, 83, false},
                                   {-0.05, 0.15, 9.0, 0.05, {0.035, 0.07, 0.03}, 97, false}};
    for (const Range& r : ranges) {
        if (elevation >= r.base + r.relief) continue;
        const double crest = r.base + r.relief * range_height(d.x, d.z, r.roughness, r.seed);
        if (elevation >= crest) continue;
        const glm::dvec3 around = glm::dvec3(d.x, 0, d.z) / flat;
        const double rock = fbm(around * 26.0 + glm::dvec3(0, 42.0 * elevation, 0), 5, r.seed + 9);
        Colour slope = r.colour * (0.55 + 0.9 * rock);
        if (r.snow)
            slope = glm::mix(slope, Colour(0.62, 0.66, 0.74), smooth(0.20, 0.28, elevation + 0.16 * (rock - 0.5)));
        if (!r.snow) slope *= 0.75 + 0.5 * noise(glm::dvec3(around.x * 160, elevation * 220, around.z * 160), 7);
        c = glm::mix(slope, Colour(0.34, 0.47, 0.66), r.haze * (1.0 - 0.6 * smooth(0.0, 0.25, elevation)));
    }
    return c;
}

Colour meadow(const glm::dvec2& p, double distance) {
    const double patches = fbm({0.25 * p.x, 1.0, 0.25 * p.y}, 4, 201),
                 blades = fbm({6.0 * p.x, 2.0, 6.0 * p.y}, 3, 211);
    Colour grass = glm::mix(Colour(0.055, 0.115, 0.022), Colour(0.17, 0.20, 0.05), patches) * (0.55 + 0.9 * blades);
    const glm::dvec2 cell = glm::floor(p * 5.0);
    const int i = static_cast<int>(cell.x), j = static_cast<int>(cell.y);
    const glm::dvec2 centre(random(i, j, 1), random(i, j, 2));
    const bool flower = random(i, j, 3) < 0.10 && glm::length(p * 5.0 - cell - (0.25 + 0.5 * centre)) < 0.2;
    if (flower && distance < 9.0) grass = random(i, j, 4) < 0.5 ? Colour(0.9, 0.85, 0.8) : Colour(0.9, 0.62, 0.08);
    const double bend = 1.1 * std::sin(0.55 * p.y) + 0.35 * std::sin(1.3 * p.y + 1.0);
    const double edge = std::abs(p.x + 1.4 - bend) + 0.25 * (blades - 0.5);
    const Colour gravel = Colour(0.46, 0.38, 0.27) * (0.65 + 0.7 * fbm({14.0 * p.x, 3.0, 14.0 * p.y}, 2, 221));
    return glm::mix(gravel, grass, smooth(0.34, 0.46, edge));
}

Colour ground(const glm::dvec3& d);

Colour above(const glm::dvec3& d) { return with_ranges(with_clouds(air(d), d), d); }

Colour water(const glm::dvec3& d, const glm::dvec2& p) {
    const double ripple = (fbm({1.5 * p.x, 0.0, 5.0 * p.y}, 4, 301) - 0.5) * 0.10;
    const glm::dvec3 mirrored = glm::normalize(glm::dvec3(d.x, -d.y + std::abs(ripple), d.z + ripple));
    const double grazing = std::pow(1.0 + d.y, 4.0);
    return glm::mix(Colour(0.02, 0.09, 0.11), above(mirrored), 0.12 + 0.85 * grazing);
}

Colour ground(const glm::dvec3& d) {
    const glm::dvec2 p = 1.3 * glm::dvec2(d.x, d.z) / -d.y;  // in metres, the eye at 1.3
    const double distance = glm::length(p);
    const double shore = p.x - 3.2 - 1.6 * (fbm({0.3 * p.x, 0.0, 0.3 * p.y}, 3, 401) - 0.5) - 0.012 * p.y * p.y;
    const Colour sand(0.50, 0.43, 0.30);
    Colour c = shore > 0.0 ? water(d, p) : glm::mix(sand, meadow(p, distance), smooth(0.15, 0.55, -shore));
    return glm::mix(c, Colour(0.40, 0.53, 0.56), 0.50 * smooth(10.0, 120.0, distance));
}

}  // namespace

glm::dvec3 sun_direction() { return glm::normalize(glm::dvec3(-0.50, 0.62, -0.60)); }

Colour sky_radiance(const glm::dvec3& direction) {
    const glm::dvec3 d = glm::normalize(direction);
    return d.y < -0.002 ? glm::mix(above(d), ground(d), smooth(0.002, 0.012, -d.y)) : above(d);
}

}  // namespace snell::environments
