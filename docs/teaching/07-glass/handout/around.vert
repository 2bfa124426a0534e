#version 330 compatibility

out vec3 vDirection;

void main()
{
    vDirection = gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
