#version 330 compatibility

out vec2 vAt;       // -1 to 1 across the square

void main()
{
    vAt = gl_Vertex.xy;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
