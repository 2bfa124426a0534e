// How much light a dielectric surface reflects: exact, and the approximations that shaders use.
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

// At normal incidence: ((n1 - n2) / (n1 + n2))².
double normal_reflectance(double n1, double n2);

// f0 + (1 - f0) (1 - cos)^power (Schlick 1994, with power 5).
double schlick(double cos_incident, double f0, double power = 5.0);
// Schlick with f0 of the two indices. From the denser side by the cosine of the *transmitted* angle, and 1 past the
// critical angle: with the incident cosine it is off by .5 in the mean.
double schlick_dielectric(double cos_incident, double n1, double n2);

// clamp(bias + scale (1 - cos)^power, 0, 1): The Cg Tutorial's empirical form. Power 0 gives bias + scale.
double cg_fresnel(double cos_incident, double bias, double scale, double power);

}  // namespace snell::optics
