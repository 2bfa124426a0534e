#version 330

// For rotations, translations and uniform scales. Everything is in world space, because the cube map is.
uniform mat4 PVM;
uniform mat4 M;
uniform mat4 uModelViewerMatrix;    // as M, but relative to the eye

in vec4 position;
in vec4 normal;

out vec3 vPosition;
out vec3 vNormal;
out vec3 vFromEye;

void main()
{
    vPosition = vec3( M * position );
    vNormal = vec3( M * normal );
    vFromEye = vec3( uModelViewerMatrix * position );
    gl_Position = PVM * position;
}
