#version 330 compatibility
in vec3 vST;

void main() {
    vec2 cell = floor(vST.st * 8.);
    float check = mod(cell.x + cell.y, 2.);
    gl_FragColor = vec4(mix(vec3(.95, .9, .8), vec3(vST.s, vST.t, .5), check), 1.);
}
