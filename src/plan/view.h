// The camera as the user has moved it. A plain value: sliders, the mouse, flags and tests write the same one.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include <glm/glm.hpp>

namespace snell {

// Rotations are kept as angles in degrees rather than as an accumulated matrix, so that rounding errors cannot pile up.
struct Transformation {
    double rotate_x = 0, rotate_y = 0;  // first about X, then about the screen's Y
    double scale = 1;
    double x = 0, y = 0, z = 0;
    double rotate_z = 0;  // applied before the two others; turns textures in their plane
    bool operator==(const Transformation&) const = default;
    std::array<double, 7> numbers() const { return {rotate_x, rotate_y, rotate_z, scale, x, y, z}; }
    glm::dmat4 matrix() const;  // translate · rotate · scale
};

// The projection: the scene's own, or the one the user chose.
enum class Projection : std::uint8_t { scene, perspective, ortho };

struct View {
    Transformation scene;    // multiplied into the projection, so eye coordinates stay as the scene made them
    Transformation eye;      // multiplied into the model-view matrix
    Transformation texture;  // gl_TextureMatrix[0]
    std::map<unsigned, Transformation> objects;  // by index into Scene::draws, see src/plan/objects.h
    Projection projection = Projection::scene;
    std::optional<double> background;  // the window's brightness, 0 to 1; nullopt: as the scene says
    bool axes = false;
    double mouse_x = 0, mouse_y = 0;
    bool operator==(const View&) const = default;
};

}  // namespace snell
