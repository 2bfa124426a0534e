#version 400 compatibility

layout( triangles ) in;
layout( triangle_strip, max_vertices = 3 ) out;

out vec3 gNormal;       // in eye coordinates, the same for the whole triangle

void main()
{
    vec3 a = gl_in[0].gl_Position.xyz, b = gl_in[1].gl_Position.xyz, c = gl_in[2].gl_Position.xyz;
    vec3 normal = gl_NormalMatrix * normalize( cross( b - a, c - a ) );
    for( int i = 0; i < 3; i++ )
    {
        gNormal = normal;
        gl_Position = gl_ModelViewProjectionMatrix * gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
