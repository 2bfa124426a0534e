// Finds and binds what each draw reads: textures by the units of its samplers, noise, harmonics.
#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/runtime/impl.h"

namespace snell {

using runtime::LinkedProgram;
using runtime::ReadyDraw;
using runtime::Sampled;
using runtime::SamplerUniform;

namespace {

// Returns the dimensions of the built-in noise that the sampler reads; 0 if it reads none.
int noise_dimensions(const SamplerUniform& sampler, bool named, int unit) {
    if (sampler.target == TextureTarget::d2 && ((sampler.name == "Noise2" && !named) || unit == 2)) return 2;
    if (sampler.target == TextureTarget::d3 && ((sampler.name == "Noise3" && !named) || unit == 3)) return 3;
    return 0;
}

// The warning that nothing of its kind is bound to the unit that a sampler reads.
Diagnostic unbound(const Scene& scene, const Draw& draw, const Sampled& sampled) {
    static constexpr std::array<std::string_view, 4> commands{"Texture1D", "Texture2D", "Texture3D", "CubeMap"};
    const std::string_view command = commands[static_cast<size_t>(*sampled.sampler->target)];
    bool other = false;
    for (const TextureTarget kind : {TextureTarget::d1, TextureTarget::d2, TextureTarget::d3, TextureTarget::cube})
        other = other || find_texture(scene, draw, sampled.unit, kind) != none;
    return {Severity::warning,
            "unbound-texture",
            draw.span,
            fmt::format("'{}' reads texture unit {}, but {} is bound there: it reads as black", sampled.sampler->name,
                        sampled.unit, other ? fmt::format("no {}", command) : "nothing"),
            contains(sampled.sampler->name, "noise") && (command == "Texture2D" || command == "Texture3D")
                ? fmt::format("the sampler of snell's own noise is called 'Noise{}'", command[7])
                : fmt::format("bind one with '{} {} {}' before the draw", command, sampled.unit,
                              command == "CubeMap" ? "FILES" : "FILE"),
            {}};
}

}  // namespace

std::vector<Sampled> Runtime::Impl::sampled_by(const Draw& draw, std::span<const SamplerUniform> samplers) const {
    std::vector<Sampled> result;
    if (draw.program == none) return result;
    for (const SamplerUniform& sampler : samplers) {
        if (!sampler.target) continue;
        // A sampler that the Program line sets reads that unit.
        const Control* control = given.find(draw.program, sampler.name);
        const bool named = control && control->listed;
        for (int element = 0; element < sampler.size; ++element) {
            const auto at = static_cast<size_t>(element);
            const int unit = control && at < control->value.size() ? static_cast<int>(control->value[at])
                             : at < sampler.initial.size()         ? sampler.initial[at]
                                                                   : 0;
            const int noise = noise_dimensions(sampler, named, unit);
            const bool by_name = noise && !named;
            Index found = find_texture(plan.scene, draw, by_name ? noise : unit, *sampler.target);
            // OpenGL ES has no 1D textures: they are 2D ones of one row.
            if (found == none && caps.es && sampler.target == TextureTarget::d2)
                found = find_texture(plan.scene, draw, unit, TextureTarget::d1);
            result.push_back({&sampler, element, unit, found, found == none ? noise : 0});
        }
    }
    return result;
}

// The last Irradiance before the draw counts, otherwise the last one of the text, as for textures.
Index Runtime::Impl::light_of(const Draw& draw) const {
    const Scene& scene = plan.scene;
    Index last = none;
    const auto consider = [&](Index texture) {
        if (scene.textures[texture].computed == Computed::irradiance && (last == none || texture > last))
            last = texture;
    };
    for (const Bindings::Entry& entry : scene.bindings[draw.bindings].entries) consider(entry.texture);
    for (Index i = 0; last == none && i < scene.textures.size(); ++i)
        consider(static_cast<Index>(scene.textures.size() - 1 - i));
    return last == none ? none : scene.textures[last].source;
}

std::vector<Index> Runtime::Impl::read_by(const Draw& draw, const LinkedProgram& program) const {
    std::vector<Index> result = read_by(draw, program.samplers);
    if (program.reads(glsl::System::harmonics)) result.push_back(light_of(draw));
    std::erase(result, none);
    return result;
}

std::vector<Index> Runtime::Impl::spared_by(const Draw& draw, const LinkedProgram& program) const {
    std::vector<Index> result;
    if (draw.program == none) return result;
    result = read_by(draw, dormant[draw.program]);
    if (spares_harmonics(draw, program)) result.push_back(light_of(draw));
    std::erase(result, none);
    return result;
}

bool Runtime::Impl::spares_harmonics(const Draw& draw, const LinkedProgram& program) const {
    return !program.reads(glsl::System::harmonics) &&
           ranges::any_of(active[draw.program],
                          [](const ActiveUniform& uniform) { return uniform.system && uniform.name == "uHarmonics"; });
}

std::vector<Index> Runtime::Impl::read_by(const Draw& draw, std::span<const SamplerUniform> samplers) const {
    std::vector<Index> result;
    for (const Sampled& sampled : sampled_by(draw, samplers)) {
        result.push_back(sampled.texture);
        if (sampled.texture != none) result.push_back(plan.scene.textures[sampled.texture].source);
    }
    std::erase(result, none);
    return result;
}

void Runtime::Impl::bind_harmonics(ReadyDraw& ready, Index pass, Diagnostics& diagnostics) {
    if (!ready.program->reads(glsl::System::harmonics)) return;
    if (auto problem = no_harmonics(pass, ready.draw)) {
        diagnostics.add(std::move(*problem));
        return;
    }
    const Index source = light_of(plan.scene.draws[ready.draw]);
    ready.sources.push_back(source);
    if (plan.scene.textures[source].files.empty()) textures.realise(source);
    ready.harmonics = textures.harmonics(source);
}

std::optional<Diagnostic> Runtime::Impl::no_harmonics(Index pass, Index index) const {
    const Draw& draw = plan.scene.draws[index];
    const Index source = light_of(draw);
    if (source != none) return feedback_error(plan.scene, pass, index, source);
    return Diagnostic{Severity::warning,
                      "no-harmonics",
                      draw.span,
                      "the program reads uHarmonics, but no Irradiance names a cube map",
                      "name one: Irradiance 7 6",
                      {}};
}

std::optional<Diagnostic> Runtime::Impl::unreadable(const Sampled& sampled, const Draw& draw, Index pass,
                                                    Index index) const {
    const Scene& scene = plan.scene;
    if (sampled.texture == none) {
        if (sampled.noise) return std::nullopt;
        return unbound(scene, draw, sampled);
    }
    if (auto problem = feedback_error(scene, pass, index, sampled.texture)) return problem;
    // A map that is computed from the target would show the frame before.
    return feedback_error(scene, pass, index, scene.textures[sampled.texture].source);
}

// Every sampler is bound, because its unit may still hold a texture of another scene.
void Runtime::Impl::bind_textures(ReadyDraw& ready, Index pass, Diagnostics& diagnostics) {
    const Scene& scene = plan.scene;
    const Draw& draw = scene.draws[ready.draw];
    const bool clamp = scene.rasters[draw.raster].clamp;
    const auto bind_black = [&](const SamplerUniform& sampler, int element) {
        const gl::Black& black = textures.nothing(sampler.type);
        ready.textures.push_back({sampler.first_unit + element, black.target, black.texture.get(), 0});
    };
    for (const Sampled& sampled : sampled_by(draw, *ready.program)) {
        const SamplerUniform& sampler = *sampled.sampler;
        const runtime::GpuTexture* gpu = nullptr;
        Filter filter;
        if (sampled.texture != none) {
            const Index source = scene.textures[sampled.texture].source;
            auto problem = unreadable(sampled, draw, pass, ready.draw);
            if (!problem) {
                if (source != none) ready.sources.push_back(source);
                gpu = textures.realise(sampled.texture);
                filter = scene.textures[sampled.texture].filter;
            } else {
                diagnostics.add(std::move(*problem));
            }
        } else if (sampled.noise) {
            gpu = textures.noise(sampled.noise);
        } else {
            diagnostics.add(*unreadable(sampled, draw, pass, ready.draw));
        }
        const bool cube = sampler.target == TextureTarget::cube;
        if (gpu)
            ready.textures.push_back({sampler.first_unit + sampled.element, gpu->target, gpu->texture.get(),
                                      textures.sampler(filter, clamp, cube)});
        else
            bind_black(sampler, sampled.element);
    }
    for (const SamplerUniform& sampler : ready.program->samplers) {
        if (sampler.target || runtime::tree_part(sampler.name, sampler.type)) continue;
        diagnostics.warning("unbound-texture", draw.span,
                            fmt::format("'{}' is {} {}, but no command binds such a texture: it reads as black",
                                        sampler.name, article(sampler.type), sampler.type),
                            "use a sampler1D, sampler2D, sampler3D or samplerCube");
        for (int element = 0; element < sampler.size; ++element) bind_black(sampler, element);
    }
}

}  // namespace snell
