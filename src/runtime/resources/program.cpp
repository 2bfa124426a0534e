#include "src/runtime/resources/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "parser/text/ranges.h"
#include "shaders/embedded.h"
#include "src/plan/texts.h"
#include "src/runtime/resources/counters.h"

namespace snell::runtime {

GLenum gl_stage(Stage stage) {
    constexpr std::array stages{GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER,
                                GL_FRAGMENT_SHADER};  // as Stage
    return static_cast<GLenum>(stages[static_cast<std::size_t>(stage)]);
}

namespace {

bool stages_supported(const LinkRequest& request, Diagnostics& diagnostics) {
    const gl::Caps& caps = request.caps;
    bool ok = true;
    for (const glsl::StageInput& stage : request.stages) {
        const bool tessellation = stage.stage == Stage::tess_control || stage.stage == Stage::tess_evaluation;
        const bool missing = (tessellation && !caps.tessellation) || (stage.stage == Stage::geometry && !caps.geometry);
        if (!missing) continue;
        ok = false;
        diagnostics.error("stage-unsupported", stage.reference,
                          fmt::format("program '{}' needs {} shaders, which this OpenGL ({}) does not have",
                                      request.program.name, tessellation ? "tessellation" : "geometry", caps.version));
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

// Two programs of one key are equal: the key holds what the driver sees, and the names of uniforms in the scene.
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
    for (const glsl::Settled& settled : translation.settled) add(fmt::format("{}={}", settled.name, settled.values[0]));
    add(fmt::format("{}{}", translation.uses_alpha, translation.plain_depth));
    add(translation.placed_by);
    std::vector<std::string_view> names;
    for (const UniformValue& uniform : program.uniforms) names.push_back(uniform.name);
    ranges::sort(names);
    for (const std::string_view name : names) add(name);
    return key;
}

// No command fills a scene's own uniform blocks: they read zeros. Browsers draw nothing where a block has no buffer.
gl::Buffer zeros_for_blocks(GLuint program) {
    GLint blocks = 0, most = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &blocks);
    for (GLuint i = 0; i < static_cast<GLuint>(blocks); ++i) {
        GLint bytes = 0;
        glGetActiveUniformBlockiv(program, i, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
        glUniformBlockBinding(program, i, 0);
        most = std::max(most, bytes);
    }
    if (most == 0) return {};
    gl::Buffer buffer(gl::make(glGenBuffers));
    const std::vector<std::byte> zeros(static_cast<std::size_t>(most));
    glBindBuffer(GL_UNIFORM_BUFFER, buffer.get());
    glBufferData(GL_UNIFORM_BUFFER, most, zeros.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    return buffer;
}

// Returns null and sets `log` if the shader does not compile.
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

// What the driver says of a shader with included files, by its lines in the whole text; empty if there are none.
std::string log_with_includes(const glsl::StageOutput& stage) {
    if (stage.files.size() < 2) return {};
    gl::Compiled again = gl::compile(gl_stage(stage.stage), glsl::unnumbered(stage.text));
    return again.shader ? std::string() : std::move(again.log);
}

}  // namespace

bool LinkedProgram::reads(glsl::System which) const {
    return ranges::any_of(system, [&](const SystemUniform& uniform) { return uniform.system == which; });
}

std::vector<std::string> LinkedProgram::functions_naming(std::string_view uniform) const {
    const std::string_view name = uniform.substr(0, uniform.find_first_of(".["));
    const auto found = ranges::find(declared, name, &glsl::DeclaredUniform::name);
    return found == declared.end() ? std::vector<std::string>() : found->functions;
}

glsl::Translation translate(const LinkRequest& request, Diagnostics& diagnostics) {
    glsl::Options options;
    options.target = {request.caps.glsl, request.caps.es, request.caps.fp64};
    options.geometry_input = request.program.geometry_input;
    options.geometry_output = request.program.geometry_output;
    options.include = shader_includes(request.files);
    options.limits = request.files.limits();
    options.flat_color = request.variant.flat;
    options.wide_lines = request.variant.wide;
    options.placed = request.variant.placed;
    options.defines = ladder_defines(request.ladders, request.variant.rungs);
    options.color_outputs = request.variant.outputs;
    // Also for any values: all forms of a program keep the same numbers from being folded.
    options.settle = request.settle ? request.settle : [](const auto&) { return std::vector<glsl::Settled>(); };
    options.find_uses = request.settle != nullptr;
    if (request.constant) options.settle = nullptr, options.constant = request.constant;
    return glsl::translate(request.stages, request.sources, options, diagnostics);
}

namespace {

// Returns null if a stage does not compile, or if the stages do not link.
std::shared_ptr<LinkedProgram> build(const LinkRequest& request, const glsl::Translation& translation,
                                     Diagnostics& diagnostics) {
    const auto explain = [&](const std::string& log, const glsl::StageOutput* stage,
                             glsl::Lines lines = glsl::Lines::numbered) {
        glsl::explain_log(log, translation, stage, request.program.span, request.program.name, request.sources,
                          diagnostics, lines);
    };
    auto linked = std::make_shared<LinkedProgram>();
    std::vector<const gl::Shader*> parts;
    for (const glsl::StageOutput& stage : translation.stages) {
        std::string log;
        if (auto shader = compile(stage, request.store, request.counters, log)) {
            parts.push_back(shader.get());
            linked->shaders.push_back(std::move(shader));
        } else if (const std::string whole = log_with_includes(stage); !whole.empty()) {
            explain(whole, &stage, glsl::Lines::unnumbered);
        } else {
            explain(log, &stage);
        }
    }
    if (parts.size() < translation.stages.size()) return nullptr;
    gl::Linked result = gl::link(parts, attribute_locations(glsl::attribute_names()));
    if (!result.program) {
        explain(result.log, nullptr);
        return nullptr;
    }
    ++request.counters.programs_compiled;
    linked->program = std::move(result.program);
    return linked;
}

}  // namespace

std::shared_ptr<LinkedProgram> link_program(const LinkRequest& request, Diagnostics& diagnostics) {
    const Stopwatch watch;
    if (!stages_supported(request, diagnostics)) return nullptr;
    const glsl::Translation translation = translate(request, diagnostics);
    if (!translation.ok) return nullptr;
    const std::string key = key_of(request.program, translation);
    Diagnostics none_said;
    if (auto known = request.store ? request.store->programs.take(key, {}, none_said) : nullptr) {
        known->declared = translation.declared;  // at the places of these sources
        return known;
    }
    auto linked = build(request, translation, diagnostics);
    if (!linked) return nullptr;
    linked->opaque = !translation.uses_alpha;
    linked->plain_depth = translation.plain_depth;
    linked->in_place = !translation.placed_by.empty() &&
                       ranges::count(request.program.uniforms, translation.placed_by, &UniformValue::name) == 0;
    linked->reads_place = translation.reads_place;
    linked->wide = request.variant.wide;
    linked->declared = translation.declared;
    linked->settled = translation.settled;
    note_geometry(*linked, translation);
    find_uniforms(*linked, request.program, translation, request.caps);
    assign_units(*linked);
    linked->blocks = zeros_for_blocks(linked->program.get());
    linked->load_ms = watch.milliseconds();
    if (request.store) request.store->programs.put(key, linked, {}, none_said, 0);
    return linked;
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
    auto linked = link_program({program, stages, {}, variant, caps, files, sources, store, counters}, diagnostics);
    if (!linked) throw std::runtime_error("the built-in program failed:\n" + render(diagnostics, sources));
    return linked;
}

}  // namespace snell::runtime
