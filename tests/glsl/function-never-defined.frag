// Declared, neither called nor defined.
varying vec3 vN;
float never(vec3 n, inout float f, float[2] a);
struct Light { vec3 color; };
Light none(const in Light light);
void main() { gl_FragColor = vec4(abs(vN), 1.); }
