#version 330 compatibility

out vec2 vST;       // 0,0 at the picture's lower left, 1,1 at its upper right

void main()
{
    vST = gl_MultiTexCoord0.st;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
