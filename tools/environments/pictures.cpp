// The pictures on the room's walls.
#include <algorithm>
#include <cmath>

#include "tools/environments/noise.h"
#include "tools/environments/paint.h"

namespace snell::environments {
namespace {

// A point of the canvas: x to the right and y up, as the visitor sees it, each in [0,1].
using Canvas = Colour (*)(double x, double y);

Colour mountains(double x, double y) {
    Colour c = glm::mix(Colour(0.85, 0.62, 0.40), Colour(0.22, 0.36, 0.60), smooth(0.3, 1.0, y));
    c = glm::mix(Colour(1.0, 0.9, 0.6), c, smooth(0.06, 0.09, std::hypot(1.5 * (x - 0.72), y - 0.72)));
    for (int layer = 0; layer < 4; ++layer) {
        const double crest =
            0.62 - 0.15 * layer + 0.22 * (fbm({(3.0 + layer) * x, 7.0 * layer, 0}, 4, 100 + layer) - 0.5);
        if (y < crest) c = glm::mix(Colour(0.42, 0.40, 0.55), Colour(0.05, 0.12, 0.12), layer / 3.0);
    }
    return c;
}

bool near_line(double x, double y, double x0, double y0, double x1, double y1, double width) {
    const double dx = x1 - x0, dy = y1 - y0,
                 t = std::clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - x0 - t * dx, y - y0 - t * dy) < width;
}

// Snell's law: a ray meets glass at 50 degrees, n = 1.5.
Colour refraction(double x, double y) {
    const Colour paper(0.84, 0.80, 0.68), glass(0.45, 0.66, 0.72), line(0.06, 0.06, 0.10), ray(0.75, 0.08, 0.03);
    const double in = 0.8727, out = std::asin(std::sin(in) / 1.5);
    Colour c = y < 0.5 ? glass : paper;
    if (std::abs(y - 0.5) < 0.008 || (std::abs(x - 0.5) < 0.006 && std::fmod(y * 14.0, 1.0) < 0.6)) c = line;
    if (near_line(x, y, 0.5 - 0.5 * std::sin(in), 0.5 + 0.5 * std::cos(in), 0.5, 0.5, 0.016)) c = ray;
    if (near_line(x, y, 0.5 + 0.5 * std::sin(out), 0.5 - 0.5 * std::cos(out), 0.5, 0.5, 0.016)) c = ray;
    if (near_line(x, y, 0.5 + 0.4 * std::sin(in), 0.5 + 0.4 * std::cos(in), 0.5, 0.5, 0.008))
        c = glm::mix(ray, paper, 0.5);
    return c;
}

Colour squares(double x, double y) {
    const Colour white(0.80, 0.78, 0.72);
    if (std::abs(x - 0.34) < 0.025 || std::abs(y - 0.40) < 0.025 || (x > 0.34 && std::abs(y - 0.16) < 0.02) ||
        (x < 0.34 && std::abs(y - 0.72) < 0.02) || (y < 0.40 && std::abs(x - 0.86) < 0.02))
        return Colour(0.02);
    if (x > 0.34 && y > 0.40) return Colour(0.62, 0.04, 0.03);
    if (x < 0.34 && y < 0.40) return Colour(0.03, 0.08, 0.36);
    if (x > 0.86 && y < 0.16) return Colour(0.80, 0.55, 0.03);
    return white;
}

Colour sunset(double x, double y) {
    const Colour sky = glm::mix(Colour(0.95, 0.35, 0.10), Colour(0.12, 0.10, 0.35), smooth(0.35, 1.0, y));
    const double sun = std::hypot(x - 0.5, y - 0.45);
    if (y > 0.36) return sun < 0.17 ? Colour(1.0, 0.78, 0.30) : sky;
    const double wave = std::sin(70.0 * y + 3.0 * noise({9.0 * x, 30.0 * y, 0}, 5));
    return std::abs(x - 0.5) < 0.05 + 0.25 * (0.36 - y) && wave > 0 ? Colour(1.0, 0.6, 0.2)
                                                                    : Colour(0.10, 0.10, 0.26) * (1.0 + 0.3 * wave);
}

Canvas canvas_of(Motif motif) {
    switch (motif) {
        case Motif::mountains:
            return mountains;
        case Motif::refraction:
            return refraction;
        case Motif::squares:
            return squares;
        case Motif::sunset:
            return sunset;
    }
    return mountains;
}

}  // namespace

Paint picture(Motif motif, const glm::dvec3& low, const glm::dvec3& high) {
    return [=, canvas = canvas_of(motif)](const Spot& spot) {
        const glm::dvec3 f = (spot.point - low) / (high - low);
        // On the walls at -X and +X right is -z and +z; on that at +Z right is -x.
        const double across = spot.axis == 0 ? f.z : f.x, x = spot.normal[spot.axis] > 0 && spot.axis == 2 ? across
                                                              : spot.axis == 0 && spot.normal.x < 0        ? across
                                                                                                    : 1.0 - across;
        return Material{canvas(x, f.y), Colour(0), 0};
    };
}

}  // namespace snell::environments
