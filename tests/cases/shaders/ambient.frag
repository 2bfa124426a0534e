#version 330 compatibility
uniform samplerCube uLight;
in vec3 vNormal;

void main() { gl_FragColor = vec4(texture(uLight, mat3(gl_ModelViewMatrixInverse) * vNormal).rgb, 1.); }
