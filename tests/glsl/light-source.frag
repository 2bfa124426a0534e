#version 120
varying vec3 vN, vL;
void main() {
    vec3 n = normalize(vN), l = normalize(vL);
    float d = max(dot(n, l), 0.);
    vec4 c = gl_LightSource[0].ambient * gl_FrontMaterial.ambient + d * gl_LightSource[0].diffuse * gl_FrontMaterial.diffuse;
    vec3 h = normalize(gl_LightSource[0].halfVector.xyz + vec3(0., 0., 1.));
    c += gl_LightSource[0].specular * pow(max(dot(n, h), 0.), 20.) * .5;
    gl_FragColor = vec4(c.rgb, 1.);
}
