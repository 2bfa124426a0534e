#include "src/gl/program.h"

#include <array>

namespace snell::gl {

namespace {

template <typename Length, typename Read>
std::string read_log(GLuint object, Length length, Read read) {
    GLint size = 0;
    length(object, GL_INFO_LOG_LENGTH, &size);
    if (size <= 1) return {};
    std::string log(static_cast<size_t>(size), '\0');
    GLsizei written = 0;
    read(object, size, &written, log.data());
    log.resize(static_cast<size_t>(written));
    return log;
}

bool is_referenced(GLuint program, GLuint index) {
    constexpr std::array<GLenum, 5> properties{GL_REFERENCED_BY_VERTEX_SHADER, GL_REFERENCED_BY_FRAGMENT_SHADER,
                                               GL_REFERENCED_BY_GEOMETRY_SHADER, GL_REFERENCED_BY_TESS_CONTROL_SHADER,
                                               GL_REFERENCED_BY_TESS_EVALUATION_SHADER};
    const bool stages = epoxy_is_desktop_gl() ? epoxy_gl_version() >= 40 : epoxy_gl_version() >= 32;
    std::array<GLint, 5> values{};
    glGetProgramResourceiv(program, GL_UNIFORM, index, stages ? 5 : 2, properties.data(), 5, nullptr, values.data());
    for (GLint value : values)
        if (value) return true;
    return false;
}

}  // namespace

Compiled compile(GLenum stage, std::string_view text) {
    Compiled result;
    Shader shader(glCreateShader(stage));
    const GLchar* data = text.data();
    const auto length = static_cast<GLint>(text.size());
    glShaderSource(shader.get(), 1, &data, &length);
    glCompileShader(shader.get());
    GLint ok = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
    result.log = read_log(shader.get(), glGetShaderiv, glGetShaderInfoLog);
    if (ok) result.shader = std::move(shader);
    return result;
}

Linked link(const std::vector<const Shader*>& shaders, const std::vector<AttributeLocation>& attributes) {
    Linked result;
    Program program(glCreateProgram());
    for (const Shader* shader : shaders) glAttachShader(program.get(), shader->get());
    for (const AttributeLocation& attribute : attributes)
        glBindAttribLocation(program.get(), attribute.location, std::string(attribute.name).c_str());
    glLinkProgram(program.get());
    GLint ok = 0;
    glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
    result.log = read_log(program.get(), glGetProgramiv, glGetProgramInfoLog);
    if (ok) {
        for (const Shader* shader : shaders) glDetachShader(program.get(), shader->get());
        result.program = std::move(program);
    }
    return result;
}

std::vector<Uniform> active_uniforms(GLuint program, bool interface_query) {
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    std::vector<Uniform> uniforms;
    for (GLint i = 0; i < count; ++i) {
        std::array<GLchar, 512> name{};
        Uniform uniform;
        glGetActiveUniform(program, static_cast<GLuint>(i), name.size(), nullptr, &uniform.size, &uniform.type,
                           name.data());
        uniform.location = glGetUniformLocation(program, name.data());
        if (uniform.location < 0) continue;  // in a block, or the driver's own
        if (interface_query && !is_referenced(program, static_cast<GLuint>(i))) continue;
        uniform.name = name.data();
        if (uniform.name.ends_with("[0]")) uniform.name.resize(uniform.name.size() - 3);
        uniforms.push_back(std::move(uniform));
    }
    return uniforms;
}

std::vector<std::string> active_attributes(GLuint program) {
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_ATTRIBUTES, &count);
    std::vector<std::string> names;
    for (GLint i = 0; i < count; ++i) {
        std::array<GLchar, 512> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveAttrib(program, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
        names.emplace_back(name.data());
    }
    return names;
}

std::string_view type_name(GLenum type) {
    switch (type) {
        case GL_FLOAT:
            return "float";
        case GL_FLOAT_VEC2:
            return "vec2";
        case GL_FLOAT_VEC3:
            return "vec3";
        case GL_FLOAT_VEC4:
            return "vec4";
        case GL_INT:
            return "int";
        case GL_INT_VEC2:
            return "ivec2";
        case GL_INT_VEC3:
            return "ivec3";
        case GL_INT_VEC4:
            return "ivec4";
        case GL_UNSIGNED_INT:
            return "uint";
        case GL_UNSIGNED_INT_VEC2:
            return "uvec2";
        case GL_UNSIGNED_INT_VEC3:
            return "uvec3";
        case GL_UNSIGNED_INT_VEC4:
            return "uvec4";
        case GL_BOOL:
            return "bool";
        case GL_BOOL_VEC2:
            return "bvec2";
        case GL_BOOL_VEC3:
            return "bvec3";
        case GL_BOOL_VEC4:
            return "bvec4";
        case GL_FLOAT_MAT2:
            return "mat2";
        case GL_FLOAT_MAT3:
            return "mat3";
        case GL_FLOAT_MAT4:
            return "mat4";
        case GL_FLOAT_MAT2x3:
            return "mat2x3";
        case GL_FLOAT_MAT2x4:
            return "mat2x4";
        case GL_FLOAT_MAT3x2:
            return "mat3x2";
        case GL_FLOAT_MAT3x4:
            return "mat3x4";
        case GL_FLOAT_MAT4x2:
            return "mat4x2";
        case GL_FLOAT_MAT4x3:
            return "mat4x3";
        case GL_DOUBLE:
            return "double";
        case GL_DOUBLE_VEC2:
            return "dvec2";
        case GL_DOUBLE_VEC3:
            return "dvec3";
        case GL_DOUBLE_VEC4:
            return "dvec4";
        case GL_SAMPLER_1D:
            return "sampler1D";
        case GL_SAMPLER_2D:
            return "sampler2D";
        case GL_SAMPLER_3D:
            return "sampler3D";
        case GL_SAMPLER_CUBE:
            return "samplerCube";
        case GL_SAMPLER_1D_SHADOW:
            return "sampler1DShadow";
        case GL_SAMPLER_2D_SHADOW:
            return "sampler2DShadow";
        case GL_SAMPLER_CUBE_SHADOW:
            return "samplerCubeShadow";
        case GL_SAMPLER_BUFFER:
            return "samplerBuffer";
        case GL_SAMPLER_2D_RECT:
            return "sampler2DRect";
        case GL_INT_SAMPLER_2D:
            return "isampler2D";
        case GL_UNSIGNED_INT_SAMPLER_2D:
            return "usampler2D";
        case GL_INT_SAMPLER_3D:
            return "isampler3D";
        case GL_UNSIGNED_INT_SAMPLER_3D:
            return "usampler3D";
        default:
            return {};
    }
}

}  // namespace snell::gl
