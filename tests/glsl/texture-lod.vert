#version 120
uniform sampler2D uHeight;
varying vec4 vColor;
void main() {
    vec4 h = texture2DLod(uHeight, gl_MultiTexCoord0.st, 0.);
    vColor = vec4(h.rgb, 1.);
    gl_Position = gl_ModelViewProjectionMatrix * vec4(gl_Vertex.xyz + .2 * h.r * gl_Normal, 1.);
}
