// Makes the resources of a plan: programs first, then what their active uniforms need.
#include <algorithm>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/runtime/impl.h"

namespace snell {

using runtime::LinkedProgram;
using runtime::ReadyDraw;
using runtime::ReadyPass;

namespace {

std::string_view input_name(GLenum input) {
    constexpr std::pair<GLenum, std::string_view> names[]{{GL_POINTS, "points"},
                                                          {GL_LINES, "lines"},
                                                          {GL_LINES_ADJACENCY, "lines_adjacency"},
                                                          {GL_TRIANGLES, "triangles"},
                                                          {GL_TRIANGLES_ADJACENCY, "triangles_adjacency"}};
    for (const auto& [known, name] : names)
        if (known == input) return name;
    return "patches";
}

int outputs_of(const Pass& pass, const gl::Caps& caps) {
    if (pass.kind != Pass::Kind::textures) return 1;
    return std::clamp(static_cast<int>(pass.textures.size()), 1, std::max(1, static_cast<int>(caps.max_draw_buffers)));
}

// Gives each draw a mesh of its own.
void own_meshes(Plan& plan) {
    std::vector<MeshRequest> meshes;
    for (Index& mesh : plan.draw_mesh) {
        if (mesh == none) continue;
        meshes.push_back(plan.meshes[mesh]);
        mesh = static_cast<Index>(meshes.size() - 1);
    }
    plan.meshes = std::move(meshes);
}

}  // namespace

Runtime::Impl::Impl(Plan p, Files& f, Sources& s, const gl::Caps& c, Diagnostics& diagnostics,
                    const RuntimeOptions& options)
    : plan(std::move(p)),
      caps(c),
      files(&f),
      sources(&s),
      working(plan.scene.programs.size()),
      savings(options.savings),
      progress(options.progress),
      store(options.previous ? options.previous->impl_->store : std::make_shared<runtime::Store>()),
      textures(plan.scene, f, caps, counters, store, savings, diagnostics),
      state(caps) {
    if (!savings) own_meshes(plan);
    if (savings) settle = options.settle;
    if (settle) settled_values = 1;
    prepare(diagnostics);
    if (!plan.scene.ladders.empty()) said = diagnostics.items();
}

// Prepares the chosen rungs. Resources of earlier calls are used again.
void Runtime::Impl::prepare(Diagnostics& diagnostics) {
    Loading loading{diagnostics, {}};
    Declared declared{*sources};
    link_programs(loading, declared);
    value_problems = Diagnostics(files->limits());
    given = make_controls(plan.scene, active, value_problems, &declared);
    given.rungs = plan.rungs;
    find_stand();
    passes.clear();
    fitted.reset();
    passes.resize(plan.scene.passes.size());
    find_live_passes(loading);
    ready_passes(loading);
    if (!savings) load_all();
    note_dormant();
    textures.finish();
    loaded_meshes.clear();
    store->prune();
    counters.targets = targets.size();
    counters.files_opened = files->counters().opened;
    counters.bytes_read = files->counters().bytes;
}

std::shared_ptr<LinkedProgram> Runtime::Impl::compile(Index program, const runtime::Variant& variant,
                                                      Diagnostics& diagnostics) {
    runtime::Store* from = savings ? store.get() : nullptr;
    if (program == none || (plan.programs[program].readable && plan.programs[program].stages.empty()))
        return runtime::link_builtin(variant, caps, from, counters);
    if (!plan.programs[program].readable) return nullptr;
    const bool another =
        ranges::any_of(programs, [&](const auto& other) { return other.first.first == program && other.second; });
    const std::uint64_t compiled = counters.programs_compiled;
    auto linked = runtime::link_program({plan.scene.programs[program],
                                         plan.programs[program].stages,
                                         plan.scene.ladders,
                                         variant,
                                         caps,
                                         *files,
                                         *sources,
                                         from,
                                         counters,
                                         variant.settled ? settler(program) : glsl::Settler(),
                                         {},
                                         program_name(plan.scene, program)},
                                        diagnostics);
    const std::uint64_t fresh = counters.programs_compiled - compiled;
    if (another) counters.variants += fresh;
    if (linked && !linked->settled.empty() && fresh > 0) {
        ++counters.specialised;
        counters.specialise_us += static_cast<std::uint64_t>(linked->load_ms * 1e3);
    }
    return linked;
}

std::shared_ptr<LinkedProgram>& Runtime::Impl::made(Index program, const runtime::Variant& variant, Loading& loading) {
    const auto [slot, fresh] = programs.try_emplace({program, variant});
    if (!fresh) return slot->second;
    Diagnostics& problems_of = program_problems[slot->first];
    slot->second = compile(program, variant, problems_of);
    if (variant.settled == 0 || (slot->second && !slot->second->settled.empty())) return slot->second;
    // There is nothing to settle, or a driver refuses constants where it takes uniforms, as for an index that is too
    // large: the program for any values is used, and says what is wrong.
    runtime::Variant general = variant;
    general.settled = 0;
    if (slot->second) {
        programs.try_emplace({program, general}, slot->second);
        program_problems.try_emplace({program, general}, problems_of);
    } else {
        slot->second = made(program, general, loading);
        problems_of = program_problems[{program, general}];
    }
    return slot->second;
}

LinkedProgram* Runtime::Impl::link(Index program, runtime::Variant variant, Loading& loading) {
    variant.settled = program == none ? 0 : settled_values;
    LinkedProgram* const linked = made(program, variant, loading).get();
    Diagnostics& problems_of = program_problems[{program, variant}];
    if (loading.reported.insert(&problems_of).second) loading.diagnostics.append(problems_of);
    return linked;
}

namespace {

bool tells_time(const ActiveUniform& uniform) {
    return uniform.system && ranges::any_of(glsl::system_names(), [&](const glsl::SystemName& known) {
               const bool time = known.system == glsl::System::timer || known.system == glsl::System::time;
               return time && known.name == uniform.name;
           });
}

}  // namespace

// Programs that no draw uses are compiled too, because the user wants their sliders and errors.
void Runtime::Impl::link_programs(Loading& loading, Declared& declared) {
    const Scene& scene = plan.scene;
    std::vector<runtime::Variant> first(scene.programs.size());
    std::vector<bool> used(scene.programs.size(), false);
    active.clear();
    dormant.clear();
    animated = mouse = timed = false;
    for (const Pass& pass : scene.passes)
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            if (draw.program == none || used[draw.program]) continue;
            used[draw.program] = true;
            first[draw.program] = {scene.rasters[draw.raster].flat, false, outputs_of(pass, caps), {}};
            first[draw.program].patch = patch_of(draw);
        }
    for (Index i = 0; i < scene.programs.size(); ++i) {
        tell(LoadProgress::Stage::programs, scene.programs[i].name, i, scene.programs.size());
        const LinkedProgram* linked = link_chosen(i, first[i], loading);
        active.emplace_back(linked ? general_uniforms(i, *linked, first[i], loading) : std::vector<ActiveUniform>{});
        declared.programs.push_back(linked ? linked->declared : std::vector<glsl::DeclaredUniform>{});
        dormant.emplace_back();
        if (linked) find_dormant(i, *linked);
        if (!linked || !used[i]) continue;
        animated = animated || linked->reads(glsl::System::timer) || linked->reads(glsl::System::time);
        timed = timed || ranges::any_of(active.back(), tells_time);
        mouse = mouse || linked->reads(glsl::System::mouse);
    }
    tell(LoadProgress::Stage::programs, "", scene.programs.size(), scene.programs.size());
}

// A pass is live if the window shows something of it, directly or through other passes. Nothing is loaded for the
// others.
std::vector<bool> Runtime::Impl::live_passes(Loading& loading, bool of_dormant) {
    const Scene& scene = plan.scene;
    std::vector<bool> live(passes.size(), false);
    std::vector<Index> open;
    const auto visit = [&](Index pass) {
        if (live[pass]) return;
        live[pass] = true;
        open.push_back(pass);
    };
    const auto read = [&](Index texture) {
        for (Index pass = 0; pass < passes.size(); ++pass)
            for (const Index drawn : scene.passes[pass].textures)
                if (drawn != none && textures.first(drawn) == textures.first(texture)) visit(pass);
    };
    for (Index pass = 0; pass < passes.size(); ++pass)
        if (!savings || scene.passes[pass].kind == Pass::Kind::window) visit(pass);
    while (!open.empty()) {
        const Index pass = open.back();
        open.pop_back();
        for (const Item& item : scene.passes[pass].items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            const LinkedProgram* program = link(draw.program, variant_of(pass, draw), loading);
            if (!program) continue;
            ranges::for_each(read_by(draw, *program), read);
            if (of_dormant) ranges::for_each(spared_by(draw, *program), read);
        }
    }
    return live;
}

void Runtime::Impl::find_live_passes(Loading& loading) {
    const Scene& scene = plan.scene;
    const std::vector<bool> live = live_passes(loading, false), wanted = live_passes(loading, true);
    for (Index pass = 0; pass < passes.size(); ++pass) {
        passes[pass].live = live[pass];
        passes[pass].wanted = wanted[pass];
        if (wanted[pass] || !scene.ladders.empty()) continue;  // another rung may read it
        loading.diagnostics.add({Severity::note,
                                 "unread-pass",
                                 scene.passes[pass].span,
                                 "nothing reads what is rendered here: the pass is not drawn",
                                 "",
                                 {},
                                 true});
    }
}

runtime::Variant Runtime::Impl::variant_of(Index pass, const Draw& draw) const {
    runtime::Variant variant{
        plan.scene.rasters[draw.raster].flat, false, outputs_of(plan.scene.passes[pass], caps), {}};
    variant.patch = patch_of(draw);
    if (draw.program != none) variant.rungs = working[draw.program].value_or(rungs_of(draw.program));
    if (!parts || plan.scene.passes[pass].kind != Pass::Kind::window) return variant;
    variant.settled = draw.program == none ? 0 : settled_values;
    const auto whole = programs.find({draw.program, variant});
    variant.placed = whole != programs.end() && whole->second && whole->second->reads_place;
    return variant;
}

// Until the mesh is there, by what is written.
int Runtime::Impl::patch_of(const Draw& draw) const {
    const auto tessellates = [](const glsl::StageInput& stage) { return stage.stage == Stage::tess_evaluation; };
    // Of OpenGL ES, only the translator knows what its stages lack.
    const bool complete = caps.tessellation && !caps.es;
    if (complete || draw.program == none || ranges::none_of(plan.programs[draw.program].stages, tessellates)) return 0;
    const Index mesh = plan.draw_mesh[&draw - plan.scene.draws.data()];
    const auto of = [](Topology topology, int patch_vertices) {
        return topology == Topology::patches ? patch_vertices : static_cast<int>(runtime::facts_of(topology).least);
    };
    if (mesh == none) return 3;
    if (mesh < meshes.size() && meshes[mesh]) return of(meshes[mesh]->topology, meshes[mesh]->patch_vertices);
    if (const auto* list = std::get_if<VertexList>(&draw.shape)) {
        const VertexListData& data = plan.scene.vertex_lists[list->list];
        return of(data.topology, data.patch_vertices);
    }
    return plan.meshes[mesh].wire ? 2 : std::holds_alternative<PointCloud>(draw.shape) ? 1 : 3;
}

void Runtime::Impl::ready_passes(Loading& loading) {
    meshes.resize(plan.meshes.size());
    trees.resize(plan.meshes.size());
    if (savings) preload(loading);
    const std::size_t all = plan.scene.draws.size();
    std::size_t done = 0;
    for (Index pass = 0; pass < plan.scene.passes.size(); ++pass) {
        if (!passes[pass].live) continue;
        ready_target(pass, loading.diagnostics);
        for (const Item& item : plan.scene.passes[pass].items) {
            auto& ready = passes[pass].items.emplace_back();
            if (item.kind != Item::Kind::draw) continue;
            tell(LoadProgress::Stage::draws, "", done++, all);
            ready = ready_draw(pass, item.index, loading);
        }
    }
    tell(LoadProgress::Stage::draws, "", all, all);
}

// Loads everything that is declared, whether it is read or not.
void Runtime::Impl::load_all() {
    Diagnostics unheard;  // the user does not see these resources
    textures.resume(unheard);
    for (Index texture = 0; texture < plan.scene.textures.size(); ++texture) textures.realise(texture);
    textures.noise(2);
    textures.noise(3);
    const std::array<bool, runtime::tree_parts> all{true, true, true};
    Diagnostics heard_before;
    for (const auto& pass : passes)
        for (const auto& ready : pass.items)
            if (ready)
                make_tree(*trees[ready->mesh], load_mesh(plan, ready->mesh, *files, heard_before), all, ready->draw,
                          unheard);
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
        diagnostics.error("target-unsupported", declared.span, "this OpenGL cannot render to these textures",
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
    runtime::Variant variant = variant_of(pass, draw);
    ready.program = link(draw.program, variant, loading);
    if (!ready.program || ready.mesh == none) return std::nullopt;
    std::optional<content::Mesh> loaded;
    ready_mesh(ready.mesh, loaded, loading);
    const auto& mesh = meshes[ready.mesh];
    if (const int patch = patch_of(draw); patch != variant.patch) {
        variant.patch = patch;
        ready.program = link(draw.program, variant, loading);
        if (!ready.program) return std::nullopt;
    }
    variant.wide = raster.line_width > static_cast<double>(caps.max_line_width) &&
                   runtime::facts_of(mesh->topology).input == GL_LINES && !ready.program->geometry_input &&
                   !ready.program->tessellates;
    if (variant.wide && !caps.geometry) {
        loading.diagnostics.warning("thin-lines", draw.span,
                                    fmt::format("this OpenGL draws lines at most {:g} pixels wide and has no geometry "
                                                "shaders to widen them",
                                                caps.max_line_width));
        variant.wide = false;
    }
    if (variant.wide) ready.program = link(draw.program, variant, loading);
    if (!ready.program || mesh->count == 0 || !match_topology(ready, *mesh, loading.diagnostics)) return std::nullopt;
    if (raster.wireframe && caps.es)
        loading.diagnostics.warning("wireframe-unsupported", draw.span,
                                    "OpenGL ES draws no wireframes: faces are filled");
    bind_textures(ready, pass, loading.diagnostics);
    report_dormant(pass, ready, loading.diagnostics);
    bind_harmonics(ready, pass, loading.diagnostics);
    bind_tree(ready, loaded ? &*loaded : nullptr, loading);
    ready.controls = controls_of(draw.program, *ready.program);
    if (!ready.program->parts.empty()) ready_stages(ready, loaded ? &*loaded : nullptr, loading);
    if (!ready.program->parts.empty() && !meshes[ready.mesh]->stages) return std::nullopt;
    return ready;
}

// GL refuses a draw whose primitives differ from those that the program takes.
bool Runtime::Impl::match_topology(ReadyDraw& ready, const runtime::GpuMesh& mesh, Diagnostics& diagnostics) {
    const LinkedProgram& program = *ready.program;
    const GLenum input = runtime::facts_of(mesh.topology).input;
    const Span span = plan.scene.draws[ready.draw].span;
    ready.mode = runtime::facts_of(mesh.topology).mode;
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

// Changes rungs while a scene runs. What a rung needs is compiled and loaded when it is first chosen, and kept.

namespace {

bool exist(const Rungs& rungs, const std::vector<Ladder>& ladders) {
    return ranges::equal(rungs, ladders,
                         [](std::size_t rung, const Ladder& ladder) { return rung < ladder.rungs.size(); });
}

bool same(const Diagnostic& a, const Diagnostic& b) {
    return a.code == b.code && a.span == b.span && a.message == b.message;
}

}  // namespace

bool Runtime::Impl::choose(const Rungs& rungs) {
    if (rungs == plan.rungs || !exist(rungs, plan.scene.ladders)) return false;
    plan.rungs = rungs;
    costly.clear();
    forget_forms();
    Diagnostics all;
    textures.resume(all);
    prepare(all);
    problems = {};
    for (const Diagnostic& diagnostic : all.items()) {
        const auto known = [&](const Diagnostic& other) { return same(diagnostic, other); };
        if (ranges::none_of(said, known) && ranges::none_of(problems.items(), known)) problems.add(diagnostic);
    }
    return true;
}

void Runtime::Impl::take(const Controls& controls) {
    choose(controls.rungs);
    const auto place = [&] {
        values = &controls;
        if (same_uniforms(controls, given)) return;
        moved = given;
        carry_over(controls, plan.scene, moved, plan.scene);
        values = &moved;
    };
    place();
    if (stands(*values) && (settled_values != 0 || forms.empty())) return;
    if (take_form(*values)) return;
    settle = nullptr;
    settled_values = 0;
    Diagnostics heard_before;
    textures.resume(heard_before);
    prepare(heard_before);
    place();
}

std::vector<Index> Runtime::Impl::controls_of(Index program, const runtime::LinkedProgram& linked) const {
    std::vector<Index> places;
    for (const runtime::UserUniform& uniform : linked.user) {
        const Control* control = given.find(program, uniform.name);
        // A program for values may need fewer elements of an array.
        const bool usable = control && control->active && control->components == uniform.components &&
                            control->value.size() >= uniform.last.size();
        places.push_back(usable ? static_cast<Index>(control - given.items.data()) : none);
    }
    return places;
}

void Runtime::Impl::take_parts(bool wanted) {
    if (parts == wanted) return;
    parts = wanted;
    forget_forms();
    const auto reads_place = [](const auto& program) { return program.second && program.second->reads_place; };
    if (ranges::none_of(programs, reads_place)) return;
    Diagnostics heard_before;
    textures.resume(heard_before);
    prepare(heard_before);
}

// A program knows only the ladders before it.
Rungs Runtime::Impl::rungs_of(Index program) const {
    const auto known = static_cast<std::ptrdiff_t>(plan.scene.programs[program].ladders);
    return {plan.rungs.begin(), plan.rungs.begin() + known};
}

// Links the program for the chosen rungs. If it does not compile, the program stays as it was before.
runtime::LinkedProgram* Runtime::Impl::link_chosen(Index program, runtime::Variant variant, Loading& loading) {
    variant.rungs = rungs_of(program);
    runtime::LinkedProgram* linked = link(program, variant, loading);
    if (linked || !working[program]) {
        if (linked) working[program] = variant.rungs;
        return linked;
    }
    variant.rungs = *working[program];
    return link(program, variant, loading);
}

}  // namespace snell
