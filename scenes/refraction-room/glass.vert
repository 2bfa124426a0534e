#version 330 compatibility

// Everything here is in the ball's own coordinates. The scene does not move the ball, so they are the room's too,
// and that is what a cube map of the room must be asked in: not in eye coordinates.
out vec3 vPosition;
out vec3 vNormal;
out vec3 vEye;

void main()
{
    vPosition = gl_Vertex.xyz;
    vNormal = gl_Normal;

    // The eye is the point that perspective sends to (0,0,z,0). Found so, it is right even while the mouse turns
    // the scene, because that turn is part of the projection.
    vec4 eye = gl_ModelViewProjectionMatrixInverse * vec4( 0., 0., 1., 0. );
    vEye = eye.xyz / eye.w;

    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
