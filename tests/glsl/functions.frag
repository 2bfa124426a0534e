#version 330 compatibility
in vec3 vN;
void split(in vec3 v, out vec2 xy, out float z) { xy = v.xy; z = v.z; }
void scale(inout float x, const float by) { x *= by; }
float area(float r) { return r * r; }
float area(vec2 r) { return r.x * r.y; }
float area(vec3);
void main() {
    vec2 xy;
    float z;
    split(vN, xy, z);
    scale(z, .5);
    gl_FragColor = vec4(abs(area(xy)), area(z), abs(area(vN)), 1.);
}
float area(vec3 v) { return area(v.xy) + area(v.z); }
