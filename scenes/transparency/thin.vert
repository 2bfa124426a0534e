#version 330

uniform mat4 PVM;
uniform mat4 M;
uniform vec3 camWorldPos;

in vec4 position;
in vec4 normal;

out vec3 vNormal;
out vec3 vFromEye;

// All in world space, where the cube map is.
void main()
{
    vNormal = vec3( M * normal );
    vFromEye = vec3( M * position ) - camWorldPos;
    gl_Position = PVM * position;
}
