#version 400 compatibility

void main()
{
    gl_Position = gl_Vertex;        // in model coordinates, until the geometry shader has finished
}
