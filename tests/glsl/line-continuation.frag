#version 330 compatibility
#define WAVE(x) \
    (.5 + .5 * \
     sin(x))
in vec2 vST;
void main() { gl_FragColor = vec4(WAVE(20. * vST.s), \
    WAVE(30. * vST.t), 0., 1.); }
