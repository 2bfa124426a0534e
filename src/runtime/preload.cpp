// Files that the draws need are read and decoded on all cores, before any of them is uploaded.
#include <algorithm>

#include "src/content/parallel.h"
#include "src/plan/identity.h"
#include "src/runtime/impl.h"
#include "src/runtime/stopwatch.h"

namespace snell {

namespace runtime {

namespace {

// What was said of the file's name when the scene was planned is not said again.
void say_once(const Diagnostics& said, Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : said.items())
        if (std::ranges::none_of(diagnostics.items(), [&](const Diagnostic& other) {
                return other.code == diagnostic.code && other.span == diagnostic.span;
            }))
            diagnostics.add(diagnostic);
}

}  // namespace

content::Image Textures::read_image(Index texture, Diagnostics& diagnostics) {
    const Texture& declared = scene_->textures[texture];
    content::Image image = content::to_rgba(load_texture(*scene_, texture, *files_, diagnostics, &images_));
    if (declared.target == TextureTarget::d1) image.height = image.depth = 1;  // the first row given
    return image.bottom_first ? image : content::flipped(image);
}

// As they are uploaded: four channels, the top row first.
content::CubeFaces Textures::read_faces(Index texture, Diagnostics& diagnostics) {
    content::CubeFaces faces = load_cube(*scene_, texture, *files_, diagnostics, &images_);
    for (content::Image& face : faces) {
        face = content::to_rgba(face);
        if (face.bottom_first) face = content::flipped(face);
    }
    return faces;
}

void Textures::preload(const std::vector<Index>& wanted) {
    std::vector<Index> jobs;
    for (const Index index : wanted) {
        Index texture = same_[index];
        if (const Index source = scene_->textures[texture].source;
            source != none) {  // its source, if it is computed now
            if (textures_[texture] || store_->textures.has(key_of(texture).key)) continue;
            texture = same_[source];
        }
        if (textures_[texture] || preloaded_.contains(texture) || scene_->textures[texture].files.empty()) continue;
        if (!store_->textures.has(key_of(texture).key)) jobs.push_back(texture);
    }
    std::ranges::sort(jobs);
    jobs.erase(std::unique(jobs.begin(), jobs.end()), jobs.end());
    if (jobs.size() < 2) return;
    std::vector<Preloaded> done(jobs.size());
    content::parallel_blocks(jobs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Stopwatch watch;
            if (scene_->textures[jobs[i]].target == TextureTarget::cube)
                done[i].faces = read_faces(jobs[i], done[i].said);
            else
                done[i].image = read_image(jobs[i], done[i].said);
            done[i].milliseconds = watch.milliseconds();
        }
    });
    for (std::size_t i = 0; i < jobs.size(); ++i) preloaded_.emplace(jobs[i], std::move(done[i]));
}

std::optional<Textures::Preloaded> Textures::take_preloaded(Index texture) {
    const auto found = preloaded_.extract(texture);
    if (found.empty()) return std::nullopt;
    say_once(found.mapped().said, *diagnostics_);
    return std::move(found.mapped());
}

}  // namespace runtime

void Runtime::Impl::preload(Loading& loading) {
    std::vector<Index> wanted;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items) {
            if (!passes[pass].live || item.kind != Item::Kind::draw) continue;
            const Draw& draw = plan.scene.draws[item.index];
            const auto* program = link(draw.program, variant_of(pass, draw), loading);
            if (!program) continue;
            for (const runtime::Sampled& sampled : sampled_by(draw, *program))
                if (sampled.texture != none) wanted.push_back(sampled.texture);
        }
    textures.preload(wanted);
    preload_meshes(loading);
}

// Those from files; shapes take less time than it takes to tell another core of them.
void Runtime::Impl::preload_meshes(Loading& loading) {
    std::vector<Index> jobs;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items)
            if (passes[pass].live && item.kind == Item::Kind::draw) jobs.push_back(plan.draw_mesh[item.index]);
    std::ranges::sort(jobs);
    jobs.erase(std::unique(jobs.begin(), jobs.end()), jobs.end());
    std::erase_if(jobs, [&](Index mesh) {
        if (mesh == none || meshes[mesh]) return true;
        const Shape& shape = plan.meshes[mesh].shape;
        const bool file = std::holds_alternative<ObjFile>(shape) || std::holds_alternative<ShpFile>(shape);
        return !file || store->meshes.has(mesh_identity(plan, mesh, loading.files).key);
    });
    if (jobs.size() < 2) return;
    std::vector<LoadedMesh> done(jobs.size());
    content::parallel_blocks(jobs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const runtime::Stopwatch watch;
            done[i].mesh = load_mesh(plan, jobs[i], loading.files, done[i].said);
            done[i].milliseconds = watch.milliseconds();
        }
    });
    for (std::size_t i = 0; i < jobs.size(); ++i) loaded_meshes.emplace(jobs[i], std::move(done[i]));
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
