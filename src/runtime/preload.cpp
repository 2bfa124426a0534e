// Files that the draws need are read and decoded on all cores, before any of them is uploaded.
#include <algorithm>

#include "src/content/image/noise.h"
#include "src/plan/identity.h"
#include "src/runtime/impl.h"
#include "src/runtime/resources/stopwatch.h"

namespace snell {

namespace runtime {

void say_once(const Diagnostics& said, Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : said.items())
        if (std::ranges::none_of(diagnostics.items(), [&](const Diagnostic& other) {
                return other.is_at(diagnostic.code, diagnostic.span);
            }))
            diagnostics.add(diagnostic);
}

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

void Textures::preload_image(Index texture, Preloaded& into) {
    const Stopwatch watch;
    if (scene_->textures[texture].target == TextureTarget::cube)
        into.faces = read_faces(texture, into.said);
    else
        into.image = read_image(texture, into.said);
    into.milliseconds = watch.milliseconds();
}

void Textures::preload_noise(int dimensions, Preloaded& into) {
    const Stopwatch watch;
    into.image = read_noise(dimensions, into.said);
    into.milliseconds = watch.milliseconds();
}

content::Image Textures::read_noise(int dimensions, Diagnostics& diagnostics) {
    const content::Image image = content::to_rgba(load_noise(dimensions, noise_size(dimensions), *files_, diagnostics));
    return image.bottom_first ? image : content::flipped(image);
}

void Textures::preload(const std::vector<Index>& wanted, const std::set<int>& noise, std::vector<Job>& jobs) {
    for (const int dimensions : noise) {
        const Identity identity = noise_identity(dimensions, noise_size(dimensions), *files_);
        if (find_noise(dimensions) || store_->textures.has(identity.key)) continue;
        Preloaded& into = preloaded_noise_[dimensions];
        jobs.push_back({content::noise_file_name(dimensions, noise_size(dimensions)),
                        [this, dimensions, &into] { preload_noise(dimensions, into); }});
    }
    std::set<Index> textures;
    for (const Index index : wanted) {
        Index texture = same_[index];
        if (const Index source = scene_->textures[texture].source;
            source != none) {  // its source, if it is computed now
            if (textures_[texture] || store_->textures.has(key_of(texture).key)) continue;
            texture = same_[source];
        }
        if (textures_[texture] || preloaded_.contains(texture) || scene_->textures[texture].files.empty()) continue;
        if (!store_->textures.has(key_of(texture).key)) textures.insert(texture);
    }
    for (const Index texture : textures) {
        Preloaded& into = preloaded_[texture];
        jobs.push_back(
            {scene_->textures[texture].files[0].name, [this, texture, &into] { preload_image(texture, into); }});
    }
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

// Those from files; shapes take less time than it takes to tell another core of them.
void Runtime::Impl::preload_meshes(Loading& loading, std::vector<runtime::Job>& jobs) {
    std::set<Index> wanted;
    for (Index pass = 0; pass < passes.size(); ++pass)
        for (const Item& item : plan.scene.passes[pass].items)
            if (passes[pass].live && item.kind == Item::Kind::draw) wanted.insert(plan.draw_mesh[item.index]);
    for (const Index mesh : wanted) {
        if (mesh == none || meshes[mesh]) continue;
        const auto* obj = std::get_if<ObjFile>(&plan.meshes[mesh].shape);
        const auto* shp = std::get_if<ShpFile>(&plan.meshes[mesh].shape);
        const Index file = obj ? obj->file : shp ? shp->file : none;
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
