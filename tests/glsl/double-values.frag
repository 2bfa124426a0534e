#version 400 compatibility
in vec2 vST;
uniform float uScale;
void main() {
    double x = double(vST.s) * 2.0lf, y = vST.t;
    dvec2 z = dvec2(x, y);
    for (int i = 0; i < 4; i++) z = dvec2(z.x * z.x - z.y * z.y, 2. * z.x * z.y) + dvec2(.1, .2);
    gl_FragColor = vec4(float(clamp(length(z) * uScale, 0., 1.)), float(x) / 2., float(y), 1.);
}
