// Setting uniforms, and only when their value changed.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "src/plan/values/controls.h"
#include "src/plan/view.h"
#include "src/runtime/resources/program.h"

namespace snell::runtime {

// 0 → 1 in `period` seconds, never 1 itself. Period 0 or less: 0.
double timer_value(double time, double period);

// When frame `frame` (from 0) of an animation is: never a sum of steps.
inline double frame_time(std::uint64_t frame, double frames_per_second) {
    return static_cast<double>(frame) / frames_per_second;
}

// The program must be in use. Both return how many uniforms were uploaded; `all`: those that did not change, too.
int set_system(LinkedProgram& program, const DrawContext& context, bool all = false);
// `places`: the control of each of LinkedProgram::user; none: the uniform keeps its initial value.
int set_user(LinkedProgram& program, const std::vector<Index>& places, const Controls& controls, bool all = false);
int set_face_index(LinkedProgram& program, int face);

}  // namespace snell::runtime
