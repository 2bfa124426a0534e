#version 330

uniform mat4 PVM;
uniform mat4 M;

in vec4 position;

out vec3 vPosition;

void main()
{
    vPosition = vec3( M * position );
    gl_Position = PVM * position;
}
