#include "src/gl/debug.h"

#include <epoxy/gl.h>

#include <cstdio>

namespace snell::gl {

namespace {

bool bad(GLenum type, GLenum severity) {
    return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
           severity == GL_DEBUG_SEVERITY_HIGH;
}

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* message,
                           const void* user) {
    if (!bad(type, severity)) return;
    auto* log = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    log->emplace_back(message, length < 0 ? std::char_traits<char>::length(message) : static_cast<size_t>(length));
}

void GLAPIENTRY print_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                              const void*) {
    if (bad(type, severity)) std::fprintf(stderr, "snell: error: OpenGL driver: %s\n", message);
}

void listen(GLDEBUGPROC call, const void* user) {
    const bool here = epoxy_is_desktop_gl() ? epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug")
                                            : epoxy_gl_version() >= 32;
    if (!here) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(call, user);
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

void collect_messages(std::vector<std::string>& log) { listen(on_message, &log); }

void print_messages() { listen(print_message, nullptr); }

std::vector<std::string> take_errors() {
    std::vector<std::string> errors;
    // The loop is bounded because a lost context reports the same error for ever.
    for (GLenum error; errors.size() < 16 && (error = glGetError()) != GL_NO_ERROR;)
        errors.emplace_back(error_name(error));
    return errors;
}

}  // namespace snell::gl
