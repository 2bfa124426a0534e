#version 110
varying vec3 vN;
struct Material { vec3 color; float shine; };
float pick(float x, float y) { return x > 0 ? 1 : y; }
float total(float a[2]) { return a[0] + a[1]; }
void main() {
    float x = -1, y;
    y = 2;
    x *= 2;
    x += 3 - 1;
    vec3 v = vec3(0);
    v += 1;
    float a[2];
    a[0] = 1;
    a[1] = -1;
    Material m = Material(vec3(1, 0, 0), 20);
    float sum = 0;
    for (float i = 0; i < 3; i++) sum += i / 4;
    if (x == 0 && y >= 2) sum -= mod(5, 2);
    sum += smoothstep(0, 1, abs(vN.x)) + atan(1, 2) + pick(vN.y, 0) + total(a) + min(2, abs(vN.z)) + step(0, vN.x);
    v = mix(v, m.color * m.shine / 40, .5) - clamp(vN, 0, 1) / 2;
    gl_FragColor = vec4(v, 1) * (sum / (vN.x > 0. ? 6 : 5.));
}
