// Structures declared where they are used: within another, named or not.
varying vec3 vN;
struct Surface {
    vec3 base;
    struct Gloss {
        float power;
        struct {
            vec3 tint;  // deepest
        } coat;
    } gloss;
};
struct Light {
    struct Lamp { vec3 color; } lamp;
    float distance;
};
void main() {
    Light light = Light(Lamp(vec3(.9, .7, .5)), 2.);
    Gloss gloss;
    gloss.power = 1.;
    gloss.coat.tint = vec3(.1, 0., 0.);
    const struct Local { struct Inner { float x; } inner; } local = Local(Inner(.25));
    gl_FragColor = vec4(light.lamp.color * abs(vN) / light.distance + local.inner.x * gloss.power + gloss.coat.tint, 1.);
}
