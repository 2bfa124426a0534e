#version 330 core
in vec3 vN;
out vec4 c;
void main() {
    float sum = 0. / 4. + 1. / 4. + 2. / 4.;
    sum -= 1.;
    sum += smoothstep(0., 1., abs(vN.x)) + atan(1., 2.) + (vN.y > 0. ? 1. : 0.) + abs(vN.z) + step(0., vN.x);
    vec3 v = mix(vec3(1.), vec3(.5, 0., 0.), .5) - clamp(vN, 0., 1.) / 2.;
    c = vec4(v, 1.) * (sum / (vN.x > 0. ? 6. : 5.));
}
