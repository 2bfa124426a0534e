#version 430 compatibility
layout(binding = 3) uniform sampler2D uImage;
layout(location = 0) out vec4 fColor;
in vec2 vST;
const float w[] = float[](.25, .5, .25);
void main() {
    vec3 sum = vec3(0.);
    for (int i = 0; i < w.length(); i++) sum += w[i] * texture(uImage, vST + vec2(.02 * float(i - 1), 0.)).rgb;
    fColor = vec4(sum, 1.);
}
