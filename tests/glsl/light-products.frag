#version 120
varying vec3 vN;
void main() {
    float d = abs(normalize(vN).z);
    vec4 c = gl_FrontLightModelProduct.sceneColor + gl_FrontLightProduct[0].ambient + d * gl_FrontLightProduct[0].diffuse +
             gl_BackLightProduct[0].specular + gl_BackLightModelProduct.sceneColor;
    gl_FragColor = vec4(c.rgb, 1.);
}
