#include "src/gl/texture.h"

#include "src/gl/target.h"

namespace snell::gl {

namespace {

GLenum component_type(Pixels type) {
    switch (type) {
        case Pixels::rgba8:
        case Pixels::srgb8:
            return GL_UNSIGNED_BYTE;
        case Pixels::rgba16f:
            return GL_HALF_FLOAT;
        case Pixels::rgba32f:
            return GL_FLOAT;
    }
    return GL_UNSIGNED_BYTE;
}

bool has_mipmaps(const Sampling& sampling) {
    return sampling.mode == Sampling::Mode::mipmap || sampling.mode == Sampling::Mode::anisotropic;
}

GLint min_filter(const Sampling& sampling) {
    switch (sampling.mode) {
        case Sampling::Mode::nearest:
            return GL_NEAREST;
        case Sampling::Mode::linear:
            return GL_LINEAR;
        case Sampling::Mode::mipmap:
        case Sampling::Mode::anisotropic:
            return GL_LINEAR_MIPMAP_LINEAR;
    }
    return GL_LINEAR;
}

void upload(GLenum target, const Texels& texels) {
    const auto internal = static_cast<GLint>(internal_format(texels.type));
    const GLenum type = component_type(texels.type);
    switch (target) {
        case GL_TEXTURE_1D:
            glTexImage1D(target, 0, internal, texels.width, 0, GL_RGBA, type, texels.data);
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
}

}  // namespace

GLenum internal_format(Pixels type) {
    switch (type) {
        case Pixels::rgba8:
            return GL_RGBA8;
        case Pixels::srgb8:
            return GL_SRGB8_ALPHA8;
        case Pixels::rgba16f:
            return GL_RGBA16F;
        case Pixels::rgba32f:
            return GL_RGBA32F;
    }
    return GL_RGBA8;
}

std::size_t texel_bytes(Pixels type) {
    switch (type) {
        case Pixels::rgba8:
        case Pixels::srgb8:
            return 4;
        case Pixels::rgba16f:
            return 8;
        case Pixels::rgba32f:
            return 16;
    }
    return 4;
}

Texture make_texture(GLenum target, const Texels& texels, const Sampling& sampling) {
    Texture texture(make(glGenTextures));
    glBindTexture(target, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload(target, texels);
    set_levels(target, sampling);
    if (has_mipmaps(sampling) && texels.data) glGenerateMipmap(target);
    glBindTexture(target, 0);
    return texture;
}

Texture make_cube(const std::array<Texels, 6>& faces, const Sampling& sampling) {
    Texture texture(make(glGenTextures));
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLenum face = 0; face < 6; ++face) upload(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, faces[face]);
    set_levels(GL_TEXTURE_CUBE_MAP, sampling);
    if (has_mipmaps(sampling) && faces[0].data) glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return texture;
}

BufferTexture make_buffer_texture(const void* texels, std::size_t count) {
    BufferTexture made{Buffer(make(glGenBuffers)), Texture(make(glGenTextures))};
    glBindBuffer(GL_TEXTURE_BUFFER, made.buffer.get());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(count * texel_bytes(Pixels::rgba32f)), texels,
                 GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, made.texture.get());
    glTexBuffer(GL_TEXTURE_BUFFER, internal_format(Pixels::rgba32f), made.buffer.get());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
    return made;
}

namespace {

void upload_levels(const std::vector<std::array<Texels, 6>>& levels, bool fresh) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t level = 0; level < levels.size(); ++level)
        for (GLenum face = 0; face < 6; ++face) {
            const Texels& texels = levels[level][face];
            const GLenum target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, type = component_type(texels.type);
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
    if (sampling.mode == Sampling::Mode::anisotropic)
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
