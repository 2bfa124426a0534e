#version 330 compatibility
void main() {
    float z = (gl_FragCoord.z - gl_DepthRange.near) / gl_DepthRange.diff;
    gl_FragColor = vec4(fract(z * 8.), gl_DepthRange.far, gl_FragCoord.x / 256., 1.);
}
