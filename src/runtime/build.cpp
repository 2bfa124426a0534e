// From a Plan to what can be drawn: programs, then what their active uniforms call for.
#include <fmt/format.h>

#include <algorithm>

#include "src/runtime/impl.h"

namespace snell {

using runtime::BoundTexture;
using runtime::LinkedProgram;
using runtime::ReadyDraw;
using runtime::ReadyPass;
using runtime::SamplerUniform;

namespace {

// The dimensions of the built-in noise that stands on this sampler, 0 for none.
int noise_dimensions(const SamplerUniform& sampler, bool named, int unit) {
    if (sampler.target == TextureTarget::d2 && ((sampler.name == "Noise2" && !named) || unit == 2)) return 2;
    if (sampler.target == TextureTarget::d3 && ((sampler.name == "Noise3" && !named) || unit == 3)) return 3;
    return 0;
}

GLenum input_of(Topology topology) {
    switch (topology) {
        case Topology::points:
            return GL_POINTS;
        case Topology::lines:
        case Topology::line_strip:
        case Topology::line_loop:
            return GL_LINES;
        case Topology::triangles:
        case Topology::triangle_strip:
        case Topology::triangle_fan:
            return GL_TRIANGLES;
        case Topology::lines_adjacency:
        case Topology::line_strip_adjacency:
            return GL_LINES_ADJACENCY;
        case Topology::triangles_adjacency:
        case Topology::triangle_strip_adjacency:
            return GL_TRIANGLES_ADJACENCY;
        case Topology::patches:
            return GL_PATCHES;
    }
    return GL_TRIANGLES;
}

std::string_view input_name(GLenum input) {
    switch (input) {
        case GL_POINTS:
            return "points";
        case GL_LINES:
            return "lines";
        case GL_LINES_ADJACENCY:
            return "lines_adjacency";
        case GL_TRIANGLES:
            return "triangles";
        case GL_TRIANGLES_ADJACENCY:
            return "triangles_adjacency";
        default:
            return "patches";
    }
}

constexpr std::array<std::string_view, 4> target_names{"Texture1D", "Texture2D", "Texture3D", "CubeMap"};

int outputs_of(const Pass& pass, const gl::Caps& caps) {
    if (pass.kind != Pass::Kind::textures) return 1;
    return std::clamp(static_cast<int>(pass.textures.size()), 1, std::max(1, static_cast<int>(caps.max_draw_buffers)));
}

}  // namespace

Runtime::Impl::Impl(Plan p, Files& f, Sources& s, const gl::Caps& c, Diagnostics& diagnostics)
    : plan(std::move(p)),
      caps(c),
      files(&f),
      sources(&s),
      working(plan.scene.programs.size()),
      textures(plan.scene, f, caps, diagnostics),
      state(caps) {
    prepare(diagnostics);
    if (!plan.scene.ladders.empty()) said = diagnostics.items();
}

// For the chosen rungs. What an earlier call has made is used again.
void Runtime::Impl::prepare(Diagnostics& diagnostics) {
    Loading loading{*files, *sources, diagnostics, {}};
    link_programs(loading);
    Diagnostics unheard;  // who asks for the controls hears of them
    given = make_controls(plan.scene, active, unheard);
    ready_passes(loading);
    drop_unread_passes(diagnostics);
    textures.finish();
    count_textures();
    counters.targets = targets.size();
    counters.files_opened = files->counters().opened;
    counters.bytes_read = files->counters().bytes;
}

void Runtime::Impl::count_textures() {
    const runtime::TextureCounters& t = textures.counters();
    counters.images_decoded = t.decoded;
    counters.bytes_decoded = t.bytes_decoded;
    counters.bytes_uploaded += t.bytes_uploaded - counted.bytes_uploaded;
    counters.textures = t.textures;
    counters.gpu_bytes += t.gpu_bytes - counted.gpu_bytes;
    counters.convolutions = t.convolutions;
    counted = t;
}

LinkedProgram* Runtime::Impl::link(Index program, const runtime::Variant& variant, Loading& loading) {
    const auto [slot, fresh] = programs.try_emplace({program, variant});
    Diagnostics& problems_of = program_problems[slot->first];
    if (fresh) {
        if (program == none || (plan.programs[program].readable && plan.programs[program].stages.empty())) {
            slot->second = runtime::link_builtin(variant, caps);
        } else if (plan.programs[program].readable) {
            slot->second =
                runtime::link_program(plan.scene.programs[program], plan.programs[program].stages, plan.scene.ladders,
                                      variant, caps, loading.files, loading.sources, problems_of);
        }
        counters.programs_compiled += slot->second ? 1 : 0;
    }
    if (loading.reported.insert(&problems_of).second) loading.diagnostics.append(problems_of);
    return slot->second ? &*slot->second : nullptr;
}

// A program that nothing draws with is compiled all the same: its sliders and its errors are the user's.
void Runtime::Impl::link_programs(Loading& loading) {
    const Scene& scene = plan.scene;
    std::vector<runtime::Variant> first(scene.programs.size());
    std::vector<bool> used(scene.programs.size(), false);
    active.clear();
    animated = mouse = false;
    for (const Pass& pass : scene.passes)
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            if (draw.program == none || used[draw.program]) continue;
            used[draw.program] = true;
            first[draw.program] = {scene.rasters[draw.raster].flat, false, outputs_of(pass, caps), {}};
        }
    for (Index i = 0; i < scene.programs.size(); ++i) {
        const LinkedProgram* linked = link_chosen(i, first[i], loading);
        active.emplace_back(linked ? linked->active : std::vector<ActiveUniform>{});
        if (!linked || !used[i]) continue;
        animated = animated || linked->reads(glsl::System::timer) || linked->reads(glsl::System::time);
        mouse = mouse || linked->reads(glsl::System::mouse);
    }
}

void Runtime::Impl::ready_passes(Loading& loading) {
    meshes.resize(plan.meshes.size());
    trees.resize(plan.meshes.size());
    passes.assign(plan.scene.passes.size(), {});
    for (Index pass = 0; pass < plan.scene.passes.size(); ++pass) {
        ready_target(pass, loading.diagnostics);
        for (const Item& item : plan.scene.passes[pass].items)
            passes[pass].items.push_back(item.kind == Item::Kind::draw ? ready_draw(pass, item.index, loading)
                                                                       : std::nullopt);
    }
}

void Runtime::Impl::ready_target(Index pass, Diagnostics& diagnostics) {
    const Pass& declared = plan.scene.passes[pass];
    ReadyPass& ready = passes[pass];
    if (declared.kind == Pass::Kind::window) return;
    std::vector<gl::Attachment> attachments;
    for (Index texture : declared.textures) {
        const runtime::GpuTexture* gpu = texture == none ? nullptr : textures.realise(texture);
        if (!gpu) continue;
        ready.textures.push_back(texture);
        ready.remake_mipmaps.push_back(gpu->mipmapped ? gpu->target : 0);
        const bool first = attachments.empty();
        ready.width = first ? gpu->size[0] : std::min(ready.width, gpu->size[0]);
        ready.height = first ? gpu->size[1] : std::min(ready.height, gpu->size[1]);
        attachments.push_back({gpu->texture.get(), gpu->target});
    }
    auto& made = targets[ready.textures];
    ready.live = !attachments.empty();
    if (!made.empty()) ready.live = static_cast<bool>(made.back().framebuffer);
    if (!ready.live || !made.empty()) return;
    const bool cube = declared.kind == Pass::Kind::cube;
    for (GLenum face = 0; face < (cube ? 6U : 1U); ++face) {
        for (gl::Attachment& attachment : attachments)
            if (cube) attachment.target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        made.push_back(gl::make_texture_target(attachments, ready.width, ready.height));
        if (made.back().framebuffer) continue;
        diagnostics.error("target-unsupported", declared.span, "this OpenGL can't render to these textures",
                          fmt::format("use 2D textures, at most {} at once", caps.max_draw_buffers));
        ready.live = false;
        return;
    }
    counters.gpu_bytes +=
        std::size_t{4} * static_cast<std::size_t>(ready.width) * static_cast<std::size_t>(ready.height) * made.size();
}

std::optional<ReadyDraw> Runtime::Impl::ready_draw(Index pass, Index index, Loading& loading) {
    const Draw& draw = plan.scene.draws[index];
    const RasterState& raster = plan.scene.rasters[draw.raster];
    ReadyDraw ready;
    ready.draw = index;
    ready.mesh = plan.draw_mesh[index];
    runtime::Variant variant{raster.flat, false, outputs_of(plan.scene.passes[pass], caps), {}};
    if (draw.program != none) variant.rungs = working[draw.program].value_or(rungs_of(draw.program));
    ready.program = link(draw.program, variant, loading);
    if (!ready.program || ready.mesh == none) return std::nullopt;
    auto& mesh = meshes[ready.mesh];
    std::optional<content::Mesh> loaded;
    if (!mesh) {
        loaded = load_mesh(plan, ready.mesh, loading.files, loading.diagnostics);
        mesh = runtime::upload(*loaded);
        counters.bytes_uploaded += mesh->bytes;
        counters.gpu_bytes += mesh->bytes;
        counters.buffers += mesh->bytes ? 2 : 0;
    }
    variant.wide = raster.line_width > static_cast<double>(caps.max_line_width) &&
                   input_of(mesh->topology) == GL_LINES && !ready.program->geometry_input &&
                   !ready.program->tessellates;
    if (variant.wide) ready.program = link(draw.program, variant, loading);
    if (!ready.program || mesh->count == 0 || !match_topology(ready, *mesh, loading.diagnostics)) return std::nullopt;
    if (raster.wireframe && caps.es)
        loading.diagnostics.warning("wireframe-unsupported", draw.span,
                                    "OpenGL ES draws no wireframes: faces are filled");
    bind_textures(ready, pass, loading.diagnostics);
    bind_harmonics(ready, pass, loading.diagnostics);
    bind_tree(ready, loaded ? &*loaded : nullptr, loading);
    return ready;
}

// GL refuses a draw whose primitives are not what the program takes.
bool Runtime::Impl::match_topology(ReadyDraw& ready, const runtime::GpuMesh& mesh, Diagnostics& diagnostics) {
    const LinkedProgram& program = *ready.program;
    const GLenum input = input_of(mesh.topology);
    const Span span = plan.scene.draws[ready.draw].span;
    ready.mode = runtime::gl_mode(mesh.topology);
    ready.patch_vertices = mesh.patch_vertices;
    if (program.tessellates) {
        if (input == GL_PATCHES) return true;
        const bool lists = mesh.topology == Topology::triangles || mesh.topology == Topology::lines ||
                           mesh.topology == Topology::points;
        if (lists) {  // each triangle, line or point is a patch
            ready.mode = GL_PATCHES;
            ready.patch_vertices = input == GL_TRIANGLES ? 3 : input == GL_LINES ? 2 : 1;
            return true;
        }
        diagnostics.error("tessellation-input", span, "a program with tessellation shaders draws patches",
                          "use gl_patches or ObjPatch");
        return false;
    }
    if (input == GL_PATCHES) {
        diagnostics.error("patches-without-tessellation", span,
                          "patches can only be drawn by a program with tessellation shaders",
                          "name TessControl and TessEvaluation shaders before the Program");
        return false;
    }
    if (!program.geometry_input || program.geometry_input == input) return true;
    diagnostics.error("geometry-input", span,
                      fmt::format("the geometry shader takes {}, but this draws {}", input_name(program.geometry_input),
                                  input_name(input)));
    return false;
}

// The cube map of the last Irradiance before the draw, or of the text's last one, as with all that is bound.
void Runtime::Impl::bind_harmonics(ReadyDraw& ready, Index pass, Diagnostics& diagnostics) {
    if (!ready.program->reads(glsl::System::harmonics)) return;
    const Scene& scene = plan.scene;
    const auto& bound = scene.bindings[scene.draws[ready.draw].bindings].entries;
    Index last = none;
    const auto consider = [&](Index texture) {
        if (scene.textures[texture].computed == Computed::irradiance && (last == none || texture > last))
            last = texture;
    };
    for (const Bindings::Entry& entry : bound) consider(entry.texture);
    for (Index i = 0; last == none && i < scene.textures.size(); ++i)
        consider(static_cast<Index>(scene.textures.size() - 1 - i));
    if (last == none) {
        diagnostics.warning("no-harmonics", scene.draws[ready.draw].span,
                            "the program reads uHarmonics, but no Irradiance names a cube map",
                            "name one: Irradiance 7 6");
        return;
    }
    const Index source = scene.textures[last].source;
    if (auto problem = feedback_error(scene, pass, ready.draw, source)) {
        diagnostics.add(std::move(*problem));
        return;
    }
    ready.sources.push_back(source);
    if (scene.textures[source].files.empty()) textures.realise(source);
    ready.harmonics = textures.harmonics(source);
}

void Runtime::Impl::bind_textures(ReadyDraw& ready, Index pass, Diagnostics& diagnostics) {
    const Scene& scene = plan.scene;
    const Draw& draw = scene.draws[ready.draw];
    if (draw.program == none) return;
    const Program& program = scene.programs[draw.program];
    const bool clamp = scene.rasters[draw.raster].clamp;
    for (const SamplerUniform& sampler : ready.program->samplers) {
        if (!sampler.target) continue;
        const bool cube = sampler.target == TextureTarget::cube;
        // What the Program line says of a sampler is read as every other value is.
        const Control* control = given.find(draw.program, sampler.name);
        const bool named = control && control->listed;
        for (int element = 0; element < sampler.size; ++element) {
            const auto at = static_cast<size_t>(element);
            const int unit = control && at < control->value.size() ? static_cast<int>(control->value[at])
                             : at < sampler.initial.size()         ? sampler.initial[at]
                                                                   : 0;
            const int noise = noise_dimensions(sampler, named, unit);
            const bool by_name = noise && !named;
            Index found = find_texture(scene, draw, by_name ? noise : unit, *sampler.target);
            // OpenGL ES has no 1D textures: they are 2D ones of one row.
            if (found == none && caps.es && sampler.target == TextureTarget::d2)
                found = find_texture(scene, draw, unit, TextureTarget::d1);
            const runtime::GpuTexture* gpu = nullptr;
            Filter filter;
            if (found != none) {
                // What is computed from the target would show the frame before.
                const Index source = scene.textures[found].source;
                auto problem = feedback_error(scene, pass, ready.draw, found);
                if (!problem) problem = feedback_error(scene, pass, ready.draw, source);
                if (problem) {
                    diagnostics.add(std::move(*problem));
                    continue;
                }
                if (source != none) ready.sources.push_back(source);
                gpu = textures.realise(found);
                filter = scene.textures[found].filter;
            } else if (noise) {
                gpu = textures.noise(noise);
            } else {
                diagnostics.warning(
                    "unbound-texture", draw.span,
                    fmt::format("no {} stands on unit {}, which '{}' of program '{}' reads",
                                target_names[static_cast<size_t>(*sampler.target)], unit, sampler.name, program.name),
                    "it reads as black");
            }
            if (gpu)
                ready.textures.push_back({sampler.first_unit + element, gpu->target, gpu->texture.get(),
                                          textures.sampler(filter, clamp, cube)});
        }
    }
}

// A pass that nothing reads is not drawn. What reads it may itself be unread, so this repeats until nothing
// changes.
void Runtime::Impl::drop_unread_passes(Diagnostics& diagnostics) {
    for (bool changed = true; changed;) {
        changed = false;
        std::set<GLuint> read;
        std::set<Index> sources;
        for (const ReadyPass& pass : passes)
            if (pass.live)
                for (const auto& item : pass.items)
                    if (item) {
                        for (const BoundTexture& texture : item->textures) read.insert(texture.texture);
                        sources.insert(item->sources.begin(), item->sources.end());
                    }
        for (Index i = 0; i < passes.size(); ++i) {
            ReadyPass& pass = passes[i];
            if (!pass.live || plan.scene.passes[i].kind == Pass::Kind::window) continue;
            const bool wanted = std::ranges::any_of(pass.textures, [&](Index texture) {
                const auto* gpu = textures.find(texture);
                return gpu && (read.contains(gpu->texture.get()) || sources.contains(texture));
            });
            if (wanted) continue;
            pass.live = false;
            changed = true;
            if (!plan.scene.ladders.empty()) continue;  // another rung may read it
            Diagnostic note{Severity::note,
                            "unread-pass",
                            plan.scene.passes[i].span,
                            "nothing reads what is rendered here: the pass is not drawn",
                            "",
                            {},
                            true};
            diagnostics.add(std::move(note));
        }
    }
}

}  // namespace snell
