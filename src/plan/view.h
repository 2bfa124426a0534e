// The camera that the user holds. A plain value: sliders, the mouse, flags and tests write the same one.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include <glm/glm.hpp>

namespace snell {

// Rotation is kept as angles (degrees), never as an accumulated matrix: rounding can't pile up.
struct Transformation {
    double rotate_x = 0, rotate_y = 0;  // about X first, then about Y as seen on the screen
    double scale = 1;
    double x = 0, y = 0, z = 0;
    double rotate_z = 0;  // before the two others: textures turn in their plane
    bool operator==(const Transformation&) const = default;
    std::array<double, 7> numbers() const { return {rotate_x, rotate_y, rotate_z, scale, x, y, z}; }
    glm::dmat4 matrix() const;  // translate · rotate · scale
};

// How the scene is projected: as it says itself, or as the user chose.
enum class Projection : std::uint8_t { scene, perspective, ortho };

struct View {
    Transformation scene;    // goes into the projection: eye coordinates stay as the scene made them
    Transformation eye;      // goes into the model-view
    Transformation texture;  // gl_TextureMatrix[0]
    std::map<unsigned, Transformation> objects;  // by index of Scene::draws: see src/plan/objects.h
    Projection projection = Projection::scene;
    std::optional<double> background;  // brightness, 0 to 1, of the window's; none: as the scene says
    bool axes = false;
    double mouse_x = 0, mouse_y = 0;
    bool operator==(const View&) const = default;
};

}  // namespace snell
