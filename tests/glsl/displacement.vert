#version 330 compatibility
uniform float uA, uB, uC;
uniform float Timer;
out vec3 vN;
const float PI = 3.14159265;
void main() {
    vec4 v = gl_Vertex;
    float r = length(v.xy);
    v.z += uA * .2 * cos(2. * PI * uB * r + uC + 2. * PI * Timer) * exp(-uC * r);
    vec3 Tx = vec3(1., 0., -uA * .2 * sin(r)), Ty = vec3(0., 1., uB * .1);
    vN = normalize(gl_NormalMatrix * normalize(cross(Tx, Ty)));
    gl_Position = gl_ModelViewProjectionMatrix * v;
}
