#include "src/runtime/uniforms.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/plan/plan.h"

namespace snell::runtime {

namespace {

using glsl::System;

template <typename Matrix>
std::vector<float> floats(const Matrix& matrix) {
    std::vector<float> values;
    for (int column = 0; column < matrix.length(); ++column)
        for (int row = 0; row < matrix[column].length(); ++row)
            values.push_back(static_cast<float>(matrix[column][row]));
    return values;
}

std::vector<float> vec3(const glm::dvec4& v) {
    return {static_cast<float>(v.x / v.w), static_cast<float>(v.y / v.w), static_cast<float>(v.z / v.w)};
}

// A singular matrix has no inverse: zero instead of infinities that would spread over the picture.
glm::dmat4 inverse(const glm::dmat4& matrix) {
    const glm::dmat4 result = glm::inverse(matrix);
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(result[i][k])) return glm::dmat4(0);
    return result;
}

std::vector<float> texture_matrices(const glm::dmat4& first, int size) {
    std::vector<float> values = floats(first);
    for (int i = 1; i < size; ++i) {
        const std::vector<float> identity = floats(glm::dmat4(1));
        values.insert(values.end(), identity.begin(), identity.end());
    }
    return values;
}

// As many coefficients as the program reads; black where nothing names a cube map.
std::vector<float> harmonics(const DrawContext& c, int size) {
    std::vector<float> values(3 * static_cast<std::size_t>(size), 0.0F);
    if (c.harmonics)
        for (std::size_t i = 0; i < std::min<std::size_t>(c.harmonics->size() * 3, values.size()); ++i)
            values[i] = (*c.harmonics)[i / 3][i % 3];
    return values;
}

std::vector<float> value_of(System system, const DrawContext& c, int size) {
    const auto number = [](double v) { return std::vector<float>{static_cast<float>(v)}; };
    const glm::dvec4 origin(0, 0, 0, 1);
    switch (system) {
        case System::model_view:
            return floats(c.view * c.model);
        case System::projection:
            return floats(c.projection);
        case System::model_view_projection:
            return floats(c.projection * c.view * c.model);
        case System::normal_matrix:
            return floats(normal_matrix(c.view * c.model));
        case System::model_view_inverse:
            return floats(inverse(c.view * c.model));
        case System::projection_inverse:
            return floats(inverse(c.projection));
        case System::model_view_projection_inverse:
            return floats(inverse(c.projection * c.view * c.model));
        case System::model_view_transpose:
            return floats(glm::transpose(c.view * c.model));
        case System::projection_transpose:
            return floats(glm::transpose(c.projection));
        case System::model_view_projection_transpose:
            return floats(glm::transpose(c.projection * c.view * c.model));
        case System::model_view_inverse_transpose:
            return floats(glm::transpose(inverse(c.view * c.model)));
        case System::projection_inverse_transpose:
            return floats(glm::transpose(inverse(c.projection)));
        case System::model_view_projection_inverse_transpose:
            return floats(glm::transpose(inverse(c.projection * c.view * c.model)));
        case System::texture_matrix:
            return texture_matrices(c.texture, size);
        case System::texture_matrix_inverse:
            return texture_matrices(inverse(c.texture), size);
        case System::texture_matrix_transpose:
            return texture_matrices(glm::transpose(c.texture), size);
        case System::texture_matrix_inverse_transpose:
            return texture_matrices(glm::transpose(inverse(c.texture)), size);
        case System::model:
            return floats(c.model);
        case System::view:
            return floats(c.view);
        case System::view_projection:
            return floats(c.projection * c.view);
        case System::model_inverse:
            return floats(inverse(c.model));
        case System::view_inverse:
            return floats(inverse(c.view));
        case System::model_normal_matrix:
            return floats(normal_matrix(c.model));
        case System::camera_position:
            return vec3(inverse(c.view) * origin);
        case System::viewer_position_eye:
            return vec3(inverse(c.scene) * origin);
        case System::normal_scale: {
            const double length = glm::length(glm::dvec3(glm::row(inverse(c.view * c.model), 2)));
            return number(length > 0 ? 1 / length : 1);
        }
        case System::timer:
            return number(timer_value(c.time, c.timer_period));
        case System::time:
            return number(c.time);
        case System::resolution:
            return {static_cast<float>(c.width), static_cast<float>(c.height)};
        case System::mouse:
            return {static_cast<float>(c.mouse_x), static_cast<float>(c.mouse_y)};
        case System::noise2:
        case System::noise3:
            return {};  // samplers: bound with the textures
        case System::face_index:
            return number(c.face_index);
        case System::depth_range_near:
            return number(0);
        case System::depth_range_far:
            return number(1);
        case System::depth_range_diff:
            return number(1);
        case System::point_size:
            return number(c.point_size);
        case System::line_width:
            return number(c.line_width);
        case System::viewport:
            return {static_cast<float>(c.width), static_cast<float>(c.height)};
        case System::harmonics:
            return harmonics(c, size);
    }
    return {};
}

void upload(const SystemUniform& uniform, const std::vector<float>& v) {
    const GLint at = uniform.location;
    if (uniform.system == System::face_index) {
        glUniform1i(at, static_cast<GLint>(v[0]));
        return;
    }
    switch (v.size() / static_cast<size_t>(uniform.size)) {
        case 1:
            glUniform1fv(at, uniform.size, v.data());
            break;
        case 2:
            glUniform2fv(at, uniform.size, v.data());
            break;
        case 3:
            glUniform3fv(at, uniform.size, v.data());
            break;
        case 9:
            glUniformMatrix3fv(at, uniform.size, GL_FALSE, v.data());
            break;
        case 16:
            glUniformMatrix4fv(at, uniform.size, GL_FALSE, v.data());
            break;
        default:
            break;
    }
}

void upload_matrix(const UserUniform& uniform, const std::vector<float>& v) {
    const std::string_view type = uniform.glsl_type;
    const GLint at = uniform.location;
    const float* data = v.data();
    const int n = uniform.size;
    if (type == "mat2") glUniformMatrix2fv(at, n, GL_FALSE, data);
    if (type == "mat3") glUniformMatrix3fv(at, n, GL_FALSE, data);
    if (type == "mat4") glUniformMatrix4fv(at, n, GL_FALSE, data);
    if (type == "mat2x3") glUniformMatrix2x3fv(at, n, GL_FALSE, data);
    if (type == "mat2x4") glUniformMatrix2x4fv(at, n, GL_FALSE, data);
    if (type == "mat3x2") glUniformMatrix3x2fv(at, n, GL_FALSE, data);
    if (type == "mat3x4") glUniformMatrix3x4fv(at, n, GL_FALSE, data);
    if (type == "mat4x2") glUniformMatrix4x2fv(at, n, GL_FALSE, data);
    if (type == "mat4x3") glUniformMatrix4x3fv(at, n, GL_FALSE, data);
}

template <typename T, typename One, typename Two, typename Three, typename Four>
void upload_vector(const UserUniform& uniform, const std::vector<double>& values, One one, Two two, Three three,
                   Four four) {
    std::vector<T> v(values.size());
    std::ranges::transform(values, v.begin(), [](double value) { return static_cast<T>(value); });
    switch (uniform.components) {
        case 1:
            one(uniform.location, uniform.size, v.data());
            break;
        case 2:
            two(uniform.location, uniform.size, v.data());
            break;
        case 3:
            three(uniform.location, uniform.size, v.data());
            break;
        default:
            four(uniform.location, uniform.size, v.data());
            break;
    }
}

void upload(const UserUniform& uniform, ValueType type, const std::vector<double>& values) {
    switch (type) {
        case ValueType::float_:
            upload_vector<GLfloat>(uniform, values, glUniform1fv, glUniform2fv, glUniform3fv, glUniform4fv);
            break;
        case ValueType::bool_:
        case ValueType::int_:
            upload_vector<GLint>(uniform, values, glUniform1iv, glUniform2iv, glUniform3iv, glUniform4iv);
            break;
        case ValueType::uint_:
            upload_vector<GLuint>(uniform, values, glUniform1uiv, glUniform2uiv, glUniform3uiv, glUniform4uiv);
            break;
        case ValueType::double_:
            upload_vector<GLdouble>(uniform, values, glUniform1dv, glUniform2dv, glUniform3dv, glUniform4dv);
            break;
        case ValueType::matrix:
            upload_matrix(uniform, std::vector<float>(values.begin(), values.end()));
            break;
        case ValueType::sampler:
            break;  // bound once for all
    }
}

}  // namespace

glm::dmat4 about_origin(const Transformation& transformation, const glm::dmat4& view) {
    if (transformation == Transformation{}) return glm::dmat4(1);
    const glm::dvec3 pivot(view[3]);
    return glm::translate(glm::dmat4(1), pivot) * transformation.matrix() * glm::translate(glm::dmat4(1), -pivot);
}

double timer_value(double time, double period) {
    if (!(period > 0) || !std::isfinite(time)) return 0;
    double phase = std::fmod(time, period) / period;
    if (phase < 0) phase += 1;
    // A double just below 1 rounds to 1 in float.
    return std::min(phase, static_cast<double>(std::nextafter(1.0F, 0.0F)));
}

std::vector<float> system_value(System system, const DrawContext& context, int size) {
    return value_of(system, context, size);
}

int set_system(LinkedProgram& program, const DrawContext& context, bool all) {
    int uploads = 0;
    for (SystemUniform& uniform : program.system) {
        if (uniform.system == System::face_index) continue;
        std::vector<float> value = value_of(uniform.system, context, uniform.size);
        if (value.empty() || (value == uniform.last && !all)) continue;
        upload(uniform, value);
        uniform.last = std::move(value);
        ++uploads;
    }
    return uploads;
}

int set_user(LinkedProgram& program, Index index, const Controls& controls, bool all) {
    int uploads = 0;
    for (UserUniform& uniform : program.user) {
        const Control* control = controls.find(index, uniform.name);
        const bool usable = control && control->active && control->value.size() == uniform.last.size();
        // Another draw with the same program may have set what this one leaves alone.
        const std::vector<double>& value = usable ? control->value : uniform.initial;
        if (value == uniform.last && !(all && usable)) continue;
        upload(uniform, uniform.type, value);
        uniform.last = value;
        ++uploads;
    }
    return uploads;
}

int set_face_index(LinkedProgram& program, int face) {
    for (SystemUniform& uniform : program.system) {
        if (uniform.system != System::face_index) continue;
        std::vector<float> value{static_cast<float>(face)};
        if (value == uniform.last) return 0;
        upload(uniform, value);
        uniform.last = std::move(value);
        return 1;
    }
    return 0;
}

}  // namespace snell::runtime
