// OpenGL's header, which the platform provides: libepoxy's (src/platform/epoxy), or that of a browser; and what the
// platform's driver is asked: its health, its messages, and calls that OpenGL ES 3.0 lacks.
#pragma once

#include <cstdint>
#include <span>

#include <snell_opengl.h>

namespace snell::gl {

// What the current context is. Each platform has its own answers.

bool is_desktop();  // OpenGL, and not OpenGL ES
int version();      // 45 for 4.5
bool has_extension(const char* name);

// Copies the beginning of the buffer that is bound, once all that writes it is done.
void read_buffer(GLenum target, std::size_t bytes, void* into);

// Detects that the driver has reset the context.

// True if the driver has reset the context, after a shader that did not end or a fault of its own. Everything drawn
// since is undefined, and the context cannot be used any more. Always false if the context does not report resets.
bool lost();

}  // namespace snell::gl

namespace snell::gl::beyond {

// Calls that OpenGL ES 3.0 lacks, for contexts that have more, as Caps and driver.h tell. In a browser, where none has,
// they throw.

void polygon_mode(GLenum mode);  // of both faces
void point_size(GLfloat size);
void patch_vertices(GLint count);

// Fill the texture that is bound.
void image_1d(GLint internal, GLsizei width, GLenum format, GLenum type, const void* texels);
void image_of_samples(GLenum target, GLenum internal);  // one texel of one sample
void buffer_texels(GLenum internal, GLuint buffer);

// Sets `count` vectors of 1 to 4 components in the program in use.
void uniform(GLint location, int components, GLsizei count, const double* values);
// Reads properties of an active uniform.
void properties_of(GLuint program, GLuint uniform, std::span<const GLenum> properties, std::span<GLint> values);

// The time when the GPU has finished all commands issued so far.
void mark_time(GLuint query);
// Waits for the result of a query of time.
std::uint64_t nanoseconds(GLuint query);

}  // namespace snell::gl::beyond
