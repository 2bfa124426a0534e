#include "src/gl/driver.h"

#include <epoxy/gl.h>

namespace snell::gl {

bool is_desktop() { return epoxy_is_desktop_gl(); }
int version() { return epoxy_gl_version(); }
bool has_extension(const char* name) { return epoxy_has_gl_extension(name); }

}  // namespace snell::gl
