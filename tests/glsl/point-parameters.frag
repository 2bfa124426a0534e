#version 120
void main() {
    gl_FragColor = vec4(gl_Point.size * .5, gl_Point.distanceConstantAttenuation * .25, gl_Point.fadeThresholdSize * .75, 1.);
}
