// Reads the pictures of textures from files, and noise; ahead of their use on all cores, if they are asked for then.
#pragma once

#include <map>
#include <vector>

#include "src/plan/plan.h"
#include "src/runtime/resources/jobs.h"

namespace snell::runtime {

// A texture of the scene, or else noise of 2 or 3 dimensions.
struct PictureKey {
    Index texture = none;
    int noise = 0;
    auto operator<=>(const PictureKey&) const = default;
};

// Ready to upload.
struct ReadPicture {
    content::Image image;
    content::CubeFaces faces;  // instead of `image`, for cube maps
    Diagnostics said;
    double milliseconds = 0;  // of reading
};

class TextureReader {
public:
    // Both outlive this.
    TextureReader(const Scene& scene, Files& files) : scene_(&scene), files_(&files) {}

    // Adds a job that reads the picture; take() returns it when the job is done. Does nothing if there is one.
    void preload(const PictureKey& key, std::vector<Job>& jobs);
    // Returns a picture that was preloaded, or reads it. Its problems go to `diagnostics`.
    ReadPicture take(const PictureKey& key, Diagnostics& diagnostics);
    // The milliseconds that the job of preload() took; 0 if there was none.
    double milliseconds(const PictureKey& key) const;
    // The faces of a cube map, which are kept for what is computed from them.
    const content::CubeFaces& faces(Index texture, Diagnostics& diagnostics);
    int noise_size(int dimensions) const { return dimensions == 3 ? scene_->noise3d : scene_->noise2d; }
    // Forgets everything, and returns how many images were decoded since the last time.
    ImageCache::Stats forget();

private:
    void read(const PictureKey& key, ReadPicture& into);

    const Scene* scene_;
    Files* files_;
    ImageCache images_;
    std::map<PictureKey, ReadPicture> preloaded_;
    std::map<Index, content::CubeFaces> faces_;
};

}  // namespace snell::runtime
