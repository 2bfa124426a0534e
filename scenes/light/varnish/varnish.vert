// Without a #version line, this is GLSL 1.10 of 2004.
uniform mat4 M;             // world from the object's own coordinates
uniform mat4 uModelViewerMatrix;    // as M, but relative to the eye
uniform float uLightX, uLightY, uLightZ;

varying vec3 vIncident, vNormal, vReflected;
varying float vLit;

void main()
{
    vec3 position = vec3( M * gl_Vertex );
    vec3 normal = normalize( mat3( M ) * gl_Normal );

#if SPACE == SPACE_eye
    vIncident = vec3( gl_ModelViewMatrix * gl_Vertex );
    vNormal = normalize( gl_NormalMatrix * gl_Normal );
#else
    vIncident = vec3( uModelViewerMatrix * gl_Vertex );
    vNormal = normal;
#endif
    vReflected = reflect( normalize( vIncident ), vNormal );

    vec3 toLight = normalize( vec3( uLightX, uLightY, uLightZ ) - position );
    vLit = max( dot( toLight, normal ), 0. );

    gl_Position = ftransform();
}
