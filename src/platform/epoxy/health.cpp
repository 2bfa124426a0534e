#include "src/gl/health.h"

#include <epoxy/gl.h>

#include "src/gl/driver.h"

namespace snell::gl {

namespace {

// GL 4.5, ES 3.2 and KHR_robustness share the name glGetGraphicsResetStatus.
bool can_ask() { return version() >= (is_desktop() ? 45 : 32) || has_extension("GL_KHR_robustness"); }

}  // namespace

bool lost() { return can_ask() && glGetGraphicsResetStatus() != GL_NO_ERROR; }

}  // namespace snell::gl
