// What scenes/refraction-room calls Walls and Glass, in the core profile's words.
#pragma once

namespace by_hand {

inline constexpr const char* wall_vertex = R"(#version 330 core
uniform mat4 toClip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 st;
out vec2 vST;
void main()
{
    vST = st;
    gl_Position = toClip * vec4(position, 1.);
}
)";

inline constexpr const char* wall_fragment = R"(#version 330 core
uniform sampler2D picture;
in vec2 vST;
out vec4 color;
void main()
{
    color = vec4(texture(picture, vST).rgb, 1.);
}
)";

inline constexpr const char* glass_vertex = R"(#version 330 core
uniform mat4 toClip, fromClip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 vPosition, vNormal, vEye;
void main()
{
    vPosition = position;
    vNormal = normal;
    vec4 eye = fromClip * vec4(0., 0., 1., 0.);
    vEye = eye.xyz / eye.w;
    gl_Position = toClip * vec4(position, 1.);
}
)";

// After one of the two beginnings below.
inline constexpr const char* glass_fragment = R"(
uniform samplerCube room;
in vec3 vPosition, vNormal, vEye;
out vec4 color;

vec3 lookAround(vec3 from, vec3 direction)
{
    vec3 toWalls = (5. - sign(direction) * from) / max(abs(direction), 1.e-20);
    float nearest = min(toWalls.x, min(toWalls.y, toWalls.z));
    return texture(room, nearWalls ? from + nearest * direction : direction).rgb;
}

float fresnel(float c, float n)
{
    float t = sqrt((n - 1.) * (n + 1.) + c * c);
    float across = (c - t) / (c + t), along = (n * n * c - t) / (n * n * c + t);
    return .5 * (across * across + along * along);
}

void main()
{
    vec3 N = normalize(vNormal), I = normalize(vPosition - vEye);
    float c = clamp(-dot(I, N), 1.e-4, 1.);
    vec3 reflected = lookAround(vPosition, reflect(I, N));
    vec3 T = refract(I, N, 1. / refraction), leaves = vPosition;
    if (bothSides) {
        leaves = vPosition - 2. * dot(vPosition, T) * T;
        T = 2. * dot(T, I) * T - I;
    }
    vec3 refracted = mix(lookAround(leaves, T), vec3(1.), milk);
    vec3 glass = mix(refracted, reflected, fresnel(c, refraction));
    color = vec4(mix(mix(glass, reflected, mirror), vec3(1.), milk * .5), 1.);
}
)";

// The scene's sliders.
inline constexpr const char* glass_sliders = R"(#version 330 core
uniform float refraction, mirror, milk;
uniform bool bothSides, nearWalls;
)";

// A ball that nobody can change.
inline constexpr const char* glass_constants = R"(#version 330 core
const float refraction = 1.5, mirror = 0., milk = 0.;
const bool bothSides = true, nearWalls = true;
)";

}  // namespace by_hand
