#include "src/gl/program.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "src/gl/driver.h"

namespace snell::gl {

namespace {

constexpr std::pair<GLenum, std::string_view> names_of_types[]{
    {GL_FLOAT, "float"},
    {GL_FLOAT_VEC2, "vec2"},
    {GL_FLOAT_VEC3, "vec3"},
    {GL_FLOAT_VEC4, "vec4"},
    {GL_INT, "int"},
    {GL_INT_VEC2, "ivec2"},
    {GL_INT_VEC3, "ivec3"},
    {GL_INT_VEC4, "ivec4"},
    {GL_UNSIGNED_INT, "uint"},
    {GL_UNSIGNED_INT_VEC2, "uvec2"},
    {GL_UNSIGNED_INT_VEC3, "uvec3"},
    {GL_UNSIGNED_INT_VEC4, "uvec4"},
    {GL_BOOL, "bool"},
    {GL_BOOL_VEC2, "bvec2"},
    {GL_BOOL_VEC3, "bvec3"},
    {GL_BOOL_VEC4, "bvec4"},
    {GL_FLOAT_MAT2, "mat2"},
    {GL_FLOAT_MAT3, "mat3"},
    {GL_FLOAT_MAT4, "mat4"},
    {GL_FLOAT_MAT2x3, "mat2x3"},
    {GL_FLOAT_MAT2x4, "mat2x4"},
    {GL_FLOAT_MAT3x2, "mat3x2"},
    {GL_FLOAT_MAT3x4, "mat3x4"},
    {GL_FLOAT_MAT4x2, "mat4x2"},
    {GL_FLOAT_MAT4x3, "mat4x3"},
    {GL_DOUBLE, "double"},
    {GL_DOUBLE_VEC2, "dvec2"},
    {GL_DOUBLE_VEC3, "dvec3"},
    {GL_DOUBLE_VEC4, "dvec4"},
    {GL_SAMPLER_1D, "sampler1D"},
    {GL_SAMPLER_2D, "sampler2D"},
    {GL_SAMPLER_3D, "sampler3D"},
    {GL_SAMPLER_CUBE, "samplerCube"},
    {GL_SAMPLER_2D_RECT, "sampler2DRect"},
    {GL_SAMPLER_1D_ARRAY, "sampler1DArray"},
    {GL_SAMPLER_2D_ARRAY, "sampler2DArray"},
    {GL_SAMPLER_CUBE_MAP_ARRAY, "samplerCubeArray"},
    {GL_SAMPLER_2D_MULTISAMPLE, "sampler2DMS"},
    {GL_SAMPLER_2D_MULTISAMPLE_ARRAY, "sampler2DMSArray"},
    {GL_SAMPLER_BUFFER, "samplerBuffer"},
    {GL_INT_SAMPLER_1D, "isampler1D"},
    {GL_INT_SAMPLER_2D, "isampler2D"},
    {GL_INT_SAMPLER_3D, "isampler3D"},
    {GL_INT_SAMPLER_CUBE, "isamplerCube"},
    {GL_INT_SAMPLER_2D_RECT, "isampler2DRect"},
    {GL_INT_SAMPLER_1D_ARRAY, "isampler1DArray"},
    {GL_INT_SAMPLER_2D_ARRAY, "isampler2DArray"},
    {GL_INT_SAMPLER_CUBE_MAP_ARRAY, "isamplerCubeArray"},
    {GL_INT_SAMPLER_2D_MULTISAMPLE, "isampler2DMS"},
    {GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "isampler2DMSArray"},
    {GL_INT_SAMPLER_BUFFER, "isamplerBuffer"},
    {GL_UNSIGNED_INT_SAMPLER_1D, "usampler1D"},
    {GL_UNSIGNED_INT_SAMPLER_2D, "usampler2D"},
    {GL_UNSIGNED_INT_SAMPLER_3D, "usampler3D"},
    {GL_UNSIGNED_INT_SAMPLER_CUBE, "usamplerCube"},
    {GL_UNSIGNED_INT_SAMPLER_2D_RECT, "usampler2DRect"},
    {GL_UNSIGNED_INT_SAMPLER_1D_ARRAY, "usampler1DArray"},
    {GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, "usampler2DArray"},
    {GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY, "usamplerCubeArray"},
    {GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE, "usampler2DMS"},
    {GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "usampler2DMSArray"},
    {GL_UNSIGNED_INT_SAMPLER_BUFFER, "usamplerBuffer"},
    {GL_SAMPLER_1D_SHADOW, "sampler1DShadow"},
    {GL_SAMPLER_2D_SHADOW, "sampler2DShadow"},
    {GL_SAMPLER_CUBE_SHADOW, "samplerCubeShadow"},
    {GL_SAMPLER_2D_RECT_SHADOW, "sampler2DRectShadow"},
    {GL_SAMPLER_1D_ARRAY_SHADOW, "sampler1DArrayShadow"},
    {GL_SAMPLER_2D_ARRAY_SHADOW, "sampler2DArrayShadow"},
    {GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW, "samplerCubeArrayShadow"},
};

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
    // Asking for a stage that the context lacks is an error. OpenGL 3.3 has geometry and no tessellation.
    const std::size_t asked = is_desktop() ? (version() >= 40 ? 5 : 3) : (version() >= 32 ? 5 : 2);
    std::array<GLint, 5> values{};
    beyond::properties_of(program, index, std::span(properties).first(asked), values);
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

Linked link(const std::vector<const Shader*>& shaders, const std::vector<AttributeLocation>& attributes,
            const std::vector<std::string>& written) {
    Linked result;
    Program program(glCreateProgram());
    for (const Shader* shader : shaders) glAttachShader(program.get(), shader->get());
    for (const AttributeLocation& attribute : attributes)
        glBindAttribLocation(program.get(), attribute.location, std::string(attribute.name).c_str());
    std::vector<const GLchar*> names;
    for (const std::string& name : written) names.push_back(name.c_str());
    if (!names.empty())
        glTransformFeedbackVaryings(program.get(), static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
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

bool gives_binaries() {
    const bool known = !is_desktop() || version() >= 41 || has_extension("GL_ARB_get_program_binary");
    GLint formats = 0;
    if (known) glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    return formats > 0;
}

std::string binary_of(const Program& program, const std::vector<const Shader*>& shaders) {
    const GLuint id = program.get();
    glProgramParameteri(id, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    for (const Shader* shader : shaders) glAttachShader(id, shader->get());
    glLinkProgram(id);
    for (const Shader* shader : shaders) glDetachShader(id, shader->get());
    GLint ok = 0, size = 0;
    glGetProgramiv(id, GL_LINK_STATUS, &ok);
    if (ok) glGetProgramiv(id, GL_PROGRAM_BINARY_LENGTH, &size);
    if (size <= 0) return {};
    std::string code(static_cast<std::size_t>(size), '\0');
    GLenum format = 0;
    GLsizei written = 0;
    glGetProgramBinary(id, size, &written, &format, code.data());
    code.resize(static_cast<std::size_t>(written));
    return code;
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
        if (uniform.location < 0) continue;  // a member of a block, or one of the driver's own uniforms
        if (interface_query && !is_referenced(program, static_cast<GLuint>(i))) continue;
        uniform.name = name.data();
        if (uniform.name.ends_with("[0]")) uniform.name.resize(uniform.name.size() - 3);
        uniforms.push_back(std::move(uniform));
    }
    return uniforms;
}

Program covering_program(bool es, std::string_view fragment) {
    const std::string head =
        es ? "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\n" : "#version 330 core\n";
    const Compiled vertex = compile(GL_VERTEX_SHADER, head +
                                                          "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : "
                                                          "-1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }\n");
    const Compiled pixels = compile(GL_FRAGMENT_SHADER, head + std::string(fragment));
    if (!vertex.shader || !pixels.shader) return {};
    return std::move(link({&vertex.shader, &pixels.shader}, {}).program);
}

void set_floats(GLenum type, GLint location, GLsizei count, const float* values) {
    switch (type) {
        case GL_FLOAT:
            return glUniform1fv(location, count, values);
        case GL_FLOAT_VEC2:
            return glUniform2fv(location, count, values);
        case GL_FLOAT_VEC3:
            return glUniform3fv(location, count, values);
        case GL_FLOAT_VEC4:
            return glUniform4fv(location, count, values);
        case GL_FLOAT_MAT2:
            return glUniformMatrix2fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT3:
            return glUniformMatrix3fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT4:
            return glUniformMatrix4fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT2x3:
            return glUniformMatrix2x3fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT2x4:
            return glUniformMatrix2x4fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT3x2:
            return glUniformMatrix3x2fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT3x4:
            return glUniformMatrix3x4fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT4x2:
            return glUniformMatrix4x2fv(location, count, GL_FALSE, values);
        case GL_FLOAT_MAT4x3:
            return glUniformMatrix4x3fv(location, count, GL_FALSE, values);
        default:
            return;
    }
}

std::string_view type_name(GLenum type) {
    const auto* found = std::find_if(std::begin(names_of_types), std::end(names_of_types),
                                     [&](const auto& known) { return known.first == type; });
    return found == std::end(names_of_types) ? std::string_view{} : found->second;
}

std::vector<std::string_view> type_names() {
    std::vector<std::string_view> names;
    for (const auto& [type, name] : names_of_types) names.push_back(name);
    return names;
}

}  // namespace snell::gl
