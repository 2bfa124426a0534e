// GLSL 1.10 has a namespace for functions and one for variables.
varying vec3 vN;
const float level = .5;
float level(float x) { return level * x; }
vec3 tint(vec3 n) { return abs(n); }
void main() {
    vec3 tint = tint(vN);
    gl_FragColor = vec4(tint * level(1.) + level(level), 1.);
}
