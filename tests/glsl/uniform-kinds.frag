#version 330 compatibility
uniform bool uFlag;
uniform int uCount;
uniform uint uBits;
uniform vec2 uTwo;
uniform vec4 uFour;
uniform ivec3 uInts;
uniform mat2 uRotate;
uniform float uWeights[4];
struct Light { vec3 color; float power; };
uniform Light uLight;
in vec2 vST;
void main() {
    float sum = 0.;
    for (int i = 0; i < 4; i++) sum += uWeights[i];
    vec2 st = uRotate * vST + uTwo;
    vec3 c = uLight.color * uLight.power + (uFlag ? uFour.rgb : vec3(0.)) * .3;
    gl_FragColor = vec4(c * fract(st.x) + .05 * sum + .02 * float(uInts.y + uCount) + .01 * float(uBits & 3u), 1.);
}
