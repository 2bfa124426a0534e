#version 330 compatibility
precision highp float;
precision mediump int;
in vec3 vN;
uniform lowp float uGain;
void main() {
    highp vec3 n = normalize(vN);
    gl_FragColor = vec4(abs(n) * uGain, 1.);
}
