// Textures of the kinds that scenes name.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

enum class Pixels { rgba8, rgba16f, rgba32f };

// Tightly packed RGBA rows, the first row at t = 0 (cube faces: as uploaded). Null data: allocated only.
struct Texels {
    Pixels type = Pixels::rgba8;
    int width = 0, height = 1, depth = 1;
    const std::byte* data = nullptr;
};

struct Sampling {
    enum class Mode { nearest, linear, mipmap, anisotropic };
    Mode mode = Mode::linear;
    float anisotropy = 1;
    bool clamp = false;  // repeat otherwise; cube maps always clamp
};

GLenum internal_format(Pixels type);
std::size_t texel_bytes(Pixels type);

// `target` is GL_TEXTURE_1D, 2D, 3D or CUBE_MAP.
Texture make_texture(GLenum target, const Texels& texels, const Sampling& sampling);
Texture make_cube(const std::array<Texels, 6>& faces, const Sampling& sampling);
// All levels given, each half of the one before, the first as large as any; null data: allocated only.
Texture make_cube_levels(const std::vector<std::array<Texels, 6>>& levels);
// Other texels of the same types and sizes.
void replace_cube_levels(GLuint texture, const std::vector<std::array<Texels, 6>>& levels);
// The faces of level 0, as uploaded: row 0 first. RGBA bytes.
std::array<std::vector<std::byte>, 6> read_cube(GLuint texture, int size);
void generate_mipmaps(GLenum target, GLuint texture);

// RGBA32F texels in a buffer, for samplerBuffer. At least one.
struct BufferTexture {
    Buffer buffer;
    Texture texture;
};
BufferTexture make_buffer_texture(const void* texels, std::size_t count);

// A sampler object, so that one texture may be clamped in one draw and repeated in the next.
inline void delete_sampler(GLuint id) { glDeleteSamplers(1, &id); }
using Sampler = Handle<delete_sampler>;
Sampler make_sampler(const Sampling& sampling, bool cube);

// Three vertices without attributes, by the program in use, which reads the 2D texture as unit 0. ES and core contexts
// want a vertex array even so.
void draw_covering(GLuint texture, GLuint vertex_array);

}  // namespace snell::gl
