#version 330

// Everything is in world space, because the cube map is looked up in world space.
uniform mat4 PVM;           // clip from the teapot's own coordinates
uniform mat4 M;             // world from the teapot's own coordinates
uniform mat4 uModelViewerMatrix;    // as M, but relative to the eye

in vec4 position;
in vec4 normal;

out vec3 vNormal, vRightNormal;
out vec3 vFromEye;

void main()
{
    vRightNormal = transpose( inverse( mat3( M ) ) ) * normal.xyz;
#if NORMALS == NORMALS_model
    vNormal = normalize( vec3( M * normal ) );
#else
    vNormal = vRightNormal;
#endif
    vFromEye = vec3( uModelViewerMatrix * position );
    gl_Position = PVM * position;
}
