#version 330 compatibility
in vec3 vN;
void half_of() { gl_FragColor.rgb *= .5; }
void main() {
    gl_FragColor = vec4(abs(vN), 1.);
    if (gl_FragColor.r > .5) gl_FragColor.g = 1.;
    half_of();
}
