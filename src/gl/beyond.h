// Calls that OpenGL ES 3.0 lacks, for contexts that have more, as Caps and driver.h tell. In a browser, where none has,
// they throw.
#pragma once

#include <cstdint>
#include <span>

#include "src/gl/api.h"

namespace snell::gl::beyond {

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
