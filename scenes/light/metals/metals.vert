#version 330

uniform mat4 PVM;
uniform mat4 M;
uniform mat4 uModelViewerMatrix;

in vec4 position;
in vec4 normal;
in vec4 aColor;     // red: the number of the metal

out vec3 vPosition, vNormal, vFromEye;
flat out int vMetal;

void main()
{
    vPosition = vec3( M * position );
    vNormal = vec3( M * normal );
    vFromEye = vec3( uModelViewerMatrix * position );
    vMetal = int( aColor.r + .5 );
    gl_Position = PVM * position;
}
