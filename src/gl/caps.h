// Capabilities of the current context.
#pragma once

#include <string>

namespace snell::gl {

struct Caps {
    std::string renderer, vendor, version;
    int glsl = 330;  // GLSL version of the translated shaders: 330, 410, 450 …; with `es`: 300 or 320
    bool es = false;
    bool software = false;  // the renderer runs on the CPU, such as llvmpipe
    bool fp64 = false;
    bool geometry = true, tessellation = false;
    bool program_interface_query = false;
    int max_viewport = 0;
    int max_texture = 0, max_texture_3d = 0, max_cube = 0;
    int max_samples = 0, max_draw_buffers = 0;
    float max_line_width = 1, max_point_size = 1;
};

// Queries the context that is current.
Caps query_caps();
// As if it had no more stages than OpenGL ES 3.0.
void leave_stages(Caps& caps);

}  // namespace snell::gl
