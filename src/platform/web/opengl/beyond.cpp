// WebGL 2 has nothing beyond OpenGL ES 3.0.
#include "src/gl/beyond.h"

#include <stdexcept>
#include <string>

namespace snell::gl::beyond {

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
