#include "src/gl/black.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "src/gl/driver.h"

namespace snell::gl {

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
    const std::array<std::array<std::uint8_t, 4>, 6> faces{f.texel, f.texel, f.texel, f.texel, f.texel, f.texel};
    switch (target) {
        case GL_TEXTURE_1D:
            return beyond::image_1d(f.internal, 1, f.external, f.type, texel);
        case GL_TEXTURE_3D:
        case GL_TEXTURE_2D_ARRAY:
            return glTexImage3D(target, 0, f.internal, 1, 1, 1, 0, f.external, f.type, texel);
        case GL_TEXTURE_CUBE_MAP_ARRAY:
            return glTexImage3D(target, 0, f.internal, 1, 1, 6, 0, f.external, f.type, faces.data());
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
