#include "src/gl/health.h"

#include <epoxy/gl.h>

namespace snell::gl {

namespace {

// GL 4.5, ES 3.2 and KHR_robustness share the name glGetGraphicsResetStatus.
bool can_ask() {
    return epoxy_gl_version() >= (epoxy_is_desktop_gl() ? 45 : 32) || epoxy_has_gl_extension("GL_KHR_robustness");
}

}  // namespace

bool lost() { return can_ask() && glGetGraphicsResetStatus() != GL_NO_ERROR; }

}  // namespace snell::gl
