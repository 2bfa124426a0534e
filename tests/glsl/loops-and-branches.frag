#version 330 compatibility
in vec2 vST;
void main() {
    float sum = 0.;
    int i = 0;
    do { sum += .05; i++; } while (i < 4);
    while (true) {
        if (++i > 9) break;
        if (i == 7) continue;
        sum += .02;
    }
    vec3 c;
    switch (int(vST.s * 4.)) {
        case 0: c = vec3(1., 0., 0.); break;
        case 1: c = vec3(0., 1., 0.);
        case 2: c = vec3(0., sum, 1.); break;
        default: c = vec3(sum);
    }
    for (float t = 0.; t < vST.t; t += .25) c *= .9;
    gl_FragColor = vec4(c, 1.);
}
