#version 330 compatibility

// The geometry shader moves the vertices in model coordinates, and multiplies by the matrix afterwards.
void main()
{
    gl_Position = gl_Vertex;
}
