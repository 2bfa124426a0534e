#ifndef SNELL_MESH_GLSL
#define SNELL_MESH_GLSL
#include <snell/refraction.glsl>
// Rays through the mesh that is being drawn: the reference for glass of any shape. snell binds these textures by
// itself, to the triangles of each draw's own mesh, where a program reads them. All positions and directions are
// those of the model, before any transformation: directions of light keep their angles under rotations, moves and
// even scales, and so does what is found here. A vertex shader that moves vertices does not move these triangles.

// Lists of texels, which fill one row of a texture after the other.
uniform sampler2D snellMeshNodes, snellMeshTriangles, snellMeshNormals;

// Which side of a triangle a ray may meet. Outside is where corners are counter-clockwise.
const int SNELL_FRONT = 1, SNELL_BACK = -1, SNELL_BOTH = 0;
const int SNELL_MESH_DEPTH = 32;  // of the tree, at most
const int SNELL_MESH_ROW = 10;    // a row has 2 to the power of this many texels
const int SNELL_MESH_ROOT = 1;    // the number of the first node: the tree's frame has the place of node 0

struct SnellMeshHit {
    float distance;  // along the ray
    int triangle;    // by its place in snellMeshTriangles
    vec3 weights;    // of its corners, from 0 to 1; sum 1
    bool front;      // met from outside
};

// Where the texel of a list lies.
ivec2 snellMeshAt(int texel) { return ivec2(texel & ((1 << SNELL_MESH_ROW) - 1), texel >> SNELL_MESH_ROW); }

// The tree has coordinates of its own, in which the mesh lies around the origin and has a size near 1: roundings are
// then a share of the mesh's size, wherever in the model it lies. xyz: the tree's origin in the model, w: the scale, a
// power of two.
vec4 snellMeshFrame() { return texelFetch(snellMeshNodes, ivec2(0), 0); }

vec3 snellMeshFromModel(vec3 position) {
    vec4 frame = snellMeshFrame();
    return (position - frame.xyz) * frame.w;
}

vec3 snellMeshToModel(vec3 position) {
    vec4 frame = snellMeshFrame();
    return frame.xyz + position / frame.w;
}

// In the tree's coordinates.
vec3 snellMeshCorner(int triangle, int corner) {
    return texelFetch(snellMeshTriangles, snellMeshAt(3 * triangle + corner), 0).xyz;
}

// In the model's coordinates. By the corners rather than along the ray, so that the error is independent of the
// distance that the ray came: at most 5 EPSILON of the mesh's size, and the rounding of the result.
vec3 snellMeshPoint(int triangle, vec3 weights) {
    return snellMeshToModel(weights.x * snellMeshCorner(triangle, 0) + weights.y * snellMeshCorner(triangle, 1) +
                            weights.z * snellMeshCorner(triangle, 2));
}

// Outward, unit length; zero for a triangle without area.
vec3 snellMeshFaceNormal(int triangle) {
    vec3 a = snellMeshCorner(triangle, 0);
    vec3 b = snellNormalize(snellMeshCorner(triangle, 1) - a, vec3(0.0));
    vec3 c = snellNormalize(snellMeshCorner(triangle, 2) - a, vec3(0.0));
    return snellNormalize(cross(b, c), vec3(0.0));
}

vec3 snellMeshVertexNormal(int triangle, int corner) {
    int vertex = int(texelFetch(snellMeshTriangles, snellMeshAt(3 * triangle + corner), 0).w);
    return (vertex >= 0) ? texelFetch(snellMeshNormals, snellMeshAt(vertex), 0).xyz : vec3(0.0);
}

// The mesh's normals, interpolated; unit length. A mesh without them: the triangle's.
vec3 snellMeshNormal(int triangle, vec3 weights) {
    vec3 n = weights.x * snellMeshVertexNormal(triangle, 0) + weights.y * snellMeshVertexNormal(triangle, 1) +
             weights.z * snellMeshVertexNormal(triangle, 2);
    return snellNormalize(n, snellMeshFaceNormal(triangle));
}

// Opposite corners of the mesh's box, in the tree's coordinates.
vec3 snellMeshLow() { return texelFetch(snellMeshNodes, ivec2(2 * SNELL_MESH_ROOT, 0), 0).xyz; }
vec3 snellMeshHigh() { return texelFetch(snellMeshNodes, ivec2(2 * SNELL_MESH_ROOT + 1, 0), 0).xyz; }

// The largest error of a point of the mesh, in the tree's coordinates: 5 EPSILON of the largest one by its corners;
// and seen from a ray's origin, 8 of their distance by the shear.
float snellMeshSlack(vec3 origin) {
    vec3 size = max(abs(snellMeshLow()), abs(snellMeshHigh())) + abs(origin);
    return 16.0 * SNELL_EPSILON * max(max(size.x, size.y), size.z);
}

// In the tree's coordinates, and away from the triangle's edges by the slack: otherwise it may lie beyond the neighbours of all of
// them at once, and a ray inside would find no way out.
vec3 snellMeshInnerPoint(int triangle, vec3 weights) {
    vec3 a = snellMeshCorner(triangle, 0), b = snellMeshCorner(triangle, 1), c = snellMeshCorner(triangle, 2);
    vec3 sides = vec3(length(c - b), length(a - c), length(b - a));
    float area2 = length(cross(b - a, c - a));
    vec3 least = (area2 > 0.0) ? min(snellMeshSlack(vec3(0.0)) * sides / area2, vec3(0.25)) : vec3(0.25);
    vec3 w = max(weights, least);
    w /= w.x + w.y + w.z;
    return w.x * a + w.y * b + w.z * c;
}

// The axis of the greatest component of a direction comes last; its handedness stays.
vec3 snellMeshTurn(vec3 v, int axis) { return (axis == 0) ? v.yzx : (axis == 1) ? v.zxy : v; }

// a x b, and exactly -snellMeshEdge(b, a), also on a GPU that fuses a multiplication with an addition: two triangles
// agree on which side of their common edge a ray passes.
float snellMeshEdge(vec2 a, vec2 b) {
    bool turned = a.x > b.x || (a.x == b.x && a.y > b.y);
    vec2 p = turned ? b : a, q = turned ? a : b;
    float e = p.x * q.y - p.y * q.x;
    return turned ? -e : e;
}

// A ray in the tree's coordinates, made ready.
struct SnellMeshRay {
    vec3 origin, direction;  // unit length
    int axis;
    vec2 shear;
    float along, slack;
};

SnellMeshRay snellMeshRay(vec3 origin, vec3 direction) {
    SnellMeshRay ray;
    ray.origin = origin;
    ray.direction = snellNormalize(direction, vec3(0.0));
    vec3 a = abs(ray.direction);
    ray.axis = (a.x >= a.y && a.x >= a.z) ? 0 : (a.y >= a.z) ? 1 : 2;
    vec3 d = snellMeshTurn(ray.direction, ray.axis);
    ray.along = d.z;
    ray.shear = d.xy / d.z;
    ray.slack = snellMeshSlack(origin);
    return ray;
}

// Watertight (Woop, Benthin and Wald 2013): corners are sheared so that the ray becomes an axis. A triangle that the
// ray's origin lies behind by no more than the slack still counts: a path goes on from the point that it has met,
// which rounding may put beyond the neighbour of its triangle.
void snellMeshTriangle(SnellMeshRay ray, int triangle, int side, inout SnellMeshHit hit) {
    vec3 A = snellMeshCorner(triangle, 0) - ray.origin, B = snellMeshCorner(triangle, 1) - ray.origin;
    vec3 C = snellMeshCorner(triangle, 2) - ray.origin;
    if (ray.axis != 2) {  // neighbouring rays mostly agree on this, and save the turns
        A = snellMeshTurn(A, ray.axis);
        B = snellMeshTurn(B, ray.axis);
        C = snellMeshTurn(C, ray.axis);
    }
    vec2 a = A.xy - ray.shear * A.z, b = B.xy - ray.shear * B.z, c = C.xy - ray.shear * C.z;
    vec3 w = vec3(snellMeshEdge(b, c), snellMeshEdge(c, a), snellMeshEdge(a, b));
    float sum = w.x + w.y + w.z;
    if (sum == 0.0 || (sum > 0.0 ? any(lessThan(w, vec3(0.0))) : any(greaterThan(w, vec3(0.0))))) return;
    bool front = (sum > 0.0) == (ray.along < 0.0);
    if (side != SNELL_BOTH && front != (side == SNELL_FRONT)) return;
    w /= sum;
    float t = (w.x * A.z + w.y * B.z + w.z * C.z) / ray.along;
    bool ahead = t > 0.0;
    if (t <= 0.0) {
        vec3 n = snellNormalize(cross(B - A, C - A), vec3(0.0));
        ahead = t * abs(dot(n, snellMeshTurn(ray.direction, ray.axis))) > -ray.slack;
    }
    if (ahead && t < hit.distance) hit = SnellMeshHit(t, triangle, w, front);
}

// snellMeshHit in the tree's coordinates.
bool snellMeshFind(vec3 origin, vec3 direction, int side, out SnellMeshHit hit) {
    const float far = 3.0e38;
    hit = SnellMeshHit(far, -1, vec3(0.0), true);
    SnellMeshRay ray = snellMeshRay(origin, direction);
    bool usable = ray.along != 0.0 && ray.slack < far;
    vec3 inverse = 1.0 / mix(ray.direction, vec3(1.0e-18), lessThan(abs(ray.direction), vec3(1.0e-18)));
    int waiting[SNELL_MESH_DEPTH];
    int count = 0, node = usable ? SNELL_MESH_ROOT : -1;
    while (node >= 0) {
        // To the next leaf that the ray enters. Triangles are tried outside of this loop, because rays of neighbouring
        // pixels run it together, and the one that has most steps decides what they all cost.
        int first = 0, triangles = 0;
        while (node >= 0 && triangles == 0) {
            // Rows have an even number of texels, so that both are in one.
            ivec2 at = snellMeshAt(2 * node);
            vec4 low = texelFetch(snellMeshNodes, at, 0), high = texelFetch(snellMeshNodes, at + ivec2(1, 0), 0);
            // Boxes are larger by the slack, and their far sides farther by the roundings of a distance.
            vec3 a = (low.xyz - ray.slack - origin) * inverse, b = (high.xyz + ray.slack - origin) * inverse;
            vec3 nearer = min(a, b), farther = max(a, b);
            float enter = max(max(nearer.x, nearer.y), nearer.z);
            float leave = min(min(farther.x, farther.y), farther.z);
            leave += abs(leave) * 4.0 * SNELL_EPSILON + 16.0 * ray.slack;
            int link = int(low.w), kind = int(high.w), next = -1;
            if (enter <= leave && enter <= hit.distance && leave >= 0.0) {
                first = link;
                triangles = max(kind, 0);
                if (kind < 0 && count < SNELL_MESH_DEPTH) {
                    bool up = ray.direction[-kind - 1] >= 0.0;
                    next = up ? node + 1 : link;
                    waiting[count++] = up ? link : node + 1;
                }
            }
            if (next < 0 && count > 0) next = waiting[--count];
            node = next;
        }
        for (int i = 0; i < triangles; ++i) snellMeshTriangle(ray, first + i, side, hit);
    }
    if (hit.triangle < 0) hit.distance = 0.0;
    return hit.triangle >= 0;
}

// The nearest triangle that the ray meets on this side. origin: where the ray begins; direction: of any length.
// False: none, or an argument is not a number. Rays find every edge and corner of a closed mesh; of what they begin
// on, see snellMeshTriangle.
bool snellMeshHit(vec3 origin, vec3 direction, int side, out SnellMeshHit hit) {
    bool found = snellMeshFind(snellMeshFromModel(origin), direction, side, hit);
    hit.distance /= snellMeshFrame().w;
    return found;
}

// All ways of light through the mesh, one after the other. Use:
//     SnellMesh s = snellMeshBegin(eye, direction, n1, n2, false);
//     for (int order = 0; order <= orders && snellMeshNext(s); ++order) color += s.energy * look(s.direction);
// For a ball the exits are those of SnellSphere, in its order: the mirrored one first. In a mesh that is not convex
// light that comes out may meet it again. Then what is mirrored outside is followed first, and of what is inside
// always the strongest ray.
const int SNELL_MESH_RAYS = 6;  // inside at once; when there are more, the weakest is given up

struct SnellMesh {
    vec3 direction;  // unit length, away from the mesh
    vec3 position;   // where the light left it
    vec3 normal;     // outward, there
    float energy;    // share of the light; 0 before the first exit
    float inside;    // share that has not come out
    int order;       // how many exits there were before this one; -1 before the first
    int met;         // how many times light met the mesh
    bool through;    // the light came from inside
    bool closed;     // false: a ray inside found no surface to leave through, and goes on as it was
    float n1, n2;
    bool interpolated;
    vec3 outFrom, outAlong, outNormal, inFrom[SNELL_MESH_RAYS], inAlong[SNELL_MESH_RAYS];  // the tree's coordinates
    float outEnergy, inEnergy[SNELL_MESH_RAYS];
    bool outThrough;
};

// A ray from a point outside the mesh, such as the eye, in the direction of the fragment. n1: index outside, n2:
// inside. interpolated: surfaces are curved by the mesh's normals, else they are as flat as their triangles. A ray
// that meets a triangle from behind first is taken to begin inside. One that meets nothing passes by: one exit, with
// energy 1. An index that is not positive: all is mirrored.
SnellMesh snellMeshBegin(vec3 origin, vec3 direction, float n1, float n2, bool interpolated) {
    SnellMesh s;
    s.direction = snellNormalize(direction, vec3(0.0, 0.0, -1.0));
    s.position = origin;
    s.normal = -s.direction;
    s.energy = 0.0;
    s.inside = 1.0;
    s.order = -1;
    s.met = 0;
    s.through = false;
    s.closed = true;
    s.n1 = n1;
    s.n2 = n2;
    s.interpolated = interpolated;
    // Not from the eye itself: from near the mesh, where floats are dense.
    vec3 low = snellMeshLow(), high = snellMeshHigh();
    vec3 from = snellMeshFromModel(origin), to = 0.5 * low + 0.5 * high - from;
    float skip = dot(to, s.direction) - length(high - low);
    s.outFrom = (skip > 0.0 && skip < 3.0e38) ? from + skip * s.direction : from;
    s.outAlong = s.direction;
    s.outNormal = s.normal;
    s.outEnergy = 1.0;
    s.outThrough = false;
    for (int i = 0; i < SNELL_MESH_RAYS; ++i) {
        s.inFrom[i] = s.inAlong[i] = vec3(0.0);
        s.inEnergy[i] = 0.0;
    }
    return s;
}

// What a surface does to a ray that comes from the side of `facing`, unit length.
struct SnellMeshMeeting {
    vec3 mirrored, refracted;  // unit length
    float reflectance;
};

SnellMeshMeeting snellMeshMeet(vec3 along, vec3 facing, float n1, float n2) {
    SnellMeshMeeting m;
    float c = clamp(-dot(along, facing), 0.0, 1.0), t = snellCosTransmitted(c, n1, n2);
    m.mirrored = snellNormalize(along + 2.0 * c * facing, facing);
    m.refracted = snellNormalize((n1 / n2) * (along + c * facing) - max(t, 0.0) * facing, along);
    m.reflectance = (t < 0.0) ? 1.0 : snellFresnelExact(c, n1, n2);
    return m;
}

void snellMeshKeepInside(inout SnellMesh s, vec3 from, vec3 along, float energy) {
    int weakest = 0;
    for (int i = 1; i < SNELL_MESH_RAYS; ++i)
        if (s.inEnergy[i] < s.inEnergy[weakest]) weakest = i;
    if (energy > s.inEnergy[weakest]) {
        s.inFrom[weakest] = from;
        s.inAlong[weakest] = along;
        s.inEnergy[weakest] = energy;
    }
}

// One ray becomes two: mirrored and refracted. Where an interpolated normal would send one of them to the wrong side
// of the triangle, the triangle's own normal is taken.
void snellMeshSplit(inout SnellMesh s, SnellMeshHit hit, vec3 along, float energy) {
    float outward = hit.front ? 1.0 : -1.0;
    float n1 = hit.front ? s.n1 : s.n2, n2 = hit.front ? s.n2 : s.n1;
    vec3 from = snellMeshInnerPoint(hit.triangle, hit.weights), facing = outward * snellMeshFaceNormal(hit.triangle);
    SnellMeshMeeting m = snellMeshMeet(along, facing, n1, n2);
    s.outNormal = outward * facing;
    if (s.interpolated) {
        vec3 curved = outward * snellMeshNormal(hit.triangle, hit.weights);
        SnellMeshMeeting other = snellMeshMeet(along, curved, n1, n2);
        if (dot(along, curved) < 0.0 && dot(other.mirrored, facing) > 0.0 &&
            (other.reflectance >= 1.0 || dot(other.refracted, facing) < 0.0)) {
            m = other;
            s.outNormal = outward * curved;
        }
    }
    float mirrored = energy * m.reflectance, refracted = energy - mirrored;
    s.outFrom = from;
    s.outAlong = hit.front ? m.mirrored : m.refracted;
    s.outEnergy = hit.front ? mirrored : refracted;
    s.outThrough = !hit.front;
    snellMeshKeepInside(s, from, hit.front ? m.refracted : m.mirrored, hit.front ? refracted : mirrored);
    s.met += 1;
}

// The next exit. False, and s.energy as it was: no ray has SNELL_SERIES_END of the light any more, or light has met
// the mesh as often as it does in the SNELL_ORDERS exits of a ball.
bool snellMeshNext(inout SnellMesh s) {
    for (int segment = 0; segment < 2 * SNELL_ORDERS + 3; ++segment) {
        bool outside = s.outEnergy > 0.0, first = s.met == 0;
        bool ended = s.met > SNELL_ORDERS;
        int strongest = 0;
        for (int i = 1; i < SNELL_MESH_RAYS; ++i)
            if (s.inEnergy[i] > s.inEnergy[strongest]) strongest = i;
        vec3 from = outside ? s.outFrom : s.inFrom[strongest];
        vec3 along = outside ? s.outAlong : s.inAlong[strongest];
        float energy = outside ? s.outEnergy : s.inEnergy[strongest];
        if (outside)
            s.outEnergy = 0.0;
        else if (!ended && energy >= SNELL_SERIES_END)
            s.inEnergy[strongest] = 0.0;
        else
            return false;
        SnellMeshHit hit;
        int side = first ? SNELL_BOTH : outside ? SNELL_FRONT : SNELL_BACK;
        if (snellMeshFind(from, along, side, hit)) {
            if (!ended && energy >= SNELL_SERIES_END) snellMeshSplit(s, hit, along, energy);
            continue;
        }
        s.direction = along;
        s.position = snellMeshToModel(from);
        s.normal = outside ? s.outNormal : along;
        s.energy = energy;
        s.inside = max(s.inside - energy, 0.0);
        s.order += 1;
        s.through = outside ? s.outThrough : true;
        s.closed = outside;
        return true;
    }
    return false;
}
#endif
