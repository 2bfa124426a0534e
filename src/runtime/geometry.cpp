// Meshes and their trees are made when the first draw that uses them is prepared.
#include <utility>

#include <fmt/format.h>

#include "src/plan/plan.h"
#include "src/runtime/impl.h"
#include "src/runtime/resources/counters.h"

namespace snell {

namespace runtime {
namespace {

constexpr std::uint64_t most_captured = 300'000;  // primitives of a frame: more are seldom drawn in time

std::array<bool, tree_parts> parts_read(const LinkedProgram& program) {
    std::array<bool, tree_parts> read{};
    for (const SamplerUniform& sampler : program.samplers)
        if (const auto part = tree_part(sampler.name, sampler.type)) read[static_cast<std::size_t>(*part)] = true;
    return read;
}

// Returns the texels in the order of TreePart. A tree without triangles gets one texel, because shaders cannot read
// empty textures.
std::array<std::vector<content::Float4>, tree_parts> texels(content::Tree tree, const content::Mesh& mesh, bool empty) {
    if (tree.triangles.empty()) tree.triangles.push_back({0, 0, 0, 0});
    return {std::move(tree.nodes), std::move(tree.triangles),
            empty ? std::vector<content::Float4>{{0, 0, 0, 0}} : content::tree_normals(mesh)};
}

}  // namespace

}  // namespace runtime

// Sets `loaded` to the mesh if it had to be read.
void Runtime::Impl::ready_mesh(Index mesh, std::optional<content::Mesh>& loaded, Loading& loading) {
    auto& slot = meshes[mesh];
    if (slot) return;
    const Identity identity = savings ? mesh_identity(plan, mesh, *files) : Identity{};
    const std::vector<Span> places = mesh_places(plan, mesh);
    slot = store->meshes.take(identity.key, places, loading.diagnostics);
    trees[mesh] = store->trees.take(identity.key, {}, loading.diagnostics);
    if (slot) {
        for (const std::string& path : identity.files) files->keep(path);
    } else {
        const std::size_t said_before = loading.diagnostics.items().size();
        LoadedMesh read = take_mesh(mesh, loading);
        loaded = std::move(read.mesh);
        const runtime::Stopwatch watch;
        slot = std::make_shared<runtime::GpuMesh>(runtime::upload(*loaded));
        slot->load_ms = read.milliseconds + watch.milliseconds();
        store->meshes.put(identity.key, slot, places, loading.diagnostics, said_before);
        counters.bytes_uploaded += slot->bytes;
        counters.buffers += slot->bytes ? 2 : 0;
        ++counters.meshes;
    }
    counters.gpu_bytes += slot->bytes;
    if (trees[mesh] && !trees[mesh]->at_fault) return;
    trees[mesh] = std::make_shared<runtime::GpuTree>();
    store->trees.put(identity.key, trees[mesh], {}, {}, 0);
}

// The mesh as textures, for vertex shaders that stand for other stages. `mesh` as in bind_tree.
void Runtime::Impl::ready_stages(runtime::ReadyDraw& ready, const content::Mesh* mesh, Loading& loading) {
    const Index program = plan.scene.draws[ready.draw].program;
    for (const auto& part : ready.program->parts) ready.part_controls.push_back(controls_of(program, *part));
    if (ready.program->tessellation)
        ready.patches = std::make_shared<runtime::PatchDraw>();
    else
        ready.stages = std::make_shared<runtime::StageDraw>();
    runtime::GpuMesh& gpu = *meshes[ready.mesh];
    if (gpu.stages) return;
    Diagnostics unheard;
    const content::Mesh again = mesh ? content::Mesh{} : load_mesh(plan, ready.mesh, *files, unheard);
    gpu.stages = runtime::stage_mesh(mesh ? *mesh : again, caps.max_texture);
    if (!gpu.stages) {
        loading.diagnostics.error("mesh-too-large", plan.scene.draws[ready.draw].span,
                                  "this OpenGL lacks stages of the program, and the mesh is too large for the textures "
                                  "by which it would do without them");
        return;
    }
    counters.gpu_bytes += gpu.stages->bytes;
    counters.bytes_uploaded += gpu.stages->bytes;
    counters.textures += 2;
}

void Runtime::Impl::find_costs() {
    for (const auto& [program, sum] : captured) {
        if (sum.primitives <= runtime::most_captured || !costly.insert(program).second) continue;
        costs.warning("costly-stages", plan.scene.programs[program].span,
                      fmt::format("without geometry shaders, which this OpenGL lacks, the {} primitives that this "
                                  "program emits take a detour through {} MB of memory in each picture",
                                  sum.primitives, sum.bytes / 1'000'000),
                      fmt::format("up to {} are drawn well: draw less, or emit less of it", runtime::most_captured));
    }
}

// Makes the parts that the draw's program is the first to read. `mesh` is the draw's mesh if it was just loaded; if it
// is null, the mesh is loaded again, and its problems have been reported.
void Runtime::Impl::bind_tree(runtime::ReadyDraw& ready, const content::Mesh* mesh, Loading& loading) {
    const auto read = runtime::parts_read(*ready.program);
    runtime::GpuTree& tree = *trees[ready.mesh];
    bool missing = false;
    for (std::size_t i = 0; i < read.size(); ++i) missing = missing || (read[i] && !tree.parts[i]);
    if (missing) {
        Diagnostics unheard;
        const content::Mesh again = mesh ? content::Mesh{} : load_mesh(plan, ready.mesh, *files, unheard);
        make_tree(tree, mesh ? *mesh : again, read, ready.draw, loading.diagnostics);
    }
    for (const runtime::SamplerUniform& sampler : ready.program->samplers)
        if (const auto part = runtime::tree_part(sampler.name, sampler.type))
            ready.textures.push_back(
                {sampler.first_unit, GL_TEXTURE_2D, tree.parts[static_cast<std::size_t>(*part)].get(), 0});
}

void Runtime::Impl::make_tree(runtime::GpuTree& tree, const content::Mesh& mesh,
                              const std::array<bool, runtime::tree_parts>& read, Index draw, Diagnostics& diagnostics) {
    const runtime::Stopwatch watch;
    const std::size_t limit = content::limit_of_rows(static_cast<std::size_t>(caps.max_texture));
    content::Tree made = content::make_tree(mesh, limit);
    const bool unfit = made.too_large;
    const Span span = plan.scene.draws[draw].span;
    if (!tree.built && unfit)
        diagnostics.error(
            "mesh-tree-too-large", span,
            fmt::format("rays cannot be traced through a mesh of {} or more triangles or vertices{}", limit,
                        limit < content::tree_limit
                            ? fmt::format(", because this OpenGL's GL_MAX_TEXTURE_SIZE is {}", caps.max_texture)
                            : ""),
            "use a coarser mesh; until then rays meet nothing");
    else if (!tree.built && made.triangles.empty())
        diagnostics.warning("mesh-tree-empty", span,
                            "the program traces rays through what it draws, but this draws no triangles",
                            "rays meet nothing");
    tree.at_fault = unfit || made.triangles.empty();
    counters.trees += tree.built ? 0 : 1;
    tree.built = true;
    auto all = runtime::texels(std::move(made), mesh, unfit);
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (!read[i] || tree.parts[i]) continue;
        const auto [width, height] = content::fill_rows(all[i]);
        const auto* data = reinterpret_cast<const std::byte*>(all[i].data());
        tree.parts[i] = gl::make_texture(GL_TEXTURE_2D, {gl::Pixels::rgba32f, width, height, 1, data},
                                         {gl::Sampling::Mode::nearest, 1, true});
        const std::size_t bytes = all[i].size() * sizeof(content::Float4);
        tree.bytes += bytes;
        counters.bytes_uploaded += bytes;
        counters.gpu_bytes += bytes;
        ++counters.textures;
    }
    tree.load_ms += watch.milliseconds();
}

// Files that the draws need are read and decoded on all cores, before any of them is uploaded.

void Runtime::Impl::preload(Loading& loading) {
    std::vector<Index> wanted;
    std::set<int> noise;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items) {
            if (!passes[pass].live || item.kind != Item::Kind::draw) continue;
            const Draw& draw = plan.scene.draws[item.index];
            const auto* program = link(draw.program, variant_of(pass, draw), loading);
            if (!program) continue;
            for (const runtime::Sampled& sampled : sampled_by(draw, *program)) {
                if (sampled.texture != none) wanted.push_back(sampled.texture);
                if (sampled.noise != 0) noise.insert(sampled.noise);
            }
        }
    std::vector<runtime::Job> jobs;
    textures.preload(wanted, noise, jobs);
    preload_meshes(jobs);
    runtime::run(jobs, progress);
}

// Only meshes from files are preloaded: making a shape takes less time than starting a job.
void Runtime::Impl::preload_meshes(std::vector<runtime::Job>& jobs) {
    std::set<Index> wanted;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items)
            if (passes[pass].live && item.kind == Item::Kind::draw) wanted.insert(plan.draw_mesh[item.index]);
    for (const Index mesh : wanted) {
        if (mesh == none || meshes[mesh]) continue;
        const Index file = file_of(plan.meshes[mesh].shape);
        if (file >= plan.scene.files.size() || store->meshes.has(mesh_identity(plan, mesh, *files).key)) continue;
        LoadedMesh& into = loaded_meshes[mesh];
        jobs.push_back({plan.scene.files[file].name, [this, mesh, &into] {
                            const runtime::Stopwatch watch;
                            into.mesh = load_mesh(plan, mesh, *files, into.said);
                            into.milliseconds = watch.milliseconds();
                        }});
    }
}

Runtime::Impl::LoadedMesh Runtime::Impl::take_mesh(Index mesh, Loading& loading) {
    LoadedMesh result;
    if (auto found = loaded_meshes.extract(mesh); !found.empty()) {
        result = std::move(found.mapped());
        runtime::say_once(result.said, loading.diagnostics);
        return result;
    }
    const runtime::Stopwatch watch;
    result.mesh = load_mesh(plan, mesh, *files, loading.diagnostics);
    result.milliseconds = watch.milliseconds();
    return result;
}

}  // namespace snell
