#version 330 compatibility
in vec4 aVertex;
in vec3 aNormal;
in vec4 aColor;
in vec2 aTexCoord0;
uniform mat4 uModelViewMatrix, uProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec4 vColor;
void main() {
    vec3 n = normalize(uNormalMatrix * aNormal);
    vColor = vec4(aColor.rgb * abs(n.z), 1.) + vec4(aTexCoord0 * .2, 0., 0.);
    gl_Position = uProjectionMatrix * uModelViewMatrix * aVertex;
}
