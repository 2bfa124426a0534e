#version 330 compatibility
in vec3 vN;
void main() {
    vec4 f = gl_FrontMaterial.emission + gl_FrontMaterial.ambient + gl_FrontMaterial.specular;
    vec4 b = gl_BackMaterial.diffuse;
    gl_FragColor = vec4(f.r + gl_FrontMaterial.shininess, b.g, abs(vN.z), 1.);
}
