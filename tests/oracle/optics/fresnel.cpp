#include "tests/oracle/optics/fresnel.h"

#include <algorithm>
#include <cmath>

#include "tests/oracle/optics/refraction.h"

namespace snell::optics {

Polarised fresnel_polarised(double cos_incident, double n1, double n2) {
    const double c = std::clamp(cos_incident, 0.0, 1.0);
    if (n1 == n2) return {0.0, 0.0};
    const double k = transmitted_cos2(c, n1, n2);
    if (!(k > 0.0)) return {1.0, 1.0};
    const double t = std::sqrt(k);
    const double sum = n1 * c + n2 * t;
    const double rs = (n1 - n2) * (n1 + n2) / (sum * sum);
    const double cosines = c * t, sines = n1 / n2 * (1.0 - c) * (1.0 + c);
    const double ratio = (cosines - sines) / (cosines + sines);
    return {std::min(rs * rs, 1.0), std::min(rs * rs * ratio * ratio, 1.0)};
}

double fresnel(double cos_incident, double n1, double n2) { return fresnel_polarised(cos_incident, n1, n2).mean(); }

double normal_reflectance(double n1, double n2) {
    const double r = (n1 - n2) / (n1 + n2);
    return r * r;
}

double schlick(double cos_incident, double f0, double power) {
    return f0 + (1.0 - f0) * std::pow(1.0 - std::clamp(cos_incident, 0.0, 1.0), power);
}

double schlick_dielectric(double cos_incident, double n1, double n2) {
    const double f0 = normal_reflectance(n1, n2);
    if (n1 <= n2) return schlick(cos_incident, f0);
    const double k = transmitted_cos2(std::clamp(cos_incident, 0.0, 1.0), n1, n2);
    return k < 0.0 ? 1.0 : schlick(std::sqrt(k), f0);
}

double gaussian_dielectric(double cos_incident, double n1, double n2) {
    const double f0 = normal_reflectance(n1, n2), c = std::clamp(cos_incident, 0.0, 1.0);
    const double k = n1 <= n2 ? c * c : transmitted_cos2(c, n1, n2);
    if (k < 0.0) return 1.0;
    const double beyond = std::sqrt(k);
    return f0 + (1.0 - f0) * std::exp2((-5.55473 * beyond - 6.98316) * beyond);
}

Polarised fresnel_conductor_polarised(double cos_incident, double n1, double eta, double k) {
    const double c = std::clamp(cos_incident, 0.0, 1.0), sin2 = (1.0 - c) * (1.0 + c);
    const double n = eta / n1, absorption = k / n1;
    const double real = (n - absorption) * (n + absorption) - sin2, half_imaginary = n * absorption;
    const double modulus = std::hypot(real, 2.0 * half_imaginary);
    const double larger = std::sqrt(0.5 * (modulus + std::abs(real)));
    const double smaller = larger > 0.0 ? half_imaginary / larger : 0.0;
    const double a = real >= 0.0 ? larger : smaller, b = real >= 0.0 ? smaller : larger;
    const auto quotient = [](double difference, double sum, double common) {
        const double below = sum * sum + common * common;
        return below > 0.0 ? (difference * difference + common * common) / below : 1.0;
    };
    const double s = quotient(c - a, c + a, b);
    return {s, s * quotient(a * c - sin2, a * c + sin2, b * c)};
}

double fresnel_conductor(double cos_incident, double n1, double eta, double k) {
    return fresnel_conductor_polarised(cos_incident, n1, eta, k).mean();
}

double lazanyi(double cos_incident, double f0, double a, double alpha) {
    const double c = std::clamp(cos_incident, 0.0, 1.0);
    return std::clamp(schlick(c, f0) - a * c * std::pow(1.0 - c, alpha), 0.0, 1.0);
}

double lazanyi_depth(double eta, double k) {
    const double c = 1.0 / (1.0 + lazanyi_power), f0 = fresnel_conductor(1.0, 1.0, eta, k);
    return (schlick(c, f0) - fresnel_conductor(c, 1.0, eta, k)) / (c * std::pow(1.0 - c, lazanyi_power));
}

double cg_fresnel(double cos_incident, double bias, double scale, double power) {
    const double shape = std::pow(1.0 - std::clamp(cos_incident, 0.0, 1.0), power);
    return std::clamp(bias + scale * shape, 0.0, 1.0);
}

}  // namespace snell::optics
