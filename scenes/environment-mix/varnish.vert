// No #version line: GLSL as it was in 2004. The reflection is worked out in world coordinates, because the cube map is
// a picture of the world; in eye coordinates it would stick to the camera.

uniform mat4 M;             // world from the object's own coordinates
uniform vec3 camWorldPos;   // the eye, in the world
uniform float uLightX, uLightY, uLightZ;

varying vec3 vReflected;
varying float vLit;

void main()
{
    vec3 position = vec3( M * gl_Vertex );
    vec3 normal = normalize( mat3( M ) * gl_Normal );

    vReflected = reflect( normalize( position - camWorldPos ), normal );

    vec3 toLight = normalize( vec3( uLightX, uLightY, uLightZ ) - position );
    vLit = max( dot( toLight, normal ), 0. );

    gl_Position = ftransform();
}
