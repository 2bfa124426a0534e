#version 330 compatibility

out vec3 vPosition, vNormal;        // in model coordinates, which are the world's here

void main()
{
    vPosition = gl_Vertex.xyz;
    vNormal = gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
