// Deterministic randomness and the brush strokes made of it: same numbers on every machine.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace snell::environments {

std::uint32_t hash(std::uint32_t x);
// In [0,1), by integers alone.
double random(int x, int y = 0, int z = 0, int seed = 0);
// Smooth value noise in [0,1], one lattice cell per unit.
double noise(const glm::dvec3& p, int seed = 0);
// Octaves of it, each half as large and twice as fine; in [0,1].
double fbm(glm::dvec3 p, int octaves, int seed = 0);

double smooth(double low, double high, double x);
// The i-th of n points that fill the unit square evenly (Hammersley).
glm::dvec2 spread(unsigned i, unsigned n);

}  // namespace snell::environments
