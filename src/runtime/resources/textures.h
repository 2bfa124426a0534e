// Work for all cores, which one thread may watch.
// Reads the pictures of textures from files, and noise; ahead of their use on all cores, if they are asked for then.
// Textures on the GPU: each realised when a draw first samples it or a pass renders to it, and only once.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "src/content/cube/convolve.h"
#include "src/gl/context.h"
#include "src/gl/texture.h"
#include "src/plan/plan.h"
#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/store.h"

namespace snell::runtime {

struct Job {
    std::string name;
    std::function<void()> work;  // must not throw
};

// Adds what was said while a job read, but for what was said of the file's name when the scene was planned.
void say_once(const Diagnostics& said, Diagnostics& diagnostics);

// Does all of them, as many at a time as there are cores. `watcher`, if any, is called on this thread: at first, for
// each that is done, and in between every now and then, with the name of one that is not done yet.
void run(const std::vector<Job>& jobs, const Watcher& watcher);

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

// Cube maps that are computed from others, as levels to upload.

struct CubeLevels {
    std::vector<content::CubeFaces> faces;  // what `texels` point to
    std::vector<std::array<gl::Texels, 6>> texels;
    std::size_t bytes = 0;

    int size() const { return faces[0][0].width; }
};

// The light that was drawn into a cube map.
content::CubeLight read_light(GLuint cube, int size);

// The size of the first level: as declared, otherwise by the size of the source.
int computed_size(const Scene& scene, const Texture& declared, int source_size);
CubeLevels computed_levels(Computed computed, const content::CubeLight& light, int size);
// For a source into which nothing was drawn yet.
CubeLevels black_levels(Computed computed, int size);

struct GpuTexture {
    gl::Texture texture;
    GLenum target = GL_TEXTURE_2D;
    std::array<int, 3> size{0, 1, 1};
    gl::Pixels pixels = gl::Pixels::rgba8;
    bool mipmapped = false;
    int levels = 1;  // where they are not those of mipmaps
    std::size_t bytes = 0;
    double load_ms = 0;
};

class Textures {
public:
    // All outlive this but the store and the diagnostics. Without savings every texture is its own.
    Textures(const Scene& scene, Files& files, const gl::Caps& caps, Counters& counters, std::shared_ptr<Store> store,
             bool savings, Diagnostics& diagnostics);

    // Adds the jobs that read the files of textures, and noise of so many dimensions, before they are realised.
    void preload(const std::vector<Index>& wanted, const std::set<int>& noise, std::vector<Job>& jobs);
    // Null when it can't be had (too large for this OpenGL; an error was given).
    const GpuTexture* realise(Index texture);
    const GpuTexture* noise(int dimensions);
    // What a sampler of that GLSL type (static text) reads where nothing is bound.
    const gl::Black& nothing(std::string_view sampler);
    GLuint sampler(const Filter& filter, bool clamp, bool cube);
    // Returns the harmonics of a cube map that is not computed itself. They stay at their place.
    const content::Harmonics* harmonics(Index texture);
    // Computes again what is computed from a cube map into which something was drawn.
    void refresh(Index source);
    // Null when it was not realised.
    const GpuTexture* find(Index texture) const;
    const GpuTexture* find_noise(int dimensions) const;
    // Something reads it, directly or by what is computed from it, or tried to.
    bool asked(Index texture) const;
    // The first texture that is declared just so, and shares everything with this one.
    Index first(Index texture) const { return same_[texture]; }
    // The decoded pictures are needed only while textures are realised.
    void finish();
    // Makes realise() possible again, until the next finish().
    void resume(Diagnostics& diagnostics) { diagnostics_ = &diagnostics; }

private:
    Identity key_of(Index texture) const;
    std::vector<Span> places(Index texture) const;
    // Takes a texture from the store, or makes it, for which its files were read in `read_ms`, and puts it there.
    template <class Make>
    std::shared_ptr<GpuTexture> take_or_make(const Identity& identity, const std::vector<Span>& at, const Make& make,
                                             double read_ms);
    GpuTexture make(Index texture);
    GpuTexture make_from_image(const Texture& declared, Index texture);
    GpuTexture make_noise(int dimensions);
    GpuTexture make_cube(const Texture& declared, Index texture);
    GpuTexture make_empty(const Texture& declared);
    GpuTexture make_computed(const Texture& declared);
    void forget_pictures();
    bool fits(const Texture& declared, std::array<int, 3> size);
    void count(const GpuTexture& texture, bool uploaded);

    const Scene* scene_;
    Files* files_;
    const gl::Caps* caps_;
    Counters* counters_;
    std::shared_ptr<Store> store_;
    bool savings_ = true;
    Diagnostics* diagnostics_;
    TextureReader reader_;
    std::vector<std::shared_ptr<GpuTexture>> textures_;  // by Scene::textures
    std::vector<Index> same_;     // the first texture that is declared just so; empty ones are all different
    std::vector<bool> drawn_to_;  // by Scene::textures: what they show is this runtime's own
    std::map<int, std::shared_ptr<GpuTexture>> noise_;
    std::map<std::string_view, gl::Black> black_;  // by GLSL type
    struct SamplerKey {
        int mode = 0, anisotropy = 1;  // of a Filter
        bool clamp = false, cube = false;
        auto operator<=>(const SamplerKey&) const = default;
    };
    std::map<SamplerKey, gl::Sampler> samplers_;
    std::map<Index, std::shared_ptr<content::Harmonics>> harmonics_;
};

}  // namespace snell::runtime
