#version 330 compatibility

out vec3 vNormal, vEyeDir;      // the two that the ladder chooses
out vec3 vPosition, vFromEye, vWorldNormal;     // in world coordinates

void main()
{
    // The scene does not move the ball, so model coordinates are world coordinates.
    vPosition = gl_Vertex.xyz;
    vWorldNormal = gl_Normal;
    vec4 eye = gl_ModelViewProjectionMatrixInverse * vec4( 0., 0., 1., 0. );
    vFromEye = vPosition - eye.xyz / eye.w;

#if SPACE == SPACE_eye
    vEyeDir = ( gl_ModelViewMatrix * gl_Vertex ).xyz;
    vNormal = normalize( gl_NormalMatrix * gl_Normal );
#else
    vEyeDir = vFromEye;
    vNormal = vWorldNormal;
#endif
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
