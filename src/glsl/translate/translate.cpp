#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

void read_unit(Program& program, Unit& u, FileId file) {
    const std::size_t before = program.diagnostics.errors();
    preprocess(u, file, program.sources, program.options, program.diagnostics);
    refuse_deep_nesting(program, u);
    // Drivers have a message that misleads. One that an error has emptied, such as a missing include, has its cause.
    if (u.tokens.size() == 1 && program.diagnostics.errors() == before)
        program.diagnostics.error("glsl-no-main", program.sources.line_span(file, 1),
                                  "this shader is empty: there is no function 'main'",
                                  "every shader starts at 'void main()'");
    mend_words(program, u);
}

void read_units(Program& program, const std::vector<StageInput>& stages) {
    program.units.reserve(stages.size() + 2);
    for (const StageInput& input : stages) {
        Unit u;
        u.stage = input.stage;
        u.reference = input.reference;
        read_unit(program, u, input.file);
        program.units.push_back(std::move(u));
    }
    std::stable_sort(program.units.begin(), program.units.end(),
                     [](const Unit& a, const Unit& b) { return a.stage < b.stage; });
}

bool is_loop(const Token& t) { return t.text == "for" || t.text == "while"; }

void parse(Program& program) {
    for (Unit& u : program.units) {
        // Only OpenGL ES has loops of other stages count, and pictures of fewer pixels take the time of those as well.
        const bool asked = program.target().es || u.stage == Stage::fragment;
        if (asked && ranges::any_of(u.tokens, is_loop)) u.tree = &program.trees[u.stage];
        Parser(u, program.target(), program.diagnostics, program.options.settle != nullptr).run();
    }
}

void add_default(Program& program, Stage stage, std::string text, std::string name) {
    Unit u;
    u.stage = stage;
    u.built_in = true;
    read_unit(program, u, program.sources.add(std::move(name), std::move(text)));
    program.units.push_back(std::move(u));
}

void add_missing_stages(Program& program) {
    if (!program.find(Stage::vertex))
        add_default(program, Stage::vertex, default_vertex_shader(program), "<built-in vertex shader>");
    if (!program.find(Stage::fragment))
        add_default(program, Stage::fragment, default_fragment_shader(), "<built-in fragment shader>");
    std::stable_sort(program.units.begin(), program.units.end(),
                     [](const Unit& a, const Unit& b) { return a.stage < b.stage; });
}

// Every type that has no precision of its own gets one. A text that begins with such statements itself needs
// none, unless declarations of ours come before it.
void add_precision(Unit& u) {
    std::set<std::string_view> there, used = {"float", "int"};
    for (std::size_t i = 0; i + 3 < u.tokens.size() && u.tokens[i].text == "precision"; i += 4)
        if (u.header.empty()) there.insert(u.tokens[i + 2].text);
    for (const Token& t : u.tokens)
        if (t.text.starts_with("sampler") || t.text.starts_with("isampler") || t.text.starts_with("usampler"))
            if (builtin_type(t.text)) used.insert(t.text == "sampler1D" ? std::string_view("sampler2D") : t.text);
    std::string lines;
    for (const std::string_view type : used)
        if (!there.contains(type)) lines += "precision highp " + std::string(type) + ";\n";
    u.header.insert(0, lines);
}

void want_extensions(const Target& target, Unit& u) {
    if (target.es || target.version >= 400) return;
    if (u.stage == Stage::tess_control || u.stage == Stage::tess_evaluation)
        u.wanted_extensions.emplace_back("GL_ARB_tessellation_shader");
    if (u.version >= 400 && u.profile != "es") u.wanted_extensions.emplace_back("GL_ARB_gpu_shader5");
    const bool doubles = std::any_of(u.tokens.begin(), u.tokens.end(), [](const Token& t) {
        return t.kind == Kind::identifier &&
               (t.text == "double" || t.text.starts_with("dvec") || t.text.starts_with("dmat"));
    });
    if (doubles && target.fp64) u.wanted_extensions.emplace_back("GL_ARB_gpu_shader_fp64");
}

// Says where a stage has the name first, if it does.
void refuse(const Program& program, const Unit& u, std::string_view name, const char* code, std::string message,
            std::string help) {
    const auto found = ranges::find(u.tokens, name, &Token::text);
    if (found == u.tokens.end()) return;
    const Span span = u.span(static_cast<int>(found - u.tokens.begin()));
    program.diagnostics.error(code, span, std::move(message), std::move(help));
}

// OpenGL ES does not clip by distances, and before 3.2 it has the vertex and the fragment stage only, and no texture
// buffers.
void refuse_late_features(const Program& program) {
    if (!program.target().es) return;
    const bool plain = ranges::none_of(
        program.units, [](const Unit& u) { return u.stage == Stage::geometry || u.stage == Stage::tess_evaluation; });
    for (const Unit& u : program.units) {
        for (const char* const name : {"gl_ClipDistance", "gl_CullDistance"})
            refuse(program, u, name, "unsupported-variable", "OpenGL ES has no '" + std::string(name) + "'",
                   "to cut something off, pass the distance on, and discard fragments where it is negative");
        if (program.target().version >= 320) continue;
        refuse(program, u, "samplerBuffer", "unsupported-type", "OpenGL ES 3.0 has no texture buffers (samplerBuffer)",
               "they are in OpenGL 3.1 and OpenGL ES 3.2");
        if (u.stage != Stage::vertex && u.stage != Stage::fragment && !program.options.without_stages)
            program.diagnostics.error("unsupported-stage", u.reference,
                                      "OpenGL ES 3.0 has no geometry and tessellation shaders");
        if (u.stage == Stage::fragment && plain)
            refuse(program, u, "gl_PrimitiveID", "unsupported-variable",
                   "OpenGL ES 3.0 has no 'gl_PrimitiveID' in fragment shaders",
                   "a geometry shader can give it: 'gl_PrimitiveID = gl_PrimitiveIDIn;' before EmitVertex()");
    }
}

}  // namespace

// Where the scene's size counts and not the shader's, as PointSizeMode says, it is above 0.
void give_point_size(Unit& vertex) {
    if (mentions(vertex, "snell_PointSize") || mentions(vertex, "snell_FixedPointSize")) return;  // translated before
    if (mentions(vertex, "gl_PointSize")) {
        declare_once(vertex, "snell_FixedPointSize", "uniform float snell_FixedPointSize;");
        return at_main_end(vertex, "if (snell_FixedPointSize > 0.0) gl_PointSize = snell_FixedPointSize;");
    }
    declare_once(vertex, "snell_PointSize", "uniform float snell_PointSize;");
    at_main_end(vertex, "gl_PointSize = snell_PointSize;");
}

Translation translate(const std::vector<StageInput>& stages, Sources& sources, const Options& options,
                      Diagnostics& diagnostics) {
    Options own = options;
    Program program{own, sources, diagnostics, {}, {}, {}, {}};
    const std::size_t errors = diagnostics.errors();
    read_units(program, stages);
    refuse_late_features(program);
    add_missing_stages(program);
    rename_words(program);
    parse(program);
    own.without_stages = own.without_stages || lacks_of_stages(program);

    const bool plain_depth = has_plain_depth(program);
    std::string placed = placed_by(program);
    for (Unit& u : program.units) {
        separate_functions(u);
        want_extensions(options.target, u);
        provide_helpers(options.target, u);
        if (u.stage == Stage::geometry) complete_geometry(program, u);
        if (u.stage == Stage::tess_control) choose_levels(u);
    }
    size_arrays(program);
    unify_uniforms(program);
    flatten_blocks(program);
    match_interfaces(program);
    for (Unit& u : program.units) give_outputs(program, u);
    if (Unit* vertex = program.find(Stage::vertex)) assign_attributes(program, *vertex);
    program.declared = declared_uniforms(program);
    choose_settled(program);
    resolve_marks(program);
    write_constant(program);
    if (Unit* fragment = program.find(Stage::fragment)) assign_outputs(program, *fragment);
    replace_legacy(program);
    if (options.target.es && program.units.size() == 2) give_point_size(program.units.front());
    const bool numbers = passes_numbers(program);
    const std::optional<std::string> lines = widen_lines(program);

    Translation out;
    out.reads_place = place_in_picture(program);
    out.plain_depth = !lines && plain_depth;
    if (!lines) out.placed_by = std::move(placed);
    for (Unit& u : program.units) {
        if (lines && u.stage == Stage::fragment)
            out.stages.push_back({Stage::geometry, *lines, {sources.add("<built-in geometry shader>", *lines)}});
        declare_functions(program, u);
        copy_assigned(program, u);
        if (auto loops = long_loops(u, options.target.es)) out.long_loops.push_back(std::move(*loops));
        move_initialisers(program, u);
        write_declarations(program, u);
        if (options.target.es) add_precision(u);
        out.stages.push_back({u.stage, emit(program, u), u.files, std::move(u.misfits)});
    }
    const Unit* fragment = program.find(Stage::fragment);
    out.uses_alpha = !fragment || !fragment->alpha_known || fragment->alpha_unknown;
    out.defaults = std::move(program.defaults);
    out.renamed = std::move(program.renamed);
    out.declared = std::move(program.declared);
    out.settled = std::move(program.settled);
    if (own.without_stages && diagnostics.errors() == errors) emulate_stages(program, out);
    if (lines && numbers && diagnostics.errors() == errors) emulate_geometry(program, out);
    if (out.stages.size() == 2 && numbers && diagnostics.errors() == errors) pass_numbers(program, out);
    out.ok = diagnostics.errors() == errors;
    return out;
}

}  // namespace snell::glsl
