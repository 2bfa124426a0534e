#version 330 compatibility

uniform float uDepth, uPleats;

out vec3 vNormal, vPosition;        // in eye coordinates

void main()
{
    // Pleats deepen downward: z = uDepth * down * sin( k x ), where down is 0 at the upper edge and 1 at the lower one.
    float k = 3.14159265 * uPleats;
    float down = .5 * ( 1. - gl_Vertex.y );
    vec4 p = gl_Vertex;
    p.z += uDepth * down * sin( k * p.x );

    float dzdx = uDepth * down * k * cos( k * p.x );
    float dzdy = -.5 * uDepth * sin( k * p.x );
    vNormal = gl_NormalMatrix * vec3( -dzdx, -dzdy, 1. );
    vPosition = ( gl_ModelViewMatrix * p ).xyz;
    gl_Position = gl_ModelViewProjectionMatrix * p;
}
