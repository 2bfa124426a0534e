#include "src/language/translations.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/declared.h"

namespace snell::language {

std::vector<glsl::Options> options_of(const Plan& plan, const glsl::IncludeReader& include) {
    const Scene& scene = plan.scene;
    std::vector<glsl::Options> all(scene.programs.size());
    for (Index i = 0; i < all.size(); ++i) {
        const Program& program = scene.programs[i];
        all[i].target = {450, false, true};
        all[i].geometry_input = program.geometry_input;
        all[i].geometry_output = program.geometry_output;
        all[i].include = include;
        all[i].defines = ladder_defines(std::span(scene.ladders).first(program.ladders), plan.rungs);
        all[i].color_outputs = 0;
    }
    // As for the first draw of each program.
    for (const Pass& pass : scene.passes)
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            if (draw.program == none || all[draw.program].color_outputs > 0) continue;
            all[draw.program].flat_color = scene.rasters[draw.raster].flat;
            all[draw.program].color_outputs =
                pass.kind == Pass::Kind::textures ? std::clamp(static_cast<int>(pass.textures.size()), 1, 8) : 1;
        }
    for (glsl::Options& options : all) options.color_outputs = std::max(options.color_outputs, 1);
    return all;
}

glsl::Translation translate_program(Project& project, Index program, const glsl::Options& options) {
    const PlannedProgram& planned = project.plan.programs[program];
    if (!planned.readable || planned.stages.empty()) return {};
    return glsl::translate(planned.stages, project.sources, options, project.diagnostics);
}

namespace {

// A member of a structure or of an array, whose type is not known here.
bool is_part(const UniformValue& value, const std::vector<glsl::DeclaredUniform>& declared) {
    const std::string_view base = std::string_view(value.name).substr(0, value.name.find_first_of(".["));
    return ranges::any_of(declared, [&](const glsl::DeclaredUniform& d) { return d.name == base && !d.simple; });
}

}  // namespace

void report_values(Project& project) {
    if (project.alone) return;
    Scene scene;  // what make_controls reads of it
    scene.programs = project.plan.scene.programs;
    std::vector<std::vector<ActiveUniform>> uniforms(scene.programs.size());
    for (Index i = 0; i < scene.programs.size(); ++i) {
        Program& program = scene.programs[i];
        const glsl::Translation& translation = project.translations[i];
        if (!translation.ok) {
            program.uniforms.clear();  // the shaders' errors come first
            continue;
        }
        for (const glsl::DeclaredUniform& declared : translation.declared)
            uniforms[i].push_back(described(program, declared));
        std::erase_if(program.uniforms, [&](const UniformValue& v) { return is_part(v, translation.declared); });
    }
    make_controls(scene, uniforms, project.diagnostics);
}

}  // namespace snell::language
