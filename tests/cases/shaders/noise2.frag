#version 330 compatibility
uniform sampler2D Noise2;
in vec3 vST;

void main() {
    vec4 n = texture(Noise2, vST.st);
    gl_FragColor = vec4(vec3(.5 + 2. * (n.r + n.g + n.b + n.a - 2.)), 1.);
}
