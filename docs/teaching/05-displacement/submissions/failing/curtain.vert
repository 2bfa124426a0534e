#version 330 compatibility
uniform float uDepth, uPleats;
out vec3 vNormal, vPosition;

void main()
{
    vec4 v = gl_Vertex;
    v.z = uDepth * ( 1. - v.y ) / 2. * sin( 3.14159265 * uPleats * v.x );
    vNormal = gl_NormalMatrix * gl_Normal;
    vPosition = ( gl_ModelViewMatrix * v ).xyz;
    gl_Position = gl_ModelViewProjectionMatrix * v;
}
