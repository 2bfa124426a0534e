#include <array>
#include <cstring>

#include <epoxy/gl.h>

#include "src/gl/context.h"
#include "src/gl/driver.h"

namespace snell::gl {

bool is_desktop() { return epoxy_is_desktop_gl(); }
int version() { return epoxy_gl_version(); }
bool has_extension(const char* name) { return epoxy_has_gl_extension(name); }

void read_buffer(GLenum target, std::size_t bytes, void* into) {
    const void* data = glMapBufferRange(target, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
    if (!data) return;
    std::memcpy(into, data, bytes);
    glUnmapBuffer(target);
}

}  // namespace snell::gl

namespace snell::gl::beyond {

void polygon_mode(GLenum mode) { glPolygonMode(GL_FRONT_AND_BACK, mode); }
void point_size(GLfloat size) { glPointSize(size); }
void patch_vertices(GLint count) { glPatchParameteri(GL_PATCH_VERTICES, count); }

void image_1d(GLint internal, GLsizei width, GLenum format, GLenum type, const void* texels) {
    glTexImage1D(GL_TEXTURE_1D, 0, internal, width, 0, format, type, texels);
}

void image_of_samples(GLenum target, GLenum internal) {
    const bool layers = target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY, desktop = is_desktop();
    if (desktop && layers) glTexImage3DMultisample(target, 1, internal, 1, 1, 1, GL_TRUE);
    if (desktop && !layers) glTexImage2DMultisample(target, 1, internal, 1, 1, GL_TRUE);
    if (!desktop && layers) glTexStorage3DMultisample(target, 1, internal, 1, 1, 1, GL_TRUE);
    if (!desktop && !layers) glTexStorage2DMultisample(target, 1, internal, 1, 1, GL_TRUE);
}

void buffer_texels(GLenum internal, GLuint buffer) { glTexBuffer(GL_TEXTURE_BUFFER, internal, buffer); }

void uniform(GLint location, int components, GLsizei count, const double* values) {
    const std::array by_components{glUniform1dv, glUniform2dv, glUniform3dv, glUniform4dv};
    by_components[static_cast<std::size_t>(components - 1)](location, count, values);
}

void properties_of(GLuint program, GLuint uniform, std::span<const GLenum> properties, std::span<GLint> values) {
    const auto count = static_cast<GLsizei>(properties.size());
    glGetProgramResourceiv(program, GL_UNIFORM, uniform, count, properties.data(), count, nullptr, values.data());
}

void mark_time(GLuint query) { glQueryCounter(query, GL_TIMESTAMP); }

std::uint64_t nanoseconds(GLuint query) {
    GLuint64 result = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &result);
    return result;
}

}  // namespace snell::gl::beyond

namespace snell::gl {

namespace {

// GL 4.5, ES 3.2 and KHR_robustness share the name glGetGraphicsResetStatus.
bool can_ask() { return version() >= (is_desktop() ? 45 : 32) || has_extension("GL_KHR_robustness"); }

bool bad(GLenum type, GLenum severity) {
    return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
           severity == GL_DEBUG_SEVERITY_HIGH;
}

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                           const void* report) {
    if (bad(type, severity)) (*static_cast<const MessageReport*>(report))(message);
}

}  // namespace

bool lost() { return can_ask() && glGetGraphicsResetStatus() != GL_NO_ERROR; }

void watch_messages(const MessageReport& report) {
    const bool available = is_desktop() ? version() >= 43 || has_extension("GL_KHR_debug") : version() >= 32;
    if (!available) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, &report);
}

}  // namespace snell::gl
