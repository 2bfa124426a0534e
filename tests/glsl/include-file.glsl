// included by include-file.frag
uniform vec3 uLight;
vec3 lit(vec3 n) { return uLight * (.2 + .8 * abs(n.z)); }
