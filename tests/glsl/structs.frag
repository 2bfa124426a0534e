#version 120
varying vec3 vN;
struct Material { vec3 diffuse, specular; float shine; };
struct Surface { Material material; vec3 normal; } surface;
Material plastic(vec3 c) { return Material(c, vec3(1.), 20.); }
void main() {
    surface.material = plastic(vec3(.8, .2, .1));
    surface.normal = normalize(vN);
    float d = abs(surface.normal.z);
    gl_FragColor = vec4(surface.material.diffuse * d + surface.material.specular * pow(d, surface.material.shine), 1.);
}
