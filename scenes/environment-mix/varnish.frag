uniform samplerCube uEnvironment;
uniform vec3 uBaseColor;
uniform float uMixRatio;

varying vec3 vReflected;
varying float vLit;

void main()
{
    vec3 mirrored = textureCube( uEnvironment, vReflected ).rgb;
    vec3 paint = ( .15 + .85 * vLit ) * uBaseColor;
    gl_FragColor = vec4( mix( mirrored, paint, uMixRatio ), 1. );
}
