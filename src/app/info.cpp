// "snell info": the OpenGL that there is.
#include <fmt/format.h>

#include "src/app/commands.h"
#include "src/app/deadline.h"
#include "src/app/headless.h"
#include "src/gl/caps.h"

namespace snell::app {

int print_info(const InfoOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin("starting OpenGL");
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    const gl::Caps caps = gl::query_caps();
    fmt::print("snell {}\nrenderer   {}\nvendor     {}\nOpenGL     {}\nGLSL used  {}{}\nplatform   EGL {}\n",
               SNELL_VERSION, caps.renderer, caps.vendor, caps.version, caps.glsl, caps.es ? " es" : " core",
               context->platform());
    fmt::print("textures   {} (2D), {} (3D), {} (cube)\nsamples    {}\nline width {}\npoint size {}\n",
               caps.max_texture, caps.max_texture_3d, caps.max_cube, caps.max_samples, caps.max_line_width,
               caps.max_point_size);
    return exit_fine;
}

}  // namespace snell::app
