// Files that the draws need are read and decoded on all cores, before any of them is uploaded.
#include <algorithm>

#include "src/plan/identity.h"
#include "src/runtime/impl.h"
#include "src/runtime/resources/stopwatch.h"

namespace snell {

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
    preload_meshes(loading, jobs);
    runtime::run(jobs, progress);
}

// Only meshes from files are preloaded: making a shape takes less time than starting a job.
void Runtime::Impl::preload_meshes(Loading& loading, std::vector<runtime::Job>& jobs) {
    std::set<Index> wanted;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items)
            if (passes[pass].live && item.kind == Item::Kind::draw) wanted.insert(plan.draw_mesh[item.index]);
    for (const Index mesh : wanted) {
        if (mesh == none || meshes[mesh]) continue;
        const Index file = file_of(plan.meshes[mesh].shape);
        if (file >= plan.scene.files.size() || store->meshes.has(mesh_identity(plan, mesh, loading.files).key))
            continue;
        LoadedMesh& into = loaded_meshes[mesh];
        jobs.push_back({plan.scene.files[file].name, [this, mesh, &into, &files = loading.files] {
                            const runtime::Stopwatch watch;
                            into.mesh = load_mesh(plan, mesh, files, into.said);
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
    result.mesh = load_mesh(plan, mesh, loading.files, loading.diagnostics);
    result.milliseconds = watch.milliseconds();
    return result;
}

}  // namespace snell
