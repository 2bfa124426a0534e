#version 120
varying vec3 vN, vL;
void main() {
    vec3 ec = vec3(gl_ModelViewMatrix * gl_Vertex);
    vN = gl_NormalMatrix * gl_Normal;
    vL = gl_LightSource[0].position.xyz - ec * gl_LightSource[0].position.w;
    gl_Position = ftransform();
}
