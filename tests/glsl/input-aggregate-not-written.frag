#version 150 compatibility
// Structures, arrays and blocks that no stage before gives read as zero, also where main stands above them.
in vec3 vN;
struct Deep {
    vec2 a[3];
    ivec2 k;
    mat2 m;
};
flat in Deep deep;
in Shade {
    smooth vec3 tint;
    vec4 row[2];
} shade;
in Loose { noperspective in vec4 loose; };
in vec3 list[2];
vec3 late();
void main() {
    vec3 sum = vec3(deep.a[2], deep.m[1][0]) + float(deep.k.y) + shade.tint + shade.row[1].xyz + loose.xyz + list[1];
    gl_FragColor = vec4(abs(vN) + sum + late(), 1.);
}
in vec3 below;
vec3 late() { return below; }
