#version 400 compatibility
layout( triangles ) in;
layout( triangle_strip, max_vertices = 3 ) out;
uniform float uShrink;
out vec3 gNormal;

void main()
{
    vec4 p0 = gl_in[0].gl_Position, p1 = gl_in[1].gl_Position, p2 = gl_in[2].gl_Position;
    vec4 center = vec4( ( p0 + p1 + p2 ).xyz / 3., 1. );
    gNormal = gl_NormalMatrix * normalize( cross( ( p1 - p0 ).xyz, ( p2 - p0 ).xyz ) );
    vec3 n = gNormal;
    gl_Position = gl_ModelViewProjectionMatrix * ( center + uShrink * ( p0 - center ) );
    EmitVertex();
    gNormal = n;
    gl_Position = gl_ModelViewProjectionMatrix * ( center + uShrink * ( p1 - center ) );
    EmitVertex();
    gNormal = n;
    gl_Position = gl_ModelViewProjectionMatrix * ( center + uShrink * ( p2 - center ) );
    EmitVertex();
    EndPrimitive();
}
