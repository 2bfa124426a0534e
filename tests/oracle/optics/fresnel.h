// How much light a surface reflects: exact for dielectrics and metals, and the approximations that shaders use.
// Every function takes the cosine of the angle of incidence (clamped to [0,1]) and returns a reflectance of power.
#pragma once

namespace snell::optics {

struct Polarised {
    double s = 0, p = 0;  // electric field perpendicular to, and in, the plane of incidence
    double mean() const { return 0.5 * (s + p); }
};

// Fresnel's equations for a lossless dielectric, light going from index n1 into n2; 1 past the critical angle, 0
// for n1 = n2. Rs = ((n1 c - n2 t) / (n1 c + n2 t))² with the numerator as (n1² - n2²) / (n1 c + n2 t), and Rp from
// Rs by Rp / Rs = ((c t - n1/n2 s²) / (c t + n1/n2 s²))²: no difference of nearly equal numbers, so n = 1.0003
// keeps its digits. Precondition: n1, n2 positive.
Polarised fresnel_polarised(double cos_incident, double n1, double n2);
// Unpolarised: the mean of both.
double fresnel(double cos_incident, double n1, double n2);

inline constexpr double lazanyi_power = 6;

// At normal incidence: ((n1 - n2) / (n1 + n2))².
double normal_reflectance(double n1, double n2);

// f0 + (1 - f0) (1 - cos)^power (Schlick 1994, with power 5).
double schlick(double cos_incident, double f0, double power = 5.0);
// Schlick with f0 of the two indices. From the denser side by the cosine of the *transmitted* angle, and 1 past the
// critical angle: with the incident cosine it is off by .5 in the mean.
double schlick_dielectric(double cos_incident, double n1, double n2);

// Schlick's shape with the power replaced by 2^((-5.55473 c - 6.98316) c) (Karis 2013, fitted to the fifth power):
// exactly 1 at grazing, f0 + 1.7e-4 (1 - f0) at normal incidence. From the denser side as schlick_dielectric.
double gaussian_dielectric(double cos_incident, double n1, double n2);

// Fresnel's equations for a metal of index eta + i k, met from a dielectric of index n1 (Born and Wolf §14.2). With
// (a + i b)² = (eta + i k)² / n1² - sin²,
//   Rs = ((c - a)² + b²) / ((c + a)² + b²),  Rp / Rs = ((a c - sin²)² + (b c)²) / ((a c + sin²)² + (b c)²):
// quotients of sums of squares, which can't leave [0,1]; the usual "x - 2 a c" cancels. The smaller of a and b is
// taken from their product eta k, because the difference that gives it directly cancels too. k = 0 is the
// dielectric, total reflection included. Precondition: n1 > 0, eta >= 0, k >= 0, not eta = k = 0.
Polarised fresnel_conductor_polarised(double cos_incident, double n1, double eta, double k);
double fresnel_conductor(double cos_incident, double n1, double eta, double k);

// The ladder of metals is schlick(c, f0), then this, then fresnel_conductor. A metal of much absorption mirrors less
// before grazing than at normal incidence, a dip that Schlick's shape can't have:
// schlick - a c (1 - c)^alpha (Lazányi and Szirmay-Kalos 2005, term 2), clamped to [0,1].
double lazanyi(double cos_incident, double f0, double a, double alpha = lazanyi_power);
// The `a` with which it is exact at c = 1/7, where c (1 - c)^6 is greatest (Hoffman 2019), met from index 1.
double lazanyi_depth(double eta, double k);

// clamp(bias + scale (1 - cos)^power, 0, 1): The Cg Tutorial's empirical form. Power 0 gives bias + scale.
double cg_fresnel(double cos_incident, double bias, double scale, double power);

}  // namespace snell::optics
