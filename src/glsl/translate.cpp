#include <algorithm>

#include "src/glsl/parse.h"
#include "src/glsl/preprocess.h"
#include "src/glsl/program.h"

namespace snell::glsl {

namespace {

void read_unit(Program& program, Unit& u, FileId file) {
    preprocess(u, file, program.sources, program.options, program.diagnostics);
    mend_words(program, u);
    Parser(u, program.target(), program.diagnostics).run();
}

void add_default(Program& program, Stage stage, std::string text, std::string name) {
    Unit u;
    u.stage = stage;
    read_unit(program, u, program.sources.add(std::move(name), std::move(text)));
    program.units.push_back(std::move(u));
}

void add_missing_stages(Program& program) {
    if (!program.find(Stage::vertex))
        add_default(program, Stage::vertex, default_vertex_shader(program), "<built-in vertex shader>");
    if (!program.find(Stage::fragment))
        add_default(program, Stage::fragment, default_fragment_shader(program), "<built-in fragment shader>");
    std::stable_sort(program.units.begin(), program.units.end(),
                     [](const Unit& a, const Unit& b) { return a.stage < b.stage; });
}

void add_precision(Unit& u) {
    for (const std::string_view type :
         {"float", "int", "sampler2D", "sampler3D", "samplerCube", "sampler2DArray", "sampler2DShadow",
          "samplerCubeShadow", "sampler2DArrayShadow", "isampler2D", "usampler2D", "isampler3D", "usampler3D"}) {
        bool there = false, used = type == "float" || type == "int";
        for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
            used = used || u.tokens[i].text == type;
            there =
                there || (u.tokens[i].text == "precision" && i + 2 < u.tokens.size() && u.tokens[i + 2].text == type);
        }
        if (used && !there) u.header += "precision highp " + std::string(type) + ";\n";
    }
}

void want_extensions(const Target& target, Unit& u) {
    if (target.es || target.version >= 400) return;
    if (u.stage == Stage::tess_control || u.stage == Stage::tess_evaluation)
        u.wanted_extensions.emplace_back("GL_ARB_tessellation_shader");
    const bool doubles = std::any_of(u.tokens.begin(), u.tokens.end(), [](const Token& t) {
        return t.kind == Kind::identifier &&
               (t.text == "double" || t.text.starts_with("dvec") || t.text.starts_with("dmat"));
    });
    if (doubles && target.fp64) u.wanted_extensions.emplace_back("GL_ARB_gpu_shader_fp64");
}

}  // namespace

Translation translate(const std::vector<StageInput>& stages, Sources& sources, const Options& options,
                      Diagnostics& diagnostics) {
    Program program{options, sources, diagnostics, {}, {}, {}};
    const std::size_t errors = diagnostics.errors();
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
    add_missing_stages(program);

    for (Unit& u : program.units) {
        if (options.target.es) add_precision(u);
        want_extensions(options.target, u);
        if (u.stage == Stage::geometry) complete_geometry(program, u);
    }
    unify_uniforms(program);
    match_interfaces(program);
    if (Unit* vertex = program.find(Stage::vertex)) assign_attributes(program, *vertex);
    if (Unit* fragment = program.find(Stage::fragment)) assign_outputs(program, *fragment);
    replace_legacy(program);

    Translation out;
    for (Unit& u : program.units) {
        move_initialisers(program, u);
        write_declarations(program, u);
        out.stages.push_back({u.stage, emit(program, u), u.files});
    }
    const Unit* fragment = program.find(Stage::fragment);
    out.uses_alpha = !fragment || !fragment->alpha_known || fragment->alpha_unknown;
    out.defaults = std::move(program.defaults);
    out.renamed = std::move(program.renamed);
    out.ok = diagnostics.errors() == errors;
    return out;
}

}  // namespace snell::glsl
