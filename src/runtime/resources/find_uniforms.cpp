// Finds the uniforms of a linked program, and decides whether snell or the scene sets each.
#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/plan/values/declared.h"
#include "src/runtime/resources/program.h"

namespace snell::runtime {

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
        active.initial = read_values(id, uniform, type_facts(type));
        const bool ours = uniform.name.starts_with("snell_");
        uniform.name = active.name = scene_name(uniform.name, translation);
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
        } else {
            active.system = ours && uniform.name.starts_with("snell_");
            linked.user.push_back({uniform.name, active.type, uniform.type, uniform.location, active.components,
                                   uniform.size, active.initial, active.initial});
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
