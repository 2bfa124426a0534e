#include "src/gl/debug.h"

#include "src/gl/api.h"

namespace snell::gl {

namespace {

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

std::vector<std::string> take_errors() {
    std::vector<std::string> errors;
    // The loop is bounded because a lost context reports the same error for ever.
    for (GLenum error; errors.size() < 16 && (error = glGetError()) != GL_NO_ERROR;)
        errors.emplace_back(error_name(error));
    return errors;
}

}  // namespace snell::gl
