#version 120
varying vec3 vN;
void main() {
    gl_LightSourceParameters light = gl_LightSource[1];
    float d = 2.;
    float att = 1. / (light.constantAttenuation + light.linearAttenuation * d + light.quadraticAttenuation * d * d);
    float spot = dot(normalize(vN), light.spotDirection);
    float cut = light.spotCosCutoff < spot ? .7 : .2;
    gl_FragColor = vec4(att * cut, light.spotCutoff / 360., .5 + .5 * spot + light.spotExponent, 1.);
}
