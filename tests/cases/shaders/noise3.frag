#version 330 compatibility
uniform sampler3D Noise3;
in vec3 vPosition;

void main() {
    vec4 n = texture(Noise3, vPosition);
    gl_FragColor = vec4(vec3(.5 + 2. * (n.r + n.g + n.b + n.a - 2.)), 1.);
}
