#include "src/runtime/resources/program.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "shaders/embedded.h"
#include "src/plan/texts.h"
#include "src/plan/values/declared.h"
#include "src/runtime/resources/stages.h"

namespace snell::runtime {

GLenum gl_stage(Stage stage) {
    constexpr std::array stages{GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER,
                                GL_FRAGMENT_SHADER};  // as Stage
    return static_cast<GLenum>(stages[static_cast<std::size_t>(stage)]);
}

namespace {

std::vector<gl::AttributeLocation> attribute_locations(const std::vector<glsl::AttributeName>& names) {
    std::vector<gl::AttributeLocation> locations;
    for (const auto& name : names) locations.push_back({name.name, static_cast<GLuint>(name.attribute)});
    return locations;
}

GLenum input_of(std::string_view primitive) {
    return primitive == "points"            ? GL_POINTS
           : primitive == "lines"           ? GL_LINES
           : primitive == "lines_adjacency" ? GL_LINES_ADJACENCY
           : primitive == "triangles"       ? GL_TRIANGLES
                                            : GL_TRIANGLES_ADJACENCY;
}

void note_geometry(LinkedProgram& linked, const glsl::Translation& translation) {
    if (translation.geometry) linked.geometry_input = input_of(translation.geometry->input);
    linked.tessellates = translation.tessellation.has_value();
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
    if (const auto& t = translation.tessellation) {
        add(t->control.text);
        add(fmt::format("{} {} {} {}", t->domain, t->spacing, t->clockwise, t->points));
    }
    if (const auto& g = translation.geometry) {
        add(g->count.text);
        add(g->capture.text);
        add(fmt::format("{} {} {} {}", g->input, g->output, g->invocations, g->vertices));
    }
    std::vector<std::string_view> names;
    for (const UniformValue& uniform : program.uniforms) names.push_back(uniform.name);
    ranges::sort(names);
    for (const std::string_view name : names) add(name);
    for (const glsl::DeclaredUniform& declared : translation.declared)
        if (has_sliders_of_elements(program, described(program, declared))) add(declared.name);
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
    return ranges::any_of(system, [&](const SystemUniform& uniform) { return uniform.system == which; }) ||
           ranges::any_of(parts, [&](const auto& part) { return part->reads(which); });
}

std::vector<std::string> LinkedProgram::functions_naming(std::string_view uniform) const {
    const auto found = ranges::find(declared, base_name(uniform), &glsl::DeclaredUniform::name);
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
    const auto tessellates = [](const glsl::StageInput& stage) { return stage.stage == Stage::tess_evaluation; };
    options.without_stages =
        !request.caps.geometry || (!request.caps.tessellation && ranges::any_of(request.stages, tessellates));
    options.patch_vertices = request.variant.patch;
    options.defines = ladder_defines(request.ladders, request.variant.rungs);
    options.color_outputs = request.variant.outputs;
    // Also for any values: all forms of a program keep the same numbers from being folded.
    options.settle = request.settle ? request.settle : [](const auto&) { return std::vector<glsl::Settled>(); };
    if (request.constant) options.settle = nullptr, options.constant = request.constant;
    return glsl::translate(request.stages, request.sources, options, diagnostics);
}

namespace {

// Mesa names limits without their numbers.
std::string with_limits(std::string log) {
    constexpr std::pair<std::string_view, GLenum> limits[]{
        {"GL_MAX_GEOMETRY_OUTPUT_VERTICES", GL_MAX_GEOMETRY_OUTPUT_VERTICES},
        {"GL_MAX_GEOMETRY_SHADER_INVOCATIONS", GL_MAX_GEOMETRY_SHADER_INVOCATIONS},
        {"GL_MAX_PATCH_VERTICES", GL_MAX_PATCH_VERTICES}};
    for (const auto& [name, which] : limits)
        for (std::size_t at = log.find(name); at != log.npos; at = log.find(name, at + 1)) {
            GLint most = 0;
            glGetIntegerv(which, &most);
            log.insert(at + name.size(), fmt::format(" ({})", most));
        }
    return log;
}

// What the driver says of a shader that it does not compile.
void explain_shader(const std::string& log, const glsl::StageOutput& stage, const glsl::Translation& translation,
                    const LinkRequest& request, Diagnostics& diagnostics) {
    const std::string whole = log_with_includes(stage);
    glsl::explain_log(with_limits(whole.empty() ? log : whole), translation, &stage, request.program.span,
                      request.called, request.sources, diagnostics,
                      whole.empty() ? glsl::Lines::numbered : glsl::Lines::unnumbered);
}

void explain_link(const std::string& log, const glsl::Translation& translation, const LinkRequest& request,
                  Diagnostics& diagnostics) {
    glsl::explain_log(log, translation, nullptr, request.program.span, request.called, request.sources, diagnostics);
}

// Returns null if a stage does not compile, or if the stages do not link.
std::shared_ptr<LinkedProgram> build(const LinkRequest& request, const glsl::Translation& translation,
                                     Diagnostics& diagnostics) {
    auto linked = std::make_shared<LinkedProgram>();
    std::vector<const gl::Shader*> parts;
    for (const glsl::StageOutput& stage : translation.stages) {
        std::string log;
        if (auto shader = compile(stage, request.store, request.counters, log)) {
            parts.push_back(shader.get());
            linked->shaders.push_back(std::move(shader));
        } else {
            explain_shader(log, stage, translation, request, diagnostics);
        }
    }
    if (parts.size() < translation.stages.size()) return nullptr;
    gl::Linked result = gl::link(parts, attribute_locations(glsl::attribute_names()));
    if (!result.program) {
        explain_link(result.log, translation, request, diagnostics);
        return nullptr;
    }
    ++request.counters.programs_compiled;
    linked->program = std::move(result.program);
    return linked;
}

// Returns false, with a diagnostic, if a program whose outputs are captured cannot be made.
bool add_parts(LinkedProgram& linked, const LinkRequest& request, const glsl::Translation& translation,
               Diagnostics& diagnostics) {
    std::vector<std::pair<const glsl::StageOutput*, const std::vector<std::string>*>> stages;
    if (const auto& form = translation.tessellation) stages.emplace_back(&form->control, &form->captured);
    if (const auto& form = translation.geometry) {
        stages.emplace_back(&form->count, &form->counted);
        if (!form->listed) stages.emplace_back(&form->capture, &form->captured);
    }
    for (const auto& [stage, written] : stages) {
        std::string log;
        auto& part = linked.parts.emplace_back(std::make_unique<LinkedProgram>());
        const auto shader = compile(*stage, request.store, request.counters, log);
        if (!shader) {
            explain_shader(log, *stage, translation, request, diagnostics);
            return false;
        }
        gl::Linked made = link_capturing(*shader, *written, request.caps);
        if (!made.program) {
            explain_link(made.log, translation, request, diagnostics);
            return false;
        }
        ++request.counters.programs_compiled;
        part->program = std::move(made.program);
        part->shaders.push_back(shader);
        find_uniforms(*part, request.program, translation, request.caps);
        part->blocks = zeros_for_blocks(part->program.get());
        part->stage_range = glGetUniformLocation(part->program.get(), glsl::stage_range.data());
    }
    linked.tessellation = translation.tessellation;
    linked.geometry = translation.geometry;
    linked.stage_range = glGetUniformLocation(linked.program.get(), glsl::stage_range.data());
    join_parts(linked);
    return true;
}

}  // namespace

std::shared_ptr<LinkedProgram> link_program(const LinkRequest& request, Diagnostics& diagnostics) {
    const Stopwatch watch;
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
    linked->long_loops = translation.long_loops;
    linked->wide = request.variant.wide;
    linked->declared = translation.declared;
    linked->settled = translation.settled;
    note_geometry(*linked, translation);
    find_uniforms(*linked, request.program, translation, request.caps);
    const bool emulated = translation.tessellation || translation.geometry;
    if (emulated && !add_parts(*linked, request, translation, diagnostics)) return nullptr;
    if (!emulated) assign_units(*linked);
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

namespace {

constexpr std::size_t most_values = 64;

// Calls `number` for every number in the text, without its sign.
template <class Function>
void each_number(std::string_view text, const Function& number) {
    const auto digit = [&](std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    const auto in_name = [](char c) {
        return c == '_' || c == '.' || std::isalnum(static_cast<unsigned char>(c)) != 0;
    };
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!digit(at) && !(text[at] == '.' && digit(at + 1))) continue;
        if (at > 0 && in_name(text[at - 1])) continue;
        double value = 0;
        const auto end = read_real(text.data() + at, text.data() + text.size(), value).ptr;
        at = std::max(at, static_cast<std::size_t>(end - text.data()) - 1);
        number(value);
    }
}

// What drivers make of one program. They write the program's name and hashes of its text into their code, too: all are
// linked into one program here, and bytes that a mere comment changes are ignored.
class Code {
public:
    explicit Code(const LinkRequest& request) : request_(request) {}
    bool same(const Control& slider, const Patience& patience);

private:
    // Empty if there is none.
    std::string with(const glsl::Translation& translation);
    glsl::Translation translated(const Control& slider, double value) const;
    static bool may_be_same(const std::string& a, const std::string& b);
    // The bytes of `code` that depend on comments. Empty: these are so many that the others may tell nothing.
    std::vector<bool> remarks_in(const std::string& code, const glsl::Translation& translation);

    const LinkRequest& request_;
    gl::Program program_{glCreateProgram()};
    int links_ = 0;
    // Code that the driver kept from an earlier run would have the name of that run's program.
    std::int64_t run_ = std::chrono::steady_clock::now().time_since_epoch().count();
};

glsl::Translation Code::translated(const Control& slider, double value) const {
    Diagnostics unheard;  // that of the program itself was heard
    LinkRequest one = request_;
    one.constant = glsl::Settled{slider.name, {value}};
    return translate(one, unheard);
}

std::string Code::with(const glsl::Translation& translation) {
    if (!translation.ok || translation.settled.empty() || translation.tessellation || translation.geometry) return {};
    std::vector<gl::Compiled> compiled;
    std::vector<const gl::Shader*> shaders;
    const std::string remark = fmt::format("\n// {} {}\n", run_, links_++);
    for (const glsl::StageOutput& stage : translation.stages) {
        compiled.push_back(gl::compile(gl_stage(stage.stage), stage.text + remark));
        if (!compiled.back().shader) return {};
    }
    for (const gl::Compiled& one : compiled) shaders.push_back(&one.shader);
    return gl::binary_of(program_, shaders);
}

// By comments alone, few bytes change.
bool Code::may_be_same(const std::string& a, const std::string& b) {
    if (a.empty() || a.size() != b.size()) return false;
    std::size_t other = 0;
    for (std::size_t at = 0; at < a.size(); ++at) other += a[at] != b[at] ? 1 : 0;
    return other * 16 <= a.size();
}

std::vector<bool> Code::remarks_in(const std::string& code, const glsl::Translation& translation) {
    std::vector<bool> remarks(code.size(), false);
    for (int i = 0; i < 3; ++i) {  // a byte of a hash may stay the same by chance
        const std::string other = with(translation);
        if (!may_be_same(code, other)) return {};
        for (std::size_t at = 0; at < code.size(); ++at)
            if (code[at] != other[at]) remarks[at] = true;
    }
    return remarks;
}

bool Code::same(const Control& slider, const Patience& patience) {
    const glsl::Translation first = translated(slider, slider.min);
    std::string text;
    for (const glsl::StageOutput& stage : first.stages) text += stage.text;
    const std::vector<double> values = telling_values(slider, text);
    if (values.empty()) return false;
    const std::string code = with(first);
    std::vector<bool> remarks;
    return std::all_of(values.begin() + 1, values.end(), [&](double value) {
        if (patience.ended()) return false;
        const std::string other = with(translated(slider, value));
        if (!may_be_same(code, other)) return false;
        if (remarks.empty()) remarks = remarks_in(code, first);
        if (remarks.empty()) return false;
        for (std::size_t at = 0; at < code.size(); ++at)
            if (code[at] != other[at] && !remarks[at]) return false;
        return true;
    });
}

}  // namespace

std::vector<double> telling_values(const Control& slider, std::string_view text) {
    if (slider.type == ValueType::bool_) return {0, 1};
    std::set<double> values{slider.min, slider.max};
    if (slider.type == ValueType::int_ || slider.type == ValueType::uint_) {
        if (slider.max - slider.min >= most_values) return {};
        for (double value = slider.min; value < slider.max; ++value) values.insert(value);
    } else {
        for (int i = 1; i < 8; ++i) values.insert(slider.min + (slider.max - slider.min) * i / 8);
        each_number(text, [&](double number) {
            for (const double value : {number, -number})
                if (value > slider.min && value < slider.max) values.insert(value);
        });
        const std::vector<double> ends(values.begin(), values.end());
        for (std::size_t i = 1; i < ends.size(); ++i) values.insert(ends[i - 1] / 2 + ends[i] / 2);
        if (values.size() > most_values) return {};
    }
    std::vector<double> ordered(values.begin(), values.end());
    std::rotate(ordered.begin() + 1, ordered.end() - 1, ordered.end());
    return ordered;
}

std::vector<const Control*> without_effect(const LinkRequest& request, std::vector<const Control*> sliders,
                                           const Patience& patience) {
    if (sliders.empty() || patience.ended() || !gl::gives_binaries()) return {};
    Code code(request);
    std::erase_if(sliders, [&](const Control* slider) { return !code.same(*slider, patience); });
    return sliders;
}

}  // namespace snell::runtime
