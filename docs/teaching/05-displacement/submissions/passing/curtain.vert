#version 330 compatibility
uniform float uDepth, uPleats;
out vec3 vNormal, vPosition;
const float PI = 3.14159265;

void main()
{
    float x = gl_Vertex.x, y = gl_Vertex.y;
    float angle = PI * uPleats * x;
    float amp = uDepth * ( 1. - y ) / 2.;
    vec3 where = vec3( x, y, gl_Vertex.z + amp * sin( angle ) );
    vec3 tx = vec3( 1., 0., amp * cos( angle ) * PI * uPleats );
    vec3 ty = vec3( 0., 1., -uDepth / 2. * sin( angle ) );
    vNormal = gl_NormalMatrix * normalize( cross( tx, ty ) );
    vPosition = vec3( gl_ModelViewMatrix * vec4( where, 1. ) );
    gl_Position = gl_ModelViewProjectionMatrix * vec4( where, 1. );
}
