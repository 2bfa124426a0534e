// Answers to questions about the context.
#include <stdexcept>
#include <string>
#include <string_view>

#include <emscripten/html5.h>
#include <webgl/webgl2.h>

#include "src/gl/context.h"
#include "src/gl/driver.h"

#undef glGetUniformfv
#undef glGetUniformiv
#undef glGetString

void snell_get_uniform(GLuint program, GLint location, GLfloat* value) {
    glUseProgram(program);
    glGetUniformfv(program, location, value);
}

void snell_get_uniform(GLuint program, GLint location, GLint* value) {
    glUseProgram(program);
    glGetUniformiv(program, location, value);
}

const GLubyte* snell_get_string(GLenum name) {
    constexpr GLenum unmasked_renderer = 0x9246;
    const GLubyte* plain = glGetString(name);
    if (name != GL_RENDERER || !plain || std::string_view(reinterpret_cast<const char*>(plain)) != "WebKit WebGL")
        return plain;
    const auto context = emscripten_webgl_get_current_context();
    return emscripten_webgl_enable_extension(context, "WEBGL_debug_renderer_info") ? glGetString(unmasked_renderer)
                                                                                   : plain;
}

namespace snell::gl {

bool is_desktop() { return false; }

int version() { return 30; }

bool has_extension(const char* name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* one = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (one && std::string_view(one) == name) return true;
    }
    return false;
}

void read_buffer(GLenum target, std::size_t bytes, void* into) {
    emscripten_glGetBufferSubData(target, 0, static_cast<GLsizeiptr>(bytes), into);
}

bool lost() { return emscripten_is_webgl_context_lost(emscripten_webgl_get_current_context()); }

// WebGL tells the browser's console.
void watch_messages(const MessageReport&) {}

}  // namespace snell::gl

namespace snell::gl::beyond {

// WebGL 2 has nothing beyond OpenGL ES 3.0.

namespace {

[[noreturn]] void lacks(const char* what) { throw std::logic_error(std::string("WebGL 2 has no ") + what); }

}  // namespace

void polygon_mode(GLenum) { lacks("polygon modes"); }
void point_size(GLfloat) { lacks("point sizes outside of shaders"); }
void patch_vertices(GLint) { lacks("tessellation"); }
void image_1d(GLint, GLsizei, GLenum, GLenum, const void*) { lacks("1D textures"); }
void image_of_samples(GLenum, GLenum) { lacks("multisampled textures"); }
void buffer_texels(GLenum, GLuint) { lacks("buffer textures"); }
void uniform(GLint, int, GLsizei, const double*) { lacks("doubles in shaders"); }
void properties_of(GLuint, GLuint, std::span<const GLenum>, std::span<GLint>) { lacks("program interface queries"); }
void mark_time(GLuint) { lacks("timers"); }
std::uint64_t nanoseconds(GLuint) { lacks("timers"); }

}  // namespace snell::gl::beyond
