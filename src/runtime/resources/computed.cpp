// Cube maps that are computed from others: when something that is drawn samples them, and again when what was drawn
// into their source changed.
#include <algorithm>

#include "src/plan/identity.h"
#include "src/runtime/resources/textures.h"

namespace snell::runtime {

namespace {

// Where the source is a file, it is computed once; where it is drawn to, perhaps for every frame.
constexpr int largest_by_default = 128, largest_drawn_by_default = 64;

// Uploads of levels, with what they are made from.
struct Levels {
    std::vector<content::CubeFaces> faces;
    std::vector<std::array<gl::Texels, 6>> texels;
    std::size_t bytes = 0;
};

Levels levels_of(const std::vector<content::CubeLight>& lights) {
    Levels result;
    for (const content::CubeLight& light : lights) result.faces.push_back(content::half_faces(light));
    for (const content::CubeFaces& faces : result.faces) {
        auto& level = result.texels.emplace_back();
        for (std::size_t face = 0; face < 6; ++face) {
            level[face] = {gl::Pixels::rgba16f, faces[face].width, faces[face].height, 1, faces[face].pixels.data()};
            result.bytes += faces[face].bytes();
        }
    }
    return result;
}

content::CubeLight black(int size) {
    content::CubeLight light;
    light.size = size;
    light.texels.resize(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    return light;
}

content::CubeLight read_light(const GpuTexture& cube) {
    auto rows = gl::read_cube(cube.texture.get(), cube.size[0]);
    content::CubeFaces faces;
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face].width = faces[face].height = cube.size[0];
        faces[face].pixels = std::move(rows[face]);
    }
    return content::cube_light(faces);
}

}  // namespace

int Textures::computed_size(const Texture& declared, int source_size) const {
    if (declared.size[0] > 0) return declared.size[0];
    const bool drawn = scene_->textures[declared.source].files.empty();
    return content::prefilter_size(source_size, drawn ? largest_drawn_by_default : largest_by_default);
}

std::vector<content::CubeLight> Textures::compute(const Texture& declared, const content::CubeLight& light) {
    ++counters_->convolutions;
    const int size = computed_size(declared, light.size);
    if (declared.computed == Computed::irradiance) return {content::irradiance(light, size)};
    return content::prefiltered(light, size);
}

GpuTexture Textures::make_computed(const Texture& declared) {
    GpuTexture gpu;
    const Texture& source = scene_->textures[declared.source];
    std::vector<content::CubeLight> lights;
    if (source.files.empty()) {  // black until something is drawn there
        int size = computed_size(declared, std::max(1, source.size[0]));
        const int levels = declared.computed == Computed::irradiance ? 1 : content::prefilter_levels(size);
        for (int level = 0; level < levels; ++level) lights.push_back(black(size >> level));
    } else {
        lights = compute(declared, content::cube_light(faces(declared.source)));
    }
    const Levels levels = levels_of(lights);
    gpu.size = {lights[0].size, lights[0].size, 1};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = GL_TEXTURE_CUBE_MAP;
    gpu.texture = gl::make_cube_levels(levels.texels);
    gpu.bytes = levels.bytes;
    count(gpu, true);
    return gpu;
}

const content::Harmonics* Textures::harmonics(Index texture) {
    const Index source = same_[texture];
    auto& harmonics = harmonics_[source];
    if (harmonics) return harmonics.get();
    Identity identity;
    if (savings_ && !drawn_to_[source]) identity = texture_identity(*scene_, source, *files_);
    if (!identity.key.empty()) identity.key += 'h';
    const std::vector<Span> at = places(source);
    if ((harmonics = store_->harmonics.take(identity.key, at, *diagnostics_))) {
        for (const std::string& path : identity.files) files_->keep(path);
        return harmonics.get();
    }
    const std::size_t said = diagnostics_->items().size();
    harmonics = std::make_shared<content::Harmonics>();
    if (!scene_->textures[source].files.empty()) {
        *harmonics = content::harmonics(content::cube_light(faces(source)));
        ++counters_->convolutions;
    }
    store_->harmonics.put(identity.key, harmonics, at, *diagnostics_, said);
    return harmonics.get();
}

void Textures::refresh(Index source) {
    const GpuTexture* cube = find(source);
    std::optional<content::CubeLight> light;
    const auto now = [&]() -> const content::CubeLight& {
        if (!light) light = read_light(*cube);
        return *light;
    };
    if (!cube) return;
    for (Index i = 0; i < textures_.size(); ++i) {
        const Texture& declared = scene_->textures[i];
        if (declared.computed == Computed::no || declared.source != source || !textures_[i] || !textures_[i]->texture)
            continue;
        const Levels levels = levels_of(compute(declared, now()));
        gl::replace_cube_levels(textures_[i]->texture.get(), levels.texels);
        counters_->bytes_uploaded += levels.bytes;
    }
    if (const auto found = harmonics_.find(source); found != harmonics_.end()) {
        *found->second = content::harmonics(now());
        ++counters_->convolutions;
    }
}

}  // namespace snell::runtime
