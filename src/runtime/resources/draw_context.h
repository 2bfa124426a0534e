#pragma once

#include <glm/glm.hpp>

#include <array>

#include "src/content/cube/convolve.h"

namespace snell::runtime {

// All that the system's uniforms are made from, in double; what a program does not read is never computed.
struct DrawContext {
    glm::dmat4 projection{1};  // clip from eye, the scene transformation included
    glm::dmat4 scene{1};       // the scene transformation, in eye space
    glm::dmat4 view{1};        // eye from world, the eye transformation included
    glm::dmat4 model{1};       // world from model
    glm::dmat4 texture{1};
    double time = 0, timer_period = 10;
    double width = 1, height = 1, mouse_x = 0, mouse_y = 0;
    double point_size = 1, line_width = 1;
    double fixed_point_size = 0;   // instead of what the shader writes; 0: the shader's
    std::array<float, 3> place{};  // of the part of the picture that is drawn: as glsl::System::place
    int face_index = 0;
    const content::Harmonics* harmonics = nullptr;  // of the cube map that the draw's last Irradiance names

    bool operator==(const DrawContext&) const = default;
};

}  // namespace snell::runtime
