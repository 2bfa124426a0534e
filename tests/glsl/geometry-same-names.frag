#version 330 compatibility
in vec4 gColor;
in vec3 gBary;
void main() {
    float edge = min(gBary.x, min(gBary.y, gBary.z));
    gl_FragColor = vec4(mix(vec3(1.), gColor.rgb, smoothstep(0., .2, edge)) * (.5 + .5 * float(gl_PrimitiveID % 2)), 1.);
}
