#include "tools/environments/room.h"

#include "tools/environments/paint.h"
#include "tools/environments/sky.h"

namespace snell::environments {
namespace {

using V = glm::dvec3;
const Colour oak(0.30, 0.17, 0.08), walnut(0.16, 0.085, 0.045), white(0.80, 0.78, 0.73), brass(0.55, 0.38, 0.12);

void add(Model& m, const V& low, const V& high, Paint paint) { m.boxes.push_back({low, high, std::move(paint)}); }

void shell(Model& m) {
    m.shell = {V(-5), V(5), [](const Spot& spot) {
                   if (spot.axis != 1) return wall(spot);
                   return spot.normal.y > 0 ? floor_boards(spot) : ceiling(spot);
               }};
    add(m, V(-3.1, -5, -2.0), V(3.1, -4.97, 2.8), carpet);
    for (double z : {-3.33, 0.0, 3.33}) add(m, V(-5, 4.62, z - 0.17), V(5, 5, z + 0.17), wood(oak));
}

void window(Model& m) {
    const Colour frame = white;
    m.niches.push_back({{V(-3, -1.6, -5.5), V(3, 3, -5),
                         [](const Spot& spot) {
                             return spot.axis == 2 ? view_of_the_lake(spot) : Material{white, Colour(0), 0};
                         }},
                        2,
                        false});
    for (double x : {-2.96, -1.0, 1.0, 2.96}) add(m, V(x - 0.06, -1.6, -5.35), V(x + 0.06, 3, -5.2), plain(frame));
    for (double y : {-1.54, 1.55, 2.94}) add(m, V(-3, y - 0.06, -5.35), V(3, y + 0.06, -5.2), plain(frame));
    add(m, V(-3.3, -1.78, -5), V(3.3, -1.6, -4.72), plain(frame, 0.02));
    add(m, V(-4.5, 3.32, -4.82), V(4.5, 3.42, -4.72), plain(brass, 0.1));
    add(m, V(-4.3, -4.6, -4.9), V(-3.05, 3.34, -4.70), curtain);
    add(m, V(3.05, -4.6, -4.9), V(4.3, 3.34, -4.70), curtain);
}

void bench(Model& m) {
    add(m, V(-2.7, -5, -5), V(2.7, -3.75, -4.05), wood(oak));
    add(m, V(-2.6, -3.75, -4.95), V(2.6, -3.5, -4.1), cloth(Colour(0.62, 0.56, 0.46)));
    add(m, V(-2.45, -3.5, -4.9), V(-1.55, -2.7, -4.65), cloth(Colour(0.60, 0.16, 0.08)));
    add(m, V(-1.45, -3.5, -4.9), V(-0.65, -2.8, -4.68), cloth(Colour(0.70, 0.48, 0.10)));
    add(m, V(1.6, -3.5, -4.9), V(2.45, -2.72, -4.65), cloth(Colour(0.08, 0.24, 0.36)));
}

void bookcase(Model& m) {
    m.niches.push_back({{V(5, -5, -3.4), V(5.6, 2.2, 1.4), plain(walnut * 0.7)}, 0, true});
    add(m, V(5.2, -5, -3.4), V(5.6, 2.2, 1.4), books);
    for (int i = 0; i <= 6; ++i) add(m, V(4.96, -5.06 + 1.2 * i, -3.45), V(5.3, -4.94 + 1.2 * i, 1.45), wood(oak));
    for (double z : {-3.4, -1.0, 1.4}) add(m, V(4.96, -5, z - 0.06), V(5.3, 2.2, z + 0.06), wood(oak));
    // A reading lamp and its table, toward +Z.
    add(m, V(3.8, -3.55, 2.5), V(4.9, -3.45, 3.6), wood(walnut));
    for (double x : {3.9, 4.7})
        for (double z : {2.6, 3.4}) add(m, V(x, -5, z), V(x + 0.1, -3.55, z + 0.1), wood(walnut));
    add(m, V(4.32, -3.45, 3.02), V(4.38, -2.6, 3.08), plain(brass, 0.1));
    m.balls.push_back({V(4.35, -2.25, 3.05), 0.42, glowing(Colour(2.6, 1.75, 0.9))});
    m.lamps.push_back({V(4.35, -2.25, 3.05), 0.42, Colour(9.0, 6.0, 3.0)});
}

void fireplace(Model& m) {
    m.niches.push_back({{V(-5.9, -5, -1.3), V(-5, -2.7, 1.3),
                         [](const Spot& spot) {
                             return spot.axis == 0 ? fire(spot) : Material{Colour(0.12, 0.09, 0.08), Colour(0), 0};
                         }},
                        0,
                        false});
    m.lamps.push_back({V(-5.5, -4.5, 0), 0.35, Colour(22.0, 8.0, 1.8)});
    add(m, V(-5, -5, -1.95), V(-4.75, -2.35, -1.3), stone);
    add(m, V(-5, -5, 1.3), V(-4.75, -2.35, 1.95), stone);
    add(m, V(-5, -2.75, -1.95), V(-4.75, -2.35, 1.95), stone);
    add(m, V(-5, -2.35, -2.2), V(-4.55, -2.15, 2.2), stone);
    add(m, V(-5, -5, -2.2), V(-4.2, -4.9, 2.2), stone);
    const V low(-5, -0.9, -1.8), high(-4.9, 2.3, 1.8);
    add(m, low - V(0, 0.16, 0.16), high + V(-0.04, 0.16, 0.16), plain(brass * 0.8, 0.05));
    add(m, low, high, picture(Motif::mountains, low, high));
    for (double z : {-1.6, 1.6}) m.balls.push_back({V(-4.75, -1.85, z), 0.26, leaves()});
    for (double z : {-1.6, 1.6})
        add(m, V(-4.9, -2.15, z - 0.13), V(-4.62, -1.98, z + 0.13), plain(Colour(0.10, 0.22, 0.42), 0.05));
    // An armchair beside it.
    add(m, V(-4.8, -5, 2.6), V(-3.2, -4.0, 4.2), cloth(Colour(0.10, 0.26, 0.24)));
    add(m, V(-4.8, -4.0, 3.8), V(-3.2, -2.6, 4.2), cloth(Colour(0.10, 0.26, 0.24)));
    add(m, V(-4.85, -4.0, 2.6), V(-4.55, -3.4, 3.8), cloth(Colour(0.12, 0.29, 0.27)));
    add(m, V(-3.45, -4.0, 2.6), V(-3.15, -3.4, 3.8), cloth(Colour(0.12, 0.29, 0.27)));
}

void behind(Model& m) {
    add(m, V(1.7, -5, 4.88), V(4.0, 0.75, 5), plain(white));
    add(m, V(1.9, -5, 4.82), V(3.8, 0.55, 5), door);
    m.balls.push_back({V(2.1, -2.3, 4.74), 0.12, plain(brass, 0.2)});
    add(m, V(0.1, 1.25, 4.9), V(1.4, 2.55, 5), wood(walnut));
    add(m, V(0.2, 1.35, 4.85), V(1.3, 2.45, 5), clock_face);
    const auto framed = [&](Motif motif, const V& low, const V& high) {
        add(m, low - V(0.1, 0.1, -0.03), high + V(0.1, 0.1, 0), wood(walnut));
        add(m, low, high, picture(motif, low, high));
    };
    framed(Motif::refraction, V(-1.5, -0.6, 4.9), V(0.3, 1.0, 5));
    framed(Motif::squares, V(-3.0, -0.3, 4.9), V(-2.0, 1.0, 5));
    framed(Motif::sunset, V(-4.5, -0.6, 4.9), V(-3.4, 1.2, 5));
    const Colour linen(0.50, 0.53, 0.56);
    add(m, V(-2.7, -5, 3.9), V(0.9, -4.0, 4.9), cloth(linen));
    add(m, V(-2.7, -4.0, 4.55), V(0.9, -2.9, 4.95), cloth(linen));
    for (double x : {-2.9, 0.8}) add(m, V(x, -5, 3.85), V(x + 0.3, -3.5, 4.95), cloth(linen * 1.1));
    add(m, V(-2.3, -4.0, 4.3), V(-1.4, -3.2, 4.6), cloth(Colour(0.70, 0.42, 0.08)));
}

void lamps_and_plants(Model& m) {
    for (double x : {-2.2, 0.0, 2.2}) {
        add(m, V(x - 0.02, 3.7, -0.02), V(x + 0.02, 4.62, 0.02), plain(brass, 0.1));
        m.balls.push_back({V(x, 3.4, 0), 0.34, glowing(Colour(3.2, 2.6, 1.8))});
        m.lamps.push_back({V(x, 3.4, 0), 0.34, Colour(19.0, 15.5, 10.9)});
    }
    add(m, V(3.5, -5, -4.7), V(4.5, -4.1, -3.7), plain(Colour(0.50, 0.22, 0.12), 0.02));
    const double heights[] = {-3.6, -3.1, -2.5, -3.3, -2.9};
    const double radii[] = {0.55, 0.5, 0.45, 0.38, 0.36};
    for (int i = 0; i < 5; ++i)
        m.balls.push_back(
            {V(4.0 + 0.25 * ((i * 2) % 3 - 1), heights[i], -4.2 + 0.22 * (i % 3 - 1)), radii[i], leaves()});
}

Model furnished() {
    Model m;
    shell(m);
    window(m);  // first: its niche is where the sun comes in
    bench(m);
    bookcase(m);
    fireplace(m);
    behind(m);
    lamps_and_plants(m);
    return m;
}

}  // namespace

Room::Room()
    : model_(std::make_shared<const Model>(furnished())),
      light_(std::make_shared<const Light>(*model_, sun_direction(), Colour(6.5, 5.7, 4.5), 2)) {}

Colour Room::operator()(const glm::dvec3& direction) const {
    const glm::dvec3 d = glm::normalize(direction);
    return light_->radiance(trace(*model_, {glm::dvec3(0), d}), d);
}

}  // namespace snell::environments
