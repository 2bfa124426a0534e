#version 120
void main() {
    float f = clamp((gl_Fog.end - gl_FogFragCoord) * gl_Fog.scale, 0., 1.);
    float g = exp(-gl_Fog.density * gl_FogFragCoord) + gl_Fog.start;
    gl_FragColor = vec4(mix(gl_Fog.color.rgb, gl_Color.rgb, f * g), 1.);
}
