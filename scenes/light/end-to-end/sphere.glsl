// The ball as a sphere, traced. Expects ORDERS (exits besides the mirrored one) and GRID (GRID x GRID rays a pixel).
#include "room.glsl"
#include <snell/ray.glsl>
#include <snell/refraction.glsl>
uniform samplerCube uRoom;
in vec4 vNear, vFar;

const float GLASS = 1.5;

vec3 look(vec3 P, vec3 d) {
#ifdef THROUGH_MAP
    return mapBox(uRoom, P, d);
#else
    return roomAlong(P, d);
#endif
}

// The light along one ray.
vec3 ray(vec3 eye, vec3 d) {
    float enter, leave;
    if (!snellHitSphere(eye, d, vec3(0.), 1., enter, leave)) return look(eye, d);
    vec3 P = eye + enter * d;
    SnellSphere s = snellSphereBegin(d, P, 1., GLASS);
    vec3 color = s.energy * look(s.normal, s.direction);
    for (int order = 0; order < ORDERS; ++order) {
        if (!snellSphereNext(s)) break;
        color += s.energy * look(s.normal, s.direction);
    }
    return color;
}

void main() {
    vec4 nearX = dFdx(vNear), nearY = dFdy(vNear), farX = dFdx(vFar), farY = dFdy(vFar);
    // A pixel belongs to the ball if its centre does, as for triangles; the walls are drawn already.
    vec3 from = vNear.xyz / vNear.w;
    float enter, leave;
    if (!snellHitSphere(from, normalize(vFar.xyz / vFar.w - from), vec3(0.), 1., enter, leave)) discard;
    vec3 sum = vec3(0.);
    for (int i = 0; i < GRID; ++i)
        for (int j = 0; j < GRID; ++j) {
            vec2 at = (vec2(i, j) + .5) / float(GRID) - .5;
            vec4 a = vNear + at.x * nearX + at.y * nearY, b = vFar + at.x * farX + at.y * farY;
            vec3 eye = a.xyz / a.w;
            sum += ray(eye, normalize(b.xyz / b.w - eye));
        }
    gl_FragColor = vec4(sum / float(GRID * GRID), 1.);
}
