#version 330

uniform samplerCube uSurroundings;
uniform float uPower;

in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

void main()
{
    // The far side would be drawn too, in whatever order its triangles come: leave it out.
    if( !gl_FrontFacing )
        discard;

    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    vec3 mirrored = texture( uSurroundings, reflect( I, N ) ).rgb;

    // I points at the surface and N away from it, so the cosine between them is -dot. It can come out a little
    // above 1, and pow() of a negative number is undefined: keep it in range.
    float facing = clamp( -dot( I, N ), 0., 1. );
    outColor = vec4( mirrored, pow( 1. - facing, uPower ) );
}
