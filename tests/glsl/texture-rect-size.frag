#version 330 compatibility
uniform sampler2D uTexUnit;
in vec2 vST;
void main() {
    ivec2 size = textureSize(uTexUnit, 0);
    ivec2 texel = ivec2(vST * vec2(size));
    gl_FragColor = vec4(texelFetch(uTexUnit, texel % size, 0).rgb, 1.);
}
