#version 330 compatibility
in vec3 vN; // a line comment with a quote ' and a "
/* a block /* that does not nest */
void main(/* nothing */) {
    float a = /* here too */ .5; // and a backslash at its end \\ x
    gl_FragColor = vec4(abs(vN) * a, /**/ 1.); /***/
}
