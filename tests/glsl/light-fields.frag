#version 120
varying vec3 vN;
void main() {
    gl_LightSourceParameters light = gl_LightSource[1];
    float d = 2.;
    float att = 1. / (light.constantAttenuation + light.linearAttenuation * d + light.quadraticAttenuation * d * d);
    float spot = dot(normalize(vN), light.spotDirection);
    gl_FragColor = vec4(att * .7, light.spotCutoff / 360., .5 + .5 * spot + light.spotExponent, 1.);
}
