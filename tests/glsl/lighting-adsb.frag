#version 330 compatibility
uniform float uKa, uKd, uKs, uShininess;
uniform float uAd, uBd, uTol;
uniform vec4 uColor, uSpecularColor;
in vec2 vST;
in vec3 vN, vL, vE;
void main() {
    vec3 Normal = normalize(vN), Light = normalize(vL), Eye = normalize(vE);
    float Ar = uAd / 2., Br = uBd / 2.;
    int numins = int(vST.s / uAd), numint = int(vST.t / uBd);
    float sc = float(numins) * uAd + Ar, tc = float(numint) * uBd + Br;
    float d = (vST.s - sc) * (vST.s - sc) / (Ar * Ar) + (vST.t - tc) * (vST.t - tc) / (Br * Br);
    float t = smoothstep(1. - uTol, 1. + uTol, d);
    vec3 color = mix(uColor.rgb, vec3(1., .9, .8), t);
    vec3 ambient = uKa * color;
    float dd = max(dot(Normal, Light), 0.), s = 0.;
    if (dot(Normal, Light) > 0.) s = pow(max(dot(Eye, normalize(reflect(-Light, Normal))), 0.), uShininess * 20.);
    gl_FragColor = vec4(ambient + uKd * dd * color + uKs * s * uSpecularColor.rgb, 1.);
}
