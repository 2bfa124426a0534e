#version 330 compatibility
in vec3 vNormal, vPosition;

// How much a ball of window glass reflects: brighter toward the rim, on two rungs of three. Each has its tint.
void main() {
    float c = clamp(dot(normalize(vNormal), normalize(-vPosition)), 0., 1.);
    const float eta = 1.52, f0 = pow((eta - 1.) / (eta + 1.), 2.);
#if FRESNEL == FRESNEL_f0
    vec4 k = vec4(1., .6, .5, f0);
#elif FRESNEL == FRESNEL_schlick
    vec4 k = vec4(.6, 1., .5, f0 + (1. - f0) * pow(1. - c, 5.));
#elif FRESNEL == FRESNEL_exact
    float g = sqrt(eta * eta - 1. + c * c);
    float a = (g - c) / (g + c), b = (c * (g + c) - 1.) / (c * (g - c) + 1.);
    vec4 k = vec4(.5, .7, 1., .5 * a * a * (1. + b * b));
#endif
    gl_FragColor = vec4(k.rgb * (.4 + .6 * k.a), 1.);
}
