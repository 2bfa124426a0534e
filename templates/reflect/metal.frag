#version 330 compatibility

uniform samplerCube uSky;
uniform float uMirror;
uniform vec3 uTint, uPaint;

in vec3 vFromEye, vNormal;

const vec3 TO_SUN = vec3( -.503, .624, -.598 );     // where the pictures have the sun, in world coordinates

void main()
{
    // reflect() expects a normal of length 1; interpolation has shortened it.
    vec3 N = normalize( vNormal );
    vec3 mirrored = reflect( normalize( vFromEye ), N );
    vec3 metal = uTint * texture( uSky, mirrored ).rgb;

    float diffuse = max( dot( N, TO_SUN ), 0. );
    vec3 paint = ( .35 + .65 * diffuse ) * uPaint;

    gl_FragColor = vec4( mix( paint, metal, uMirror ), 1. );
}
