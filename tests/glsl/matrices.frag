#version 330 compatibility
in vec3 vN;
void main() {
    mat3 m = mat3(vec3(1., 2., 0.), vec3(0., 1., .5), vec3(.2, 0., 1.));
    mat4x3 w = mat4x3(m[0], m[1], m[2], vec3(.1));
    mat2 q = mat2(m);
    vec3 a = m * vN, b = vN * m, c = w * vec4(vN, 1.);
    q[1][0] = determinant(m);
    gl_FragColor = vec4(.5 + .1 * (a + b + c + outerProduct(vN, vN) * vN) + .05 * vec3(q * vN.xy, inverse(m)[0].x), 1.);
}
