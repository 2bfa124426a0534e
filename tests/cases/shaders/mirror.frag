#version 330 compatibility
uniform samplerCube uRoom;
in vec3 vNormal, vPosition;

void main() {
    vec3 r = reflect(normalize(vPosition), normalize(vNormal));
    gl_FragColor = vec4(texture(uRoom, mat3(gl_ModelViewMatrixInverse) * r).rgb, 1.);
}
