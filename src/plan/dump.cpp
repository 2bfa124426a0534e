#include <fmt/format.h>

#include <set>

#include "parser/text_of.h"
#include "src/plan/plan.h"

namespace snell {
namespace {

constexpr std::array stage_names{"vertex", "tess control", "tess evaluation", "geometry", "fragment"};
constexpr std::array target_names{"1D", "2D", "3D", "cube"};

std::string at(const Span& span, const Sources& sources) {
    return fmt::format("{}:{}", sources.name(span.file), sources.position(span.file, span.begin).line);
}

void dump_programs(std::string& out, const Plan& plan, const Sources& sources) {
    std::set<FileId> files;
    for (const PlannedProgram& planned : plan.programs) {
        out += fmt::format("program {} '{}'{}\n", planned.program, plan.scene.programs[planned.program].name,
                           planned.readable ? "" : " (not readable)");
        for (const glsl::StageInput& stage : planned.stages) {
            files.insert(stage.file);
            out +=
                fmt::format("  {}: {}\n", stage_names[static_cast<std::size_t>(stage.stage)], sources.name(stage.file));
        }
    }
    out += fmt::format("shader files: {}\n", files.size());
}

void dump_meshes(std::string& out, const Plan& plan, const Sources& sources) {
    std::vector<std::size_t> uses(plan.meshes.size());
    for (const Index mesh : plan.draw_mesh) {
        if (mesh < uses.size()) ++uses[mesh];
    }
    for (std::size_t i = 0; i < plan.meshes.size(); ++i) {
        const MeshRequest& mesh = plan.meshes[i];
        out += fmt::format("mesh {} {}, draws: {}, first at {}\n", i, text_of::shape(plan.scene, mesh.shape, mesh.wire),
                           uses[i], at(mesh.span, sources));
    }
}

void dump_textures(std::string& out, const Plan& plan, const Sources& sources) {
    for (std::size_t i = 0; i < plan.scene.textures.size(); ++i) {
        const Texture& texture = plan.scene.textures[i];
        out += fmt::format("texture {} {} unit {}", i, target_names[static_cast<std::size_t>(texture.target)],
                           texture.unit);
        if (texture.computed != Computed::no) {
            out += fmt::format(", {} of texture {}",
                               texture.computed == Computed::irradiance ? "irradiance" : "prefiltered levels",
                               texture.source);
        } else if (texture.files.empty()) {
            out += fmt::format(", empty {} x {} x {}", texture.size[0], texture.size[1], texture.size[2]);
        }
        for (const FileName& file : texture.files) out += fmt::format(" '{}'", file.name);
        if (i < plan.same_pixels.size() && plan.same_pixels[i] != i)
            out += fmt::format(", pixels of texture {}", plan.same_pixels[i]);
        out += fmt::format(", at {}\n", at(texture.span, sources));
    }
}

std::string pass_target(const Pass& pass) {
    std::string units;
    for (const int unit : pass.units) units += fmt::format(" {}", unit);
    switch (pass.kind) {
        case Pass::Kind::window:
            return "window";
        case Pass::Kind::textures:
            return "textures on units" + units;
        case Pass::Kind::cube:
            return fmt::format("cube{} from {} {} {}{}", units, pass.center[0], pass.center[1], pass.center[2],
                               pass.faces_per_frame < 6 ? fmt::format(", {} faces a frame", pass.faces_per_frame) : "");
    }
    return {};
}

void dump_passes(std::string& out, const Plan& plan, const Sources& sources) {
    for (std::size_t i = 0; i < plan.scene.passes.size(); ++i) {
        const Pass& pass = plan.scene.passes[i];
        out += fmt::format("pass {} to {}\n", i, pass_target(pass));
        for (const Item& item : pass.items) {
            if (item.kind == Item::Kind::clear) {
                out += "  clear\n";
                continue;
            }
            const Draw& draw = plan.scene.draws[item.index];
            const std::string program = draw.program == none ? "built-in" : std::to_string(draw.program);
            out +=
                fmt::format("  draw {} mesh {} program {} camera {} matrix {} at {}\n", item.index,
                            plan.draw_mesh.at(item.index), program, draw.camera, draw.matrix, at(draw.span, sources));
        }
    }
}

}  // namespace

std::string dump_plan(const Plan& plan, const Sources& sources) {
    std::string out;
    dump_programs(out, plan, sources);
    dump_meshes(out, plan, sources);
    dump_textures(out, plan, sources);
    dump_passes(out, plan, sources);
    return out;
}

}  // namespace snell
