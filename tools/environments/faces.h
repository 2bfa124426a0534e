// From a light field around one point to the six pictures of a cube map.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace snell::environments {

using Colour = glm::dvec3;  // linear light, 1 = white paper in full light

// In OpenGL's order, rows top first, RGB bytes.
struct Face {
    int size = 0;
    std::vector<std::uint8_t> rgb;
    bool operator==(const Face&) const = default;
};
using Faces = std::array<Face, 6>;
inline constexpr std::array<std::string_view, 6> face_names = {"posx", "negx", "posy", "negy", "posz", "negz"};

// What is seen from the origin in a direction (of any length).
using Radiance = std::function<Colour(const glm::dvec3& direction)>;

// `samples` × `samples` rays through each texel, averaged after the tone curve, so that bright edges stay smooth.
Faces render_faces(const Radiance& radiance, int size, int samples);

// 24-bit BI_RGB, bottom row first, rows padded to 4 bytes.
std::string encode_bmp(const Face& face);

}  // namespace snell::environments
