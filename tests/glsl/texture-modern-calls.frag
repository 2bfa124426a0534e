#version 330 compatibility
uniform sampler2D uTexUnit;
uniform sampler3D uVolume;
uniform samplerCube uSky;
in vec2 vST;
in vec3 vMC, vN;
void main() {
    vec4 a = texture(uTexUnit, vST), b = texture(uVolume, vMC), c = texture(uSky, vN), d = textureLod(uTexUnit, vST, 1.);
    gl_FragColor = vec4(a.r + d.g * .1, b.g, c.b, 1.);
}
