#include "tools/environments/model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snell::environments {
namespace {

constexpr double skin = 1e-6;  // of a surface: what starts on it does not hit it

// The face of a box that a point lies on: 2 axis + (1 if at the high end).
int face_at(const Box& box, const glm::dvec3& p) {
    int best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double off = std::abs(p[axis] - (face % 2 ? box.high[axis] : box.low[axis]));
        if (off < nearest) nearest = off, best = face;
    }
    return best;
}

glm::dvec3 outward(int face) {
    glm::dvec3 n(0);
    n[face / 2] = face % 2 ? 1.0 : -1.0;
    return n;
}

// Slabs with the reciprocal direction at hand: where the ray enters, if that lies ahead and before `limit`; else
// `limit`.
double entry(const Box& box, const glm::dvec3& origin, const glm::dvec3& inverse, double limit) {
    const glm::dvec3 a = (box.low - origin) * inverse, b = (box.high - origin) * inverse;
    const glm::dvec3 nearer = glm::min(a, b), farther = glm::max(a, b);
    const double enter = std::max({nearer.x, nearer.y, nearer.z}), leave = std::min({farther.x, farther.y, farther.z});
    return enter <= leave && enter > skin && enter < limit ? enter : limit;
}

double reciprocal(double d) { return 1.0 / (std::abs(d) > 1e-200 ? d : 1e-200); }

bool contains(const Box& box, const glm::dvec3& p) {
    return glm::all(glm::greaterThan(p, box.low - skin)) && glm::all(glm::lessThan(p, box.high + skin));
}

Hit wall_of(const Box& box, const optics::Ray& ray, double distance, int first_surface) {
    const glm::dvec3 p = ray.at(distance);
    const int face = face_at(box, p);
    return {{p, -outward(face), face / 2}, &box.paint, first_surface + face, distance};
}

// Where a ray that starts inside a box leaves it.
double exit_of(const Box& box, const optics::Ray& ray, const glm::dvec3& inverse) {
    const glm::dvec3 farther = glm::max((box.low - ray.origin) * inverse, (box.high - ray.origin) * inverse);
    return std::min({farther.x, farther.y, farther.z});
}

std::optional<std::size_t> niche_at(const Model& model, const glm::dvec3& p) {
    for (std::size_t i = 0; i < model.niches.size(); ++i)
        if (contains(model.niches[i].box, p)) return i;
    return std::nullopt;
}

// From inside the shell or a niche to what encloses it, through openings that are in the way.
Hit enclosing(const Model& model, const optics::Ray& ray, const glm::dvec3& inverse) {
    const auto inside_niche = [&](std::size_t i) {
        const Box& box = model.niches[i].box;
        return wall_of(box, ray, exit_of(box, ray, inverse), 6 * static_cast<int>(1 + model.boxes.size() + i));
    };
    const auto start = contains(model.shell, ray.origin) ? std::nullopt : niche_at(model, ray.origin);
    if (start) {
        const Hit wall = inside_niche(*start);
        const Niche& niche = model.niches[*start];
        if ((wall.surface - 2 * niche.axis) % 6 != (niche.high ? 0 : 1)) return wall;  // not the opening
    }
    const double leave = exit_of(model.shell, ray, inverse);
    // A point of the shell that touches a niche is its opening.
    const auto end = niche_at(model, ray.at(leave));
    return end ? inside_niche(*end) : wall_of(model.shell, ray, leave, 0);
}

}  // namespace

Paint plain(const Colour& albedo, double gloss) {
    return [=](const Spot&) { return Material{albedo, Colour(0), gloss}; };
}

Paint glowing(const Colour& emission) {
    return [=](const Spot&) { return Material{Colour(0.6), emission, 0}; };
}

Hit trace(const Model& model, const optics::Ray& ray) {
    const glm::dvec3 inverse(reciprocal(ray.direction.x), reciprocal(ray.direction.y), reciprocal(ray.direction.z));
    Hit hit = enclosing(model, ray, inverse);
    std::size_t nearest = model.boxes.size();
    for (std::size_t i = 0; i < model.boxes.size(); ++i) {
        const double distance = entry(model.boxes[i], ray.origin, inverse, hit.distance);
        if (distance < hit.distance) hit.distance = distance, nearest = i;
    }
    if (nearest < model.boxes.size()) {
        const Box& box = model.boxes[nearest];
        const glm::dvec3 p = ray.at(hit.distance);
        const int face = face_at(box, p);
        hit = {{p, outward(face), face / 2}, &box.paint, 6 + 6 * static_cast<int>(nearest) + face, hit.distance};
    }
    for (const Ball& ball : model.balls) {
        const auto c = optics::cross_sphere(ray, ball.centre, ball.radius);
        if (!c || c->enter <= skin || c->enter >= hit.distance) continue;
        const glm::dvec3 p = ray.at(c->enter);
        hit = {{p, (p - ball.centre) / ball.radius, 0}, &ball.paint, -1, c->enter};
    }
    return hit;
}

bool visible(const Model& model, const glm::dvec3& from, const glm::dvec3& to) {
    const double distance = glm::length(to - from);
    return trace(model, {from, (to - from) / distance}).distance > distance - 1e-3;
}

std::vector<Patch> patches(const Model& model) {
    std::vector<Patch> result;
    const auto add = [&](const Box& box, double side) {
        for (int face = 0; face < 6; ++face) {
            const int axis = face / 2;
            glm::dvec3 origin = box.low, u(0), v(0);
            origin[axis] = face % 2 ? box.high[axis] : box.low[axis];
            u[(axis + 1) % 3] = box.high[(axis + 1) % 3] - box.low[(axis + 1) % 3];
            v[(axis + 2) % 3] = box.high[(axis + 2) % 3] - box.low[(axis + 2) % 3];
            result.push_back({origin, u, v, side * outward(face)});
        }
    };
    add(model.shell, -1.0);
    for (const Box& box : model.boxes) add(box, 1.0);
    for (const Niche& niche : model.niches) add(niche.box, -1.0);
    return result;
}

}  // namespace snell::environments
