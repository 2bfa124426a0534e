#version 330 compatibility

out vec3 vPosition;     // in model coordinates
out vec3 vNormal;       // in eye coordinates

void main()
{
    vPosition = gl_Vertex.xyz;
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
