#include "src/runtime/explain.h"

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/plan/plan.h"
#include "src/plan/values/programs.h"
#include "src/runtime/impl.h"

namespace snell {

namespace {

using Kind = Explanation::Kind;
using Paid = Explanation::Paid;

std::string size_text(const std::array<int, 3>& size) {
    return size[2] > 1 ? fmt::format("{}x{}x{}", size[0], size[1], size[2]) : fmt::format("{}x{}", size[0], size[1]);
}

std::string statement_of(const Texture& texture) {
    constexpr std::array<std::string_view, 4> targets{"Texture1D", "Texture2D", "Texture3D", "CubeMap"};
    constexpr std::array<std::string_view, 3> computed{"", "Irradiance", "Prefilter"};
    const bool made = texture.computed != Computed::no;
    return fmt::format(
        "{} {}",
        made ? computed[static_cast<std::size_t>(texture.computed)] : targets[static_cast<std::size_t>(texture.target)],
        texture.unit);
}

Kind kind_of(const Texture& texture) {
    return texture.computed != Computed::no        ? Kind::computed
           : texture.files.empty()                 ? Kind::empty_texture
           : texture.target == TextureTarget::cube ? Kind::cube_map
                                                   : Kind::image;
}

}  // namespace

std::string title_of(const Texture& texture) {
    const std::string_view file = texture.files.empty() ? std::string_view() : texture.files[0].name;
    return fmt::format("{}{}{}", statement_of(texture), file.empty() ? "" : " ", file.substr(file.rfind('/') + 1));
}

namespace {

std::string name_of(const Pass& pass) {
    return std::array{"window", "RenderToTexture", "RenderToCube"}[static_cast<std::size_t>(pass.kind)];
}

std::string value_text(const std::vector<double>& values, ValueType type) {
    std::vector<std::string> words;
    for (const double value : values)
        words.push_back(type == ValueType::bool_ ? (value != 0 ? "true" : "false")
                                                 : text_of::number(value, value == std::round(value)));
    return words.size() == 1 ? words[0] : fmt::format("({})", fmt::join(words, ", "));
}

// What the values of uniforms switch off, without what it saves. Values count alone where Runtime::find_switched_off
// has tried them.
class SwitchedOffFinder {
public:
    explicit SwitchedOffFinder(const Runtime::Impl& impl) : impl_(impl), scene_(impl.plan.scene) {}

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
                if (!stays(uniform.name) && !(linked.general && ranges::count(*linked.general, uniform.name) == 0))
                    inactive.push_back(&uniform);
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

std::string_view name(Explanation::Kind kind) {
    constexpr std::array<std::string_view, 12> names{"image",  "cube map", "empty texture", "computed",
                                                     "noise",  "mesh",     "tree",          "program",
                                                     "target", "pass",     "sampler",       "uniform"};
    return names[static_cast<std::size_t>(kind)];
}

namespace {

// Gathers what a runtime has, without changing it.
class Explainer {
public:
    explicit Explainer(const Runtime::Impl& impl) : impl_(impl), scene_(impl.plan.scene) {
        for (const auto& pass : impl.passes)
            for (const auto& item : pass.items)
                if (item) note(*item);
    }

    Explanation explain() {
        textures();
        noise();
        meshes();
        programs();
        passes();
        result_.switched_off = SwitchedOffFinder(impl_).all();
        unused();
        unpaid();
        redraw();
        return std::move(result_);
    }

private:
    void note(const runtime::ReadyDraw& ready) {
        const Draw& draw = scene_.draws[ready.draw];
        ++mesh_draws_[ready.mesh];
        if (draw.program != none) ++program_draws_[draw.program];
        drawn_with_[ready.draw] = ready.program;
        for (const runtime::Sampled& sampled : impl_.sampled_by(draw, *ready.program)) {
            const std::string reader =
                fmt::format("{} of {}", sampled.sampler->name, program_name(scene_, draw.program));
            if (sampled.texture != none) readers_[impl_.textures.first(sampled.texture)].insert(reader);
            if (sampled.noise) noise_readers_[sampled.noise].insert(reader);
        }
        for (const Index source : ready.sources)
            readers_[impl_.textures.first(source)].insert("what is computed of it");
    }

    void textures() {
        for (Index i = 0; i < scene_.textures.size(); ++i) {
            const runtime::GpuTexture* gpu = impl_.textures.first(i) == i ? impl_.textures.find(i) : nullptr;
            if (!gpu) continue;
            const Texture& declared = scene_.textures[i];
            Paid paid;
            paid.kind = kind_of(declared);
            paid.name = fmt::format("{} {}{}", title_of(declared), size_text(gpu->size),
                                    gpu->mipmapped ? ", with mipmaps" : "");
            paid.why = readers_[i].empty() ? "rendered to" : fmt::format("read by {}", fmt::join(readers_[i], ", "));
            std::size_t twins = 0;
            for (Index other = i + 1; other < scene_.textures.size(); ++other)
                twins += impl_.textures.first(other) == i;
            if (twins) paid.why += fmt::format("; once for {} statements", twins + 1);
            paid.span = declared.span;
            paid.texture = i;
            paid.bytes = gpu->bytes;
            paid.load_ms = gpu->load_ms;
            result_.paid.push_back(std::move(paid));
        }
    }

    void noise() {
        for (const auto& [dimensions, readers] : noise_readers_) {
            Paid paid{Kind::noise, fmt::format("Noise{}", dimensions),
                      fmt::format("read by {}", fmt::join(readers, ", ")), std::nullopt};
            paid.noise = dimensions;
            if (const auto* gpu = impl_.textures.find_noise(dimensions)) {
                paid.name += " " + size_text(gpu->size);
                paid.bytes = gpu->bytes;
                paid.load_ms = gpu->load_ms;
            }
            result_.paid.push_back(std::move(paid));
        }
    }

    void meshes() {
        for (const auto& [mesh, draws] : mesh_draws_) {
            const runtime::GpuMesh& gpu = *impl_.meshes[mesh];
            const MeshRequest& request = impl_.plan.meshes[mesh];
            Paid paid{Kind::mesh, text_of::shape(scene_, request.shape, request.wire), counted(draws, "draw"),
                      request.span};
            paid.bytes = gpu.bytes;
            paid.load_ms = gpu.load_ms;
            paid.triangles = runtime::triangle_count(gpu.topology, gpu.count);
            result_.paid.push_back(std::move(paid));
            const runtime::GpuTree& tree = *impl_.trees[mesh];
            if (!tree.built) continue;
            Paid own{Kind::tree, result_.paid.back().name, "rays of a program go through it", request.span};
            own.bytes = tree.bytes;
            own.load_ms = tree.load_ms;
            result_.paid.push_back(std::move(own));
        }
    }

    void programs() {
        std::set<const runtime::LinkedProgram*> told;  // forms of a program may be one, and so may programs
        std::map<const runtime::LinkedProgram*, std::set<Index>> users;
        for (const auto& [key, linked] : impl_.programs)
            if (key.first != none) users[linked.get()].insert(key.first);
        for (const auto& [key, linked] : impl_.programs) {
            const auto& [index, variant] = key;
            if (!linked || index == none || !told.insert(linked.get()).second) continue;
            const Program& program = scene_.programs[index];
            Paid paid{Kind::program, program.name, "", program.span};
            paid.load_ms = linked->load_ms;
            for (const auto& [draw, with] : drawn_with_)
                if (with == linked.get()) paid.draws.push_back(draw);
            paid.why = paid.draws.empty() ? "no draw; compiled for its sliders and errors"
                                          : counted(paid.draws.size(), "draw");
            paid.programs.assign(users[linked.get()].begin(), users[linked.get()].end());
            if (paid.programs.size() > 1) {
                std::vector<std::string> names;
                for (const Index user : paid.programs) names.push_back(scene_.programs[user].name);
                paid.why += fmt::format("; compiled once for {}", fmt::join(names, ", "));
            }
            runtime::Variant drawn = variant;
            drawn.settled = impl_.settled_values;
            const bool asked = impl_.settled_values != 0 && variant.settled == 0 && linked->settled.empty() &&
                               impl_.programs.contains({index, drawn});
            if (paid.draws.empty() && asked) {
                paid.name += ", for any values";
                paid.why = "no draw; compiled to learn which uniforms it reads";
            }
            if (variant.wide) paid.name += ", lines widened";
            if (variant.outputs > 1) paid.name += fmt::format(", {} outputs", variant.outputs);
            for (std::size_t i = 0; i < variant.rungs.size(); ++i)
                paid.name += fmt::format(", {} {}", scene_.ladders[i].name, scene_.ladders[i].rungs[variant.rungs[i]]);
            for (const runtime::SamplerUniform& sampler : linked->samplers) paid.why += "; reads " + sampler.name;
            result_.paid.push_back(std::move(paid));
        }
    }

    void passes() {
        for (Index i = 0; i < impl_.passes.size(); ++i) {
            const runtime::ReadyPass& ready = impl_.passes[i];
            const Pass& pass = scene_.passes[i];
            const bool window = pass.kind == Pass::Kind::window;
            if (!ready.live || (window && pass.items.empty())) continue;
            if (!window) target(ready, pass);
            Paid paid;
            paid.kind = Kind::pass;
            paid.pass = i;
            for (const auto& item : ready.items)
                if (item) {
                    paid.draws.push_back(item->draw);
                    paid.triangles +=
                        runtime::triangle_count(impl_.meshes[item->mesh]->topology, impl_.meshes[item->mesh]->count);
                }
            paid.name = name_of(pass);
            paid.kept = pass.kind == Pass::Kind::cube && !impl_.reads_other_passes(ready);
            paid.why =
                counted(paid.draws.size(), "draw") + (paid.kept ? ", again when what its faces show changed" : "");
            if (!window) paid.span = pass.span;
            result_.paid.push_back(std::move(paid));
        }
    }

    void target(const runtime::ReadyPass& ready, const Pass& pass) {
        Paid paid{Kind::target, fmt::format("depth {}x{}", ready.width, ready.height), "drawn to off-screen",
                  pass.span};
        paid.bytes = std::size_t{4} * static_cast<std::size_t>(ready.width) * static_cast<std::size_t>(ready.height) *
                     impl_.targets.at(ready.textures).size();
        result_.paid.push_back(std::move(paid));
    }

    // Its files may be read all the same, for what is computed from them.
    bool sampled_for_other_values(Index texture) const {
        return ranges::any_of(scene_.draws, [&](const Draw& draw) {
            return draw.program != none && ranges::count(impl_.sampled_by(draw, impl_.dormant[draw.program]), texture,
                                                         &runtime::Sampled::texture) > 0;
        });
    }

    // By some form of the program. What programs for any values read is known once one was linked.
    bool is_read(Index program, std::string_view uniform) const {
        const auto named = [&](std::string_view active) { return uniform.starts_with(active); };
        for (const auto& [key, linked] : impl_.programs)
            if (key.first == program && linked && linked->general && ranges::none_of(*linked->general, named))
                return false;
        return ranges::any_of(impl_.active[program], named, &ActiveUniform::name);
    }

    void unused() {
        for (Index i = 0; i < scene_.textures.size(); ++i)
            if (!impl_.textures.find(i) && !impl_.dormant_textures.contains(impl_.textures.first(i)) &&
                !sampled_for_other_values(i))
                result_.unused.push_back(
                    {statement_of(scene_.textures[i]), "no draw samples it", scene_.textures[i].span, i});
        for (Index i = 0; i < scene_.programs.size(); ++i) {
            const Program& program = scene_.programs[i];
            if (!program_draws_.contains(i))
                result_.unused.push_back(
                    {"Program " + program_name(scene_, i), "nothing is drawn with it", program.span});
            for (const UniformValue& uniform : program.uniforms)
                if (!is_read(i, uniform.name))
                    result_.unused.push_back({fmt::format("{} of {}", uniform.name, program_name(scene_, i)),
                                              "no stage reads it: it is not active", uniform.span});
        }
        for (Index i = 0; i < impl_.passes.size(); ++i)
            if (!impl_.passes[i].wanted)
                result_.unused.push_back(
                    {"RenderTo", "nothing reads what is rendered there: not drawn", scene_.passes[i].span});
        for (const Ladder& ladder : scene_.ladders)
            if (ladder.rungs.size() > 1)
                result_.unused.push_back(
                    {"Ladder " + ladder.name,
                     counted(ladder.rungs.size() - 1, "other rung") + ": compiled when they are chosen", ladder.span});
    }

    void redraw() {
        std::set<std::string_view> clocks;
        for (const auto& [draw, program] : drawn_with_)
            if (program->reads(glsl::System::timer) || program->reads(glsl::System::time))
                clocks.insert(scene_.programs[scene_.draws[draw].program].name);
        result_.redraw = clocks.empty() ? "when input, a file, the size or a value changed something"
                                        : fmt::format("all the time: {} read the clock", fmt::join(clocks, ", "));
    }

    void say(std::string_view what, bool paid_for, std::string_view why) {
        if (!paid_for) result_.unpaid.push_back({std::string(what), std::string(why)});
    }

    void unpaid() {
        const Counters& c = impl_.counters;
        const auto has = [&](Kind kind) { return ranges::count(result_.paid, kind, &Paid::kind) > 0; };
        say("Timer", impl_.animated, "inactive in every drawn program: drawn again when something changed");
        say("Noise2, Noise3", has(Kind::noise), "inactive");
        say("off-screen targets", has(Kind::target), "nothing is rendered to textures");
        say("mipmaps", c.mip_chains > 0, "no Filter asks for them");
        say("irradiance, prefilter", c.convolutions > 0, "not sampled");
        say("trees of meshes", has(Kind::tree), "no program traces rays through what it draws");
        say("blending", c.blended_draws > 0, "no program can write an alpha below 1");
        out_of_view();
        say("more samples a pixel", false, "1 sample");
    }

    // As of the last frame.
    void out_of_view() {
        std::size_t all = 0, out = 0, passes = 0;
        std::set<std::string> shapes;
        for (Index i = 0; i < impl_.passes.size(); ++i) {
            const runtime::ReadyPass& pass = impl_.passes[i];
            passes += pass.live && pass.stale ? 1 : 0;
            for (const runtime::OutOfView& face : pass.out_of_view)
                for (std::size_t item = 0; item < face.items.size(); ++item) {
                    all += pass.items[item] ? 1 : 0;
                    if (!face.items[item]) continue;
                    ++out;
                    const MeshRequest& request = impl_.plan.meshes[pass.items[item]->mesh];
                    shapes.insert(text_of::shape(scene_, request.shape, request.wire));
                }
        }
        std::vector<std::string> names(shapes.begin(), shapes.end());
        if (names.size() > 4) {
            names.resize(3);
            names.emplace_back("others");
        }
        say("draws out of view", out == 0,
            fmt::format("{} of {}, outside of the picture or of a face of a cube map: {}", out, all,
                        fmt::join(names, ", ")));
        say("passes out of view", passes == 0,
            fmt::format("{}, read only by draws out of view", counted(passes, "pass")));
    }

    const Runtime::Impl& impl_;
    const Scene& scene_;
    Explanation result_;
    std::map<Index, std::set<std::string>> readers_;
    std::map<int, std::set<std::string>> noise_readers_;
    std::map<Index, std::size_t> mesh_draws_, program_draws_;
    std::map<Index, const runtime::LinkedProgram*> drawn_with_;
};

}  // namespace

Explanation Runtime::explain() const { return Explainer(*impl_).explain(); }

}  // namespace snell
