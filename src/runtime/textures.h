// Textures on the GPU: each realised when a draw first samples it or a pass renders to it, and only once.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "src/content/convolve.h"
#include "src/gl/caps.h"
#include "src/gl/texture.h"
#include "src/plan/files.h"
#include "src/plan/plan.h"

namespace snell::runtime {

struct GpuTexture {
    gl::Texture texture;
    GLenum target = GL_TEXTURE_2D;
    std::array<int, 3> size{0, 1, 1};
    bool mipmapped = false;
    std::size_t bytes = 0;
};

struct TextureCounters {
    std::uint64_t decoded = 0, bytes_decoded = 0, bytes_uploaded = 0, textures = 0, gpu_bytes = 0;
    std::uint64_t convolutions = 0;
};

class Textures {
public:
    Textures(const Scene& scene, Files& files, const gl::Caps& caps, Diagnostics& diagnostics);

    // Null when it can't be had (too large for this OpenGL; an error was given).
    const GpuTexture* realise(Index texture);
    const GpuTexture* noise(int dimensions);
    GLuint sampler(const Filter& filter, bool clamp, bool cube);
    // Of the cube map `texture`, which is not computed; computed now, if nobody asked before. Stays where it is.
    const content::Harmonics* harmonics(Index texture);
    // What was drawn into a cube map is another: what is computed from it is computed again.
    void refresh(Index source);
    // Null when it was not realised.
    const GpuTexture* find(Index texture) const;
    const TextureCounters& counters() const { return counters_; }
    // The files and their decoded pictures are needed only while textures are realised.
    void finish();
    // Makes realise() possible again, until the next finish().
    void resume(Files& files, Diagnostics& diagnostics);

private:
    GpuTexture make(Index texture);
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
    Diagnostics* diagnostics_;
    std::vector<std::unique_ptr<GpuTexture>> textures_;  // by Scene::textures
    std::vector<Index> same_;  // the first texture that is declared just so; empty ones are all different
    std::map<int, GpuTexture> noise_;
    std::map<std::tuple<int, int, bool, bool>, gl::Sampler> samplers_;
    ImageCache images_;
    std::map<Index, content::CubeFaces> faces_;  // by the first texture that is declared just so
    std::map<Index, std::unique_ptr<content::Harmonics>> harmonics_;
    TextureCounters counters_;
};

}  // namespace snell::runtime
