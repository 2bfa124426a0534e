#include "src/gl/debug.h"

#include <epoxy/gl.h>

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

const char* error_name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        case GL_CONTEXT_LOST:
            return "GL_CONTEXT_LOST";
        default:
            return "unknown GL error";
    }
}

}  // namespace

void watch_messages(const MessageReport& report) {
    const bool available = epoxy_is_desktop_gl() ? epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug")
                                                 : epoxy_gl_version() >= 32;
    if (!available) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, &report);
}

std::vector<std::string> take_errors() {
    std::vector<std::string> errors;
    // The loop is bounded because a lost context reports the same error for ever.
    for (GLenum error; errors.size() < 16 && (error = glGetError()) != GL_NO_ERROR;)
        errors.emplace_back(error_name(error));
    return errors;
}

}  // namespace snell::gl
