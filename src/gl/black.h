// What a sampler reads where nothing is bound: a texel of its own kind, so that it can't be another program's texture.
#pragma once

#include <string_view>

#include "src/gl/handle.h"

namespace snell::gl {

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
