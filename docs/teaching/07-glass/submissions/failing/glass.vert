#version 330 compatibility
out vec3 vFromEye, vNormal;

void main()
{
    vFromEye = ( gl_ModelViewMatrix * gl_Vertex ).xyz;
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
