#version 330 compatibility
#define QUALITY 2
#if defined(GL_ES)
precision mediump float;
#elif QUALITY >= 2 && !defined NOTHING
#define SCALE 4.
#else
#error never here
#endif
#ifndef SCALE
this would not compile
#endif
#undef QUALITY
#ifdef QUALITY
nor would this
#endif
in vec2 vST;
void main() { gl_FragColor = vec4(fract(vST * SCALE), 0., 1.); }
