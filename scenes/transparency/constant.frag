#version 330

uniform samplerCube uSurroundings;
uniform float uOpacity;

in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

void main()
{
    // The far side would be drawn too, in whatever order its triangles come: leave it out.
    if( !gl_FrontFacing )
        discard;

    vec3 mirrored = texture( uSurroundings, reflect( normalize( vFromEye ), normalize( vNormal ) ) ).rgb;

    // Alpha says how much of this covers what has been drawn already.
    outColor = vec4( mirrored, uOpacity );
}
