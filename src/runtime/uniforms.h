// Setting uniforms, and only when their value changed.
#pragma once

#include <glm/glm.hpp>

#include "src/content/convolve.h"
#include "src/plan/controls.h"
#include "src/runtime/program.h"
#include "src/runtime/runtime.h"

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
    int face_index = 0;
    const content::Harmonics* harmonics = nullptr;  // of the cube map that the draw's last Irradiance names
};

// The scene transformation in eye space: about the world's origin, wherever the camera sees it, along the axes
// of the screen.
glm::dmat4 about_origin(const Transformation& transformation, const glm::dmat4& view);

// 0 → 1 in `period` seconds, never 1 itself. Period 0 or less: 0.
double timer_value(double time, double period);

// When frame `frame` (from 0) of an animation is: never a sum of steps.
inline double frame_time(std::uint64_t frame, double frames_per_second) {
    return static_cast<double>(frame) / frames_per_second;
}

// What a uniform of the system holds, column by column; `size` elements of an array.
std::vector<float> system_value(glsl::System system, const DrawContext& context, int size = 1);

// The program must be in use. Both return how many uniforms were uploaded; `all`: those that did not change, too.
int set_system(LinkedProgram& program, const DrawContext& context, bool all = false);
int set_user(LinkedProgram& program, Index index, const Controls& controls, bool all = false);
int set_face_index(LinkedProgram& program, int face);

}  // namespace snell::runtime
