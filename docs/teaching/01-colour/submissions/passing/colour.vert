#version 330 compatibility

out vec3 vNormal, vPosition;        // in eye coordinates

void main()
{
    vNormal = gl_NormalMatrix * gl_Normal;
    vPosition = ( gl_ModelViewMatrix * gl_Vertex ).xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
