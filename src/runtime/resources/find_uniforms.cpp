// Finds the uniforms of a linked program, and decides whether snell or the scene sets each.
#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/runtime/resources/program.h"
#include "src/runtime/resources/tree.h"

namespace snell::runtime {

namespace {

struct TypeFacts {
    ValueType type = ValueType::float_;
    int components = 1;
};

TypeFacts facts(std::string_view type) {
    if (type.find("sampler") != std::string_view::npos) return {ValueType::sampler, 1};
    const char last = type.empty() ? '1' : type.back();
    const int digit = last >= '2' && last <= '4' ? last - '0' : 1;
    if (type.starts_with("mat")) return {ValueType::matrix, (type[3] - '0') * digit};
    switch (type.empty() ? 'f' : type[0]) {
        case 'i':
            return {ValueType::int_, digit};
        case 'u':
            return {ValueType::uint_, digit};
        case 'b':
            return {ValueType::bool_, digit};
        case 'd':
            return {ValueType::double_, digit};
        default:
            return {ValueType::float_, digit};
    }
}

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

bool scene_sets(const Program& program, std::string_view name) {
    return ranges::any_of(program.uniforms, [&](const UniformValue& u) { return u.name == name; });
}

const glsl::SystemName* find_system(const std::vector<glsl::SystemName>& names, std::string_view name,
                                    std::string_view type, const Program& program) {
    for (const glsl::SystemName& candidate : names)
        if (candidate.name == name && candidate.type == type && (candidate.legacy || !scene_sets(program, name)))
            return &candidate;
    return nullptr;
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
        active.type = facts(type).type;
        active.components = facts(type).components;
        active.array_size = uniform.size;
        active.initial = read_values(id, uniform, facts(type));
        const bool ours = uniform.name.starts_with("snell_");
        uniform.name = active.name = scene_name(uniform.name, translation);
        if (active.type == ValueType::sampler) {
            SamplerUniform sampler{uniform.name, type, sampler_target(type), uniform.location, next_unit,
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

bool set_by_snell(const Program& program, std::string_view name, std::string_view type) {
    const bool sampler = facts(type).type == ValueType::sampler;
    if (sampler) return (name == "Noise2" || name == "Noise3" || tree_part(name, type)) && !scene_sets(program, name);
    return name.starts_with("snell_") || find_system(glsl::system_names(), name, type, program) != nullptr;
}

ActiveUniform described(const Program& program, const glsl::DeclaredUniform& declared) {
    ActiveUniform uniform;
    uniform.name = declared.name;
    uniform.glsl_type = declared.glsl_type;
    uniform.type = facts(declared.glsl_type).type;
    uniform.components = facts(declared.glsl_type).components;
    uniform.array_size = std::max(declared.array_size, 1);
    uniform.system = set_by_snell(program, declared.name, declared.glsl_type);
    uniform.initial = declared.initial;
    uniform.initial.resize(static_cast<std::size_t>(uniform.components) * static_cast<std::size_t>(uniform.array_size));
    return uniform;
}

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
