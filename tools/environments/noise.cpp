#include "tools/environments/noise.h"

#include <algorithm>
#include <cmath>

namespace snell::environments {

std::uint32_t hash(std::uint32_t x) {
    x ^= x >> 16, x *= 0x7feb352dU;
    x ^= x >> 15, x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

double random(int x, int y, int z, int seed) {
    const auto u = [](int i) { return static_cast<std::uint32_t>(i); };
    return hash((u(x) * 0x8da6b343U) ^ (u(y) * 0xd8163841U) ^ (u(z) * 0xcb1ab31fU) ^ (u(seed) * 0x9e3779b1U)) /
           4294967296.0;
}

double noise(const glm::dvec3& p, int seed) {
    const glm::dvec3 cell = glm::floor(p), f = p - cell;
    const glm::dvec3 w = f * f * (3.0 - 2.0 * f);
    const auto corner = [&](int i, int j, int k) {
        return random(static_cast<int>(cell.x) + i, static_cast<int>(cell.y) + j, static_cast<int>(cell.z) + k, seed);
    };
    const auto edge = [&](int j, int k) { return glm::mix(corner(0, j, k), corner(1, j, k), w.x); };
    return glm::mix(glm::mix(edge(0, 0), edge(1, 0), w.y), glm::mix(edge(0, 1), edge(1, 1), w.y), w.z);
}

double fbm(glm::dvec3 p, int octaves, int seed) {
    double sum = 0, weight = 0, amplitude = 1;
    for (int i = 0; i < octaves; ++i) {
        sum += amplitude * noise(p, seed + i);
        weight += amplitude;
        amplitude /= 2;
        p = p * 2.0 + 17.3;
    }
    return sum / weight;
}

double smooth(double low, double high, double x) {
    const double f = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return f * f * (3.0 - 2.0 * f);
}

glm::dvec2 spread(unsigned i, unsigned n) {
    std::uint32_t bits = i;
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00ff00ffU) << 8) | ((bits & 0xff00ff00U) >> 8);
    bits = ((bits & 0x0f0f0f0fU) << 4) | ((bits & 0xf0f0f0f0U) >> 4);
    bits = ((bits & 0x33333333U) << 2) | ((bits & 0xccccccccU) >> 2);
    bits = ((bits & 0x55555555U) << 1) | ((bits & 0xaaaaaaaaU) >> 1);
    return {(i + 0.5) / n, (bits + 0.5) / 4294967296.0};
}

}  // namespace snell::environments
