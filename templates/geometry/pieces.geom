#version 330 compatibility

layout( triangles ) in;
layout( triangle_strip, max_vertices = 12 ) out;        // at most four triangles

uniform float uShrink, uExplode;
uniform bool uSplit;

out vec3 gNormal;       // in eye coordinates

void emitTriangle( vec3 a, vec3 b, vec3 c )
{
    // A normal that is the same for the whole triangle: at right angles to two of its sides. A ball's sides are
    // counter-clockwise seen from outside. At the poles some triangles have no area, and so no normal.
    vec3 across = cross( b - a, c - a );
    if( dot( across, across ) < 1.e-12 )
        return;
    vec3 normal = normalize( across );

    vec3 middle = ( a + b + c ) / 3.;
    vec3 corners[3] = vec3[3]( a, b, c );
    for( int i = 0; i < 3; i++ )
    {
        vec3 corner = mix( middle, corners[i], uShrink ) + uExplode * normal;
        gNormal = gl_NormalMatrix * normal;
        gl_Position = gl_ModelViewProjectionMatrix * vec4( corner, 1. );
        EmitVertex();
    }
    EndPrimitive();
}

void main()
{
    vec3 a = gl_in[0].gl_Position.xyz, b = gl_in[1].gl_Position.xyz, c = gl_in[2].gl_Position.xyz;
    if( !uSplit )
    {
        emitTriangle( a, b, c );
        return;
    }

    // The middles of the sides, out on the ball.
    vec3 ab = normalize( a + b ), bc = normalize( b + c ), ca = normalize( c + a );
    emitTriangle( a, ab, ca );
    emitTriangle( ab, b, bc );
    emitTriangle( ca, bc, c );
    emitTriangle( ab, bc, ca );
}
