   #   version   330    compatibility   // with blanks and a comment
/* and more
   comments */ in vec3 vN;
void main() { gl_FragColor = vec4(abs(vN), 1.); }
