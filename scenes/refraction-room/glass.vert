#version 330 compatibility

// Everything is in model coordinates. The scene does not move the ball, so they are also the room's coordinates, in
// which a cube map of the room must be looked up. Eye coordinates would be wrong.
out vec3 vPosition;
out vec3 vNormal;
out vec3 vEye;

void main()
{
    vPosition = gl_Vertex.xyz;
    vNormal = gl_Normal;

    // The eye is the point that the projection maps to (0,0,z,0). This holds even while the mouse turns the scene,
    // because that rotation is part of the projection.
    vec4 eye = gl_ModelViewProjectionMatrixInverse * vec4( 0., 0., 1., 0. );
    vEye = eye.xyz / eye.w;

    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
