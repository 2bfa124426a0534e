#version 120
varying vec3 vN;
void main() {
    float inside = -vN.z > gl_LightSource[0].spotCosCutoff ? .75 : .25;
    gl_FragColor = vec4(inside, abs(vN.xy), 1.);
}
