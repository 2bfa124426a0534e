// Textures of the kinds that scenes use, and sampler objects.
// What a sampler reads where nothing is bound: a texel of its own kind, so that it can't be another program's texture.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

// srgb8: bytes that stand for light, encoded by the sRGB curve; alpha is not.
enum class Pixels { rgba8, srgb8, rgba16f, rgba32f };

// Tightly packed RGBA texels. The first row is at t = 0; faces of cube maps are in the order that GL expects. If `data`
// is null, the storage is allocated but not filled.
struct Texels {
    Pixels type = Pixels::rgba8;
    int width = 0, height = 1, depth = 1;
    const std::byte* data = nullptr;
};

struct Sampling {
    enum class Mode { nearest, linear, mipmap, anisotropic };
    Mode mode = Mode::linear;
    float anisotropy = 1;
    bool clamp = false;  // clamp to the edge instead of repeating; cube maps are always clamped
};

GLenum internal_format(Pixels type);
std::size_t texel_bytes(Pixels type);

// `target` is GL_TEXTURE_1D, GL_TEXTURE_2D or GL_TEXTURE_3D with one image, or GL_TEXTURE_CUBE_MAP with its six faces
// in OpenGL's order.
Texture make_texture(GLenum target, std::span<const Texels> images, const Sampling& sampling);
Texture make_texture(GLenum target, const Texels& texels, const Sampling& sampling);
// Makes a cube map from all of its levels, each half the size of the one before; the first may have any size. If `data`
// is null, the storage is allocated but not filled.
Texture make_cube_levels(const std::vector<std::array<Texels, 6>>& levels);
// Replaces the texels of all levels; types and sizes must be the same as before.
void replace_cube_levels(GLuint texture, const std::vector<std::array<Texels, 6>>& levels);
// Reads the faces of level 0 as RGBA bytes, in the order of rows in which they were uploaded.
std::array<std::vector<std::byte>, 6> read_cube(GLuint texture, int size);
// A texture of four whole numbers of 32 bits a texel, and its texels from a buffer; it must be bound.
Texture make_words(int width, int height);
void fill_words(GLuint buffer, int width, int height);
void generate_mipmaps(GLenum target, GLuint texture);

// A sampler object keeps wrapping apart from the texture, so that one texture can be clamped in one draw and repeated
// in the next.
inline void delete_sampler(GLuint id) { glDeleteSamplers(1, &id); }
using Sampler = Handle<delete_sampler>;
// `cube` is true for samplers of cube maps, which are always clamped.
Sampler make_sampler(const Sampling& sampling, bool cube);

// Draws one triangle that covers the viewport, with the program in use and `texture` bound to unit 0. The triangle has
// no attributes, but OpenGL ES and core contexts require a vertex array even so.
void draw_covering(GLuint texture, GLuint vertex_array);

// Reads as (0, 0, 0, 1), as OpenGL has it for textures that are not complete; shadow samplers as 0, and multisampled
// textures and buffers as (0, 0, 0, 0), as texels beyond the edge do.
struct Black {
    GLenum target = GL_TEXTURE_2D;
    Buffer buffer;  // of a buffer texture
    Texture texture;
};

// `sampler`: a type of GLSL that this context has, such as isampler2DArray.
Black make_black(std::string_view sampler);

}  // namespace snell::gl
