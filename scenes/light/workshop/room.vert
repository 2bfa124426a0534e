#version 330

uniform mat4 PVM;

in vec4 position;

out vec3 vPosition;

void main()
{
    vPosition = position.xyz;
    gl_Position = PVM * position;
}
