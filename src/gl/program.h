// Compiles and links shaders, and lists the active uniforms of a program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

struct Compiled {
    Shader shader;  // empty if compiling failed
    std::string log;
};
// `stage` is GL_VERTEX_SHADER, GL_FRAGMENT_SHADER and so on.
Compiled compile(GLenum stage, std::string_view text);

struct AttributeLocation {
    std::string_view name;
    GLuint location;
};
struct Linked {
    Program program;  // empty if linking failed
    std::string log;
};
// Links shaders with fixed locations of attributes. `written`: the outputs that transform feedback writes, interleaved.
Linked link(const std::vector<const Shader*>& shaders, const std::vector<AttributeLocation>& attributes,
            const std::vector<std::string>& written = {});

// True if the driver gives the code that it makes of programs. Mesa does if it caches shaders.
bool gives_binaries();
// Links the shaders into `program`, in place of what was linked into it, and returns the driver's code; empty if they
// do not link. Needs gives_binaries().
std::string binary_of(const Program& program, const std::vector<const Shader*>& shaders);

struct Uniform {
    std::string name;  // array names are without "[0]"
    GLenum type = 0;   // GL_FLOAT_VEC3 …
    GLint size = 1;    // number of array elements
    GLint location = -1;
};
// Lists the active uniforms outside of blocks. With `interface_query` (the context has program interface queries),
// uniforms that no stage references are left out: some drivers report an initialised uniform as active although no
// stage uses it.
std::vector<Uniform> active_uniforms(GLuint program, bool interface_query);

// Links a fragment shader, without its #version line, to a triangle that covers the viewport; empty if it fails. See
// draw_covering in texture.h.
Program covering_program(bool es, std::string_view fragment);

// The GLSL name of the type, such as "vec3" or "sampler2D"; empty if scenes cannot set this type.
std::string_view type_name(GLenum type);
// All of these names.
std::vector<std::string_view> type_names();

// Sets `count` elements of a uniform of floats, which is of that type (GL_FLOAT to GL_FLOAT_MAT4x3), in the program in
// use. Matrices are column by column.
void set_floats(GLenum type, GLint location, GLsizei count, const float* values);

}  // namespace snell::gl
