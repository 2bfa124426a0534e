#include "src/runtime/resources/state.h"

#include <algorithm>

#include "src/gl/driver.h"
#include "src/glsl/glsl.h"

namespace snell::runtime {

namespace {

GLenum factor(BlendFactor f) {
    constexpr std::array factors{GL_ZERO,
                                 GL_ONE,
                                 GL_SRC_COLOR,
                                 GL_ONE_MINUS_SRC_COLOR,
                                 GL_DST_COLOR,
                                 GL_ONE_MINUS_DST_COLOR,
                                 GL_SRC_ALPHA,
                                 GL_ONE_MINUS_SRC_ALPHA,
                                 GL_DST_ALPHA,
                                 GL_ONE_MINUS_DST_ALPHA,
                                 GL_SRC_ALPHA_SATURATE};  // as BlendFactor
    return static_cast<GLenum>(factors[static_cast<std::size_t>(f)]);
}

// With alpha 1 these factors are one and zero, so the picture is the same without blending.
bool is_plain_alpha(const RasterState& state) {
    return state.src == BlendFactor::src_alpha && state.dst == BlendFactor::one_minus_src_alpha;
}

}  // namespace

void State::forget() {
    raster_.reset();
    blending_.reset();
    color_.reset();
    program_.reset();
    array_.reset();
    units_.clear();
}

bool State::blend(const RasterState& wanted, bool opaque) {
    const bool on = wanted.blend && !(opaque && is_plain_alpha(wanted));
    if (blending_ != on) {
        toggle(GL_BLEND, on);
        blending_ = on;
        ++changes_;
    }
    if (!raster_ || raster_->src != wanted.src || raster_->dst != wanted.dst) {
        glBlendFunc(factor(wanted.src), factor(wanted.dst));
        ++changes_;
    }
    return on;
}

bool State::raster(const RasterState& wanted, bool opaque) {
    const bool blends = blend(wanted, opaque);
    const bool all = !raster_;
    if (!all && *raster_ == wanted) return blends;
    const RasterState old = raster_.value_or(RasterState{});
    if (all || old.cull != wanted.cull) {
        toggle(GL_CULL_FACE, wanted.cull != CullFace::none);
        glCullFace(wanted.cull == CullFace::front ? GL_FRONT : GL_BACK);
        ++changes_;
    }
    if (all || old.depth_test != wanted.depth_test || old.depth_write != wanted.depth_write) {
        // Without the test GL writes no depth either; writing without testing is a test that always passes.
        toggle(GL_DEPTH_TEST, wanted.depth_test || wanted.depth_write);
        glDepthFunc(wanted.depth_test ? GL_LESS : GL_ALWAYS);
        glDepthMask(wanted.depth_write ? GL_TRUE : GL_FALSE);
        ++changes_;
    }
    if ((all || old.wireframe != wanted.wireframe) && !caps_->es) {
        gl::beyond::polygon_mode(wanted.wireframe ? GL_LINE : GL_FILL);
        ++changes_;
    }
    if (all || old.line_width != wanted.line_width) {
        glLineWidth(std::clamp(static_cast<float>(wanted.line_width), 1.0F, std::max(1.0F, caps_->max_line_width)));
        ++changes_;
    }
    if ((all || old.point_size != wanted.point_size || old.point_size_mode != wanted.point_size_mode) && !caps_->es) {
        toggle(GL_PROGRAM_POINT_SIZE, wanted.point_size_mode);
        gl::beyond::point_size(
            std::clamp(static_cast<float>(wanted.point_size), 1.0F, std::max(1.0F, caps_->max_point_size)));
        ++changes_;
    }
    raster_ = wanted;
    return blends;
}

void State::color(const Vec4& wanted) {
    if (color_ == wanted) return;
    color_ = wanted;
    glVertexAttrib4f(static_cast<GLuint>(glsl::Attribute::color), static_cast<float>(wanted[0]),
                     static_cast<float>(wanted[1]), static_cast<float>(wanted[2]), static_cast<float>(wanted[3]));
    ++changes_;
}

void State::program(GLuint wanted) {
    if (program_ == wanted) return;
    program_ = wanted;
    glUseProgram(wanted);
    ++changes_;
}

void State::vertex_array(GLuint wanted) {
    if (array_ == wanted) return;
    array_ = wanted;
    glBindVertexArray(wanted);
    ++changes_;
}

void State::texture(int unit, GLenum target, GLuint texture, GLuint sampler) {
    const auto at = static_cast<size_t>(unit);
    if (units_.size() <= at) units_.resize(at + 1);
    const Unit wanted{target, texture, sampler};
    if (units_[at] == wanted) return;
    units_[at] = wanted;
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture);
    glBindSampler(static_cast<GLuint>(unit), sampler);
    ++changes_;
}

}  // namespace snell::runtime
