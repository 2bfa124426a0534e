#ifndef SNELL_RAY_GLSL
#define SNELL_RAY_GLSL
// Rays against shapes that have exact answers. `direction` has unit length; distances are along it and may be
// negative, behind the origin.

// By the point nearest to the centre: the textbook's b² - c is a difference of large numbers, and misses a ball of
// radius 1 at a distance of 1000. False, and zeros: the ray passes by, or an argument is not a number.
bool snellHitSphere(vec3 origin, vec3 direction, vec3 centre, float radius, out float enter, out float leave) {
    vec3 to = centre - origin;
    float middle = dot(to, direction);
    vec3 off = to - middle * direction;
    float h2 = radius * radius - dot(off, off);
    bool hit = h2 >= 0.0 && h2 < 3.0e38 && abs(middle) < 1.0e38;
    float h = sqrt(max(h2, 0.0));
    enter = hit ? middle - h : 0.0;
    leave = hit ? middle + h : 0.0;
    return hit;
}

// The box low..high. A component of direction that is zero decides by the origin alone, on a side counting as inside.
// False, and zeros: the ray passes by, or an argument is not a number.
bool snellHitBox(vec3 origin, vec3 direction, vec3 low, vec3 high, out float enter, out float leave) {
    float near = -3.0e38, far = 3.0e38;
    bool hit = true;
    for (int i = 0; i < 3; ++i) {
        float d = direction[i], a = low[i] - origin[i], b = high[i] - origin[i];
        if (abs(d) > 1.0e-20) {
            near = max(near, min(a / d, b / d));
            far = min(far, max(a / d, b / d));
        } else {
            hit = hit && abs(d) <= 1.0e-20 && a <= 0.0 && b >= 0.0;
        }
    }
    hit = hit && near <= far && near > -3.0e38 && far < 3.0e38;
    enter = hit ? near : 0.0;
    leave = hit ? far : 0.0;
    return hit;
}
#endif
