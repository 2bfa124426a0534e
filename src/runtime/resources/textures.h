// Textures on the GPU: each realised when a draw first samples it or a pass renders to it, and only once.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "src/content/cube/convolve.h"
#include "src/gl/black.h"
#include "src/gl/caps.h"
#include "src/gl/texture.h"
#include "src/plan/files.h"
#include "src/plan/identity.h"
#include "src/plan/plan.h"
#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/jobs.h"
#include "src/runtime/resources/store.h"

namespace snell::runtime {

struct GpuTexture {
    gl::Texture texture;
    GLenum target = GL_TEXTURE_2D;
    std::array<int, 3> size{0, 1, 1};
    bool mipmapped = false;
    std::size_t bytes = 0;
    double load_ms = 0;
};

class Textures {
public:
    // All outlive this but the store and the diagnostics. Without savings every texture is its own.
    Textures(const Scene& scene, Files& files, const gl::Caps& caps, Counters& counters, std::shared_ptr<Store> store,
             bool savings, Diagnostics& diagnostics);

    // What reads those from files, and noise of so many dimensions; realise() and noise() find them when it is done.
    void preload(const std::vector<Index>& wanted, const std::set<int>& noise, std::vector<Job>& jobs);
    // Null when it can't be had (too large for this OpenGL; an error was given).
    const GpuTexture* realise(Index texture);
    const GpuTexture* noise(int dimensions);
    // What a sampler of that GLSL type (static text) reads where nothing is bound.
    const gl::Black& nothing(std::string_view sampler);
    GLuint sampler(const Filter& filter, bool clamp, bool cube);
    // Of the cube map `texture`, which is not computed; computed now, if nobody asked before. Stays where it is.
    const content::Harmonics* harmonics(Index texture);
    // What was drawn into a cube map is another: what is computed from it is computed again.
    void refresh(Index source);
    // Null when it was not realised.
    const GpuTexture* find(Index texture) const;
    const GpuTexture* find_noise(int dimensions) const;
    // Something reads it, directly or by what is computed from it, or tried to.
    bool asked(Index texture) const;
    // The first texture that is declared just so, and shares everything with this one.
    Index first(Index texture) const { return same_[texture]; }
    // The files and their decoded pictures are needed only while textures are realised.
    void finish();
    // Makes realise() possible again, until the next finish().
    void resume(Files& files, Diagnostics& diagnostics);

private:
    // What preload() has read of a texture: one of both.
    struct Preloaded {
        content::Image image;
        content::CubeFaces faces;
        Diagnostics said;
        double milliseconds = 0;
    };
    void preload_image(Index texture, Preloaded& into);
    void preload_noise(int dimensions, Preloaded& into);
    std::optional<Preloaded> take_preloaded(Index texture);
    content::Image read_image(Index texture, Diagnostics& diagnostics);
    content::CubeFaces read_faces(Index texture, Diagnostics& diagnostics);
    content::Image read_noise(int dimensions, Diagnostics& diagnostics);
    int noise_size(int dimensions) const { return dimensions == 3 ? scene_->noise3d : scene_->noise2d; }
    Identity key_of(Index texture) const;
    std::shared_ptr<GpuTexture> take_or_make(Index texture);
    GpuTexture make(Index texture);
    GpuTexture make_noise(int dimensions);
    std::vector<Span> places(Index texture) const;
    void empty_image_cache();
    GpuTexture make_from_image(const Texture& declared, Index texture);
    GpuTexture make_cube(const Texture& declared, Index texture);
    GpuTexture make_empty(const Texture& declared);
    GpuTexture make_computed(const Texture& declared);
    const content::CubeFaces& faces(Index texture);
    int computed_size(const Texture& declared, int source_size) const;
    std::vector<content::CubeLight> compute(const Texture& declared, const content::CubeLight& light);
    bool fits(const Texture& declared, std::array<int, 3> size);
    void count(const GpuTexture& texture, bool uploaded);

    const Scene* scene_;
    Files* files_;
    const gl::Caps* caps_;
    Counters* counters_;
    std::shared_ptr<Store> store_;
    bool savings_ = true;
    Diagnostics* diagnostics_;
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
    ImageCache images_;
    std::map<Index, Preloaded> preloaded_;
    std::map<int, Preloaded> preloaded_noise_;   // by dimensions
    std::map<Index, content::CubeFaces> faces_;  // by the first texture that is declared just so
    std::map<Index, std::shared_ptr<content::Harmonics>> harmonics_;
};

}  // namespace snell::runtime
