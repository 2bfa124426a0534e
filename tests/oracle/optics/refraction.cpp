#include "tests/oracle/optics/refraction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snell::optics {

glm::dvec3 glsl_reflect(const glm::dvec3& incident, const glm::dvec3& normal) {
    return incident - 2.0 * glm::dot(normal, incident) * normal;
}

glm::dvec3 glsl_refract(const glm::dvec3& incident, const glm::dvec3& normal, double eta) {
    const double d = glm::dot(normal, incident);
    const double k = 1.0 - eta * eta * (1.0 - d * d);
    if (k < 0.0) return glm::dvec3(0.0);
    return eta * incident - (eta * d + std::sqrt(k)) * normal;
}

std::optional<glm::dvec3> unit(const glm::dvec3& v) {
    // By the largest component first: the sum of squares of 1e200 or 1e-200 leaves the range of a double.
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0) || !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
    const glm::dvec3 scaled = v / largest;
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::optional<glm::dvec3> mirror(const glm::dvec3& incident, const glm::dvec3& normal) {
    const auto i = unit(incident), n = unit(normal);
    if (!i || !n) return std::nullopt;
    return unit(glsl_reflect(*i, *n));
}

double transmitted_cos2(double cos_incident, double n1, double n2) {
    const double eta = n1 / n2;
    return (n2 - n1) / n2 * ((n2 + n1) / n2) + eta * eta * cos_incident * cos_incident;
}

std::optional<Interface> meet(const glm::dvec3& incident, const glm::dvec3& normal, double n_outside, double n_inside) {
    const auto i = unit(incident), n = unit(normal);
    const auto usable = [](double index) { return std::isfinite(index) && index > 0.0; };
    if (!i || !n || !usable(n_outside) || !usable(n_inside)) return std::nullopt;

    Interface result;
    const double d = glm::dot(*i, *n);
    result.side = d > 0.0 ? Side::inside : Side::outside;
    result.n1 = result.side == Side::inside ? n_inside : n_outside;
    result.n2 = result.side == Side::inside ? n_outside : n_inside;
    const glm::dvec3 facing = d > 0.0 ? -*n : *n;
    result.cos_incident = std::min(std::abs(d), 1.0);
    result.reflected = *unit(*i + 2.0 * result.cos_incident * facing);

    const double k = transmitted_cos2(result.cos_incident, result.n1, result.n2);
    const double eta = result.n1 / result.n2;
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * eta * eta;
    result.total = k < -rounding;
    result.cos_transmitted = std::sqrt(std::clamp(k, 0.0, 1.0));
    result.transmitted = result.reflected;
    if (result.total) return result;
    const glm::dvec3 along = *i + result.cos_incident * facing;  // the part of I that lies in the surface
    result.transmitted = *unit(eta * along - result.cos_transmitted * facing);
    return result;
}

std::optional<double> critical_angle(double n1, double n2) {
    if (!(n1 > n2)) return std::nullopt;
    return std::asin(n2 / n1);
}

double brewster_angle(double n1, double n2) { return std::atan2(n2, n1); }

glm::dvec3 leave_sphere(const glm::dvec3& incident, const glm::dvec3& inside) {
    return 2.0 * glm::dot(inside, incident) * inside - incident;
}

}  // namespace snell::optics
