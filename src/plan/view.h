// The camera that the user holds. A plain value: sliders, the mouse, flags and tests write the same one.
#pragma once

#include <array>
#include <map>

#include <glm/glm.hpp>

namespace snell {

// Rotation is kept as angles (degrees), never as an accumulated matrix: rounding can't pile up.
struct Transformation {
    double rotate_x = 0, rotate_y = 0;  // about X first, then about Y as seen on the screen
    double scale = 1;
    double x = 0, y = 0, z = 0;
    bool operator==(const Transformation&) const = default;
    glm::dmat4 matrix() const;  // translate · rotate · scale
};

struct View {
    Transformation scene;    // goes into the projection: eye coordinates stay as the scene made them
    Transformation eye;      // goes into the model-view
    Transformation texture;  // gl_TextureMatrix[0]
    std::map<unsigned, Transformation> objects;  // by index of Scene::draws
    bool axes = false;
    double mouse_x = 0, mouse_y = 0;
    bool operator==(const View&) const = default;
};

}  // namespace snell
