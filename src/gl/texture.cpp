#include "src/gl/texture.h"

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

Texture make_texture(GLenum target, const Texels& texels, const Sampling& sampling) {
    return make_texture(target, {&texels, 1}, sampling);
}

namespace {

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

}  // namespace snell::gl
