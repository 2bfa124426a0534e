#version 330 core
in float gLightIntensity;
uniform vec4 uColor;
out vec4 c;
void main() { c = vec4(gLightIntensity * uColor.rgb, 1.); }
