// `snell info`: OpenGL version and renderer.
#include <fmt/format.h>

#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/deadline.h"
#include "src/app/open/exit_status.h"
#include "src/app/open/headless.h"
#include "src/app/open/version.h"
#include "src/gl/caps.h"

namespace snell::app {

namespace {

struct InfoOptions {
    std::string context;
    double timeout = 20;  // in seconds, for the whole command
};

Exit print_info(const InfoOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin("starting OpenGL");
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    const gl::Caps caps = gl::query_caps();
    fmt::print("snell {}\nrenderer   {}\nvendor     {}\nOpenGL     {}\nGLSL used  {}{}\nplatform   EGL {}\n", version(),
               caps.renderer, caps.vendor, caps.version, caps.glsl, caps.es ? " es" : " core", context->platform());
    fmt::print("textures   {} (2D), {} (3D), {} (cube)\nsamples    {}\nline width {}\npoint size {}\n",
               caps.max_texture, caps.max_texture_3d, caps.max_cube, caps.max_samples, caps.max_line_width,
               caps.max_point_size);
    return exit_fine;
}

}  // namespace

Run add_info(CLI::App& command) {
    auto options = std::make_shared<InfoOptions>();
    add_timeout(command, options->timeout, "the driver to answer");
    add_context(command, options->context);
    return [options] { return print_info(*options); };
}

}  // namespace snell::app
