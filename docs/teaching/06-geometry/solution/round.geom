#version 400 compatibility

layout( triangles ) in;
layout( triangle_strip, max_vertices = 3 ) out;

uniform float uShrink;      // size of the triangles, 1 is their own

out vec3 gNormal;       // in eye coordinates, the same for the whole triangle

void main()
{
    vec3 a = gl_in[0].gl_Position.xyz, b = gl_in[1].gl_Position.xyz, c = gl_in[2].gl_Position.xyz;
    vec3 normal = gl_NormalMatrix * normalize( cross( b - a, c - a ) );
    vec3 middle = ( a + b + c ) / 3.;
    for( int i = 0; i < 3; i++ )
    {
        gNormal = normal;
        gl_Position = gl_ModelViewProjectionMatrix * vec4( mix( middle, gl_in[i].gl_Position.xyz, uShrink ), 1. );
        EmitVertex();
    }
    EndPrimitive();
}
