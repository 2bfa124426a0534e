#version 330 compatibility

out vec3 vNormal;       // in eye coordinates, as the lamp

// Runs once for each vertex.
void main()
{
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
