#version 120
varying vec3 vN;
void main() {
    vec4 sum = gl_LightModel.ambient;
    for (int i = 0; i < 3; i++) sum += gl_LightSource[i].diffuse * max(dot(normalize(vN), gl_LightSource[i].position.xyz), 0.);
    gl_FragColor = vec4(sum.rgb, 1.);
}
