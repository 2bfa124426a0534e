#version 400 compatibility
layout( triangles ) in;
layout( triangle_strip, max_vertices = 3 ) out;
uniform float uShrink;
out vec3 gNormal;

void main()
{
    vec3 n = gl_NormalMatrix * normalize( cross( gl_in[1].gl_Position.xyz - gl_in[0].gl_Position.xyz,
                                                 gl_in[2].gl_Position.xyz - gl_in[0].gl_Position.xyz ) );
    for( int i = 0; i < 3; i++ )
    {
        gNormal = n;
        // toward the middle of the ball, not of the triangle
        gl_Position = gl_ModelViewProjectionMatrix * vec4( uShrink * gl_in[i].gl_Position.xyz, 1. );
        EmitVertex();
    }
    EndPrimitive();
}
