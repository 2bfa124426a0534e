#include "src/gl/texture.h"

#include <algorithm>
#include <cstdint>

#include "src/gl/driver.h"
#include "src/gl/target.h"

namespace snell::gl {

namespace {

struct StoredFormat {
    GLenum internal, component;
    std::size_t bytes;  // of a texel
};

const StoredFormat& format_of(Pixels type) {
    static constexpr StoredFormat formats[]{{GL_RGBA8, GL_UNSIGNED_BYTE, 4},
                                            {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE, 4},
                                            {GL_RGBA16F, GL_HALF_FLOAT, 8},
                                            {GL_RGBA32F, GL_FLOAT, 16}};  // as Pixels
    return formats[static_cast<std::size_t>(type)];
}

bool has_mipmaps(const Sampling& sampling) {
    return sampling.mode == Sampling::Mode::mipmap || sampling.mode == Sampling::Mode::anisotropic;
}

GLint min_filter(const Sampling& sampling) {
    if (has_mipmaps(sampling)) return GL_LINEAR_MIPMAP_LINEAR;
    return sampling.mode == Sampling::Mode::nearest ? GL_NEAREST : GL_LINEAR;
}

void upload(GLenum target, const Texels& texels) {
    const auto internal = static_cast<GLint>(internal_format(texels.type));
    const GLenum type = format_of(texels.type).component;
    switch (target) {
        case GL_TEXTURE_1D:
            beyond::image_1d(internal, texels.width, GL_RGBA, type, texels.data);
            break;
        case GL_TEXTURE_3D:
            glTexImage3D(target, 0, internal, texels.width, texels.height, texels.depth, 0, GL_RGBA, type, texels.data);
            break;
        default:
            glTexImage2D(target, 0, internal, texels.width, texels.height, 0, GL_RGBA, type, texels.data);
            break;
    }
}

// Without a maximum level, a texture with one level and the default filter is incomplete and reads as black.
void set_levels(GLenum target, const Sampling& sampling) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, min_filter(sampling));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, sampling.mode == Sampling::Mode::nearest ? GL_NEAREST : GL_LINEAR);
    if (!has_mipmaps(sampling)) glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    if (!sampling.clamp) return;  // what scenes read is wrapped by sampler objects
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(target, axis, GL_CLAMP_TO_EDGE);
}

void upload_levels(const std::vector<std::array<Texels, 6>>& levels, bool fresh) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t level = 0; level < levels.size(); ++level)
        for (GLenum face = 0; face < 6; ++face) {
            const Texels& texels = levels[level][face];
            const GLenum target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, type = format_of(texels.type).component;
            const auto at = static_cast<GLint>(level);
            if (fresh)
                glTexImage2D(target, at, static_cast<GLint>(internal_format(texels.type)), texels.width, texels.height,
                             0, GL_RGBA, type, texels.data);
            else
                glTexSubImage2D(target, at, 0, 0, texels.width, texels.height, GL_RGBA, type, texels.data);
        }
}

}  // namespace

GLenum internal_format(Pixels type) { return format_of(type).internal; }
std::size_t texel_bytes(Pixels type) { return format_of(type).bytes; }

Texture make_texture(GLenum target, std::span<const Texels> images, const Sampling& sampling) {
    Texture texture(make(glGenTextures));
    glBindTexture(target, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLenum part = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
    for (const Texels& texels : images) upload(part++, texels);
    set_levels(target, sampling);
    if (has_mipmaps(sampling) && images[0].data) glGenerateMipmap(target);
    glBindTexture(target, 0);
    return texture;
}

Texture make_words(int width, int height) {
    Texture texture(make(glGenTextures));
    glBindTexture(GL_TEXTURE_2D, texture.get());
    if (is_desktop())
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, width, height, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
    else  // ANGLE complains, and copies on the CPU, unless the storage is there before a buffer fills it
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32UI, width, height);
    set_levels(GL_TEXTURE_2D, {Sampling::Mode::nearest, 1, true});
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

void fill_words(GLuint buffer, int width, int height) {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

Texture make_texture(GLenum target, const Texels& texels, const Sampling& sampling) {
    return make_texture(target, {&texels, 1}, sampling);
}

Texture make_cube_levels(const std::vector<std::array<Texels, 6>>& levels) {
    Texture texture(make(glGenTextures));
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture.get());
    upload_levels(levels, true);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER,
                    levels.size() > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return texture;
}

void replace_cube_levels(GLuint texture, const std::vector<std::array<Texels, 6>>& levels) {
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
    upload_levels(levels, false);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
}

// Reads through a framebuffer, because OpenGL ES cannot read textures directly.
std::array<std::vector<std::byte>, 6> read_cube(GLuint texture, int size) {
    std::array<std::vector<std::byte>, 6> faces;
    const Framebuffer framebuffer(make(glGenFramebuffers));
    settle();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.get());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (GLenum face = 0; face < 6; ++face) {
        faces[face].resize(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
        glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face,
                               texture, 0);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, faces[face].data());
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return faces;
}

void generate_mipmaps(GLenum target, GLuint texture) {
    glBindTexture(target, texture);
    glGenerateMipmap(target);
    glBindTexture(target, 0);
}

Sampler make_sampler(const Sampling& sampling, bool cube) {
    GLuint id = 0;
    glGenSamplers(1, &id);
    Sampler sampler(id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, min_filter(sampling));
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, sampling.mode == Sampling::Mode::nearest ? GL_NEAREST : GL_LINEAR);
    const GLint wrap = cube || sampling.clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) glSamplerParameteri(id, axis, wrap);
    if (sampling.mode == Sampling::Mode::anisotropic && has_extension("GL_EXT_texture_filter_anisotropic"))
        glSamplerParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, sampling.anisotropy);
    return sampler;
}

void draw_covering(GLuint texture, GLuint vertex_array) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glBindSampler(0, 0);
    glBindVertexArray(vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

namespace {

// How texels are stored and uploaded.
struct Format {
    GLint internal;
    GLenum external, type;
    std::array<std::uint8_t, 4> texel;
    GLenum buffer;  // of a texel in a buffer texture
};

constexpr Format real{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, {0, 0, 0, 255}, GL_RGBA32F};
constexpr Format integral{GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE, {0, 0, 0, 1}, GL_RGBA32I};
constexpr Format natural{GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, {0, 0, 0, 1}, GL_RGBA32UI};
constexpr Format depth{GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, {}, 0};

const Format& format_of(std::string_view sampler) {
    if (sampler.ends_with("Shadow")) return depth;
    return sampler.starts_with('i') ? integral : sampler.starts_with('u') ? natural : real;
}

GLenum target_of(std::string_view sampler) {
    struct Kind {
        std::string_view name;
        GLenum target;
    };
    static constexpr Kind kinds[]{{"1D", GL_TEXTURE_1D},
                                  {"2D", GL_TEXTURE_2D},
                                  {"3D", GL_TEXTURE_3D},
                                  {"Cube", GL_TEXTURE_CUBE_MAP},
                                  {"2DRect", GL_TEXTURE_RECTANGLE},
                                  {"1DArray", GL_TEXTURE_1D_ARRAY},
                                  {"2DArray", GL_TEXTURE_2D_ARRAY},
                                  {"CubeArray", GL_TEXTURE_CUBE_MAP_ARRAY},
                                  {"2DMS", GL_TEXTURE_2D_MULTISAMPLE},
                                  {"2DMSArray", GL_TEXTURE_2D_MULTISAMPLE_ARRAY},
                                  {"Buffer", GL_TEXTURE_BUFFER}};
    sampler.remove_prefix(std::min(sampler.size(), sampler.find("sampler") + 7));
    if (sampler.ends_with("Shadow")) sampler.remove_suffix(6);
    const auto* found =
        std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& kind) { return kind.name == sampler; });
    return found == std::end(kinds) ? GL_TEXTURE_2D : found->target;
}

void fill(GLenum target, const Format& f) {
    const void* texel = f.texel.data();
    const std::array<std::array<std::uint8_t, 4>, 6> texels{f.texel, f.texel, f.texel, f.texel, f.texel, f.texel};
    switch (target) {
        case GL_TEXTURE_1D:
            return beyond::image_1d(f.internal, 1, f.external, f.type, texel);
        case GL_TEXTURE_3D:
        case GL_TEXTURE_2D_ARRAY:
            return glTexImage3D(target, 0, f.internal, 1, 1, 1, 0, f.external, f.type, texel);
        case GL_TEXTURE_CUBE_MAP_ARRAY:
            return glTexImage3D(target, 0, f.internal, 1, 1, 6, 0, f.external, f.type, texels.data());
        case GL_TEXTURE_CUBE_MAP:
            for (GLenum face = 0; face < 6; ++face)
                glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, f.internal, 1, 1, 0, f.external, f.type, texel);
            return;
        default:
            return glTexImage2D(target, 0, f.internal, 1, 1, 0, f.external, f.type, texel);
    }
}

// Texels of several samples can't be uploaded: they are cleared.
void fill_samples(GLenum target, GLuint texture, const Format& f) {
    beyond::image_of_samples(target, static_cast<GLenum>(f.internal));
    const Framebuffer framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    if (target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY)
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, 0);
    else
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, texture, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    constexpr std::array<GLfloat, 4> floats{};
    constexpr std::array<GLint, 4> ints{};
    constexpr std::array<GLuint, 4> uints{};
    if (&f == &real) glClearBufferfv(GL_COLOR, 0, floats.data());
    if (&f == &integral) glClearBufferiv(GL_COLOR, 0, ints.data());
    if (&f == &natural) glClearBufferuiv(GL_COLOR, 0, uints.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void fill_buffer(GLuint buffer, const Format& f) {
    constexpr std::array<std::uint32_t, 4> zeros{};
    glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    glBufferData(GL_TEXTURE_BUFFER, sizeof zeros, zeros.data(), GL_STATIC_DRAW);
    beyond::buffer_texels(f.buffer, buffer);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

}  // namespace

Black make_black(std::string_view sampler) {
    const Format& format = format_of(sampler);
    Black black{target_of(sampler), {}, Texture(make(glGenTextures))};
    glBindTexture(black.target, black.texture.get());
    if (black.target == GL_TEXTURE_BUFFER) {
        black.buffer = Buffer(make(glGenBuffers));
        fill_buffer(black.buffer.get(), format);
    } else if (black.target == GL_TEXTURE_2D_MULTISAMPLE || black.target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY) {
        fill_samples(black.target, black.texture.get(), format);
    } else {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        fill(black.target, format);
        // Integers can't be filtered. All else is, because Mesa's llvmpipe compiles the nearest texel at a constant
        // coordinate that is NaN to an illegal instruction.
        const bool filtered = &format == &real;
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(black.target, filter, filtered ? GL_LINEAR : GL_NEAREST);
        glTexParameteri(black.target, GL_TEXTURE_MAX_LEVEL, 0);
        if (&format == &depth) {
            glTexParameteri(black.target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
            glTexParameteri(black.target, GL_TEXTURE_COMPARE_FUNC, GL_NEVER);
        }
    }
    glBindTexture(black.target, 0);
    return black;
}

}  // namespace snell::gl
