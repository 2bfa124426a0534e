#version 120
void main() {
    gl_FragColor = vec4(float(gl_MaxLights) / 16., float(gl_MaxTextureCoords) / 16., float(gl_MaxClipPlanes) / 16., 1.);
}
