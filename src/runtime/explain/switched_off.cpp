#include "src/runtime/explain/switched_off.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "parser/text/ranges.h"
#include "parser/text_of.h"
#include "src/plan/identity.h"
#include "src/runtime/explain/explain.h"
#include "src/runtime/impl.h"

namespace snell::runtime {

using Kind = Explanation::Kind;

namespace {

std::string value_text(const std::vector<double>& values, ValueType type) {
    std::vector<std::string> words;
    for (const double value : values)
        words.push_back(type == ValueType::bool_ ? (value != 0 ? "true" : "false")
                                                 : text_of::number(value, value == std::round(value)));
    return words.size() == 1 ? words[0] : fmt::format("({})", fmt::join(words, ", "));
}

class Finder {
public:
    explicit Finder(const Runtime::Impl& impl) : impl_(impl), scene_(impl.plan.scene) {}

    std::vector<Explanation::SwitchedOff> all() {
        std::set<Index> told;
        for (Index pass = 0; pass < impl_.passes.size(); ++pass)
            for (const Draw* draw : programmed(scene_.passes[pass])) {
                const auto* linked = impl_.passes[pass].live ? impl_.program_of(pass, *draw) : nullptr;
                if (linked && !linked->settled.empty() && told.insert(draw->program).second)
                    of_program(draw->program, *linked);
            }
        return std::move(result_);
    }

private:
    // What draws would read.
    struct Reach {
        std::set<Index> textures, passes;
        std::set<int> noise;
    };

    std::vector<const Draw*> programmed(const Pass& pass) const {
        std::vector<const Draw*> draws;
        for (const Item& item : pass.items)
            if (item.kind == Item::Kind::draw && scene_.draws[item.index].program != none)
                draws.push_back(&scene_.draws[item.index]);
        return draws;
    }

    void reach(Reach& all, const Draw& draw, std::span<const runtime::SamplerUniform> samplers) const {
        for (const runtime::Sampled& sampled : impl_.sampled_by(draw, samplers))
            if (sampled.noise) all.noise.insert(sampled.noise);
        for (const Index texture : impl_.read_by(draw, samplers)) reach(all, texture);
    }

    void reach(Reach& all, Index index) const {
        const Index texture = index == none ? none : impl_.textures.first(index);
        if (texture == none || !all.textures.insert(texture).second) return;
        const auto is_it = [&](Index drawn) { return drawn != none && impl_.textures.first(drawn) == texture; };
        for (Index i = 0; i < impl_.passes.size(); ++i) {
            const Pass& pass = scene_.passes[i];
            if (impl_.passes[i].live || ranges::none_of(pass.textures, is_it) || !all.passes.insert(i).second) continue;
            for (const Draw* draw : programmed(pass)) {
                reach(all, *draw, impl_.dormant[draw->program]);
                if (const auto* linked = impl_.program_of(i, *draw)) reach(all, *draw, linked->samplers);
            }
        }
    }

    void of_program(Index program, const runtime::LinkedProgram& linked) {
        std::set<std::string_view> told;  // of single values, and these themselves
        const auto off = [&](const auto& stays) {
            std::vector<const ActiveUniform*> inactive;
            for (const ActiveUniform& uniform : impl_.active[program])
                if (!stays(uniform.name)) inactive.push_back(&uniform);
            return inactive;
        };
        Explanation::SwitchedOff row{program, scene_.programs[program].name, "", "", {}, {}, {}};
        for (std::size_t i = 0; i < linked.alone.size(); ++i) {
            const auto& [name, values] = linked.settled[i];
            const Control* control = impl_.given.find(program, name);
            row.uniform = name;
            row.value = value_text(values, control ? control->type : ValueType::float_);
            row.span = control && control->listed ? std::optional(control->span) : std::nullopt;
            const auto& active = linked.alone[i];
            const auto inactive =
                off([&](const std::string& n) { return n == row.uniform || ranges::count(active, n) > 0; });
            for (const ActiveUniform* uniform : inactive) told.insert(uniform->name);
            add_parts(row, linked, inactive);
        }
        for (const glsl::Settled& settled : linked.settled) told.insert(settled.name);
        row.uniform = row.value = "";
        row.span = scene_.programs[program].span;
        add_parts(row, linked, off([&](const std::string& n) {
                      return told.contains(n) || ranges::count(linked.active, n, &ActiveUniform::name) > 0;
                  }));
    }

    void add_parts(Explanation::SwitchedOff row, const runtime::LinkedProgram& linked,
                   const std::vector<const ActiveUniform*>& inactive) {
        std::vector<runtime::SamplerUniform> samplers;
        bool light = false;
        for (const ActiveUniform* uniform : inactive) {
            light = light || (uniform->system && uniform->name == "uHarmonics");
            if (uniform->name.starts_with("snell_")) continue;  // matrices and the like
            row.parts.push_back({uniform->type == ValueType::sampler ? Kind::sampler : Kind::uniform,
                                 fmt::format("{} {}", uniform->glsl_type, uniform->name),
                                 linked.functions_naming(uniform->name)});
            for (const runtime::SamplerUniform& sampler : impl_.dormant[row.program])
                if (sampler.name == uniform->name) samplers.push_back(sampler);
        }
        Reach all;
        for (const Draw& draw : scene_.draws) {
            if (draw.program != row.program) continue;
            reach(all, draw, samplers);
            if (light) reach(all, impl_.light_of(draw));
        }
        for (const Index index : all.textures) {
            const Texture& texture = scene_.textures[index];
            if (impl_.textures.asked(index)) continue;
            row.parts.push_back({kind_of(texture), title_of(texture), {}, {}, 0, texture.span});
            for (const FileName& file : texture.files) row.parts.back().files.push_back(file.name);
            if (!texture.files.empty()) row.parts.back().bytes = file_bytes(scene_, index, *impl_.files);
        }
        for (const int dimensions : all.noise)
            if (!impl_.textures.find_noise(dimensions))
                row.parts.push_back({Kind::noise, fmt::format("Noise{}", dimensions)});
        for (const Index pass : all.passes)
            row.parts.push_back({Kind::pass, name_of(scene_.passes[pass]), {}, {}, 0, scene_.passes[pass].span});
        if (!row.parts.empty()) result_.push_back(std::move(row));
    }

    const Runtime::Impl& impl_;
    const Scene& scene_;
    std::vector<Explanation::SwitchedOff> result_;
};

}  // namespace

std::vector<Explanation::SwitchedOff> switched_off(const Runtime::Impl& impl) { return Finder(impl).all(); }

}  // namespace snell::runtime
