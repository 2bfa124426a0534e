#version 120
flat varying vec4 vFlat;
void main() {
    vFlat = vec4(.5 + .5 * gl_Normal, 1.);
    gl_Position = ftransform();
}
