uniform vec4 uColor;
varying vec3 N;
void main() {
    float d = abs(dot(normalize(N), vec3(0., 0., 1.)));
    gl_FragColor = vec4(d * uColor.rgb, 1.);
}
