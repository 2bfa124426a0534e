#include "src/runtime/resources/uniforms.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "parser/text/ranges.h"
#include "src/gl/driver.h"
#include "src/plan/plan.h"
#include "src/plan/values/declared.h"

namespace snell::runtime {

namespace {

using glsl::System;

using Floats = std::vector<float>;

template <typename Matrix>
void append(Floats& out, const Matrix& matrix) {
    for (int column = 0; column < matrix.length(); ++column)
        for (int row = 0; row < matrix[column].length(); ++row) out.push_back(static_cast<float>(matrix[column][row]));
}

void append(Floats& out, const glm::dvec4& point) {
    for (int i = 0; i < 3; ++i) out.push_back(static_cast<float>(point[i] / point.w));
}

void append(Floats& out, std::initializer_list<double> numbers) {
    for (const double number : numbers) out.push_back(static_cast<float>(number));
}

// The inverse of a singular matrix is zero here, because infinities would spread over the picture.
glm::dmat4 inverse(const glm::dmat4& matrix) {
    const glm::dmat4 result = glm::inverse(matrix);
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(result[i][k])) return glm::dmat4(0);
    return result;
}

// Appends as many coefficients as the program reads. They are zero if no statement names a cube map.
void append_harmonics(Floats& out, const DrawContext& c, int size) {
    const std::size_t wanted = 3 * static_cast<std::size_t>(size);
    const std::size_t there = c.harmonics ? std::min(c.harmonics->size() * 3, wanted) : 0;
    for (std::size_t i = 0; i < wanted; ++i) out.push_back(i < there ? (*c.harmonics)[i / 3][i % 3] : 0.0F);
}

// ---- matrices of four columns ------------------------------------------------------------------------------

// In world coordinates. The scene transformation comes after eye coordinates, so it moves the viewer.
glm::dvec3 viewer(const DrawContext& c) {
    const glm::dvec4 eye = inverse(c.scene * c.view) * glm::dvec4(0, 0, 0, 1);
    return glm::dvec3(eye) / eye.w;
}

glm::dmat4 model_view(const DrawContext& c) { return c.view * c.model; }
glm::dmat4 projection(const DrawContext& c) { return c.projection; }
glm::dmat4 model_view_projection(const DrawContext& c) { return c.projection * c.view * c.model; }
glm::dmat4 of_texture(const DrawContext& c) { return c.texture; }
glm::dmat4 model_alone(const DrawContext& c) { return c.model; }
glm::dmat4 view_alone(const DrawContext& c) { return c.view; }
glm::dmat4 view_projection(const DrawContext& c) { return c.projection * c.view; }
glm::dmat4 model_viewer(const DrawContext& c) { return glm::translate(glm::dmat4(1), -viewer(c)) * c.model; }

enum class Form : std::uint8_t { plain, inverse, transpose, inverse_transpose };

struct MatrixUniform {
    System system;
    glm::dmat4 (*product)(const DrawContext&);
    Form form;
};

constexpr MatrixUniform matrix_uniforms[]{
    {System::model_view, model_view, Form::plain},
    {System::model_view_inverse, model_view, Form::inverse},
    {System::model_view_transpose, model_view, Form::transpose},
    {System::model_view_inverse_transpose, model_view, Form::inverse_transpose},
    {System::projection, projection, Form::plain},
    {System::projection_inverse, projection, Form::inverse},
    {System::projection_transpose, projection, Form::transpose},
    {System::projection_inverse_transpose, projection, Form::inverse_transpose},
    {System::model_view_projection, model_view_projection, Form::plain},
    {System::model_view_projection_inverse, model_view_projection, Form::inverse},
    {System::model_view_projection_transpose, model_view_projection, Form::transpose},
    {System::model_view_projection_inverse_transpose, model_view_projection, Form::inverse_transpose},
    {System::texture_matrix, of_texture, Form::plain},
    {System::texture_matrix_inverse, of_texture, Form::inverse},
    {System::texture_matrix_transpose, of_texture, Form::transpose},
    {System::texture_matrix_inverse_transpose, of_texture, Form::inverse_transpose},
    {System::model, model_alone, Form::plain},
    {System::model_inverse, model_alone, Form::inverse},
    {System::view, view_alone, Form::plain},
    {System::view_inverse, view_alone, Form::inverse},
    {System::view_projection, view_projection, Form::plain},
    {System::model_viewer, model_viewer, Form::plain},
};

const MatrixUniform* matrix_uniform(System system) {
    const auto* found = ranges::find(matrix_uniforms, system, &MatrixUniform::system);
    return found == std::end(matrix_uniforms) ? nullptr : found;
}

void append_matrix(Floats& out, const MatrixUniform& uniform, const DrawContext& c, int size) {
    glm::dmat4 matrix = uniform.product(c);
    if (uniform.form == Form::inverse || uniform.form == Form::inverse_transpose) matrix = inverse(matrix);
    if (uniform.form == Form::transpose || uniform.form == Form::inverse_transpose) matrix = glm::transpose(matrix);
    append(out, matrix);
    // Only the first unit has a texture matrix that moves.
    for (int i = 1; i < size && uniform.product == of_texture; ++i) append(out, glm::dmat4(1));
}

// ---- all others --------------------------------------------------------------------------------------------

double normal_scale(const DrawContext& c) {
    const double length = glm::length(glm::dvec3(glm::row(inverse(c.view * c.model), 2)));
    return length > 0 ? 1 / length : 1;
}

void append_value(Floats& out, System system, const DrawContext& c, int size) {
    if (const MatrixUniform* matrix = matrix_uniform(system)) return append_matrix(out, *matrix, c, size);
    const glm::dvec4 origin(0, 0, 0, 1);
    switch (system) {
        case System::normal_matrix:
            return append(out, normal_matrix(c.view * c.model));
        case System::model_normal_matrix:
            return append(out, normal_matrix(c.model));
        case System::camera_position:
            return append(out, glm::dvec4(viewer(c), 1));
        case System::viewer_position_eye:
            return append(out, inverse(c.scene) * origin);
        case System::normal_scale:
            return append(out, {normal_scale(c)});
        case System::timer:
            return append(out, {timer_value(c.time, c.timer_period)});
        case System::time:
            return append(out, {c.time});
        case System::resolution:
        case System::viewport:
            return append(out, {c.width, c.height});
        case System::mouse:
            return append(out, {c.mouse_x, c.mouse_y});
        case System::place:
            return static_cast<void>(out.insert(out.end(), c.place.begin(), c.place.end()));
        case System::face_index:
            return append(out, {static_cast<double>(c.face_index)});
        case System::point_size:
            return append(out, {c.point_size});
        case System::fixed_point_size:
            return append(out, {c.fixed_point_size});
        case System::line_width:
            return append(out, {c.line_width});
        case System::harmonics:
            return append_harmonics(out, c, size);
        default:
            return;  // noise: samplers, bound with the textures
    }
}

void upload(const SystemUniform& uniform, const std::vector<float>& values) {
    if (uniform.system == System::face_index)
        glUniform1i(uniform.location, static_cast<GLint>(values[0]));
    else
        gl::set_floats(uniform.kind, uniform.location, uniform.size, values.data());
}

template <typename T, typename Upload>
void converted(const std::vector<double>& values, const Upload& upload) {
    std::array<T, 16> few;  // what sliders have: no heap for them
    std::vector<T> many(values.size() > few.size() ? values.size() : 0);
    T* const v = many.empty() ? few.data() : many.data();
    ranges::transform(values, v, [](double value) { return static_cast<T>(value); });
    upload(v);
}

void upload(const UserUniform& uniform, const std::vector<double>& values) {
    const auto set = [&](const auto& one, const auto& two, const auto& three, const auto& four) {
        const std::array by_components{one, two, three, four};
        return [&uniform, call = by_components[static_cast<std::size_t>(uniform.components - 1)]](const auto* v) {
            call(uniform.location, uniform.size, v);
        };
    };
    switch (uniform.type) {
        case ValueType::float_:
        case ValueType::matrix:
            return converted<GLfloat>(
                values, [&](const auto* v) { gl::set_floats(uniform.kind, uniform.location, uniform.size, v); });
        case ValueType::bool_:
        case ValueType::int_:
            return converted<GLint>(values, set(glUniform1iv, glUniform2iv, glUniform3iv, glUniform4iv));
        case ValueType::uint_:
            return converted<GLuint>(values, set(glUniform1uiv, glUniform2uiv, glUniform3uiv, glUniform4uiv));
        case ValueType::double_:
            return gl::beyond::uniform(uniform.location, uniform.components, uniform.size, values.data());
        case ValueType::sampler:
            return;  // bound once for all
    }
}

}  // namespace

double timer_value(double time, double period) {
    if (!(period > 0) || !std::isfinite(time)) return 0;
    double phase = std::fmod(time, period) / period;
    if (phase < 0) phase += 1;
    // A double just below 1 rounds to 1 in float.
    return std::min(phase, static_cast<double>(std::nextafter(1.0F, 0.0F)));
}

int set_system(LinkedProgram& program, const DrawContext& context, bool all) {
    // The harmonics may have changed although their address is the same.
    if (!all && !context.harmonics && program.shown == context) return 0;
    program.shown = context;
    int uploads = 0;
    Floats& value = program.scratch;
    for (SystemUniform& uniform : program.system) {
        if (uniform.system == System::face_index) continue;
        value.clear();
        append_value(value, uniform.system, context, uniform.size);
        // A scene may declare an array where snell has one value: it stays zero.
        if (value.size() != uniform.floats || (value == uniform.last && !all)) continue;
        upload(uniform, value);
        uniform.last = value;
        ++uploads;
    }
    return uploads;
}

int set_user(LinkedProgram& program, const std::vector<Index>& places, const Controls& controls, bool all) {
    int uploads = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        UserUniform& uniform = program.user[i];
        // Another draw with the same program may have set what this one leaves alone.
        const std::vector<double>& whole = places[i] == none ? uniform.initial : controls.items[places[i]].value;
        const bool fits = whole.size() == uniform.last.size();
        const std::vector<double> first =
            fits ? std::vector<double>()
                 : std::vector<double>(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(uniform.last.size()));
        const std::vector<double>& value = fits ? whole : first;
        if (value == uniform.last && !(all && places[i] != none)) continue;
        upload(uniform, value);
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

// Finds the uniforms of a linked program, and decides whether snell or the scene sets each.

namespace {

std::vector<double> read_values(GLuint program, const gl::Uniform& uniform, const TypeFacts& type) {
    std::vector<double> values;
    for (int element = 0; element < uniform.size; ++element) {
        const GLint location = uniform.size > 1
                                   ? glGetUniformLocation(program, fmt::format("{}[{}]", uniform.name, element).c_str())
                                   : uniform.location;
        float floats[16]{};
        int ints[16]{};
        const bool whole =
            type.type != ValueType::float_ && type.type != ValueType::matrix && type.type != ValueType::double_;
        if (location >= 0) {
            if (whole)
                glGetUniformiv(program, location, ints);
            else
                glGetUniformfv(program, location, floats);
        }
        for (int i = 0; i < type.components; ++i) values.push_back(whole ? ints[i] : static_cast<double>(floats[i]));
    }
    return values;
}

// Returns the name that the scene uses for a uniform that the translation had to rename.
std::string scene_name(const std::string& shader_name, const glsl::Translation& translation) {
    const auto renamed = ranges::find(translation.renamed, shader_name, &glsl::RenamedUniform::shader_name);
    return renamed == translation.renamed.end() ? shader_name : renamed->name;
}

// Drivers leave out the last elements of an array if no shader reads them: a scene's array is the declared one.
void complete(ActiveUniform& array, const glsl::Translation& translation) {
    const auto declared = ranges::find(translation.declared, array.name, &glsl::DeclaredUniform::name);
    if (declared == translation.declared.end() || declared->array_size <= array.array_size) return;
    array.array_size = declared->array_size;
    array.initial.resize(static_cast<std::size_t>(array.components) * static_cast<std::size_t>(array.array_size));
    for (std::size_t i = 0; i < std::min(array.initial.size(), declared->initial.size()); ++i)
        array.initial[i] = declared->initial[i];
}

// Sorts the active uniforms: those that the runtime sets, those that the scene sets, and samplers.
void introspect(LinkedProgram& linked, const Program& program, const glsl::Translation& translation,
                const gl::Caps& caps) {
    const GLuint id = linked.program.get();
    const auto names = glsl::system_names();
    int next_unit = 0;
    glUseProgram(id);  // Emscripten reads the values of the program in use, whatever program it is asked for
    for (gl::Uniform& uniform : gl::active_uniforms(id, caps.program_interface_query)) {
        const std::string_view type = gl::type_name(uniform.type);
        if (type.empty()) continue;
        ActiveUniform active;
        active.name = uniform.name;
        active.glsl_type = type;
        active.type = type_facts(type).type;
        active.components = type_facts(type).components;
        active.array_size = uniform.size;
        const std::vector<double> read = read_values(id, uniform, type_facts(type));
        active.initial = read;
        const bool ours = uniform.name.starts_with("snell_");
        const std::string shader_name = uniform.name;
        uniform.name = active.name = scene_name(uniform.name, translation);
        complete(active, translation);
        if (active.type == ValueType::sampler) {
            SamplerUniform sampler{uniform.name, type, sampler_target(uniform.name, type), uniform.location, next_unit,
                                   uniform.size, {}};
            for (double unit : active.initial) sampler.initial.push_back(static_cast<int>(unit));
            next_unit += uniform.size;
            active.system = set_by_snell(program, uniform.name, type);
            linked.samplers.push_back(std::move(sampler));
        } else if (const auto* system = find_system(names, uniform.name, type, program)) {
            active.system = true;
            const auto floats = static_cast<std::size_t>(active.components * uniform.size);
            linked.system.push_back({system->system, uniform.type, uniform.location, uniform.size, floats, {}});
        } else if (has_sliders_of_elements(program, active)) {
            for (ActiveUniform& element : elements_of(active)) {
                const std::string within = shader_name + element.name.substr(active.name.size());
                const GLint location = glGetUniformLocation(id, within.c_str());
                if (location >= 0)
                    linked.user.push_back({element.name, element.type, uniform.type, location, element.components, 1,
                                           element.initial, element.initial});
                linked.active.push_back(std::move(element));
            }
            continue;
        } else {
            active.system = ours && uniform.name.starts_with("snell_");
            linked.user.push_back({uniform.name, active.type, uniform.type, uniform.location, active.components,
                                   uniform.size, read, read});
        }
        linked.active.push_back(std::move(active));
    }
}

// Lights, materials and fog always have the default values that OpenGL documents.
void set_fixed_function_defaults(LinkedProgram& linked) {
    const auto defaults = glsl::fixed_function_defaults();
    glUseProgram(linked.program.get());
    for (const UserUniform& uniform : linked.user) {
        if (!uniform.name.starts_with("snell_")) continue;
        for (const auto& value : defaults) {
            if (value.name != uniform.name) continue;
            std::vector<float> floats(value.values.begin(), value.values.end());
            const auto count = static_cast<GLsizei>(floats.size()) / uniform.components;
            gl::set_floats(uniform.kind, uniform.location, count, floats.data());
        }
    }
}

// Initial values in the shaders that the target language cannot express are set here. A value with fewer components
// than the uniform sets its first ones.
void take_defaults(LinkedProgram& linked, const glsl::Translation& translation) {
    const auto is = [](std::string_view name, const std::string& shader) {
        return name == shader || (name.ends_with("[0]") && name.substr(0, name.size() - 3) == shader);
    };
    for (const glsl::UniformDefault& value : translation.defaults) {
        for (ActiveUniform& active : linked.active)
            if (is(active.name, value.name))
                std::copy_n(value.values.begin(), std::min(value.values.size(), active.initial.size()),
                            active.initial.begin());
        for (UserUniform& user : linked.user)
            if (is(user.name, value.name))
                std::copy_n(value.values.begin(), std::min(value.values.size(), user.initial.size()),
                            user.initial.begin());
        for (SamplerUniform& sampler : linked.samplers)
            if (is(sampler.name, value.name)) sampler.initial.assign(value.values.begin(), value.values.end());
    }
}

}  // namespace

void find_uniforms(LinkedProgram& linked, const Program& program, const glsl::Translation& translation,
                   const gl::Caps& caps) {
    introspect(linked, program, translation, caps);
    set_fixed_function_defaults(linked);
    take_defaults(linked, translation);
}

// Each sampler gets GL units of its own: one scene unit may hold a 2D texture and a cube map at once, which
// GL does not allow within a program.
void assign_units(const LinkedProgram& linked) {
    glUseProgram(linked.program.get());
    for (const SamplerUniform& sampler : linked.samplers) {
        std::vector<GLint> units(static_cast<size_t>(sampler.size));
        for (int i = 0; i < sampler.size; ++i) units[static_cast<size_t>(i)] = sampler.first_unit + i;
        glUniform1iv(sampler.location, sampler.size, units.data());
    }
}

}  // namespace snell::runtime
