// The current context: its capabilities, its errors and messages.
#pragma once

#include <functional>
#include <string>
#include <vector>

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

// Errors and warnings of the OpenGL driver. The tests fail on any of them.

using MessageReport = std::function<void(const char* message)>;
// From now on reports the driver's messages: errors, undefined behaviour, and all messages of high severity. A debug
// context reports the most. `report` must outlive the context. Has no effect if the context has no debug output.
void watch_messages(const MessageReport& report);

// Returns the names of the errors that glGetError reports, and clears them.
std::vector<std::string> take_errors();

}  // namespace snell::gl
