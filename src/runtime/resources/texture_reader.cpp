#include "src/runtime/resources/texture_reader.h"

#include "src/content/image/noise.h"
#include "src/runtime/resources/counters.h"

namespace snell::runtime {

void TextureReader::read(const PictureKey& key, ReadPicture& into) {
    const Stopwatch watch;
    if (key.noise != 0)
        into.image = load_noise(key.noise, noise_size(key.noise), *files_, into.said);
    else if (scene_->textures[key.texture].target == TextureTarget::cube)
        into.faces = load_cube(*scene_, key.texture, *files_, into.said, &images_);
    else
        into.image = load_texture(*scene_, key.texture, *files_, into.said, &images_);
    into.milliseconds = watch.milliseconds();
}

void TextureReader::preload(const PictureKey& key, std::vector<Job>& jobs) {
    const auto [into, fresh] = preloaded_.try_emplace(key);
    if (!fresh) return;
    const std::string name = key.noise != 0 ? content::noise_file_name(key.noise, noise_size(key.noise))
                                            : scene_->textures[key.texture].files[0].name;
    jobs.push_back({name, [this, key, picture = &into->second] { read(key, *picture); }});
}

ReadPicture TextureReader::take(const PictureKey& key, Diagnostics& diagnostics) {
    auto found = preloaded_.extract(key);
    ReadPicture picture;
    if (found.empty())
        read(key, picture);
    else
        picture = std::move(found.mapped());
    say_once(picture.said, diagnostics);
    return picture;
}

double TextureReader::milliseconds(const PictureKey& key) const {
    const auto found = preloaded_.find(key);
    return found == preloaded_.end() ? 0 : found->second.milliseconds;
}

const content::CubeFaces& TextureReader::faces(Index texture, Diagnostics& diagnostics) {
    const auto [found, fresh] = faces_.try_emplace(texture);
    if (fresh) found->second = take({texture}, diagnostics).faces;
    return found->second;
}

ImageCache::Stats TextureReader::forget() {
    const ImageCache::Stats stats = images_.stats();
    images_.clear();
    preloaded_.clear();
    faces_.clear();
    return stats;
}

}  // namespace snell::runtime
