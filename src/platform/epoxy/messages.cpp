#include <epoxy/gl.h>

#include "src/gl/debug.h"
#include "src/gl/driver.h"

namespace snell::gl {

namespace {

bool bad(GLenum type, GLenum severity) {
    return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
           severity == GL_DEBUG_SEVERITY_HIGH;
}

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                           const void* report) {
    if (bad(type, severity)) (*static_cast<const MessageReport*>(report))(message);
}

}  // namespace

void watch_messages(const MessageReport& report) {
    const bool available = is_desktop() ? version() >= 43 || has_extension("GL_KHR_debug") : version() >= 32;
    if (!available) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, &report);
}

}  // namespace snell::gl
