#version 120
void main() {
    vec4 sum = vec4(0.);
    for (int i = 0; i < 4; i++) sum += gl_TexCoord[i];
    gl_FragColor = vec4(sum.st / 4., 0., 1.);
}
