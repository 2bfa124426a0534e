// Compiling, linking and asking programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

struct Compiled {
    Shader shader;  // empty when it failed
    std::string log;
};
// `stage` is GL_VERTEX_SHADER and so on.
Compiled compile(GLenum stage, std::string_view text);

struct AttributeLocation {
    std::string_view name;
    GLuint location;
};
struct Linked {
    Program program;  // empty when it failed
    std::string log;
};
Linked link(const std::vector<const Shader*>& shaders, const std::vector<AttributeLocation>& attributes);

struct Uniform {
    std::string name;  // without "[0]"
    GLenum type = 0;   // GL_FLOAT_VEC3 …
    GLint size = 1;    // of the array
    GLint location = -1;
};
// Active default-block uniforms. With program interface queries those that no stage references are left out:
// an initialised uniform looks active when it is not used.
std::vector<Uniform> active_uniforms(GLuint program, bool interface_query);

std::vector<std::string> active_attributes(GLuint program);

// The name GLSL has for the type: "vec3", "sampler2D"; empty: not one that a scene can set.
std::string_view type_name(GLenum type);

}  // namespace snell::gl
