#version 330 compatibility
in vec2 vST;
void main() {
    uint h = uint(vST.s * 255.) * 2654435761u;
    h ^= h >> 16;
    int i = int(h & 0xFFu), o = 017, n = -i % 7;
    ivec2 p = ivec2(vST * 10.);
    gl_FragColor = vec4(float(h & 255u) / 255., float(p.x * p.y + o) / 115., float(n + 7) / 14., 1.);
}
