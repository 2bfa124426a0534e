#include "src/runtime/resources/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "shaders/embedded.h"
#include "src/runtime/resources/stopwatch.h"
#include "src/runtime/resources/tree.h"

namespace snell::runtime {

namespace {

GLenum gl_stage(Stage stage) {
    switch (stage) {
        case Stage::vertex:
            return GL_VERTEX_SHADER;
        case Stage::tess_control:
            return GL_TESS_CONTROL_SHADER;
        case Stage::tess_evaluation:
            return GL_TESS_EVALUATION_SHADER;
        case Stage::geometry:
            return GL_GEOMETRY_SHADER;
        case Stage::fragment:
            return GL_FRAGMENT_SHADER;
    }
    return GL_VERTEX_SHADER;
}

struct TypeFacts {
    ValueType type = ValueType::float_;
    int components = 1;
};

TypeFacts facts(std::string_view type) {
    TypeFacts result;
    if (type.find("sampler") != std::string_view::npos) return {ValueType::sampler, 1};
    const char last = type.empty() ? '1' : type.back();
    const int digit = last >= '2' && last <= '4' ? last - '0' : 1;
    if (type.starts_with("mat")) {
        const int columns = type[3] - '0';
        return {ValueType::matrix, columns * digit};
    }
    result.components = digit;
    switch (type.empty() ? 'f' : type[0]) {
        case 'i':
            result.type = ValueType::int_;
            break;
        case 'u':
            result.type = ValueType::uint_;
            break;
        case 'b':
            result.type = ValueType::bool_;
            break;
        case 'd':
            result.type = ValueType::double_;
            break;
        default:
            result.type = ValueType::float_;
            break;
    }
    return result;
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
    return std::ranges::any_of(program.uniforms, [&](const UniformValue& u) { return u.name == name; });
}

const glsl::SystemName* find_system(const std::vector<glsl::SystemName>& names, std::string_view name,
                                    std::string_view type, const Program& program) {
    for (const glsl::SystemName& candidate : names)
        if (candidate.name == name && candidate.type == type && (candidate.legacy || !scene_sets(program, name)))
            return &candidate;
    return nullptr;
}

// What the scene calls a uniform that the translation had to rename.
std::string scene_name(const std::string& shader_name, const glsl::Translation& translation) {
    const auto renamed = std::ranges::find(translation.renamed, shader_name, &glsl::RenamedUniform::shader_name);
    return renamed == translation.renamed.end() ? shader_name : renamed->name;
}

// Sorts the active uniforms into what the runtime sets, what the scene sets and samplers.
void introspect(LinkedProgram& linked, const Program& program, const glsl::Translation& translation,
                const gl::Caps& caps) {
    const GLuint id = linked.program.get();
    const auto names = glsl::system_names();
    int next_unit = 0;
    for (gl::Uniform& uniform : gl::active_uniforms(id, caps.program_interface_query)) {
        const std::string_view type = gl::type_name(uniform.type);
        if (type.empty()) continue;
        ActiveUniform active;
        active.name = uniform.name;
        active.glsl_type = type;
        active.type = facts(type).type;
        active.components = facts(type).components;
        active.array_size = uniform.size;
        active.location = uniform.location;
        active.initial = read_values(id, uniform, facts(type));
        const bool ours = uniform.name.starts_with("snell_");
        uniform.name = active.name = scene_name(uniform.name, translation);
        if (active.type == ValueType::sampler) {
            SamplerUniform sampler{uniform.name, type, sampler_target(type), uniform.location, next_unit,
                                   uniform.size, {}};
            for (double unit : active.initial) sampler.initial.push_back(static_cast<int>(unit));
            next_unit += uniform.size;
            active.system = (uniform.name == "Noise2" || uniform.name == "Noise3" || tree_part(uniform.name, type)) &&
                            !scene_sets(program, uniform.name);
            linked.samplers.push_back(std::move(sampler));
        } else if (const auto* system = find_system(names, uniform.name, type, program)) {
            active.system = true;
            linked.system.push_back({system->system, uniform.location, uniform.size, {}});
        } else {
            active.system = ours && uniform.name.starts_with("snell_");
            linked.user.push_back({uniform.name, type, active.type, uniform.location, active.components, uniform.size,
                                   active.initial, active.initial});
        }
        linked.active.push_back(std::move(active));
    }
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

// Lights, materials and fog have the values that OpenGL documents, once and for all.
void set_fixed_function_defaults(LinkedProgram& linked) {
    const auto defaults = glsl::fixed_function_defaults();
    glUseProgram(linked.program.get());
    for (const UserUniform& uniform : linked.user) {
        if (!uniform.name.starts_with("snell_")) continue;
        for (const auto& value : defaults) {
            if (value.name != uniform.name) continue;
            std::vector<float> floats(value.values.begin(), value.values.end());
            const auto count = static_cast<GLsizei>(floats.size()) / uniform.components;
            switch (uniform.components) {
                case 1:
                    glUniform1fv(uniform.location, count, floats.data());
                    break;
                case 2:
                    glUniform2fv(uniform.location, count, floats.data());
                    break;
                case 3:
                    glUniform3fv(uniform.location, count, floats.data());
                    break;
                default:
                    glUniform4fv(uniform.location, count, floats.data());
                    break;
            }
        }
    }
}

// Values that the shaders name and the target has no words for: they become the uniforms' own. A value with
// fewer components than the uniform is its beginning.
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

bool stages_supported(const std::vector<glsl::StageInput>& stages, const Program& program, const gl::Caps& caps,
                      Diagnostics& diagnostics) {
    bool ok = true;
    for (const glsl::StageInput& stage : stages) {
        const bool tessellation = stage.stage == Stage::tess_control || stage.stage == Stage::tess_evaluation;
        const bool missing = (tessellation && !caps.tessellation) || (stage.stage == Stage::geometry && !caps.geometry);
        if (!missing) continue;
        ok = false;
        diagnostics.error("stage-unsupported", stage.reference,
                          fmt::format("program '{}' needs {} shaders, which this OpenGL ({}) does not have",
                                      program.name, tessellation ? "tessellation" : "geometry", caps.version));
    }
    return ok;
}

std::vector<gl::AttributeLocation> attribute_locations(const std::vector<glsl::AttributeName>& names) {
    std::vector<gl::AttributeLocation> locations;
    for (const auto& name : names) locations.push_back({name.name, static_cast<GLuint>(name.attribute)});
    return locations;
}

void note_geometry(LinkedProgram& linked, const glsl::Translation& translation) {
    for (const auto& stage : translation.stages) {
        if (stage.stage == Stage::tess_evaluation) linked.tessellates = true;
        if (stage.stage != Stage::geometry) continue;
        GLint input = 0;
        glGetProgramiv(linked.program.get(), GL_GEOMETRY_INPUT_TYPE, &input);
        linked.geometry_input = static_cast<GLenum>(input);
    }
}

// All that a linked program is made from: what the driver sees, and what the scene calls its uniforms.
std::string key_of(const Program& program, const glsl::Translation& translation) {
    std::string key;
    const auto add = [&key](std::string_view text) { (key += text) += '\0'; };
    for (const glsl::StageOutput& stage : translation.stages)
        add(std::to_string(static_cast<int>(stage.stage)) + stage.text);
    for (const glsl::UniformDefault& value : translation.defaults) {
        add(value.name);
        for (const double number : value.values) add(fmt::format("{}", number));
    }
    for (const glsl::RenamedUniform& renamed : translation.renamed) add(renamed.name + '=' + renamed.shader_name);
    add(fmt::format("{}{}", translation.uses_alpha, translation.plain_depth));
    std::vector<std::string_view> names;
    for (const UniformValue& uniform : program.uniforms) names.push_back(uniform.name);
    std::ranges::sort(names);
    for (const std::string_view name : names) add(name);
    return key;
}

std::size_t block_bytes() {
    GLint bytes = 0;
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(std::max(bytes, 0));
}

// Null when it failed.
std::shared_ptr<gl::Shader> compile(const glsl::StageOutput& stage, Store* store, Counters& counters,
                                    std::string& log) {
    const std::string key = std::to_string(static_cast<int>(stage.stage)) + stage.text;
    Diagnostics said;
    if (auto known = store ? store->shaders.take(key, {}, said) : nullptr) return known;
    gl::Compiled compiled = gl::compile(gl_stage(stage.stage), stage.text);
    log = std::move(compiled.log);
    if (!compiled.shader) return nullptr;
    ++counters.shaders_compiled;
    auto shader = std::make_shared<gl::Shader>(std::move(compiled.shader));
    if (store) store->shaders.put(key, shader, {}, said, 0);
    return shader;
}

}  // namespace

glsl::IncludeReader include_reader(Files& files) {
    return [&files](std::string_view from, std::string_view name, bool angle) -> std::optional<glsl::IncludeText> {
        if (angle) {
            const std::string_view text = embedded_shader(name);
            if (text.empty()) return std::nullopt;
            return glsl::IncludeText{std::string(name), std::string(text)};
        }
        const Resolved resolved = files.resolve_beside(from, name, {"glsl"});
        std::string error;
        const auto text = resolved.path.empty() ? nullptr : files.read_once(resolved.path, error);
        if (!text) return std::nullopt;
        return glsl::IncludeText{resolved.path, *text};
    };
}

bool LinkedProgram::reads(glsl::System which) const {
    return std::ranges::any_of(system, [&](const SystemUniform& uniform) { return uniform.system == which; });
}

std::shared_ptr<LinkedProgram> link_program(const Program& program, const std::vector<glsl::StageInput>& stages,
                                            std::span<const Ladder> ladders, const Variant& variant,
                                            const gl::Caps& caps, Files& files, Sources& sources, Store* store,
                                            Counters& counters, Diagnostics& diagnostics) {
    const Stopwatch watch;
    if (!stages_supported(stages, program, caps, diagnostics)) return nullptr;
    glsl::Options options;
    options.target = {caps.glsl, caps.es, caps.fp64};
    options.geometry_input = program.geometry_input;
    options.geometry_output = program.geometry_output;
    options.include = include_reader(files);
    options.limits = files.limits();
    options.flat_color = variant.flat;
    options.wide_lines = variant.wide;
    options.placed = variant.placed;
    options.defines = ladder_defines(ladders, variant.rungs);
    options.color_outputs = variant.outputs;
    const glsl::Translation translation = glsl::translate(stages, sources, options, diagnostics);
    if (!translation.ok) return nullptr;
    const std::string key = key_of(program, translation);
    Diagnostics none_said;
    if (auto known = store ? store->programs.take(key, {}, none_said) : nullptr) return known;

    auto linked = std::make_shared<LinkedProgram>();
    for (const glsl::StageOutput& stage : translation.stages) {
        std::string log;
        auto shader = compile(stage, store, counters, log);
        if (shader)
            linked->shaders.push_back(std::move(shader));
        else
            glsl::explain_log(log, translation, &stage, program.span, program.name, sources, diagnostics);
    }
    if (linked->shaders.size() < translation.stages.size()) return nullptr;

    std::vector<const gl::Shader*> parts;
    for (const auto& shader : linked->shaders) parts.push_back(shader.get());
    const auto names = glsl::attribute_names();
    gl::Linked result = gl::link(parts, attribute_locations(names));
    if (!result.program) {
        glsl::explain_log(result.log, translation, nullptr, program.span, program.name, sources, diagnostics);
        return nullptr;
    }
    ++counters.programs_compiled;
    linked->program = std::move(result.program);
    linked->opaque = !translation.uses_alpha;
    linked->plain_depth = translation.plain_depth;
    linked->reads_place = translation.reads_place;
    linked->wide = variant.wide;
    note_geometry(*linked, translation);
    introspect(*linked, program, translation, caps);
    assign_units(*linked);
    set_fixed_function_defaults(*linked);
    take_defaults(*linked, translation);
    linked->instanced = instanced_text(translation, block_bytes());
    linked->load_ms = watch.milliseconds();
    if (store) store->programs.put(key, linked, {}, none_said, 0);
    return linked;
}

// Whatever fails here fails silently: the draws are done one by one then.
const Instancing* make_instancing(LinkedProgram& linked, const Program& program, const gl::Caps& caps,
                                  Counters& counters) {
    if (linked.instancing) return linked.instancing->program ? &*linked.instancing : nullptr;
    linked.instancing.emplace();
    if (linked.instanced.text.empty() || linked.shaders.size() != 2) return nullptr;
    gl::Compiled vertex = gl::compile(GL_VERTEX_SHADER, linked.instanced.text);
    if (!vertex.shader) return nullptr;
    const auto names = glsl::attribute_names();
    gl::Linked result = gl::link({&vertex.shader, linked.shaders[1].get()}, attribute_locations(names));
    if (!result.program) return nullptr;
    auto many = std::make_shared<LinkedProgram>();
    many->program = std::move(result.program);
    many->opaque = linked.opaque;
    introspect(*many, program, {}, caps);
    // What is bound for the one is bound for the other.
    for (SamplerUniform& sampler : many->samplers) {
        const auto same = std::ranges::find(linked.samplers, sampler.name, &SamplerUniform::name);
        if (same == linked.samplers.end() || same->size != sampler.size) return nullptr;
        sampler.first_unit = same->first_unit;
    }
    assign_units(*many);
    set_fixed_function_defaults(*many);
    ++counters.programs_compiled;
    ++counters.shaders_compiled;
    ++counters.variants;
    linked.instancing = {std::move(many), linked.instanced.matrices, linked.instanced.capacity};
    return &*linked.instancing;
}

std::shared_ptr<LinkedProgram> link_builtin(const Variant& variant, const gl::Caps& caps, Store* store,
                                            Counters& counters) {
    Sources sources;
    Diagnostics diagnostics;
    Files files("");
    Program program;
    program.name = "built-in";
    std::vector<glsl::StageInput> stages;
    for (const auto& [stage, name] :
         {std::pair(Stage::vertex, "builtin/color.vert"), std::pair(Stage::fragment, "builtin/color.frag")})
        stages.push_back({stage, sources.add(name, std::string(embedded_shader(name))), {}});
    auto linked = link_program(program, stages, {}, variant, caps, files, sources, store, counters, diagnostics);
    if (!linked) throw std::runtime_error("the built-in program failed:\n" + render(diagnostics, sources));
    return linked;
}

}  // namespace snell::runtime
