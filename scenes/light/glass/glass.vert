#version 330 compatibility

out vec3 vPosition, vNormal, vFromEye;

// The scene does not move the ball, so model coordinates are world coordinates, as the cube map needs. The eye is the
// point that the projection maps to (0,0,z,0). This holds even while the mouse turns the scene.
void main()
{
    vPosition = gl_Vertex.xyz;
    vNormal = gl_Normal;
    vec4 eye = gl_ModelViewProjectionMatrixInverse * vec4( 0., 0., 1., 0. );
    vFromEye = vPosition - eye.xyz / eye.w;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
