#version 330 compatibility
uniform int FaceIndex;
in vec3 vNormal, vST;

void main() {
    vec3 leather = FaceIndex < 12 ? vec3(.1) : vec3(.95);
    if (vST.p > .95) leather = vec3(.4);
    gl_FragColor = vec4(leather * (.3 + .7 * max(0., normalize(vNormal).z)), 1.);
}
