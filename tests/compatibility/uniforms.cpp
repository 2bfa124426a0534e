#include "tests/compatibility/uniforms.h"

#include <epoxy/gl.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "tests/std.h"

namespace snell::oracle {
namespace {

// .2 to 1, the same for the same name everywhere.
float value_of(std::string_view name, int index) {
    std::uint32_t hash = 2166136261u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    hash += static_cast<std::uint32_t>(index) * 2654435761u;
    return .2f + .8f * static_cast<float>((hash >> 8) % 1000) / 1000.f;
}

std::optional<glm::dmat4> matrix_of(glsl::System system) {
    const glm::dmat4 mv = model_view(), p = projection(), mvp = p * mv;
    using enum glsl::System;
    switch (system) {
        case model_view:
            return mv;
        case projection:
            return p;
        case model_view_projection:
            return mvp;
        case normal_matrix:
            return glm::dmat4(glm::inverseTranspose(glm::dmat3(mv)));
        case model_view_inverse:
            return inverse(mv);
        case projection_inverse:
            return inverse(p);
        case model_view_projection_inverse:
            return inverse(mvp);
        case model_view_transpose:
            return transpose(mv);
        case projection_transpose:
            return transpose(p);
        case model_view_projection_transpose:
            return transpose(mvp);
        case model_view_inverse_transpose:
            return transpose(inverse(mv));
        case projection_inverse_transpose:
            return transpose(inverse(p));
        case model_view_projection_inverse_transpose:
            return transpose(inverse(mvp));
        case texture_matrix:
            return oracle::texture_matrix();
        case texture_matrix_inverse:
            return inverse(oracle::texture_matrix());
        case texture_matrix_transpose:
            return transpose(oracle::texture_matrix());
        case texture_matrix_inverse_transpose:
            return transpose(inverse(oracle::texture_matrix()));
        case model:
            return oracle::model();
        case view:
            return oracle::view();
        case view_projection:
            return p * oracle::view();
        case model_inverse:
            return inverse(oracle::model());
        case view_inverse:
            return inverse(oracle::view());
        case model_normal_matrix:
            return glm::dmat4(glm::inverseTranspose(glm::dmat3(oracle::model())));
        default:
            return std::nullopt;
    }
}

void set_matrix(GLint location, GLenum type, GLint size, const glm::dmat4& m) {
    if (type == GL_FLOAT_MAT3) {
        const glm::mat3 value(m);
        glUniformMatrix3fv(location, 1, GL_FALSE, glm::value_ptr(value));
        return;
    }
    std::vector<glm::mat4> values(static_cast<std::size_t>(size), glm::mat4(1));
    values[0] = glm::mat4(m);
    glUniformMatrix4fv(location, size, GL_FALSE, glm::value_ptr(values[0]));
}

// OpenGL's factor for GL_RESCALE_NORMAL: one over the length of the third row of the inverse.
float rescale_factor() {
    const glm::dmat4 inv = inverse(oracle::model_view());
    return static_cast<float>(1 / glm::length(glm::dvec3(inv[0][2], inv[1][2], inv[2][2])));
}

bool set_system(const std::string& name, GLint location, GLenum type, GLint size) {
    for (const glsl::SystemName& system : glsl::system_names()) {
        if (system.name != name) continue;
        if (const auto matrix = matrix_of(system.system)) {
            set_matrix(location, type, size, *matrix);
            return true;
        }
        using enum glsl::System;
        switch (system.system) {
            case normal_scale:
                glUniform1f(location, rescale_factor());
                return true;
            case point_size:
                glUniform1f(location, 1);
                return true;
            case camera_position: {
                const glm::vec3 eye = glm::vec3(inverse(oracle::view())[3]);
                glUniform3f(location, eye.x, eye.y, eye.z);
                return true;
            }
            case noise2:
                glUniform1i(location, 2);
                return true;
            case noise3:
                glUniform1i(location, 3);
                return true;
            default:
                return false;
        }
    }
    return false;
}

int components(GLenum type) {
    switch (type) {
        case GL_FLOAT_VEC2:
        case GL_INT_VEC2:
        case GL_BOOL_VEC2:
            return 2;
        case GL_FLOAT_VEC3:
        case GL_INT_VEC3:
        case GL_BOOL_VEC3:
            return 3;
        case GL_FLOAT_VEC4:
        case GL_INT_VEC4:
        case GL_BOOL_VEC4:
        case GL_FLOAT_MAT2:
            return 4;
        case GL_FLOAT_MAT3:
            return 9;
        case GL_FLOAT_MAT4:
            return 16;
        default:
            return 1;
    }
}

void set_floats(GLint location, GLenum type, GLint size, const float* v) {
    switch (type) {
        case GL_FLOAT:
            return glUniform1fv(location, size, v);
        case GL_FLOAT_VEC2:
            return glUniform2fv(location, size, v);
        case GL_FLOAT_VEC3:
            return glUniform3fv(location, size, v);
        case GL_FLOAT_VEC4:
            return glUniform4fv(location, size, v);
        case GL_FLOAT_MAT2:
            return glUniformMatrix2fv(location, size, GL_FALSE, v);
        case GL_FLOAT_MAT3:
            return glUniformMatrix3fv(location, size, GL_FALSE, v);
        case GL_FLOAT_MAT4:
            return glUniformMatrix4fv(location, size, GL_FALSE, v);
        default:
            break;
    }
}

bool is_float(GLenum type) {
    switch (type) {
        case GL_FLOAT:
        case GL_FLOAT_VEC2:
        case GL_FLOAT_VEC3:
        case GL_FLOAT_VEC4:
        case GL_FLOAT_MAT2:
        case GL_FLOAT_MAT3:
        case GL_FLOAT_MAT4:
            return true;
        default:
            return false;
    }
}

void set_integers(GLint location, GLenum type, GLint size, const std::vector<GLint>& v) {
    const std::vector<GLuint> u(v.begin(), v.end());
    switch (type) {
        case GL_UNSIGNED_INT:
            return glUniform1uiv(location, size, u.data());
        case GL_INT_VEC2:
        case GL_BOOL_VEC2:
            return glUniform2iv(location, size, v.data());
        case GL_INT_VEC3:
        case GL_BOOL_VEC3:
            return glUniform3iv(location, size, v.data());
        case GL_INT_VEC4:
        case GL_BOOL_VEC4:
            return glUniform4iv(location, size, v.data());
        default:
            return glUniform1iv(location, size, v.data());
    }
}

void set_default(GLint location, GLenum type, GLint size, const std::vector<double>& values) {
    if (values.size() < static_cast<std::size_t>(components(type) * size)) return;
    if (is_float(type)) {
        const std::vector<float> v(values.begin(), values.end());
        return set_floats(location, type, size, v.data());
    }
    std::vector<GLint> v;
    for (const double x : values) v.push_back(static_cast<GLint>(x));
    set_integers(location, type, size, v);
}

bool set_sampler(GLuint program, const std::string& name, GLint location, GLenum type) {
    switch (type) {
        case GL_SAMPLER_2D_SHADOW:
            glUniform1i(location, shadow_unit);
            return true;
        case GL_SAMPLER_1D:
        case GL_SAMPLER_2D:
        case GL_SAMPLER_3D:
        case GL_SAMPLER_CUBE:
            break;
        default:
            return false;
    }
    GLint unit = 0;
    glGetUniformiv(program, location, &unit);
    if (unit != 0) return true;  // layout(binding) has set it
    // Samplers of different kinds must not share a unit.
    const GLint first = type == GL_SAMPLER_2D ? 0 : type == GL_SAMPLER_CUBE ? 4 : type == GL_SAMPLER_3D ? 6 : 7;
    glUniform1i(location, first + (first < 6 && value_of(name, 0) > .6f ? 1 : 0));
    return true;
}

void set_user(GLuint program, const std::string& name, GLint location, GLenum type, GLint size) {
    if (set_sampler(program, name, location, type)) return;
    std::vector<float> floats;
    for (int i = 0; i < components(type) * size; ++i) floats.push_back(value_of(name, i));
    if (is_float(type)) return set_floats(location, type, size, floats.data());
    std::vector<GLint> integers;
    for (const float f : floats) integers.push_back(1 + static_cast<int>(f * 3));  // 1, 2, 3
    set_integers(location, type, size, integers);
}

void set_fixed_function(GLuint program) {
    for (const glsl::UniformDefault& d : glsl::fixed_function_defaults()) {
        const GLint location = glGetUniformLocation(program, d.name.c_str());
        if (location < 0) continue;
        const std::vector<float> v(d.values.begin(), d.values.end());
        constexpr GLenum types[] = {GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4};
        set_floats(location, types[v.size() - 1], 1, v.data());
    }
}

}  // namespace

// What the fixed-function pipeline is given has the precision of floats.
glm::dmat4 model_view() { return glm::dmat4(glm::mat4(view() * model())); }

glm::dmat4 view() { return glm::lookAt(glm::dvec3(.5, 1, 4), glm::dvec3(0), glm::dvec3(0, 1, 0)); }

glm::dmat4 model() {
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), .7, glm::normalize(glm::dvec3(1, 2, .5)));
    return glm::scale(turned, glm::dvec3(1.2, .9, 1.1));
}

glm::dmat4 projection() { return glm::dmat4(glm::mat4(glm::perspective(glm::radians(45.), 1., .5, 20.))); }

glm::dmat4 texture_matrix() {
    return glm::dmat4(glm::mat4(glm::rotate(glm::scale(glm::dmat4(1), glm::dvec3(2, .5, 1)), .4, glm::dvec3(0, 0, 1))));
}

void set_uniforms(unsigned program, const glsl::Translation& translation, bool set_defaults) {
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char text[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), sizeof text, nullptr, &size, &type, text);
        std::string name = text;
        const GLint location = glGetUniformLocation(program, text);
        if (location < 0) continue;
        if (name.ends_with("[0]")) name.resize(name.size() - 3);
        for (const glsl::RenamedUniform& r : translation.renamed)
            if (r.shader_name == name) name = r.name;
        const auto named = [&](const glsl::UniformDefault& d) { return d.name == name; };
        const auto own = std::find_if(translation.defaults.begin(), translation.defaults.end(), named);
        if (own != translation.defaults.end()) {
            if (set_defaults) set_default(location, type, size, own->values);
            continue;
        }
        if (set_system(name, location, type, size) || name.starts_with("snell_") || name.starts_with("gl_")) continue;
        set_user(program, name, location, type, size);
    }
    set_fixed_function(program);
}

}  // namespace snell::oracle
