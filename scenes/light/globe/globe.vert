#version 330 compatibility

out vec3 vLook;         // direction of the lookup
out vec3 vNormal;       // in eye coordinates, for the light

void main()
{
#if BY == BY_normal
    vLook = gl_Normal;
#else
    vLook = gl_Vertex.xyz;
#endif
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
